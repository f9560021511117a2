#include "join/SurfaceUnion.h"
#include "join/BoundsTree.h"
#include "join/Corners.h"
#include "join/SurfaceCutter.h"
#include "join/TurnOfLine.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace stromar {

namespace {
using Index = CWoodPatch::Index;
using Surface = CCrossingCurves::Surface;
using Facet = CCrossingCurves::Facet;
using Curve = CCrossingCurves::Curve;
using Curves = std::set<Index>;

constexpr std::size_t kMostTries = 8;         // curves to begin with
constexpr std::size_t kTrianglesPerWork = 50; // to find where they cross takes as long as cutting one of so many does
constexpr std::size_t kMeetingsPerWork = 20;  // likewise to look at so many edges and triangles
constexpr std::size_t kMostSamples = 100;     // triangles
constexpr double kMostSeen = 0.03;            // of their area, which may turn out to lie outside
constexpr double kSameDistance = 1e-6;        // over the distance
constexpr double kSliver = 2;                 // times what points on a curve are apart: across what may be left out

class CSurfaceUnion {
public:
    CSurfaceUnion(const CrossingSurfaces& surfaces, std::size_t& work, CWoodPatch& patch)
        : m_work(work), m_patch(patch), m_curves(surfaces, patch), m_cutter(m_curves, patch) {
        m_surfaceOf.resize(patch.triangles().size());
        for (const Index t : surfaces.wood) m_surfaceOf[t] = Surface::Wood;
        for (const Index t : surfaces.branch) m_surfaceOf[t] = Surface::Branch;
    }

    std::optional<double> make() {
        m_patch.keepWholes();
        take((m_curves.surfaces().wood.size() + m_curves.surfaces().branch.size()) / kTrianglesPerWork);
        const bool found = m_curves.find();
        take(m_curves.looked() / kMeetingsPerWork);
        if (!found) return {};
        if (!m_curves.meet()) return leaveOut() ? std::optional(0.0) : std::nullopt;
        Curves best = bestOf(together());
        if (best.empty()) best = bestOf(alone());
        if (best.empty() || neededOf(best) != best) return {};
        for (const Index t : m_inside) m_patch.remove(t);
        double turn = 0;
        for (const Index c : best) turn += turnOf(coarsened(m_curves.curves()[c]));
        leaveOutSlivers();
        return turn;
    }

private:
    void take(std::size_t work) { m_work -= std::min(m_work, work); }

    std::optional<Surface> surfaceOf(Index triangle) const {
        const Index whole = m_patch.triangles()[triangle].whole;
        return whole < m_surfaceOf.size() ? m_surfaceOf[whole] : std::nullopt;
    }

    /// Which curves may be cut together, as many as there are.
    std::set<Curves> together() const {
        std::set<Curves> all;
        for (Index c = 0; c < std::min<std::size_t>(m_curves.curves().size(), kMostTries); ++c)
            if (!m_curves.cross(c, c)) all.insert(withoutConflict(c));
        return all;
    }

    std::set<Curves> alone() const {
        std::set<Curves> all;
        for (Index c = 0; c < std::min<std::size_t>(m_curves.curves().size(), kMostTries); ++c)
            if (!m_curves.cross(c, c)) all.insert({c});
        return all;
    }

    /// Those that are needed of what bounds least of the branch; none where no choice will do.
    Curves bestOf(const std::set<Curves>& choices) {
        Curves best;
        double least = std::numeric_limits<double>::infinity();
        for (const Curves& curves : choices) {
            const auto needed = neededOf(curves);
            const double area = needed ? insideOfBranch() : least;
            if (area < least && isHidden(Surface::Branch) && isHidden(Surface::Wood)) least = area, best = *needed;
        }
        return best;
    }

    /// A curve and as many others as do not cross it, nor each other.
    Curves withoutConflict(Index first) const {
        Curves chosen{first};
        for (Index c = 0; c < m_curves.curves().size(); ++c)
            if (!m_curves.cross(c, c) &&
                std::ranges::none_of(chosen, [&](Index own) { return m_curves.cross(own, c); }))
                chosen.insert(c);
        return chosen;
    }

    /// Those curves that bound what lies inside, when these are cut; none where that cannot be told.
    std::optional<Curves> neededOf(const Curves& curves) {
        for (const Index c : curves) take(m_curves.curves()[c].segments.size());
        if (m_work == 0 || !m_cutter.cut(curves)) return {};
        m_curveAt.clear();
        m_outside.assign(m_patch.triangles().size(), false);
        for (const Index c : curves) {
            forEachEdge(c, [&](Index from, Index to) { return m_curveAt[edgeOf(from, to)] = c, true; });
            if (!forEachSide(c, [&](Index, Index outer) { return m_outside[outer] = true; })) return {};
        }
        std::vector<Index> base;
        for (const Index t : m_curves.surfaces().base) std::ranges::copy(m_cutter.partsOf(t), std::back_inserter(base));
        if (auto needed = findInside(base)) return needed;
        for (const Index c : curves) { // wood that is thinner than the base
            if (!crossesBase(c)) continue;
            std::vector<Index> seeds;
            forEachSide(c, [&](Index inner, Index) { return seeds.push_back(inner), true; });
            if (auto needed = findInside(seeds)) return needed;
        }
        std::vector<Index> seeds; // of a base that comes out of the wood
        for (const Index c : curves) forEachSide(c, [&](Index inner, Index) { return seeds.push_back(inner), true; });
        return findInside(seeds);
    }

