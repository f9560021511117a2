#include "wind/StemChoice.h"
#include <algorithm>

namespace stromar {

void CStemChoice::choose(const CWindTable& table, std::vector<std::uint32_t> candidates, std::size_t count) {
    const auto& stems = table.stems();
    std::ranges::stable_sort(candidates, std::greater(), [&](std::uint32_t s) { return stems[s].diameter; });
    candidates.resize(std::min(count, candidates.size()));
    std::vector<bool> leads(stems.size());
    for (const std::uint32_t s : candidates) leads[s] = true;
    m_leaderOf.resize(stems.size());
    for (std::uint32_t s = 0; s < stems.size(); ++s) {
        const int below = stems[s].parent < 0 ? -1 : m_leaderOf[static_cast<std::size_t>(stems[s].parent)];
        m_leaderOf[s] = below;
        if (!leads[s]) continue;
        m_leaderOf[s] = static_cast<int>(m_leaders.size());
        m_leaders.push_back(s);
        m_below.push_back(below);
    }
}

} // namespace stromar
