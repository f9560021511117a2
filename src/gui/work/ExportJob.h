#pragma once
#include "stromar/app/Export.h"
#include "stromar/app/ExportRow.h"
#include <QObject>
#include <QString>
#include <filesystem>
#include <thread>

namespace stromar {

/// One export, on a thread of its own. Tells once how it ended: done, failed or cancelled.
class CExportJob : public QObject {
    Q_OBJECT
public:
    struct Task {
        CParams params;
        std::shared_ptr<const TreeModel> model; ///< the full one, when it is already made
        ExportOptions options;
        std::filesystem::path treeFolder, path;
        SizeLimits limits;
        double age = 1;
        Motion motion{}; ///< of clips
        std::vector<RowTree> row{}; ///< all trees beside each other instead of the one
    };

    explicit CExportJob(Task task, QObject* parent = nullptr) : QObject(parent), m_task(std::move(task)) {}
    /// Cancels and waits.
    ~CExportJob() override;

    /// Once, after the signal is connected.
    void start();
    void cancel() { m_progress.cancel(); }
    double progress() const { return m_progress.done(); }

signals:
    /// `why` is empty when all went well; cancelled tells that the user stopped it.
    void finished(const QString& why, bool cancelled);

private:
    void work();
    void writeTree();

    Task m_task;
    CProgress m_progress;
    std::jthread m_thread;
};

} // namespace stromar
