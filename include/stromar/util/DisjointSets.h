#pragma once
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace stromar {

/// Numbers from 0 in sets that are joined one after the other (union–find): the least of a set stands for it.
class CDisjointSets {
public:
    explicit CDisjointSets(std::size_t count) : m_least(count) { std::iota(m_least.begin(), m_least.end(), 0u); }
    std::uint32_t of(std::uint32_t number) {
        while (m_least[number] != number) number = m_least[number] = m_least[m_least[number]];
        return number;
    }
    void join(std::uint32_t one, std::uint32_t other) {
        one = of(one);
        other = of(other);
        m_least[std::max(one, other)] = std::min(one, other);
    }
    std::size_t count() const { ///< of the sets
        std::size_t count = 0;
        for (std::uint32_t number = 0; number < m_least.size(); ++number) count += m_least[number] == number;
        return count;
    }

private:
    std::vector<std::uint32_t> m_least;
};

} // namespace stromar
