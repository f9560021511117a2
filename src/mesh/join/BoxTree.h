#pragma once
#include <algorithm>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

namespace stromar {

/// With sides along the axes; empty at first.
struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};

    void add(const glm::dvec3& place) {
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    bool touches(const Box& other) const { return glm::all(glm::lessThanEqual(low, other.high)) && glm::all(glm::lessThanEqual(other.low, high)); }
};

/// Finds those of many boxes that touch one: a binary tree of the boxes around their halves. Made in time n log n.
class CBoxTree {
public:
    explicit CBoxTree(std::vector<Box> boxes) : m_boxes(std::move(boxes)), m_order(m_boxes.size()), m_around(4 * m_boxes.size() + 1) {
        std::iota(m_order.begin(), m_order.end(), 0u);
        split(0, m_order);
    }

    /// Calls work(i) for each, in an order of the tree's own.
    template <typename Do> void forEachTouching(const Box& box, Do&& work) const { visit(0, m_order, box, work); }

private:
    using Numbers = std::span<const std::uint32_t>;

    void split(std::size_t node, std::span<std::uint32_t> own) {
        for (const std::uint32_t i : own) m_around[node].add(m_boxes[i].low), m_around[node].add(m_boxes[i].high);
        if (own.size() < 2) return;
        const glm::dvec3 size = m_around[node].high - m_around[node].low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const auto middle = own.begin() + static_cast<std::ptrdiff_t>(own.size() / 2);
        const auto place = [&](std::uint32_t i) { return std::pair(m_boxes[i].low[axis] + m_boxes[i].high[axis], i); };
        std::ranges::nth_element(own, middle, {}, place);
        split(2 * node + 1, own.first(own.size() / 2));
        split(2 * node + 2, own.subspan(own.size() / 2));
    }

    template <typename Do> void visit(std::size_t node, Numbers own, const Box& box, Do& work) const {
        if (own.empty() || !m_around[node].touches(box)) return;
        if (own.size() == 1) return work(own[0]);
        visit(2 * node + 1, own.first(own.size() / 2), box, work);
        visit(2 * node + 2, own.subspan(own.size() / 2), box, work);
    }

    std::vector<Box> m_boxes;
    std::vector<std::uint32_t> m_order;
    std::vector<Box> m_around; ///< by node: its halves follow at 2 n + 1
};

} // namespace stromar
