#include "stromar/mesh/twig/Twig.h"
#include "foliage/Foliage.h"
#include "foliage/LeafBlade.h"
#include "twig/LeafyTwigs.h"
#include "twig/StraightStem.h"
#include "stem/TubeWriter.h"
#include "stromar/util/Rasterise.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace stromar {

namespace {
constexpr double kFewestLeaves = 6; // of a large twig; most have half of them
constexpr double kMostLeaves = 60;   // likewise; more run into each other in a picture, as the leaflets of a palm's frond
constexpr double kDrawable = 1e5;    // of all twigs; more leaves than that are cards in any case
constexpr double kLongest = 32;     // large twig, in leaves' lengths; most have half of that
constexpr double kFlat = 0.35;       // spread out of the plane over that in it
constexpr double kMaxTilt = 0.9;    // radians between a leaf that is seen best and one in the picture
constexpr double kShowsBack = -0.25; // of a normal's z
constexpr double kMargin = 0.02;     // of the card, around what it shows
constexpr int kCells = 128;          // of the grid that measures what leaves cover, on a side
constexpr int kDirections = 24;      // from which that is measured
using std::numbers::pi;

std::vector<const CLeaf*> leavesAt(const TwigPlace& place, const CTree& tree, const COrgans& organs, double share) {
    std::vector<const CLeaf*> leaves;
    for (const CLeaf& leaf : organs.grown)
        if (leaf.generation == place.generation && leaf.stem == place.stem &&
            !hasFallen(tree.generation(place.generation).stems[place.stem], leaf.number, share))
            leaves.push_back(&leaf);
    return leaves;
}

/// The leaves' places across the stem: how far they spread along which direction.
struct Spread {
    double turn; ///< of the direction in which they spread least
    bool flat;
};

Spread spreadOf(const CStraightStem& stem, const std::vector<const CLeaf*>& leaves, double size) {
    double xx = 0, xy = 0, yy = 0, frontX = 0, frontY = 0;
    for (const CLeaf* leaf : leaves) {
        const Frame& f = stem.segments()[stem.segmentAt(stem.nearest(leaf->position))].frame;
        const auto add = [&](const glm::dvec3& way) {
            const double x = glm::dot(way, f[0]), y = glm::dot(way, f[1]);
            xx += x * x;
            xy += x * y;
            yy += y * y;
        };
        const glm::dvec3 axis = leaf->axis, normal = leaf->normal;
        add(size * leaf->length * axis);
        add(0.5 * size * leaf->width * glm::cross(axis, normal));
        frontX += glm::dot(normal, f[0]);
        frontY += glm::dot(normal, f[1]);
    }
    const double widest = 0.5 * std::atan2(2 * xy, xx - yy), mean = (xx + yy) / 2,
                 apart = std::hypot((xx - yy) / 2, xy);
    const double turn = widest + pi / 2;
    const bool behind = std::cos(turn) * frontX + std::sin(turn) * frontY < 0; // most leaves would show their backs
    return {behind ? turn + pi : turn, std::sqrt(std::max(0.0, mean - apart)) < kFlat * std::sqrt(mean + apart)};
}

/// A normal turned about its leaf's axis until the leaf is no longer seen edge-on, as in a pressed twig.
glm::dvec3 pressed(const glm::dvec3& axis, const glm::dvec3& normal) {
    const glm::dvec3 viewer(0, 0, 1), flat = viewer - axis.z * axis; // the normal that shows most of it
    const double seen = glm::length(flat), side = normal.z < kShowsBack ? -1 : 1;
    if (seen < 0.1) return normal;
    const glm::dvec3 best = side / seen * flat;
    const double angle = std::acos(glm::clamp(glm::dot(normal, best), -1.0, 1.0));
    if (angle <= kMaxTilt) return normal;
    const glm::dvec3 across = glm::cross(axis, best);
    const double tilt = glm::dot(normal, across) < 0 ? -kMaxTilt : kMaxTilt;
    return std::cos(tilt) * best + std::sin(tilt) * across;
}

enum class Leaves { AsGrown, Pressed };

/// A leaf as it stands on the straight stem.
CLeaf straight(const CStraightStem& stem, CLeaf leaf, Leaves how) {
    const double y = stem.nearest(leaf.position);
    const glm::dmat3 toCard = glm::transpose(stem.frameOf(stem.segmentAt(y)));
    leaf.position = toCard * (glm::dvec3(leaf.position) - stem.pointAt(y)) + glm::dvec3(0, y, 0);
    leaf.axis = toCard * glm::dvec3(leaf.axis);
    leaf.normal = toCard * glm::dvec3(leaf.normal);
    if (how == Leaves::Pressed) leaf.normal = pressed(leaf.axis, leaf.normal);
    return leaf;
}

/// Adds leaves of one form to a mesh.
void addLeaves(const CStraightStem& stem, const std::vector<const CLeaf*>& leaves, const LeafBlade& blade, double size, Leaves how, CMesh& mesh) {
    for (const CLeaf* leaf : leaves) {
        const CBladePlacer placer(straight(stem, *leaf, how), size);
        const auto first = static_cast<std::uint32_t>(mesh.vertexCount());
        for (const LeafBlade::Point& point : blade.points) {
            mesh.positions.push_back(glm::vec3(placer.place(point)));
            mesh.normals.push_back(glm::vec3(placer.normal(point)));
            mesh.texCoords.push_back(point.texCoord);
            mesh.looks.push_back({});
        }
        for (const std::uint32_t corner : blade.indices) mesh.indices.push_back(first + corner);
    }
}

using KindStarts = std::array<std::size_t, kLeafKinds + 1>; // as Twig::kinds

/// Kind by kind.
std::shared_ptr<CMesh> meshOf(const CStraightStem& stem, const CStem& own, const std::vector<const CLeaf*>& all, const MeshParams& params,
                              double size, Leaves how, KindStarts& starts) {
    const auto mesh = allocateMesh("leaves", Surface::Leaf, 0, 0);
    for (std::size_t kind = 0; kind < kLeafKinds; ++kind) {
        starts[kind] = mesh->indices.size();
        std::vector<const CLeaf*> leaves;
        std::ranges::copy_if(all, std::back_inserter(leaves), [&](const CLeaf* leaf) { return params.kindOf(own, leaf->number) == kind; });
        addLeaves(stem, leaves, makeBlade(params.formOf(kind), detailOf(Model::Full, 3)), size, how, *mesh);
    }
    starts[kLeafKinds] = mesh->indices.size();
    return mesh;
}

/// The half of the wood that is seen.
std::shared_ptr<const CMesh> straightWood(const CStraightStem& stem, double minRadius, Surface bark) {
    constexpr std::uint32_t kAcross = 5;
    const std::span<const CSegment> segments = stem.segments();
    const auto rings = static_cast<std::uint32_t>(segments.size()) + 1;
    const auto mesh =
        allocateMesh("wood", bark, std::size_t{rings} * kAcross, std::size_t{rings - 1} * (kAcross - 1) * 6);
    VertexSink sink = sinkAt(*mesh, 0);
    std::uint32_t* index = mesh->indices.data();
    for (std::uint32_t r = 0; r < rings; ++r) {
        const CSegment& segment = segments[std::min<std::size_t>(r, segments.size() - 1)];
        const bool tip = r == segments.size();
        const double radius = std::max(minRadius, tip ? segment.radiusEnd : segment.radiusBase);
        for (std::uint32_t i = 0; i < kAcross; ++i) {
            const double angle = pi * (1 - double(i) / (kAcross - 1));
            const glm::dvec3 out(std::cos(angle), 0, std::sin(angle));
            sink.add(radius * out + glm::dvec3(0, tip ? segment.end() : segment.start, 0), out, 0.5, 0.5, {});
            if (r == 0 || i == 0) continue;
            const std::uint32_t here = r * kAcross + i, below = here - kAcross;
            for (const std::uint32_t corner : {below - 1, below, here, below - 1, here, here - 1}) *index++ = corner;
        }
    }
    return mesh;
}

/// m² that triangles cover of what `view` maps their points to, between two corners.
template <typename View>
double coveredArea(const CMesh& mesh, const glm::dvec2& low, const glm::dvec2& high, View&& view) {
    std::vector<bool> covered(kCells * kCells);
    const auto cell = [&](std::size_t corner) {
        return (view(glm::dvec3(mesh.positions[mesh.indices[corner]])) - low) / (high - low) * double(kCells);
    };
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3)
        rasterise(cell(t), cell(t + 1), cell(t + 2), kCells, kCells,
                  [&](int x, int y, double, double) { covered[static_cast<std::size_t>(y * kCells + x)] = true; });
    return double(std::ranges::count(covered, true)) / double(covered.size()) * (high.x - low.x) * (high.y - low.y);
}

