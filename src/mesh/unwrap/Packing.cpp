#include "unwrap/Packing.h"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace stromar {

namespace {
/// Lays rectangles on shelves, high ones first.
class CShelves {
public:
    CShelves(const std::vector<glm::dvec2>& sizes, double gap) : m_sizes(sizes), m_gap(gap), m_order(sizes.size()), m_all(sizes.size()) {
        std::iota(m_order.begin(), m_order.end(), std::size_t{0});
        std::ranges::stable_sort(m_order, [&](std::size_t a, std::size_t b) { return heightOf(a) > heightOf(b); });
    }

    bool fits(double scale) {
        glm::dvec2 at(0);
        double shelf = 0;
        for (const std::size_t i : m_order) {
            const glm::dvec2 own = pressed(scale * glm::dvec2(std::max(m_sizes[i].x, m_sizes[i].y), heightOf(i))) + m_gap;
            if (at.x + own.x > 1) {
                at = {0, at.y + shelf};
                shelf = 0;
            }
            shelf = std::max(shelf, own.y);
            if (at.y + shelf > 1) return false;
            m_all[i] = placed(i, at, own - m_gap);
            at.x += own.x;
        }
        return true;
    }
    const std::vector<Packing>& all() const { return m_all; }

private:
    double heightOf(std::size_t i) const { return std::min(m_sizes[i].x, m_sizes[i].y); }
    glm::dvec2 pressed(const glm::dvec2& size) const { return {std::min(size.x, 1 - m_gap), std::min(size.y, 1 - m_gap)}; }
    Packing placed(std::size_t i, const glm::dvec2& at, const glm::dvec2& size) const {
        const bool turned = m_sizes[i].y > m_sizes[i].x;
        const auto share = [](double to, double from) { return from > 0 ? to / from : 0; };
        const glm::dvec2 scale = turned ? glm::dvec2(share(size.y, m_sizes[i].x), share(size.x, m_sizes[i].y))
                                        : glm::dvec2(share(size.x, m_sizes[i].x), share(size.y, m_sizes[i].y));
        return {at + m_gap / 2, scale, turned};
    }

    const std::vector<glm::dvec2>& m_sizes;
    double m_gap;
    std::vector<std::size_t> m_order;
    std::vector<Packing> m_all;
};
} // namespace

std::vector<Packing> packed(const std::vector<glm::dvec2>& sizes, double gap) {
    constexpr int kTries = 24;
    double area = 0;
    for (const glm::dvec2& size : sizes) area += size.x * size.y;
    CShelves shelves(sizes, gap);
    double fits = 0, tooLarge = area > 0 ? 2 / std::sqrt(area) : 1;
    for (int i = 0; i < kTries; ++i) {
        const double scale = (fits + tooLarge) / 2;
        (shelves.fits(scale) ? fits : tooLarge) = scale;
    }
    shelves.fits(fits);
    return shelves.all();
}

} // namespace stromar
