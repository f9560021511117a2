#include "stromar/scene/ViewPass.h"
#include <algorithm>
#include <cassert>
#include <cmath>
#include <osg/Math>

namespace stromar {

namespace {
// The next numbers fall into the largest gaps: the plastic number in the plane, the golden one on a circle (Roberts 2018).
constexpr double kAlong = 0.75487766624669276, kUp = 0.56984029099805327, kGolden = 0.61803398874989485;

double fraction(double x) { return x - std::floor(x); }
} // namespace

ViewPass ViewPass::of(int i, int count) {
    const double out = std::sqrt(double(i) / std::max(1, count)), around = 2 * osg::PI * kGolden * i;
    return {.pixel = {fraction(0.5 + kAlong * i) - 0.5, fraction(0.5 + kUp * i) - 0.5},
            .sun = {out * std::cos(around), out * std::sin(around)},
            .pattern = fraction(kGolden * i),
            .sunDisc = count > 1,
            .alone = count <= 1};
}

void CPictureMean::add(std::span<const std::uint8_t> bytes) {
    assert(m_count < kMost);
    if (bytes.size() != m_sums.size()) m_count = 0;
    if (m_count == 0) m_sums.assign(bytes.size(), 0);
    for (std::size_t i = 0; i < bytes.size(); ++i) m_sums[i] = static_cast<std::uint16_t>(m_sums[i] + bytes[i]);
    ++m_count;
}

void CPictureMean::write(std::span<std::uint8_t> bytes) const {
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::uint8_t>((m_sums[i] + m_count / 2) / m_count);
}

} // namespace stromar