/// m² of a mesh that are seen, the mean over directions that are spread evenly.
double seenArea(const CMesh& mesh) {
    double sum = 0;
    for (int i = 0; i < kDirections; ++i) { // a spiral on half a sphere
        const double height = (i + 0.5) / kDirections, turn = i * pi * (3 - std::sqrt(5.0)), out = std::sqrt(1 - height * height);
        const Frame frame = transported({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {out * std::cos(turn), out * std::sin(turn), height});
        const auto view = [&](const glm::dvec3& p) { return glm::dvec2(glm::dot(frame[0], p), glm::dot(frame[1], p)); };
        glm::dvec2 low(1e30), high(-1e30);
        for (const glm::vec3& p : mesh.positions) {
            low = glm::min(low, view(p));
            high = glm::max(high, view(p));
        }
        sum += coveredArea(mesh, low, high, view);
    }
    return sum / kDirections;
}

/// A card as wide to the left as to the right, so that it turns about its stem.
void frame(Twig& twig) {
    const Bounds leaves = twig.leaves->bounds(), wood = twig.wood->bounds();
    const glm::vec3 low = glm::min(leaves.min, wood.min), high = glm::max(leaves.max, wood.max);
    const double half = std::max(std::abs(low.x), std::abs(high.x));
    const glm::dvec2 margin = kMargin * glm::dvec2(2 * half, double(high.y) - low.y);
    twig.low = glm::dvec2(-half, low.y) - margin;
    twig.high = glm::dvec2(half, high.y) + margin;
}
} // namespace

