#include "ExportJob.h"

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
        std::shared_ptr<const TreeModel> model = m_task.model;
        if (!model) {
            model = CTreeCreator(true, m_task.mostVertices).create(m_task.params, detailOf(Model::Full), m_progress);
        }
        exportModel(*model, m_task.treeFolder, m_task.path, m_progress);
        emit finished({}, false);
    } catch (const CCancelled&) {
        emit finished({}, true);
    } catch (const std::exception& e) {
        emit finished(QString::fromUtf8(e.what()), false);
    }
}

} // namespace stromar
