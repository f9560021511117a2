#include "stem/Nodes.h"
#include <algorithm>
#include <utility>

namespace stromar {

std::vector<std::uint32_t> CNodes::at(std::uint32_t stem, std::uint32_t position) const {
    std::vector<std::uint32_t> parting;
    const auto place = [](const CStem& branch) { return std::pair(branch.parent, branch.position); };
    for (const CStem& branch : std::ranges::equal_range(m_branches, std::pair(static_cast<std::int32_t>(stem), position), {}, place)) {
        const auto s = static_cast<std::uint32_t>(&branch - m_branches.data());
        if ((!m_drawn || (*m_drawn)[s]) && branch.mayPart()) parting.push_back(s);
    }
    return parting;
}

} // namespace stromar
