#pragma once
#include "stromar/tree/Tree.h"
#include <vector>

namespace stromar {

/// How thick the stems of each level are that may have a bark of its own (kBarks): where wood is as thick as those of another, it shows
/// the bark of that.
class CBarkLevels {
public:
    /// Linear in the stems.
    explicit CBarkLevels(const CTree& tree);

    std::size_t count() const { return m_thinness.size(); }
    /// VertexLook::thinness of wood of the mean radius.
    int thinness(std::size_t level) const { return m_thinness[level]; }
    /// Whether wood of one level gives way to that of another in this direction.
    bool isApart(std::size_t level, std::size_t other) const {
        return other > level ? m_thinness[other] > m_thinness[level] : m_thinness[other] < m_thinness[level];
    }
    /// The level whose stems are as thick as wood of a level that is so thin: of two, half way between them by halvings of the radius.
    std::size_t levelOf(std::size_t own, int thinness) const;

private:
    std::vector<int> m_thinness;
};

} // namespace stromar
