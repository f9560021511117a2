#include "work/Randomiser.h"
#include "stromar/util/Error.h"

namespace stromar {

CRandomiser::~CRandomiser() { cancel(); }

void CRandomiser::cancel() {
    m_progress.cancel();
    if (m_thread.joinable()) m_thread.join();
}

void CRandomiser::start(Task task) {
    cancel();
    m_progress = CProgress(1); // the tree in the window comes first
    m_busy = true;
    m_thread = std::jthread([this, task = std::move(task), number = ++m_number] { look(task, number); });
}

void CRandomiser::look(const Task& task, quint64 number) {
    ParamValues values;
    try {
        values = randomisedTree(task.params, task.refs, task.amount, task.seed, task.limits, m_progress);
    } catch (const CCancelled&) {
        return;
    } catch (const CError&) { // this tree does not grow as it is
        values = randomised(task.params, task.refs, task.amount, task.seed);
    }
    QMetaObject::invokeMethod(
        this,
        [this, number, from = task.params, values] {
            if (number != m_number) return;
            m_busy = false;
            emit found(from, values);
        },
        Qt::QueuedConnection);
}

} // namespace stromar
