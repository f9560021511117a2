#include "work/ExportJob.h"
#include "window/QtText.h"

namespace stromar {

CExportJob::~CExportJob() {
    cancel();
    if (m_thread.joinable()) m_thread.join();
}

void CExportJob::start() {
    m_thread = std::jthread([this] { work(); });
}

void CExportJob::work() {
    try {
        if (m_task.row.empty())
            writeTree();
        else
            exportRow(m_task.row, m_task.options, m_task.limits, m_task.treeFolder, m_task.path, m_progress);
        emit finished({}, false);
    } catch (const CCancelled&) {
        emit finished({}, true);
    } catch (const std::exception& e) {
        emit finished(errorText(e), false);
    }
}

void CExportJob::writeTree() {
    CTreeCreator creator(true, m_task.limits);
    creator.setAge(m_task.age);
    exportTree(creator, m_task.params, m_task.options, m_task.treeFolder, m_task.path, m_progress, m_task.model, m_task.motion);
}

} // namespace stromar