bool suitsCards(const TwigBound& twigs, const SeasonShare& season) {
    const double leaves = twigs.leaves * season.share;
    const bool toldApart = leaves <= kMostLeaves || leaves * twigs.stems > kDrawable;
    return season.size > 0 && leaves >= kFewestLeaves && toldApart && twigs.length <= kLongest * twigs.leafLength;
}

std::optional<TwigPlace> typicalOf(const StemSet& twigs, const CTree& tree, const COrgans& leaves, const MeshParams& params) {
    const std::vector<LeafyTwig> leafy = leafyTwigs(twigs, tree, leaves, params.seasonOf(Organ::Leaf).share);
    const auto count = double(leafy.size());
    const double total = leavesOn(leafy);
    double meanLength = 0;
    for (const LeafyTwig& twig : leafy) meanLength += twig.of(tree).length;
    meanLength /= std::max(1.0, count);
    std::optional<TwigPlace> best;
    double nearest = 0;
    for (const LeafyTwig& twig : leafy) {
        const CStem& stem = twig.of(tree);
        const double off = std::abs(twig.leaves * count / total - 1) + std::abs(stem.length / meanLength - 1) +
                           (stem.pathCount - 1); // rather one without clones
        if (best && off >= nearest) continue;
        nearest = off;
        best = {twig.generation, twig.stem};
    }
    return best;
}

std::shared_ptr<const Twig> twigAt(const TwigPlace& place, const StemSet& twigs, const CTree& tree, const COrgans& organs,
                                   const CrownOrgans& crown, const LeafMasks& masks, const MeshParams& params, const CProgress& progress) {
    const SeasonShare season = params.seasonOf(Organ::Leaf);
    const CGeneration& all = tree.generation(place.generation);
    const CStem& own = all.stems[place.stem];
    const std::vector<const CLeaf*> leaves = leavesAt(place, tree, organs, season.share);
    const Spread spread = spreadOf(CStraightStem(all, own, 0), leaves, season.size);
    const CStraightStem stem(all, own, spread.turn);
    auto twig = std::make_shared<Twig>();
    twig->leaves = meshOf(stem, own, leaves, params, season.size, Leaves::Pressed, twig->kinds);
    twig->wood = straightWood(stem, params.minRadius, barkOf(place.generation));
    twig->length = stem.length();
    twig->turn = spread.turn;
    twig->flat = spread.flat;
    for (std::size_t i = 1; i < stem.segments().size(); ++i)
        twig->bend += std::acos(
            glm::clamp(glm::dot(stem.segments()[i - 1].frame[2], stem.segments()[i].frame[2]), -1.0, 1.0));
    frame(*twig);
    twig->leafArea = twig->leaves->area() / double(leaves.size());
    twig->allLeafArea = leavesOn(leafyTwigs(twigs, tree, organs, season.share)) * twig->leafArea;
    twig->shownArea = coveredArea(*twig->leaves, twig->low, twig->high, [](const glm::dvec3& p) { return glm::dvec2(p); });
    KindStarts unused;
    twig->seenPerLeaf = seenArea(*meshOf(stem, own, leaves, params, season.size, Leaves::AsGrown, unused)) / double(leaves.size());
    twig->masks = masks;
    measureCrown(*twig, twigs, tree, crown, params, progress);
    return twig;
}

std::shared_ptr<const Twig> typicalTwig(const CTree& tree, const MeshParams& params, const CProgress& progress) {
    const auto& leaves = tree.organs(Organ::Leaf);
    const StemSet twigs = twigsOf(tree, *leaves);
    const auto place = typicalOf(twigs, tree, *leaves, params);
    return place ? twigAt(*place, twigs, tree, *leaves, {leaves, {}, {}}, {}, params, progress) : nullptr;
}

} // namespace stromar
