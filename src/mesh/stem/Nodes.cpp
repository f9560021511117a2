#include "stem/Nodes.h"
#include <algorithm>
#include <utility>

namespace stromar {

std::vector<std::uint32_t> CNodes::at(std::uint32_t stem, std::uint32_t position) const {
    std::vector<std::uint32_t> parting;
    const auto place = [](const CStem& branch) { return std::pair(branch.parent, branch.position); };
    const std::pair wanted(static_cast<std::int32_t>(stem), position);
    for (auto branch = std::ranges::lower_bound(m_branches, wanted, {}, place); branch != m_branches.end() && place(*branch) == wanted; ++branch) {
        const auto s = static_cast<std::uint32_t>(branch - m_branches.begin());
        if ((!m_drawn || (*m_drawn)[s]) && branch->mayPart()) parting.push_back(s);
    }
    return parting;
}

} // namespace stromar
