#include "InstanceArrays.h"
#include "stromar/util/Parallel.h"
#include <algorithm>
#include <numeric>

namespace stromar {

namespace {
/// Steps of the golden ratio fall into the largest gaps; without a common divisor they meet every one.
std::uint64_t strideFor(std::size_t count) {
    auto stride = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(0.61803398874989485 * double(count)));
    while (std::gcd(stride, std::uint64_t(count)) > 1) ++stride;
    return stride;
}
} // namespace

CInstances::CInstances(std::shared_ptr<const COrganMesh> organs)
    : m_organs(std::move(organs)), m_stride(strideFor(m_organs->count())) {}

void CInstances::compute(const CProgress& progress) {
    constexpr std::size_t kGrain = 8192;
    m_values.places.resize(count());
    m_values.turns.resize(count());
    m_values.widths.resize(count());
    parallelFor(
        count(), kGrain,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const InstancePlace at = m_organs->place(source(i));
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
