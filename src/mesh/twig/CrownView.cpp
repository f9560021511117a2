#include "twig/CrownView.h"
#include "foliage/Foliage.h"
#include "foliage/LeafBlade.h"
#include "stromar/util/Parallel.h"
#include "stromar/util/Random.h"
#include "stromar/util/Rasterise.h"
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

namespace stromar {

namespace {
constexpr int kViewCells = 512, kSunCells = 2048;
constexpr std::size_t kSeenPixels = 1024, kLookViews = 4, kCoverViews = 8; // sparse crowns cover a twentieth more or less from one side than from another
constexpr double kHeight = 5 * std::numbers::pi / 180, kSunHeight = 51 * std::numbers::pi / 180;
constexpr double kLift = 1.5, kDisc = 2.5; // cells of the sun's view: by which a leaf is lifted out of its own shadow; that shadows are soft over, a radius

glm::dvec3 directionTo(double turn, double height) {
    return {std::cos(height) * std::cos(turn), std::cos(height) * std::sin(turn), std::sin(height)};
}

/// Across, up, to the viewer.
glm::dmat3 frameTo(const glm::dvec3& viewer) {
    const glm::dvec3 across = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), viewer));
    return {across, glm::cross(viewer, across), viewer};
}

/// What is seen in a cell.
struct Facing {
    glm::vec3 normal{0}; ///< of the side that is seen
    bool back = false;   ///< it is a leaf's under side
    bool behind = false; ///< of the leaf or the card
    bool wood = false;
};

/// The derivatives of places by a triangle's texture coordinates, unit.
struct Axes {
    glm::vec3 right, along;
};
Axes axesOf(const CMesh& mesh, const std::uint32_t* corners) {
    const auto place = [&](int i) { return mesh.positions[corners[i]]; };
    const glm::vec2 d1 = mesh.texCoords[corners[1]] - mesh.texCoords[corners[0]], d2 = mesh.texCoords[corners[2]] - mesh.texCoords[corners[0]];
    const glm::vec3 e1 = place(1) - place(0), e2 = place(2) - place(0);
    const float side = d1.x * d2.y - d1.y * d2.x < 0 ? -1.0f : 1.0f;
    const auto unit = [](const glm::vec3& v) { return v / std::max(1e-20f, glm::length(v)); };
    return {unit(side * (d2.y * e1 - d1.y * e2)), unit(side * (d1.x * e2 - d2.x * e1))};
}

/// How a crown lies on the square grid of a view.
class CCrownGrid {
public:
    CCrownGrid(const CrownFrame& crown, const glm::dvec3& viewer, int cells)
        : m_middle(crown.middle), m_toView(glm::transpose(frameTo(viewer))), m_viewer(viewer), m_perMetre(cells / (2 * crown.radius)), m_side(cells) {}

protected:
    /// On the grid; z, metres towards the viewer.
    glm::dvec3 seen(const glm::vec3& place) const {
        const glm::dvec3 p = m_toView * (glm::dvec3(place) - m_middle);
        return {glm::dvec2(p) * m_perMetre + m_side / 2.0, p.z};
    }
    std::size_t cellAt(int x, int y) const { return static_cast<std::size_t>(y * m_side + x); }
    std::size_t cellCount() const { return static_cast<std::size_t>(m_side) * static_cast<std::size_t>(m_side); }

    template <typename Draw> static void forEachTriangle(const std::vector<CrownPart>& parts, const CProgress& progress, Draw&& draw) {
        constexpr std::size_t kBetweenPolls = 30'000;
        for (const CrownPart& part : parts)
            for (std::size_t t = 0; t + 2 < part.mesh->indices.size(); t += 3) {
                if (t % kBetweenPolls == 0) progress.poll();
                draw(part, &part.mesh->indices[t]);
            }
    }

    glm::dvec3 m_middle;
    glm::dmat3 m_toView;
    glm::dvec3 m_viewer;
    double m_perMetre;
    int m_side;
};

/// The mean of a triangle's values by the weights of its second and third corner.
template <typename Values> auto mixed(const Values& values, const std::uint32_t* corners, double u, double v) {
    return float(1 - u - v) * values[corners[0]] + float(u) * values[corners[1]] + float(v) * values[corners[2]];
}

