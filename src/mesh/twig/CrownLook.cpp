#include "stromar/mesh/twig/CrownLook.h"
#include "foliage/Foliage.h"
#include "stromar/util/Rasterise.h"
#include "twig/CrownGrid.h"
#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <limits>
#include <numeric>
#include <optional>

namespace stromar {

namespace {
constexpr int kSunCells = 2048;
constexpr std::size_t kSeenPixels = 4096, kLookViews = 8;
constexpr double kSunHeight = 51 * std::numbers::pi / 180;
// Cells of the sun's view: by which a leaf is lifted out of its own shadow; over which shadows are soft, a radius. As the viewport's.
constexpr double kLift = 1.5, kDisc = 2.5;

/// What is seen in a cell.
struct Facing {
    glm::vec3 normal{0}; ///< of the side that is seen
    bool back = false;   ///< it is a leaf's under side
    bool behind = false; ///< of the leaf or the card
    CrownLayer layer = CrownLayer::Leaf;
};

/// The derivatives of places by a triangle's texture coordinates, unit.
struct Axes {
    glm::vec3 right{0}, along{0};
};
Axes axesOf(const CMesh& mesh, const std::uint32_t* corners) {
    const auto place = [&](int i) { return mesh.positions[corners[i]]; };
    const glm::vec2 d1 = mesh.texCoords[corners[1]] - mesh.texCoords[corners[0]], d2 = mesh.texCoords[corners[2]] - mesh.texCoords[corners[0]];
    const glm::vec3 e1 = place(1) - place(0), e2 = place(2) - place(0);
    const float side = d1.x * d2.y - d1.y * d2.x < 0 ? -1.0f : 1.0f;
    const auto unit = [](const glm::vec3& v) { return v / std::max(1e-20f, glm::length(v)); };
    return {unit(side * (d2.y * e1 - d1.y * e2)), unit(side * (d1.x * e2 - d2.x * e1))};
}

/// A crown from one side, without perspective: how near it is, and, where that is wanted, how it faces.
class CCrownView : CCrownGrid {
public:
    CCrownView(const CrownFrame& crown, const glm::dvec3& viewer, int cells, bool facings = true)
        : CCrownGrid(crown, viewer, cells), m_depths(cellCount(), -std::numeric_limits<float>::infinity()), m_facings(facings ? cellCount() : 0) {}

    void draw(const std::vector<CrownPart>& parts, const CProgress& progress) {
        forEachTriangle(parts, progress, [this](const CrownPart& part, const std::uint32_t* corners) { drawTriangle(part, corners); });
    }

    /// In how many cells something else is seen than in another view of the same side.
    std::size_t countOther(const CCrownView& before) const {
        std::size_t count = 0;
        for (std::size_t cell = 0; cell < m_depths.size(); ++cell) count += m_depths[cell] != before.m_depths[cell];
        return count;
    }

    /// visit(pixel, place, facing) for what is seen in at most so many pixels, evenly chosen.
    template <typename Visit> void forEachSeen(std::size_t max, Visit&& visit) const {
        std::vector<std::pair<int, int>> pixels;
        for (int y = 0; y + kSamples <= m_side; y += kSamples)
            for (int x = 0; x + kSamples <= m_side; x += kSamples)
                if (forEachSample(x, y, [](std::size_t) {})) pixels.emplace_back(x, y);
        const std::size_t count = std::min(max, pixels.size());
        for (std::size_t i = 0; i < count; ++i) {
            const auto& [x, y] = pixels[evenly(i, count, pixels.size())];
            forEachSample(x, y, [&](std::size_t cell) { visit(i, placeOf(cell), m_facings[cell]); });
        }
    }
    /// What part of a disc around a place nothing hides from the viewer, as the viewport looks up its shadows (sunSeen() in kLightFunctions).
    float seenOf(const glm::dvec3& place, const glm::dvec3& normal) const {
        constexpr int kPoints = 8;
        const glm::dvec3 lift = kLift / m_perMetre * (m_viewer + (glm::dot(normal, m_viewer) < 0 ? -normal : normal)), p = m_toView * (place + lift - m_middle);
        const auto at = [&](double v) { return std::clamp(static_cast<int>(v), 0, m_side - 1); };
        int count = 0;
        for (int i = 0; i < kPoints; ++i) {
            const double out = std::sqrt((i + 0.5) / kPoints) * kDisc, turn = 2.3999632 * i; // a spiral
            const glm::dvec2 cell = glm::dvec2(p) * m_perMetre + m_side / 2.0 + out * glm::dvec2(std::cos(turn), std::sin(turn));
            count += p.z >= double(m_depths[cellAt(at(cell.x), at(cell.y))]);
        }
        return float(count) / kPoints;
    }

