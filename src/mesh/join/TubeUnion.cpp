#include "join/TubeUnion.h"
#include "join/ShortestFill.h"
#include "join/SurfaceUnion.h"
#include "join/TurnOfLine.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <span>

namespace stromar {

namespace {
constexpr double kApartOfRadius = 0.02; // radii of the tube: points so near are one
constexpr double kStrip = 0.25;         // radii of the tube between the loops
constexpr double kFlatWall = 1e-7;      // twice the area of a triangle that is too flat, over its sides squared
constexpr double kTurned = 100;         // times: the cost of a triangle that looks inwards

using Index = CWoodPatch::Index;

/// How the loop is looked for: a narrower tube keeps off others.
struct Try {
    double width;                ///< over the tube's own
    bool startsInMiddle = false; ///< see CTubeLines
};
constexpr Try kTries[]{{1}, {0.7}, {0.4}, {1, true}};
/// How walls are moved to tell where they cross the wood: those that lie in each other cross anywhere.
struct SurfaceTry {
    double inset;                      ///< radii of the tube
    std::optional<double> starts = {}; ///< in the middle of what is drawn of the wood, so many radii of it further down
};
/// Between which walls: others that run through those of its parent make curves that cross themselves, and so do twigs of the tube.
struct Sides {
    bool parentAlone = false; ///< of the wood
    bool movesTwigs = false;  ///< as the tube's own walls
};
constexpr Sides kSides[]{{}, {.parentAlone = true}, {.movesTwigs = true}};
/// A tube's, for uniting as surfaces.
struct Walls {
    std::vector<CWoodPatch::Index> branch, base; ///< with all that grows on it; its lid in the wood
    std::vector<CWoodPatch::Index> parent;       ///< of the wood: those of the stem that it grows on
};
constexpr double kApartOnCurve = 0.3; // radii of the tube
constexpr double kSmoothTurn = 540;   // degrees: once around, and half as much for what is uneven
/// First those whose seams are the smoothest, as a rule.
constexpr SurfaceTry kSurfaceTries[]{{0.1},     {0.2},    {0.05},   {0.3},     {0.02},   {0.5},      {-0.02},  {-0.1},
                                     {0.02, 0}, {0.1, 0}, {0.3, 0}, {0.02, 3}, {0.1, 3}, {0.02, 12}, {0.1, 12}, {0.8}};

/// One tube and the wood it comes out of. Both are cut along a loop, the tube a little further up, and what lies between is filled.
class CTubeUnion {
public:
    CTubeUnion(const CTree& tree, std::span<const StemMesh> stems, const BranchTube& of, CTubeLines& lines, CWoodPatch& patch)
        : m_tree(tree), m_stems(stems), m_of(of), m_lines(lines), m_tube(lines.tube), m_patch(patch) {
        const auto sourceOf = [&](Index t) { return patch.vertices()[patch.triangles()[t].vertices[0]].value.source; };
        m_own = those(patch.selected(), [&](Index t) { return isOwn(sourceOf(t)); });
        patch.flood(those(patch.selected(), [&](Index t) { return isBelow(sourceOf(t)); }));
        m_below = those(patch.selected(), [&](Index t) { return patch.isMarked(t); });
    }

    /// False where the tube is part of the wood, or cannot be joined.
    bool make(const UnionMethod& method) {
        if (m_own.empty() || std::ranges::any_of(m_own, [&](Index t) { return m_patch.isMarked(t); })) return false;
        return method.by == UnionBy::Lines ? makeAlongLines(method) : makeOfSurfaces(method);
    }

private:
    bool makeAlongLines(const UnionMethod& method) {
        for (const Try& own : kTries) {
            if (own.startsInMiddle) {
                m_lines.startInMiddle();
                m_near.clear();
            }
            for (const Across across : {Across::Normals, Across::Wall}) {
                m_width = own.width;
                m_across = across;
                m_patch.mark();
                m_patch.markOnly(m_below);
                const bool leaves = findExits() && (method.effort != UnionEffort::Smooth || turnOfExits() <= kSmoothTurn);
                if (leaves && cutWood() && cutTube() && stitch() && m_patch.finish()) return true;
                m_patch.undo();
                if (!leaves) break;
            }
        }
        return false;
    }

