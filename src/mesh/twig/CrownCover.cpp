#include "stromar/util/Random.h"
#include "stromar/util/Rasterise.h"
#include "twig/CrownGrid.h"
#include <algorithm>
#include <array>
#include <bit>
#include <glm/common.hpp>
#include <numeric>
#include <optional>

namespace stromar {

namespace {
constexpr std::size_t kCoverViews = 8; // sparse crowns cover a twentieth more or less from one side than from another

/// Cells of a square grid, a bit for each, and those that are not in it as the wanted ones of rasterise(): what is covered, most of it many times
/// over, is passed by in words.
class CUncovered {
public:
    explicit CUncovered(int side) : m_words(static_cast<std::size_t>((side + kBits - 1) / kBits)), m_bits(m_words * static_cast<std::size_t>(side)) {}

    void cover(int x, int y) { m_bits[placeOf(x, y)] |= std::uint64_t{1} << (x % kBits); }
    std::size_t countCovered() const {
        std::size_t sum = 0;
        for (const std::uint64_t word : m_bits) sum += static_cast<std::size_t>(std::popcount(word));
        return sum;
    }
    bool any(int y, int x0, int x1) const {
        for (int first = x0; first <= x1;) {
            const auto [missing, count] = wordFrom(first, x1, y);
            if (missing) return true;
            first += count;
        }
        return false;
    }
    template <typename Look> void forEach(int y, int x0, int x1, Look&& look) const {
        for (int first = x0; first <= x1;) {
            auto [missing, count] = wordFrom(first, x1, y);
            for (const int start = first - first % kBits; missing; missing &= missing - 1) look(start + std::countr_zero(missing));
            first += count;
        }
    }

private:
    static constexpr int kBits = 64;

    /// Those uncovered of the cells from `first`, up to `last`, that lie in one word, and how many cells these are.
    std::pair<std::uint64_t, int> wordFrom(int first, int last, int y) const {
        const int bit = first % kBits, count = std::min(last - first + 1, kBits - bit);
        const std::uint64_t wanted = (~std::uint64_t{0} >> (kBits - count)) << bit;
        return {wanted & ~m_bits[placeOf(first, y)], count};
    }
    std::size_t placeOf(int x, int y) const { return static_cast<std::size_t>(y) * m_words + static_cast<std::size_t>(x / kBits); }

    std::size_t m_words; ///< of a row
    std::vector<std::uint64_t> m_bits;
};

/// Which cells a crown covers from one side: much cheaper than what is seen there.
class CCrownOutline : CCrownGrid {
public:
    CCrownOutline(const CrownFrame& crown, const glm::dvec3& viewer, int cells, double pixels)
        : CCrownGrid(crown, viewer, cells), m_uncovered(cells), m_pixelsPerCell(pixels / cells) {}

    void draw(const std::vector<CrownPart>& parts, const CProgress& progress) {
        forEachTriangle(parts, progress, [this](const CrownPart& part, const std::uint32_t* corners) {
            const CMesh& mesh = *part.mesh;
            const CCutOut* cutOut = part.cutOut();
            const std::array<glm::dvec2, 3> p = {seen(mesh.positions[corners[0]]), seen(mesh.positions[corners[1]]), seen(mesh.positions[corners[2]])};
            std::optional<Softness> soft;
            rasterise(
                p[0], p[1], p[2], m_side, m_side,
                [&](int x, int y, double u, double v) {
                    if (cutOut && !soft) soft = softnessOf(mesh, corners, p, *cutOut);
                    if (!cutOut || shows(*cutOut, mixed(mesh.texCoords, corners, u, v), *soft, x, y, corners[0])) m_uncovered.cover(x, y);
                },
                m_uncovered);
        });
    }

    double count() const { return double(m_uncovered.countCovered()); }

private:
    /// How a triangle's picture is drawn.
    struct Softness {
        int level;
        double soft;
    };
    Softness softnessOf(const CMesh& mesh, const std::uint32_t* corners, const std::array<glm::dvec2, 3>& p, const CCutOut& cutOut) const {
        const glm::dvec2 t(mesh.texCoords[corners[0]]), ds = glm::dvec2(mesh.texCoords[corners[1]]) - t, dt = glm::dvec2(mesh.texCoords[corners[2]]) - t;
        const glm::dvec2 ab = p[1] - p[0], ac = p[2] - p[0];
        const glm::dvec2 across = glm::abs(ac.y * ds - ab.y * dt), up = glm::abs(ab.x * dt - ac.x * ds);
        const double perCell = std::max({across.x, across.y, up.x, up.y}) / std::abs(ab.x * ac.y - ab.y * ac.x);
        const double footprint = std::max(1e-9, perCell / m_pixelsPerCell);
        return {CCutOut::levelOf(footprint), cutOut.softening().at(footprint)};
    }

    /// A cell is a sample of a pixel; soft pictures cover all of a pixel's or none, as often as they are to cover it. Soft or hard, a picture covers
    /// as much in the mean.
    bool shows(const CCutOut& cutOut, const glm::vec2& texCoord, const Softness& softness, int x, int y, std::uint32_t corner) const {
        const double soft = softness.soft, mean = soft > 0 ? cutOut.meanAt(texCoord, softness.level) : 0;
        if (soft > 0 && (mean <= 0 || mean >= 1)) return mean > 0;
        const bool hard = soft < 1 && cutOut.covers(texCoord);
        if (soft <= 0) return hard;
        const double cover = soft * mean + (1 - soft) * (hard ? 1 : 0);
        const auto pixel = [&](int cell) { return static_cast<std::uint64_t>(cell * m_pixelsPerCell); };
        const std::uint64_t ofPixel = hashCombine(corner, pixel(y) << 32 | pixel(x));
        const bool whole = cover > unitOf(ofPixel);
        return soft >= 1 ? whole : soft * (whole ? 1 : 0) + (1 - soft) * cover > unitOf(hashCombine(ofPixel, cellAt(x, y)));
    }

    CUncovered m_uncovered;
    double m_pixelsPerCell;
};
} // namespace

double pixelsOf(const CrownFrame& frame, double height, const Detail& detail) {
    return kScreenHeight * kScreenCoverage[static_cast<std::size_t>(detail.lod) - 1] * 2 * frame.radius / std::max(height, 0.01 * frame.radius);
}

class CCrownCover::CBackground {
public:
    std::vector<CCrownOutline> outlines; ///< a side each
};

CCrownCover::CCrownCover(const CrownFrame& frame, double pixels, const std::vector<CrownPart>& background, const CProgress& progress)
    : m_progress(progress) {
    constexpr double kPerPixel = 1.25;
    const int cells = static_cast<int>(std::clamp(kPerPixel * pixels, kViewCells / 2.0, double(kViewCells)));
    m_cells = double(cells) * cells;
    auto own = std::make_unique<CBackground>();
    for (std::size_t i = 0; i < kCoverViews; ++i) own->outlines.emplace_back(frame, sideOf(i, kCoverViews), cells, pixels);
    forEachOf(kCoverViews, progress, [&](std::size_t i) { own->outlines[i].draw(background, progress); });
    m_background = std::move(own);
}

CCrownCover::~CCrownCover() = default;

double CCrownCover::with(const std::vector<CrownPart>& parts) const {
    std::array<double, kCoverViews> covered{};
    forEachOf(kCoverViews, m_progress, [&](std::size_t i) {
        CCrownOutline outline = m_background->outlines[i];
        outline.draw(parts, m_progress);
        covered[i] = outline.count();
    });
    return std::accumulate(covered.begin(), covered.end(), 0.0) / (double(kCoverViews) * m_cells);
}

} // namespace stromar
