#include "stromar/mesh/Weld.h"
#include "Groups.h"
#include <algorithm>
#include <tuple>

namespace stromar {

std::vector<std::uint32_t> weld(std::span<const glm::vec3> positions, const std::vector<std::uint32_t>& surfaces) {
    const std::size_t count = surfaces.empty() ? 0 : *std::ranges::max_element(surfaces) + std::size_t{1};
    CGroups<std::uint32_t> groups(count, positions.size(), [&](std::size_t v) { return surfaces[v]; }, [](std::size_t v) { return static_cast<std::uint32_t>(v); });
    const auto place = [&](std::uint32_t v) { return std::tuple(positions[v].x, positions[v].y, positions[v].z); };
    std::vector<std::uint32_t> number(positions.size());
    std::uint32_t next = 0;
    for (std::size_t surface = 0; surface < count; ++surface) {
        const std::span<std::uint32_t> own = groups.of(surface);
        std::ranges::sort(own, {}, place);
        for (std::size_t i = 0; i < own.size(); ++i) {
            next += i == 0 || place(own[i]) != place(own[i - 1]);
            number[own[i]] = next - 1;
        }
    }
    return number;
}

} // namespace stromar