    double turnOfExits() const {
        std::vector<glm::dvec3> line;
        for (const Exit& exit : std::span(m_exits).first(m_tube.points)) line.push_back(m_patch.place(exit.point));
        return turnOf(line);
    }

    /// Cuts wherever the walls cross, without a strip between: in the first way that makes a smooth seam, or the smoothest.
    bool makeOfSurfaces(const UnionMethod& method) {
        m_patch.flood(m_own);
        Walls walls{those(m_patch.selected(), [&](Index t) { return m_patch.isMarked(t); }),
                    those(m_own, [&](Index t) { return isOfBaseLid(m_patch.triangles()[t]); }),
                    those(m_below, [&](Index t) { return isOfParent(m_patch.triangles()[t]); })};
        std::size_t work = method.mostWork;
        for (const Sides& sides : std::span(kSides).first(method.effort == UnionEffort::All ? std::size(kSides) : 1))
            if (makeSmoothest(walls, sides, method.effort, work)) return true;
        return false;
    }

    bool makeSmoothest(const Walls& walls, const Sides& sides, UnionEffort effort, std::size_t& work) {
        const SurfaceTry* best = nullptr;
        std::size_t needed = 0;
        for (double least = std::numeric_limits<double>::infinity(); const SurfaceTry& own : kSurfaceTries) {
            if (work == 0) break;
            if (m_lines.isClone() && own.starts.value_or(0) > 0) continue; // it starts in the path it parts from
            const std::size_t before = work;
            const std::optional<double> turn = makeOfSurfaces(walls, sides, own, work);
            if (!turn) continue;
            if (*turn <= kSmoothTurn) return true;
            m_patch.undo();
            if (*turn < least) least = *turn, best = &own, needed = before - work + 1;
        }
        return best && effort != UnionEffort::Smooth && makeOfSurfaces(walls, sides, *best, needed);
    }

    /// By how many degrees the seam turns; none, and nothing is changed, where it cannot be made.
    std::optional<double> makeOfSurfaces(const Walls& walls, const Sides& sides, const SurfaceTry& own, std::size_t& work) {
        m_patch.mark();
        CrossingSurfaces surfaces{sides.parentAlone ? walls.parent : m_below, walls.branch, sides.movesTwigs ? walls.branch : m_own, walls.base,
                                  kApartOnCurve * m_lines.radius, own.inset * m_lines.radius};
        if (own.starts) surfaces.start = m_lines.middleOfWood(*own.starts);
        const std::optional<double> turn = uniteSurfaces(surfaces, work, m_patch);
        if (turn && m_patch.finish()) return turn;
        m_patch.undo();
        return {};
    }

    template <typename Is> static std::vector<Index> those(std::span<const Index> triangles, Is&& is) {
        std::vector<Index> chosen;
        std::ranges::copy_if(triangles, std::back_inserter(chosen), is);
        return chosen;
    }

    /// Whether a triangle is of the walls of the stem that the tube's grows on, or of a clone's stem.
    bool isOfParent(const CWoodPatch::Triangle& triangle) const {
        const std::uint32_t generation = m_of.generation - (m_lines.isClone() ? 0 : 1);
        return triangle.generation == generation && std::ranges::any_of(triangle.vertices, [&](Index v) {
            const VertexSource& source = m_patch.vertices()[v].value.source;
            return source.generation == generation && isBelow(source);
        });
    }

    bool isOfBaseLid(const CWoodPatch::Triangle& triangle) const {
        const MeshPlan& plan = m_stems[m_of.generation].plan;
        const std::uint32_t lid = plan.baseLidPoints(m_tube) + (m_tube.middleOfLid(true) ? 1 : 0);
        return std::ranges::all_of(triangle.vertices, [&](Index v) { return m_patch.vertices()[v].value.source.vertex >= m_tube.firstVertex + m_tube.vertices - lid; });
    }

