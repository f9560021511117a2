#pragma once
#include "stromar/mesh/Mesh.h"
#include <algorithm>
#include <cstdint>
#include <glm/common.hpp>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace stromar {

/// Of nothing yet.
inline constexpr Bounds kNowhere{glm::vec3(std::numeric_limits<float>::infinity()), glm::vec3(-std::numeric_limits<float>::infinity())};

inline void include(Bounds& bounds, const glm::vec3& place) {
    bounds.min = glm::min(bounds.min, place);
    bounds.max = glm::max(bounds.max, place);
}

inline bool touch(const Bounds& one, const Bounds& other) {
    return one.min.x <= other.max.x && other.min.x <= one.max.x && one.min.y <= other.max.y && other.min.y <= one.max.y &&
           one.min.z <= other.max.z && other.min.z <= one.max.z;
}

/// Finds those of many bounds that touch others: a binary tree (bounding volume hierarchy). Made in time n log n.
class CBoundsTree {
public:
    explicit CBoundsTree(std::vector<Bounds> all) : m_all(std::move(all)), m_order(m_all.size()), m_nodes(4 * m_all.size() + 1) {
        std::iota(m_order.begin(), m_order.end(), 0u);
        split(0, m_order);
    }

    /// Calls work(i) for each, always in the same order; what it returns false for is not found again.
    template <typename Do> void forEachTouching(const Bounds& bounds, Do&& work) { visit(0, m_order, bounds, work); }
    /// Whether there are any.
    bool touches(const Bounds& bounds) const { return touches(0, m_order, bounds); }

private:
    struct Node {
        Bounds around = kNowhere;
        std::size_t count = 0; ///< of those that can be found
    };

    void split(std::size_t node, std::span<std::uint32_t> own) {
        m_nodes[node].count = own.size();
        Bounds& around = m_nodes[node].around;
        for (const std::uint32_t i : own) include(around, m_all[i].min), include(around, m_all[i].max);
        if (own.size() < 2) return;
        const glm::vec3 size = around.max - around.min;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const auto place = [&](std::uint32_t i) { return std::pair(m_all[i].min[axis] + m_all[i].max[axis], i); };
        std::ranges::nth_element(own, own.begin() + static_cast<std::ptrdiff_t>(own.size() / 2), {}, place);
        split(2 * node + 1, own.first(own.size() / 2));
        split(2 * node + 2, own.subspan(own.size() / 2));
    }

    bool touches(std::size_t node, std::span<const std::uint32_t> own, const Bounds& bounds) const {
        if (m_nodes[node].count == 0 || !touch(m_nodes[node].around, bounds)) return false;
        return own.size() == 1 || touches(2 * node + 1, own.first(own.size() / 2), bounds) || touches(2 * node + 2, own.subspan(own.size() / 2), bounds);
    }

    template <typename Do> void visit(std::size_t node, std::span<const std::uint32_t> own, const Bounds& bounds, Do& work) {
        Node& here = m_nodes[node];
        if (here.count == 0 || !touch(here.around, bounds)) return;
        if (own.size() == 1) {
            if (!work(own[0])) here.count = 0;
            return;
        }
        visit(2 * node + 1, own.first(own.size() / 2), bounds, work);
        visit(2 * node + 2, own.subspan(own.size() / 2), bounds, work);
        here.count = m_nodes[2 * node + 1].count + m_nodes[2 * node + 2].count;
    }

    std::vector<Bounds> m_all;
    std::vector<std::uint32_t> m_order;
    std::vector<Node> m_nodes; ///< halves follow at 2 n + 1
};

} // namespace stromar