/// Cells of a square grid, a bit for each: those that are covered, most of them many times over, are passed by in words.
class CCellSet {
public:
    explicit CCellSet(int side) : m_words((static_cast<std::size_t>(side) + kBits - 1) / kBits), m_bits(m_words * static_cast<std::size_t>(side)) {}

    void add(int x, int y) { wordAt(x, y) |= std::uint64_t{1} << (static_cast<std::size_t>(x) % kBits); }
    std::size_t count() const {
        std::size_t sum = 0;
        for (const std::uint64_t word : m_bits) sum += static_cast<std::size_t>(std::popcount(word));
        return sum;
    }
    /// visit(x) for the cells x0..x1 of a row that are not in it, each once.
    template <typename Visit> void forEachMissing(int y, int x0, int x1, Visit&& visit) const {
        for (int first = x0; first <= x1;) {
            const auto bit = static_cast<std::size_t>(first) % kBits;
            const int count = std::min(x1 - first + 1, static_cast<int>(kBits - bit));
            const std::uint64_t wanted = (~std::uint64_t{0} >> (kBits - static_cast<std::size_t>(count))) << bit;
            for (std::uint64_t missing = wanted & ~wordAt(first, y); missing; missing &= missing - 1)
                visit(first - static_cast<int>(bit) + std::countr_zero(missing));
            first += count;
        }
    }

private:
    static constexpr std::size_t kBits = 64;

    std::size_t placeOf(int x, int y) const { return static_cast<std::size_t>(y) * m_words + static_cast<std::size_t>(x) / kBits; }
    const std::uint64_t& wordAt(int x, int y) const { return m_bits[placeOf(x, y)]; }
    std::uint64_t& wordAt(int x, int y) { return m_bits[placeOf(x, y)]; }

    std::size_t m_words; ///< of a row
    std::vector<std::uint64_t> m_bits;
};

/// Which cells a crown covers from one side: much cheaper than what is seen there.
class CCrownOutline : CCrownGrid {
public:
    CCrownOutline(const CrownFrame& crown, const glm::dvec3& viewer, int cells, double pixels)
        : CCrownGrid(crown, viewer, cells), m_covered(cells), m_pixelsPerCell(pixels / cells) {}

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
                    if (!cutOut || shows(*cutOut, mixed(mesh.texCoords, corners, u, v), *soft, x, y, corners[0])) m_covered.add(x, y);
                },
                [&](int y, int x0, int x1, auto&& look) { m_covered.forEachMissing(y, x0, x1, look); });
        });
    }

    double count() const { return double(m_covered.count()); }

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

    CCellSet m_covered;
    double m_pixelsPerCell;
};

/// A crown from one side, without perspective: how near it is, and, where that is wanted, how it faces.
class CCrownView : CCrownGrid {
public:
    CCrownView(const CrownFrame& crown, const glm::dvec3& viewer, int cells, bool facings = true)
        : CCrownGrid(crown, viewer, cells), m_depths(cellCount(), -std::numeric_limits<float>::infinity()), m_facings(facings ? cellCount() : 0) {}

    void draw(const std::vector<CrownPart>& parts, const CProgress& progress) {
        forEachTriangle(parts, progress, [this](const CrownPart& part, const std::uint32_t* corners) { drawTriangle(part, corners); });
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
    /// What part of a disc around a place nothing hides from the viewer, as viewports look up their shadows.
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
                const glm::vec2 at = part.isWood() ? glm::vec2(0) : mixed(mesh.texCoords, corners, u, v);
                if ((part.leaf && !part.leaf->covers(at)) || (part.twig && !part.twig->shows(at))) return;
                m_depths[cell] = depth;
                if (m_facings.empty()) return;
                if (part.twig && !axes) axes = axesOf(mesh, corners);
                m_facings[cell] = facingOf(mixed(mesh.normals, corners, u, v), part.twig ? part.twig->at(at, level) : CTwigMask::Texel{{0, 0, 1}, false, part.isWood()}, axes);
            },
            [&](int y, int x0, int x1, auto&& look) {
                for (int x = x0; x <= x1; ++x)
                    if (m_depths[cellAt(x, y)] < nearest) look(x);
            });
    }

    /// Of a card's front, what its picture shows there; of a leaf's, itself.
    Facing facingOf(const glm::vec3& front, const CTwigMask::Texel& shown, const std::optional<Axes>& axes) const {
        const bool behind = glm::dot(glm::dvec3(front), m_viewer) < 0;
        glm::vec3 normal = shown.normal.z * (behind ? -front : front);
        if (axes) normal += shown.normal.x * axes->right + shown.normal.y * axes->along;
        return {normal / std::max(1e-6f, glm::length(normal)), !shown.wood && behind != shown.back, behind, shown.wood};
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

/// To the viewers of so many sides.
glm::dvec3 sideOf(std::size_t i, std::size_t count) { return directionTo(2 * std::numbers::pi * (double(i) + 0.5) / double(count), kHeight); }

/// work(i) for each, in parallel.
template <typename Work> void forEachOf(std::size_t count, const CProgress& progress, Work&& work) {
    parallelFor(
        count, 1,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) work(i);
        },
        progress);
}
} // namespace

