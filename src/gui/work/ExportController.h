#pragma once
#include "document/Document.h"
#include "work/ExportJob.h"
#include "stromar/tree/Fall.h"
#include <QObject>
#include <functional>
#include <memory>
#include <optional>

class QProgressDialog;
class QWidget;

namespace stromar {

/// Exports the tree of a document, one at a time, beside everything else.
class CExportController : public QObject {
    Q_OBJECT
public:
    /// What is ready: the model that is shown, or null; what a tree may take.
    using Shown = std::function<std::shared_ptr<const TreeModel>()>;
    using Limits = std::function<SizeLimits()>;
    /// Of the tree in the window: how old it is, and the wind over it.
    struct Motion {
        double age;
        Wind wind;
        std::optional<Felling> felling;
    };
    using Moving = std::function<Motion()>;
    using Row = std::function<std::vector<RowTree>()>;
    CExportController(CDocument& document, Shown shown, Limits limits, Moving moving, Row row, QWidget* window);
    ~CExportController() override;

    /// Asks for format, file and choices; again with the same after an error.
    void chooseAndExport();
    /// Returns at once; `ended` tells how it went. `row`: all trees that stand side by side, instead of the one.
    void exportTo(const QString& path, const ExportOptions& options = {}, bool row = false);
    /// 0..1; nothing when idle.
    std::optional<double> progress() const { return m_job ? std::optional(m_job->progress()) : std::nullopt; }

signals:
    void started();
    void notice(const QString& text);
    void ended(const QString& why, bool cancelled);

private:
    void choose(const QString& name); ///< perhaps with its folder
    bool fits();
    QProgressDialog* showProgress(const QString& path);
    void finish(const QString& path, const QString& why, bool cancelled);

    CDocument& m_document;
    Shown m_shown;
    Limits m_limits;
    Moving m_moving;
    Row m_row; ///< the trees side by side; empty when the tree is alone
    QWidget* m_window;
    std::unique_ptr<CExportJob> m_job;
    bool m_chosen = false; ///< in the dialog, which comes back after an error
};

} // namespace stromar