    static constexpr int kSamples = 2; ///< cells of a pixel, each way

private:
    /// visit(cell) for those of a pixel where something is seen; whether there are any.
    template <typename Visit> bool forEachSample(int x, int y, Visit&& visit) const {
        bool any = false;
        for (int i = 0; i < kSamples * kSamples; ++i) {
            const std::size_t cell = cellAt(x + i % kSamples, y + i / kSamples);
            if (!std::isfinite(m_depths[cell])) continue;
            any = true;
            visit(cell);
        }
        return any;
    }

    glm::dvec3 placeOf(std::size_t cell) const {
        const auto side = static_cast<std::size_t>(m_side);
        const glm::dvec3 seen((double(cell % side) + 0.5) / m_perMetre - m_side / (2 * m_perMetre), (double(cell / side) + 0.5) / m_perMetre - m_side / (2 * m_perMetre), m_depths[cell]);
        return m_middle + glm::transpose(m_toView) * seen;
    }

    void drawTriangle(const CrownPart& part, const std::uint32_t* corners) {
        const CMesh& mesh = *part.mesh;
        const std::array<glm::dvec3, 3> p = {seen(mesh.positions[corners[0]]), seen(mesh.positions[corners[1]]), seen(mesh.positions[corners[2]])};
        const auto nearest = static_cast<float>(std::max({p[0].z, p[1].z, p[2].z}));
        std::optional<Axes> axes;
        const int level = part.twig ? levelOf(mesh, corners, p[0], p[1], p[2]) : 0;
        rasterise(
            p[0], p[1], p[2], m_side, m_side,
            [&](int x, int y, double u, double v) {
                const std::size_t cell = cellAt(x, y);
                const auto depth = static_cast<float>((1 - u - v) * p[0].z + u * p[1].z + v * p[2].z);
                if (depth <= m_depths[cell]) return;
                const glm::vec2 at = part.cutOut() ? mixed(mesh.texCoords, corners, u, v) : glm::vec2(0);
                if ((part.leaf && !part.leaf->covers(at)) || (part.twig && !part.twig->shows(at))) return;
                m_depths[cell] = depth;
                if (m_facings.empty()) return;
                if (part.twig && !axes) axes = axesOf(mesh, corners);
                const glm::vec3 front = mixed(mesh.normals, corners, u, v);
                m_facings[cell] = part.twig ? facingOf(front, part.twig->at(at, level), *axes) : facingOf(front, {{0, 0, 1}}, {}, part.layer);
            },
            Farther{*this, nearest});
    }

    /// The cells where what is seen is farther away than `nearest`.
    struct Farther {
        const CCrownView& view;
        float nearest;
        bool any(int, int, int) const { return true; }
        template <typename Look> void forEach(int y, int x0, int x1, Look&& look) const {
            for (int x = x0; x <= x1; ++x)
                if (view.m_depths[view.cellAt(x, y)] < nearest) look(x);
        }
    };

    /// Of a card's front, what its picture shows there; of a leaf's, itself.
    Facing facingOf(const glm::vec3& front, const CTwigMask::Texel& shown, const Axes& axes, CrownLayer layer = CrownLayer::Leaf) const {
        if (shown.wood) layer = CrownLayer::Wood;
        const bool behind = glm::dot(glm::dvec3(front), m_viewer) < 0;
        const glm::vec3 normal = shown.normal.z * (behind ? -front : front) + shown.normal.x * axes.right + shown.normal.y * axes.along;
        return {normal / std::max(1e-6f, glm::length(normal)), !isWood(layer) && behind != shown.back, behind, layer};
    }

    /// Of the mask, that a card of so many pixels shows.
    static int levelOf(const CMesh& mesh, const std::uint32_t* corners, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
        const auto twice = [](const glm::dvec2& p, const glm::dvec2& q) { return std::abs(p.x * q.y - p.y * q.x); };
        const glm::dvec2 s = mesh.texCoords[corners[0]], t = mesh.texCoords[corners[1]], u = mesh.texCoords[corners[2]];
        const double cells = std::max(1e-9, twice(b - a, c - a)), texels = twice(t - s, u - s) * CTwigMask::kSide * CTwigMask::kSide;
        return static_cast<int>(std::lround(std::max(0.0, 0.5 * std::log2(texels / cells) + std::log2(double(kSamples)))));
    }