    bool crossesBase(Index curve) const {
        return std::ranges::any_of(m_curves.curves()[curve].segments, [&](Index segment) {
            return std::ranges::count(m_curves.surfaces().base, m_curves.segments()[segment].in(Surface::Branch)) > 0;
        });
    }

    /// Which curves bound what lies inside and hangs together with some triangles.
    std::optional<Curves> findInside(std::span<const Index> seeds) {
        m_inside.clear();
        m_isInside.assign(m_patch.triangles().size(), false);
        Curves found, done;
        bool bound = std::ranges::all_of(seeds, [&](Index seed) { return addInside(seed, found); });
        while (bound && done.size() < found.size()) {
            const Index c = *std::ranges::find_if(found, [&](Index own) { return !done.contains(own); });
            done.insert(c);
            bound = forEachSide(c, [&](Index inner, Index) { return addInside(inner, found); });
        }
        take(m_inside.size() / kTrianglesPerWork);
        return bound && !found.empty() ? std::optional(found) : std::nullopt;
    }

    /// False at the patch's border, and outside of a curve.
    bool addInside(Index seed, Curves& curves) {
        std::vector<Index> open{seed};
        while (!open.empty()) {
            const Index t = open.back();
            open.pop_back();
            if (t == CWoodPatch::kNone || !surfaceOf(t) || m_outside[t]) return false;
            if (m_isInside[t]) continue;
            m_isInside[t] = true;
            m_inside.push_back(t);
            const auto corners = m_curves.cornersOf(t);
            const bool isPart = m_patch.triangles()[t].whole != t; // only these are at curves
            for (std::uint32_t c = 0; c < 3; ++c) {
                const auto curve =
                    isPart ? m_curveAt.find(edgeOf(corners[c], corners[after(c)])) : m_curveAt.end();
                if (curve != m_curveAt.end())
                    curves.insert(curve->second);
                else
                    open.push_back(m_patch.beyond({t, c}));
            }
        }
        return true;
    }

    static std::uint64_t edgeOf(Index one, Index other) {
        return std::uint64_t{std::min(one, other)} << 32 | std::max(one, other);
    }

    /// work(from, to) for the points of each edge of a curve, as long as it returns true.
    template <typename Do>
    bool forEachEdge(Index curve, Do&& work) const {
        const std::vector<Index>& nodes = m_curves.curves()[curve].nodes;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (!work(m_cutter.pointOf(nodes[i]), m_cutter.pointOf(nodes[(i + 1) % nodes.size()]))) return false;
        return true;
    }

    /// work(inner, outer) for the triangles of both surfaces beside each edge of a curve: that inside the other
    /// surface, and the other one.
    template <typename Do>
    bool forEachSide(Index curve, Do&& work) const {
        return forEachEdge(curve, [&](Index from, Index to) {
            return std::ranges::all_of(std::array{Surface::Wood, Surface::Branch}, [&](Surface surface) {
                const bool onLeft = surface == Surface::Branch;
                const Index left = triangleAt(from, to, surface), right = triangleAt(to, from, surface);
                return left != CWoodPatch::kNone && right != CWoodPatch::kNone &&
                       work(onLeft ? left : right, onLeft ? right : left);
            });
        });
    }

    /// Of a surface, to the left of an edge.
    Index triangleAt(Index from, Index to, Surface surface) const {
        Index found = CWoodPatch::kNone;
        m_patch.forEachAround(from, [&](Index t) {
            const auto& corners = m_curves.cornersOf(t);
            for (std::uint32_t c = 0; c < 3; ++c)
                if (corners[c] == from && corners[after(c)] == to && surfaceOf(t) == surface) found = t;
        });
        return found;
    }

    double areaOf(Index triangle) const {
        const auto [a, b, c] = m_curves.cornersOf(triangle);
        return glm::length(glm::cross(m_patch.place(b) - m_patch.place(a), m_patch.place(c) - m_patch.place(a))) / 2;
    }

    double insideOfBranch() const {
        double area = 0;
        for (const Index t : m_inside)
            if (surfaceOf(t) == Surface::Branch) area += areaOf(t);
        return area;
    }

    /// Leaves out nodes that are nearer to the last one than triangles should be small; the places of the others.
    std::vector<glm::dvec3> coarsened(const Curve& curve) {
        Index last = m_cutter.pointOf(curve.nodes[0]);
        std::vector<glm::dvec3> seam{m_patch.place(last)};
        for (std::size_t i = 1, left = curve.nodes.size(); i < curve.nodes.size(); ++i) {
            const Index own = m_cutter.pointOf(curve.nodes[i]);
            const bool near =
                left > 3 && glm::distance(m_patch.place(own), m_patch.place(last)) < m_curves.surfaces().apart;
            if (near && m_patch.collapse(own, last))
                --left;
            else
                seam.emplace_back(m_patch.place(last = own));
        }
        return seam;
    }

