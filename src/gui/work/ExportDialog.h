#pragma once
#include "stromar/app/Engines.h"
#include <QDialog>
#include <functional>
#include <vector>

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace stromar {

/// Asks for a format, a place and the rows of the table of export choices; tells what is lost and about how large the
/// file will be. Remembers the last choices.
class CExportDialog : public QDialog {
    Q_OBJECT
public:
    /// `fullVertices` of the full model, for the size; `name` proposes the file's; `rowTrees`: how many stand side by side.
    CExportDialog(const QString& name, double fullVertices, std::size_t rowTrees = 0, QWidget* parent = nullptr);

    QString path() const;
    const ExportOptions& options() const { return m_options; }
    bool wantsRow() const;

    void accept() override;

private:
    void addTrees(QFormLayout& form);
    void addEngines(QFormLayout& form);
    void takeEngine(int index);
    void take(const ExportSettings& settings);
    void loadSettings();
    void saveSettings();
    void addFormats(QFormLayout& form);
    void addChoice(const ExportChoice& choice, QFormLayout& form);
    void addPlace(QFormLayout& form, const QString& name);
    void browse();
    void onPath();
    void update();
    const Format& format() const;

    double m_fullVertices;
    std::size_t m_rowTrees;
    ExportOptions m_options;
    std::vector<std::function<void()>> m_show; ///< the options' values in their editors
    QComboBox *m_trees, *m_engine, *m_format;
    QLabel* m_notes;
    QLineEdit* m_path;
    QLabel *m_losses, *m_size, *m_conflict;
    QPushButton* m_export;
};

} // namespace stromar