double pixelsOf(const CrownFrame& frame, double height, const Detail& detail) {
    return kScreenHeight * kScreenCoverage[static_cast<std::size_t>(detail.lod) - 1] * 2 * frame.radius / std::max(height, 0.01 * frame.radius);
}

double crownCover(const std::vector<CrownPart>& parts, const CrownFrame& frame, double pixels, const CProgress& progress) {
    constexpr double kPerPixel = 1.25;
    const int cells = static_cast<int>(std::clamp(kPerPixel * pixels, kViewCells / 2.0, double(kViewCells)));
    std::array<double, kCoverViews> covered{};
    forEachOf(kCoverViews, progress, [&](std::size_t i) {
        CCrownOutline outline(frame, sideOf(i, kCoverViews), cells, pixels);
        outline.draw(parts, progress);
        covered[i] = outline.count();
    });
    return std::accumulate(covered.begin(), covered.end(), 0.0) / (double(kCoverViews) * cells * cells);
}

namespace {
/// The box around a tree: towards its middle less of the sky is seen, as in the viewport.
class CRoom {
public:
    explicit CRoom(const std::vector<CrownPart>& parts) {
        Bounds box{glm::vec3(0), glm::vec3(0)};
        for (const CrownPart& part : parts) box = {glm::min(box.min, part.mesh->bounds().min), glm::max(box.max, part.mesh->bounds().max)};
        m_middle = (box.min + box.max) / 2.0f;
        m_half = glm::max((box.max - box.min) / 2.0f, 1e-3f);
    }

    float openAt(const glm::dvec3& place) const {
        const glm::vec3 out = (glm::vec3(place) - m_middle) / m_half;
        return 0.35f + 0.65f * glm::smoothstep(0.05f, 1.0f, 0.8f * glm::length(out) + 0.25f * out.z);
    }

private:
    glm::vec3 m_middle, m_half;
};
} // namespace

CrownLook crownLook(const std::vector<CrownPart>& parts, const CrownFrame& frame, double pixels, const CProgress& progress) {
    const glm::dvec3 sun = directionTo(0, kSunHeight);
    const int cells = static_cast<int>(std::clamp(CCrownView::kSamples * pixels, kViewCells / 2.0, 2.0 * kViewCells));
    std::vector<CCrownView> views{CCrownView(frame, sun, kSunCells, false)};
    for (std::size_t i = 0; i < kLookViews; ++i) views.emplace_back(frame, sideOf(i, kLookViews), cells);
    forEachOf(views.size(), progress, [&](std::size_t i) { views[i].draw(parts, progress); });
    const CRoom room(parts);
    constexpr std::size_t kOfSide = kSeenPixels / kLookViews;
    CrownLook look{glm::vec3(sun), std::vector<SeenPixel>(kSeenPixels)};
    forEachOf(kLookViews, progress, [&](std::size_t i) {
        const glm::vec3 toViewer(sideOf(i, kLookViews));
        views[i + 1].forEachSeen(kOfSide, [&](std::size_t pixel, const glm::dvec3& place, const Facing& facing) {
            const float sunny = views.front().seenOf(place, glm::dvec3(facing.normal));
            look.pixels[i * kOfSide + pixel].push_back({facing.normal, toViewer, sunny, room.openAt(place), facing.back, facing.behind, facing.wood});
        });
    });
    return look;
}