    /// What the plane through two points of the loop is square to: the normals there, or the tube's wall between them.
    enum class Across { Normals, Wall };
    /// Where a line of the tube leaves the wood.
    struct Left {
        CWoodPatch::Crossing crossing;
        double along; ///< metres, of the line
        glm::dvec3 way;
    };
    struct Exit {
        Index point; ///< of the patch
        double along; ///< metres, of the line, as wide as the tube is
        glm::dvec3 way;
    };
    /// Points of the patch: one for each line, and those on the way to the next.
    struct Loop {
        std::vector<Index> points; ///< the first again at the end
        std::vector<std::vector<Index>> ways;

        /// From a line to the next; one point where both have the same.
        std::vector<Index> side(std::size_t i) const {
            std::vector<Index> side{points[i]};
            side.insert(side.end(), ways[i].begin(), ways[i].end());
            if (points[i + 1] != points[i]) side.push_back(points[i + 1]);
            return side;
        }
        /// Each point once.
        std::vector<Index> whole() const {
            std::vector<Index> all;
            for (std::size_t i = 0; i < ways.size(); ++i) {
                const std::vector<Index> own = side(i);
                all.insert(all.end(), own.begin(), own.end() - 1);
            }
            return all;
        }
    };

    bool isOwn(const VertexSource& source) const {
        return source.generation == m_of.generation && source.vertex >= m_tube.firstVertex && source.vertex < m_tube.firstVertex + m_tube.vertices;
    }

    /// Whether a vertex is of one of the stems that the tube's grows on, or of a path it may part from.
    bool isBelow(const VertexSource& source) const {
        if (source.generation > m_of.generation || isOwn(source)) return false;
        const std::uint32_t surface = surfaceOf(m_stems, source), stem = m_stems[source.generation].plan.tubes[surface].stem;
        if (source.generation == m_of.generation) return stem == m_tube.stem && m_stems[source.generation].plan.tubes[surface].path < m_tube.path; // not of its own clones
        const CStem& own = m_tree.generation(m_of.generation).stems[m_tube.stem];
        return &m_tree.ancestor(m_of.generation, own, m_of.generation - source.generation) == &m_tree.generation(source.generation).stems[stem];
    }

    double apart() const { return kApartOfRadius * m_lines.radius; }

    bool findExits() {
        std::vector<Left> all;
        for (std::uint32_t line = 0; line < m_tube.points; ++line) {
            auto left = leftBy(line, m_width);
            if (const auto whole = m_width < 1 && left ? leftBy(line, 1) : left; whole)
                left->along = whole->along;
            else
                return false;
            all.push_back(*left);
        }
        m_exits.clear();
        for (const Left& left : all) m_exits.push_back({m_patch.pointAt(left.crossing, apart()), left.along, left.way});
        m_exits.push_back(m_exits.front());
        return std::ranges::count(m_exits, CWoodPatch::kNone, &Exit::point) == 0;
    }

    /// Where a line leaves the wood for longer than for a radius of the tube.
    std::optional<Left> leftBy(std::uint32_t line, double width) {
        std::optional<Left> left;
        double along = 0;
        bool out = false;
        for (std::uint32_t r = 0; r < m_lines.rings(); ++r) {
            const glm::dvec3 low = r == 0 ? m_lines.base : m_lines.at(r - 1, line, width), way = m_lines.at(r, line, width) - low;
            const double length = glm::length(way);
            const glm::dvec3 beyond = CTubeLines::kBeyond * way;
            for (const CWoodPatch::Crossing& crossing : m_patch.crossings(low - beyond, low + way + beyond, nearBelow(r))) {
                const double place = along + std::clamp(crossing.share * (1 + 2 * CTubeLines::kBeyond) - CTubeLines::kBeyond, 0.0, 1.0) * length;
                if (out && place - left->along > m_lines.radius) break;
                if (crossing.leaves && !out) left = Left{crossing, place, way};
                out = crossing.leaves;
            }
            along += length;
            if (out && along - left->along > m_lines.radius) break;
        }
        return out ? left : std::nullopt;
    }