    std::vector<float> m_depths; ///< towards the viewer
    std::vector<Facing> m_facings;
};

/// The box around a tree: towards its middle less of the sky is seen, as in the viewport (skyVisibility in kTreeVertexShader).
class CRoom {
public:
    explicit CRoom(const std::vector<CrownPart>& parts) {
        Bounds box{glm::vec3(0), glm::vec3(0)};
        for (const CrownPart& part : parts)
            for (const glm::vec3& p : part.mesh->positions) box = {glm::min(box.min, p), glm::max(box.max, p)};
        m_middle = (box.min + box.max) / 2.0f;
        m_half = glm::max((box.max - box.min) / 2.0f, 1e-3f);
    }

    float skyVisibilityAt(const glm::dvec3& place) const {
        const glm::vec3 out = (glm::vec3(place) - m_middle) / m_half;
        return 0.35f + 0.65f * glm::smoothstep(0.05f, 1.0f, 0.8f * glm::length(out) + 0.25f * out.z);
    }

private:
    glm::vec3 m_middle, m_half;
};
} // namespace

double seenOverSeen(const std::vector<CrownPart>& one, const std::vector<CrownPart>& other, const std::vector<CrownPart>& hiding, const CrownFrame& frame,
                    double pixels, const CProgress& progress) {
    const int cells = static_cast<int>(std::clamp(CCrownView::kSamples * pixels, kViewCells / 2.0, 2.0 * kViewCells));
    std::array<std::size_t, kLookViews> ones{}, others{};
    forEachOf(kLookViews, progress, [&](std::size_t i) {
        CCrownView before(frame, sideOf(i, kLookViews), cells, false);
        before.draw(hiding, progress);
        const auto seenOf = [&](const std::vector<CrownPart>& parts) {
            CCrownView view = before;
            view.draw(parts, progress);
            return view.countOther(before);
        };
        ones[i] = seenOf(one);
        others[i] = seenOf(other);
    });
    const auto sum = [](const auto& counts) { return double(std::accumulate(counts.begin(), counts.end(), std::size_t{0})); };
    return sum(ones) / std::max(1.0, sum(others));
}

CrownLook crownLook(const std::vector<CrownPart>& parts, const CrownFrame& frame, double pixels, const CProgress& progress) {
    const glm::dvec3 sun = directionTo(0, kSunHeight);
    const int cells = static_cast<int>(std::clamp(CCrownView::kSamples * pixels, kViewCells / 2.0, 2.0 * kViewCells));
    CCrownView shadows(frame, sun, kSunCells, false);
    const CRoom room(parts);
    CrownLook look{glm::vec3(sun), std::vector<SeenPixel>(kSeenPixels)};
    const auto read = [&](const CCrownView& view, std::size_t side) {
        constexpr std::size_t kOfSide = kSeenPixels / kLookViews;
        const glm::vec3 toViewer(sideOf(side, kLookViews));
        view.forEachSeen(kOfSide, [&](std::size_t pixel, const glm::dvec3& place, const Facing& facing) {
            const float sunVisibility = shadows.seenOf(place, glm::dvec3(facing.normal));
            look.pixels[side * kOfSide + pixel].push_back({facing.normal, toViewer, sunVisibility, room.skyVisibilityAt(place), facing.back, facing.behind, facing.layer});
        });
    };
    constexpr std::size_t kAtOnce = 4; // for their memory
    for (std::size_t first = 0; first < kLookViews; first += kAtOnce) {
        std::vector<CCrownView> views;
        for (std::size_t i = 0; i < kAtOnce; ++i) views.emplace_back(frame, sideOf(first + i, kLookViews), cells);
        const std::size_t shadowsToo = first == 0 ? 1 : 0;
        forEachOf(kAtOnce + shadowsToo, progress, [&](std::size_t i) { (i < kAtOnce ? views[i] : shadows).draw(parts, progress); });
        forEachOf(kAtOnce, progress, [&](std::size_t i) { read(views[i], first + i); });
    }
    return look;
}

} // namespace stromar
