#include "solid/WoodPieces.h"
#include "stem/PathSurface.h"
#include "stromar/util/Turn.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace stromar {

namespace {
constexpr int kAnglesPerRidge = 16;
constexpr int kMaxPieces = 400; // of a segment
constexpr double kCutReach = 2; // radii above a trunk's base: what is below it there is cut off

/// Cuts the paths of one generation.
class CWoodCutter {
public:
    CWoodCutter(const CTree& tree, std::size_t generation, const MeshParams& params, double thinnest, double longest)
        : m_generation(tree.generation(generation)), m_surface(tree, static_cast<int>(generation), params),
          m_path(m_generation, m_surface), m_trunk(generation == 0), m_thinnest(thinnest), m_longest(longest) {}

    void cut(std::vector<WoodPiece>& pieces) {
        for (const CStem& stem : m_generation.stems)
            for (std::uint32_t p = stem.firstPath; p < stem.firstPath + stem.pathCount; ++p)
                cutPath(stem, m_generation.paths[p], pieces);
    }

private:
    void cutPath(const CStem& stem, const CPath& path, std::vector<WoodPiece>& pieces) {
        m_path.start(stem, path, m_longest, m_surface.ridges() > 0);
        for (std::uint32_t s = path.firstSegment; s < path.firstSegment + path.segmentCount; ++s) {
            const CSegment& segment = m_generation.segments[s];
            const double arc = std::hypot(segment.length, kTurn * segment.turns * segment.helixRadius);
            const int count = static_cast<int>(std::clamp(std::ceil(arc / m_longest), 1.0, double(kMaxPieces)));
            for (int k = 0; k < count; ++k) add(s, double(k) / count, double(k + 1) / count, pieces);
        }
    }

    void add(std::uint32_t segment, double low, double high, std::vector<WoodPiece>& pieces) const {
        const CSegment& base = m_generation.segments[m_path.stem().firstSegment];
        const RingShape from = m_path.shapeAt(segment, low), to = m_path.shapeAt(segment, high);
        pieces.push_back({from.centre, to.centre, std::max(m_thinnest, from.radius), std::max(m_thinnest, to.radius), from.frame,
                          m_surface.ridges() > 0 ? outAt(from) : std::vector<float>(),
                          m_trunk && from.along < kCutReach * from.radius, base.position, base.frame[2]});
    }

    std::vector<float> outAt(const RingShape& ring) const {
        const int count = kAnglesPerRidge * m_surface.ridges();
        std::vector<float> out;
        for (int i = 0; i < count; ++i) {
            const double angle = kTurn * i / count;
            const glm::dvec3 point = m_path.pointAt(ring, angle, {std::cos(angle), std::sin(angle)});
            out.push_back(static_cast<float>(glm::distance(point, ring.centre) / ring.radius));
        }
        return out;
    }

    const CGeneration& m_generation;
    CStemSurface m_surface;
    CPathSurface m_path;
    bool m_trunk;
    double m_thinnest, m_longest;
};
} // namespace

double WoodPiece::distanceTo(const glm::dvec3& point) const {
    const glm::dvec3 along = to - from, off = point - from;
    const double length = glm::dot(along, along), t = length > 0 ? glm::dot(off, along) / length : 0;
    const double inside = std::clamp(t, 0.0, 1.0);
    double radius = radiusFrom + inside * (radiusTo - radiusFrom);
    if (!out.empty()) {
        const double turn = std::atan2(glm::dot(off, frame[1]), glm::dot(off, frame[0])) / kTurn;
        const double at = (turn - std::floor(turn)) * double(out.size());
        const auto i = static_cast<std::size_t>(at) % out.size();
        const double share = at - std::floor(at);
        radius *= (1 - share) * double(out[i]) + share * double(out[(i + 1) % out.size()]);
    }
    const double round = glm::distance(off, inside * along) - radius;
    return cut ? std::max(round, -glm::dot(point - base, up)) : round;
}

double WoodPiece::maxRadius() const {
    const double widest = out.empty() ? 1 : double(*std::ranges::max_element(out));
    return std::max(radiusFrom, radiusTo) * widest;
}

std::vector<WoodPiece> woodPiecesOf(const CTree& tree, const MeshParams& params, double thinnest, double longest) {
    std::vector<WoodPiece> pieces;
    for (std::size_t g = 0; g < tree.generationCount(); ++g) CWoodCutter(tree, g, params, thinnest, longest).cut(pieces);
    return pieces;
}

} // namespace stromar
