#include "InstanceArrays.h"
#include "stromar/util/Parallel.h"

namespace stromar {

void CInstances::compute(const CProgress& progress) {
    constexpr std::size_t kGrain = 8192;
    m_values.places.resize(count());
    m_values.turns.resize(count());
    m_values.widths.resize(count());
    parallelFor(
        count(), kGrain,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const InstancePlace at = m_organs->place(i);
                m_values.places[i] = glm::vec4(at.position, at.length);
                m_values.turns[i] = at.turn;
                m_values.widths[i] = at.width;
            }
        },
        progress);
}

void CInstances::release() { m_values = Values(); }

const CInstances::Values& CInstances::values() {
    if (m_values.places.size() != count()) compute(CProgress());
    return m_values;
}

} // namespace stromar