    /// The wood around the lines up to a ring, from the one before or the base.
    std::span<const Index> nearBelow(std::uint32_t ring) {
        for (auto r = static_cast<std::uint32_t>(m_near.size()); r <= ring; ++r) m_near.push_back(m_patch.near(m_lines.around(r)));
        return m_near[ring];
    }

    bool cutWood() {
        m_wood = {};
        for (const Exit& exit : m_exits) m_wood.points.push_back(exit.point);
        const auto upAt = [&](std::size_t i, bool wall) {
            if (wall) return glm::normalize(m_exits[i].way) + glm::normalize(m_exits[i + 1].way);
            return glm::normalize(m_patch.normalAt(m_wood.points[i])) + glm::normalize(m_patch.normalAt(m_wood.points[i + 1]));
        };
        const bool wall = m_across == Across::Wall;
        if (!close(m_wood, [&](std::size_t i) { return std::array{upAt(i, wall), upAt(i, !wall)}; })) return false;
        return m_patch.removeLeftOf(m_wood.whole(), m_of.generation, true);
    }

    bool cutTube() {
        m_patch.flood(m_own);
        m_edge = {};
        for (std::uint32_t line = 0; line < m_tube.points; ++line) {
            const auto place = m_lines.placeAt(line, std::max(m_exits[line].along, glm::distance(m_lines.base, m_lines.at(0, line))) + kStrip * m_lines.radius);
            m_edge.points.push_back(place ? m_patch.pointNear(*place, apart()) : CWoodPatch::kNone);
            if (m_edge.points.back() == CWoodPatch::kNone) return false;
        }
        m_edge.points.push_back(m_edge.points.front());
        const auto upAt = [&](std::size_t i) { return glm::normalize(m_patch.normalAt(m_edge.points[i])) + glm::normalize(m_patch.normalAt(m_edge.points[i + 1])); };
        if (!close(m_edge, [&](std::size_t i) { return std::array{upAt(i)}; })) return false;
        std::vector<Index> back = m_edge.whole();
        std::ranges::reverse(back);
        return m_patch.removeLeftOf(back, m_of.generation, false);
    }

    /// Cuts from each point of a loop to the next; the normals of the planes to do so are tried in turn.
    template <typename UpAt> bool close(Loop& loop, UpAt&& upAt) {
        std::vector<Index> closed;
        for (std::size_t i = 0; i + 1 < loop.points.size(); ++i) {
            const Index from = loop.points[i], to = loop.points[i + 1];
            std::vector<Index>& way = loop.ways.emplace_back();
            if (from == to) continue;
            std::vector<Index> kept = closed; // that must not be touched: the loop so far and what comes later
            kept.insert(kept.end(), loop.points.begin(), loop.points.end());
            std::erase_if(kept, [&](Index point) { return point == from || point == to; });
            if (std::ranges::count(closed, to) > 0 && i + 2 < loop.points.size()) return false;
            const auto ups = upAt(i);
            const bool made = std::ranges::any_of(ups, [&](const glm::dvec3& up) {
                way.clear();
                const glm::dvec3 across = glm::cross(m_patch.place(to) - m_patch.place(from), up);
                return glm::length(across) > 0 && m_patch.cut(from, to, glm::normalize(across), apart() / 2, kept, way);
            });
            if (!made) return false;
            way.pop_back(); // the next point
            closed.push_back(from);
            closed.insert(closed.end(), way.begin(), way.end());
        }
        return loop.whole().size() >= 3;
    }

    bool stitch() {
        for (std::size_t i = 0; i < m_tube.points; ++i)
            if (!fill(stripOf(i))) return false;
        return true;
    }

