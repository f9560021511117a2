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
        exportModels(createModels(), m_task.options, m_task.treeFolder, m_task.path, m_progress);
        emit finished({}, false);
    } catch (const CCancelled&) {
        emit finished({}, true);
    } catch (const std::exception& e) {
        emit finished(QString::fromUtf8(e.what()), false);
    }
}

std::vector<std::shared_ptr<const TreeModel>> CExportJob::createModels() const {
    CTreeCreator creator(true, m_task.limits);
    std::vector<std::shared_ptr<const TreeModel>> models;
    for (const Detail* detail : detailsOf(m_task.options)) {
        const bool ready = m_task.model && m_task.model->detail == detail;
        models.push_back(ready ? m_task.model : creator.create(m_task.params, *detail, m_progress));
    }
    return models;
}

} // namespace stromar
