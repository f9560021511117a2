#include "work/ExportJob.h"

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
        CTreeCreator creator(true, m_task.limits);
        creator.setAge(m_task.age);
        exportTree(creator, m_task.params, m_task.options, m_task.treeFolder, m_task.path, m_progress, m_task.model,
                   m_task.motion);
        emit finished({}, false);
    } catch (const CCancelled&) {
        emit finished({}, true);
    } catch (const std::exception& e) {
        emit finished(QString::fromUtf8(e.what()), false);
    }
}

} // namespace stromar
