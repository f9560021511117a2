#include "work/ExportController.h"
#include "document/FileController.h"
#include "stromar/app/Methods.h"
#include "stromar/app/Prediction.h"
#include "window/QtText.h"
#include "work/ExportDialog.h"
#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QProgressDialog>
#include <QTimer>

namespace stromar {

namespace {
constexpr int kStill = 10; // times without progress after which the bar says only that there is work
}

CExportController::CExportController(CDocument& document, Shown shown, Limits limits, Moving moving, Row row,
                                     QWidget* window)
    : QObject(window), m_document(document), m_shown(std::move(shown)), m_limits(std::move(limits)),
      m_moving(std::move(moving)), m_row(std::move(row)), m_window(window) {}

CExportController::~CExportController() = default;

void CExportController::chooseAndExport() {
    takeTyped(*m_window);
    choose(QFileInfo(m_document.displayName()).completeBaseName());
}

void CExportController::choose(const QString& name) {
    if (m_job) return;
    const Detail& full = detailOf(Model::Full);
    const auto shown = m_shown();
    const bool isFull = shown && shown->detail == &full, mayPredict = methodOf(m_document.params()).boundIsQuick;
    const double vertices = isFull || !mayPredict ? (shown ? double(shown->vertexCount()) : 0)
                                                  : predictSize(m_document.params(), full).vertices;
    if (mayPredict && !fits()) return;
    CExportDialog dialog(name, vertices, m_row().size(), m_window);
    if (dialog.exec() != QDialog::Accepted) return;
    exportTo(dialog.path(), dialog.options(), dialog.wantsRow());
    m_chosen = true;
}

/// Tells why not, before anything is chosen.
bool CExportController::fits() {
    try {
        refuseTooLarge(m_document.params(), detailOf(Model::Full), m_limits(), CProgress());
        return true;
    } catch (const CError& e) {
        QMessageBox::critical(m_window, tr("Cannot export the tree"), errorText(e));
        return false;
    }
}

void CExportController::exportTo(const QString& path, const ExportOptions& options, bool row) {
    if (m_job) return;
    const Motion moving = m_moving();
    m_job = std::make_unique<CExportJob>(CExportJob::Task{m_document.params(),
                                                          m_shown(),
                                                          options,
                                                          m_document.folder(),
                                                          toPath(path),
                                                          m_limits(),
                                                          moving.age,
                                                          {.wind = moving.wind, .felling = moving.felling},
                                                          row ? m_row() : std::vector<RowTree>()});
    QProgressDialog* dialog = showProgress(path);
    connect(
        m_job.get(), &CExportJob::finished, this,
        [this, dialog, path](const QString& why, bool cancelled) {
            dialog->disconnect(this);
            dialog->close();
            finish(path, why, cancelled);
        },
        Qt::QueuedConnection);
    m_job->start();
    emit started();
}

QProgressDialog* CExportController::showProgress(const QString& path) {
    auto* dialog = new QProgressDialog(tr("Writing %1").arg(QFileInfo(path).fileName()), tr("Cancel"), 0, 1000, m_window);
    dialog->setWindowModality(Qt::WindowModal);
    dialog->setMinimumDuration(300);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    auto* poll = new QTimer(dialog);
    connect(poll, &QTimer::timeout, this, [this, dialog, last = -1, still = 0]() mutable {
        if (!m_job) return;
        const int done = std::min(999, static_cast<int>(m_job->progress() * 1000));
        still = done == std::exchange(last, done) ? still + 1 : 0;
        dialog->setMaximum(still < kStill ? 1000 : 0); // no maximum: it is at work, nobody knows how long
        if (still < kStill) dialog->setValue(done);
    });
    poll->start(100);
    connect(dialog, &QProgressDialog::canceled, this, [this] {
        if (m_job) m_job->cancel();
    });
    return dialog;
}

void CExportController::finish(const QString& path, const QString& why, bool cancelled) {
    m_job.reset();
    if (!why.isEmpty())
        QMessageBox::critical(m_window, tr("Cannot export the tree"), why);
    else
        emit notice(cancelled ? tr("Export cancelled; no file was changed") : tr("Exported %1").arg(path));
    emit ended(why, cancelled);
    if (std::exchange(m_chosen, false) && !why.isEmpty())
        choose(QFileInfo(path).dir().filePath(QFileInfo(path).completeBaseName()));
}

} // namespace stromar