    /// Vertices around what lies between the two loops and two lines, counter-clockwise seen from outside; none where there are no two loops.
    std::vector<Index> stripOf(std::size_t i) {
        const std::vector<Index> lower = m_wood.side(i), top = topOf(m_edge.side(i));
        if (std::ranges::count(top, CWoodPatch::kNone) > 0) return {}; // a loop touches itself
        std::vector<double> along{0};
        for (std::size_t k = 1; k < lower.size(); ++k) along.push_back(along.back() + glm::distance(m_patch.place(lower[k - 1]), m_patch.place(lower[k])));
        const glm::dvec3 first = m_patch.place(m_edge.points[i]), last = m_patch.place(m_edge.points[i + 1]);
        std::vector<Index> strip;
        for (std::size_t k = 0; k < lower.size(); ++k) {
            const double share = along[k] > 0 ? along[k] / along.back() : 0;
            const double below = m_lines.barkPerMetre() * glm::distance(m_patch.place(lower[k]), glm::mix(first, last, share));
            strip.push_back(m_patch.addBetween(top.front(), top.back(), share, below, lower[k]));
        }
        strip.insert(strip.end(), top.rbegin(), top.rend());
        return strip;
    }

    /// The tube's vertices along its edge.
    std::vector<Index> topOf(const std::vector<Index>& side) const {
        if (side.size() == 1) return {m_patch.vertexAt(side[0])};
        std::vector<Index> top;
        for (std::size_t k = 0; k + 1 < side.size(); ++k) top.push_back(m_patch.vertexAt(side[k], side[k + 1], false));
        top.push_back(m_patch.vertexAt(side[side.size() - 2], side.back(), true));
        return top;
    }

    /// Triangles within a closed edge: those with the shortest sides that look outwards.
    bool fill(const std::vector<Index>& edge) {
        if (edge.size() < 3) return edge.size() == 2;
        return fillPolygon(
            edge.size(), [&](std::size_t a, std::size_t b, std::size_t c) { return costOf(edge[a], edge[b], edge[c]); },
            [&](std::size_t a, std::size_t b, std::size_t c) { m_patch.addTriangle({edge[a], edge[b], edge[c]}, m_of.generation); });
    }

    double costOf(Index a, Index b, Index c) const {
        const auto& vertices = m_patch.vertices();
        const auto place = [&](Index v) { return glm::dvec3(vertices[v].value.position); };
        const glm::dvec3 face = glm::cross(place(b) - place(a), place(c) - place(a));
        const double twice = glm::length(face), sides = glm::distance(place(a), place(b)) + glm::distance(place(b), place(c)) + glm::distance(place(c), place(a));
        if (!(twice > kFlatWall * sides * sides)) return std::numeric_limits<double>::infinity();
        const glm::dvec3 normal = glm::dvec3(vertices[a].value.normal + vertices[b].value.normal + vertices[c].value.normal);
        return sides * (glm::dot(face, normal) > 0 ? 1 : kTurned);
    }

    const CTree& m_tree;
    std::span<const StemMesh> m_stems;
    BranchTube m_of;
    CTubeLines& m_lines;
    const Tube& m_tube;
    CWoodPatch& m_patch;
    std::vector<Index> m_own, m_below; ///< triangles of the tube, and of what it grows on with all that is joined to it
    Across m_across = Across::Normals;
    double m_width = 1; ///< see Try
    std::vector<std::vector<Index>> m_near; ///< by ring: the wood around the lines below
    std::vector<Exit> m_exits; ///< by line, the first again at the end
    Loop m_wood, m_edge;       ///< of the wood and of the tube
};
} // namespace

bool unite(const CTree& tree, std::span<const StemMesh> stems, const BranchTube& tube, const UnionMethod& method, CTubeLines& lines, CWoodPatch& patch) {
    return CTubeUnion(tree, stems, tube, lines, patch).make(method);
}

} // namespace stromar
