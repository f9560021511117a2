#pragma once
#include "stromar/tree/Wind.h"

namespace stromar {

/// Stems that others follow: some of the thickest.
class CStemChoice {
public:
    /// At most `count` of those that `mayLead(stem)`.
    template <typename MayLead>
    CStemChoice(const CWindTable& table, std::size_t count, MayLead&& mayLead) {
        std::vector<std::uint32_t> candidates;
        for (std::uint32_t s = 0; s < table.stems().size(); ++s)
            if (mayLead(s)) candidates.push_back(s);
        choose(table, std::move(candidates), count);
    }

    /// In the table's order: parents come before what they bear.
    const std::vector<std::uint32_t>& leaders() const { return m_leaders; }
    /// Which of them a stem follows: itself, or the nearest that bears it; −1: none.
    int leaderOf(std::uint32_t stem) const { return m_leaderOf[stem]; }
    /// The one that bears a leader; −1: none.
    int leaderBelow(std::size_t leader) const { return m_below[leader]; }

private:
    void choose(const CWindTable& table, std::vector<std::uint32_t> candidates, std::size_t count);

    std::vector<std::uint32_t> m_leaders;
    std::vector<int> m_leaderOf; ///< by stem
    std::vector<int> m_below;    ///< by leader
};

} // namespace stromar
