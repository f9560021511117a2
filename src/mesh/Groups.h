#pragma once
#include <numeric>
#include <span>
#include <vector>

namespace stromar {

/// Values by a number below `groups` that `groupOf(i)` gives them: those of a group lie together.
template <typename Value> class CGroups {
public:
    template <typename GroupOf, typename ValueOf> CGroups(std::size_t groups, std::size_t count, GroupOf&& groupOf, ValueOf&& valueOf) : m_ends(groups + 1), m_values(count) {
        for (std::size_t i = 0; i < count; ++i) ++m_ends[groupOf(i) + 1];
        std::partial_sum(m_ends.begin(), m_ends.end(), m_ends.begin());
        std::vector<std::size_t> next(m_ends.begin(), m_ends.end() - 1);
        for (std::size_t i = 0; i < count; ++i) m_values[next[groupOf(i)]++] = valueOf(i);
    }
    std::size_t count() const { return m_ends.size() - 1; }
    std::span<Value> of(std::size_t group) { return {m_values.data() + m_ends[group], m_values.data() + m_ends[group + 1]}; }

private:
    std::vector<std::size_t> m_ends; ///< of the group before
    std::vector<Value> m_values;
};

} // namespace stromar