namespace {
constexpr std::size_t kMaxVertices = 2'000'000; // of leaves: those of a file may have 20,000 each

/// Keeps at most so many, evenly chosen; which part of them.
double thin(std::vector<std::uint32_t>& all, std::size_t max) {
    const std::size_t total = all.size(), count = std::clamp<std::size_t>(max, 1, total);
    for (std::size_t i = 0; i < count; ++i) all[i] = all[evenly(i, count, total)];
    all.resize(count);
    return double(count) / double(total);
}

std::size_t verticesOf(const OrganMeshes& meshes) {
    std::size_t sum = 0;
    for (const auto& mesh : meshes) sum += mesh->vertexCount();
    return sum;
}
} // namespace

std::vector<CrownPart> leafParts(const std::shared_ptr<const COrgans>& leaves, const StemSet* stems, double present, const CTree& tree,
                                 const MeshParams& params, const LeafMasks& masks, const Detail& detail, const CProgress& progress) {
    const SeasonShare season = params.seasonOf(Organ::Leaf);
    std::array<std::vector<std::uint32_t>, kLeafKinds> shown;
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < leaves->grown.size(); ++i) {
        const CLeaf& leaf = leaves->grown[i];
        const CStem& stem = tree.generation(leaf.generation).stems[leaf.stem];
        if ((stems && !stems->has(leaf.generation, leaf.stem)) || hasFallen(stem, leaf.number, season.share)) continue;
        shown[params.kindOf(stem, leaf.number)].push_back(i);
        ++count;
    }
    const Rounding rounding = roundingOf(tree, *leaves, params.leaf);
    const CrownShade shade = shadeOf(tree, *leaves, params.sunAndShade);
    const auto kinds = static_cast<std::size_t>(std::ranges::count_if(shown, [](const auto& own) { return !own.empty(); }));
    std::vector<CrownPart> parts;
    for (std::size_t kind = 0; kind < kLeafKinds; ++kind) {
        if (shown[kind].empty()) continue;
        LeafBlade blade = makeBlade(params.formOf(kind), detail);
        const double part = thin(shown[kind], kMaxVertices / kinds / blade.points.size());
        const double growth = season.size * std::sqrt(present / std::max(1.0, double(count)) / part);
        const COrganMesh own(Organ::Leaf, kind, std::move(blade), leaves, std::move(shown[kind]), growth, rounding, shade);
        parts.push_back({own.expanded(progress), &masks[kind]});
    }
    return parts;
}

std::vector<CrownPart> partsOf(const OrganMeshes& leaves, const LeafMasks& masks, const CProgress& progress) {
    std::vector<CrownPart> parts;
    if (verticesOf(leaves) > kMaxVertices) return parts;
    for (const auto& mesh : leaves)
        if (mesh->count() > 0) parts.push_back({mesh->expanded(progress), &masks[mesh->kind()]});
    return parts;
}

OrganMeshes fittingLeaves(const OrganMeshes& thinned, const std::shared_ptr<const COrgans>& all, const CTree& tree, const LeafMasks& masks,
                          const MeshParams& params, const Detail& detail, const CProgress& progress) {
    const double present = double(all->grown.size()) * params.seasonOf(Organ::Leaf).share;
    if (present < 1 || double(all->grown.size()) > kMeasuredLeaves || verticesOf(thinned) > kMaxVertices) return thinned;
    const std::vector<CrownPart> whole = leafParts(all, nullptr, present, tree, params, masks, detailOf(Model::Full), progress);
    if (whole.empty()) return thinned;
    Bounds box = whole.front().mesh->bounds();
    for (const CrownPart& part : whole) box = {glm::min(box.min, part.mesh->bounds().min), glm::max(box.max, part.mesh->bounds().max)};
    const CrownFrame frame{glm::dvec3(box.min + box.max) / 2.0, 0.55 * glm::length(glm::dvec3(box.max - box.min))}; // with room for larger leaves
    const double pixels = pixelsOf(frame, tree.height(), detail);
    const auto resized = [&](double fit) {
        OrganMeshes sized;
        for (const auto& mesh : thinned) sized.push_back(mesh->resized(std::sqrt(fit)));
        return sized;
    };
    const CrownFit fit = fitTo(crownCover(whole, frame, pixels, progress), 1, [&](double areas) {
        return crownCover(partsOf(resized(areas), masks, progress), frame, pixels, progress);
    });
    return resized(fit.areas);
}

} // namespace stromar