    /// Between curves a piece of both surfaces may be left that hangs together with nothing else.
    void leaveOutSlivers() {
        std::unordered_set<Index> known; // of larger pieces
        for (Index t = 0; t < m_patch.triangles().size(); ++t) {
            if (!m_patch.triangles()[t].isNew || m_patch.triangles()[t].removed || known.contains(t)) continue;
            const std::vector<Index> piece = smallPieceOf(t, known);
            for (const Index own : piece) m_patch.remove(own);
        }
    }

    /// All that hangs together with a triangle; nothing where that goes further than a sliver does, and those looked at are known then.
    std::vector<Index> smallPieceOf(Index seed, std::unordered_set<Index>& known) const {
        std::vector<Index> piece{seed};
        std::unordered_set<Index> found{seed};
        bool small = true;
        for (std::size_t i = 0; small && i < piece.size(); ++i) {
            small = glm::distance(m_patch.place(m_curves.cornersOf(piece[i])[0]), m_patch.place(m_curves.cornersOf(seed)[0])) < kSliver * m_curves.surfaces().apart;
            for (std::uint32_t c = 0; small && c < 3; ++c) {
                const Index next = m_patch.beyond({piece[i], c});
                small = next != CWoodPatch::kNone && !known.contains(next);
                if (small && found.insert(next).second) piece.push_back(next);
            }
        }
        if (small) return piece;
        known.insert(piece.begin(), piece.end());
        return {};
    }

    /// Whether what was found inside of one surface is there, as far as some of its triangles tell: not where curves
    /// that are left uncut cross it.
    bool isHidden(Surface surface) const {
        std::vector<Index> own;
        Bounds around = kNowhere;
        for (const Index t : m_inside) {
            if (surfaceOf(t) != surface) continue;
            own.push_back(t);
            for (const Index point : m_curves.cornersOf(t)) include(around, glm::vec3(m_curves.placeOf(point)));
        }
        std::vector<Facet> near;
        std::ranges::copy_if(m_curves.facets(surface == Surface::Branch ? Surface::Wood : Surface::Branch),
                             std::back_inserter(near), [&](const Facet& facet) { return touch(facet.bounds, around); });
        double all = 0, seen = 0;
        for (std::size_t i = 0; i < own.size(); i += own.size() / kMostSamples + 1) {
            const auto [a, b, c] = m_curves.cornersOf(own[i]);
            all += areaOf(own[i]);
            if (isOutside((m_curves.placeOf(a) + m_curves.placeOf(b) + m_curves.placeOf(c)) / 3.0, near))
                seen += areaOf(own[i]);
        }
        return seen <= kMostSeen * all;
    }

    /// On which side of the nearest of some triangles a place lies: of the steepest, where several are as near.
    static bool isOutside(const glm::dvec3& place, std::span<const Facet> facets) {
        double least = std::numeric_limits<double>::infinity(), side = 1;
        for (const Facet& facet : facets) {
            const double far = least * (1 + kSameDistance) + facet.radius;
            const glm::dvec3 toMiddle = place - facet.middle;
            if (glm::dot(toMiddle, toMiddle) > far * far * (1 + kSameDistance)) continue;
            const glm::dvec3 way =
                place - nearestOnTriangle(place, facet.corners[0], facet.corners[1], facet.corners[2]);
            const double distance = glm::length(way), own = glm::dot(facet.normal, way);
            if (distance > least * (1 + kSameDistance)) continue;
            if (distance < least * (1 - kSameDistance) || std::abs(own) > std::abs(side)) side = own;
            least = std::min(least, distance);
        }
        return side > 0;
    }

    /// The branch, where it lies in the wood as a whole.
    bool leaveOut() {
        const std::vector<Facet> wood = m_curves.allOfWood();
        for (const Facet& facet : m_curves.facets(Surface::Branch))
            for (std::uint32_t c = 0; c < 3; ++c) {
                const Index next = m_patch.beyond({facet.triangle, c});
                if (next == CWoodPatch::kNone || surfaceOf(next) != Surface::Branch ||
                    isOutside(facet.corners[c], wood))
                    return false;
            }
        for (const Index t : m_curves.surfaces().branch) m_patch.remove(t);
        return true;
    }

    std::size_t& m_work;
    CWoodPatch& m_patch;
    CCrossingCurves m_curves;
    CSurfaceCutter m_cutter;
    std::vector<std::optional<Surface>> m_surfaceOf;     ///< by whole triangle
    std::unordered_map<std::uint64_t, Index> m_curveAt;  ///< by edge
    std::vector<Index> m_inside;                         ///< triangles
    std::vector<std::uint8_t> m_isInside, m_outside;     ///< by triangle; beside curves
};
} // namespace

std::optional<double> uniteSurfaces(const CrossingSurfaces& surfaces, std::size_t& work, CWoodPatch& patch) {
    return CSurfaceUnion(surfaces, work, patch).make();
}

} // namespace stromar
