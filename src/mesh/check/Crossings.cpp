#include "stromar/mesh/check/Crossings.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tuple>
#include <vector>

namespace stromar {

namespace {
constexpr double kInsideParent = 1.5; // of its radius: how far a stem is within its parent
constexpr int kPiecesPerTurn = 8;     // of a helix
constexpr double kLeastCell = 0.02;   // metres
constexpr double kCellsPerPiece = 48; // that the longest may reach through

/// Where a stem comes in the tree.
struct StemName {
    std::uint32_t generation, stem;
    auto operator<=>(const StemName&) const = default;
};

/// A straight round piece of a stem.
struct Piece {
    glm::dvec3 from, to;
    double radius;
    StemName of;
    std::int32_t parent;
};

/// The shortest distance between two lines from end to end (Ericson, Real-Time Collision Detection, 5.1.9).
double distanceBetween(const Piece& a, const Piece& b) {
    const glm::dvec3 u = a.to - a.from, v = b.to - b.from, w = a.from - b.from;
    const double uu = glm::dot(u, u), vv = glm::dot(v, v), uv = glm::dot(u, v), uw = glm::dot(u, w), vw = glm::dot(v, w);
    const double parallel = uu * vv - uv * uv;
    double s = parallel > 1e-18 ? glm::clamp((uv * vw - uw * vv) / parallel, 0.0, 1.0) : 0;
    const double t = vv > 0 ? glm::clamp((uv * s + vw) / vv, 0.0, 1.0) : 0;
    if (uu > 0) s = glm::clamp((uv * t - uw) / uu, 0.0, 1.0);
    return glm::distance(a.from + s * u, b.from + t * v);
}

/// The pieces of a tree's stems, where they are outside of their parents.
class CPieces {
public:
    explicit CPieces(const CTree& tree) {
        for (std::uint32_t g = 0; g < tree.generationCount(); ++g) {
            const CGeneration& all = tree.generation(g);
            for (std::uint32_t s = 0; s < all.stems.size(); ++s) add(all, {g, s});
        }
    }
    std::vector<Piece> pieces;

private:
    void add(const CGeneration& all, StemName name) {
        const CStem& stem = all.stems[name.stem];
        const double free = kInsideParent * stem.parentRadius;
        for (std::uint32_t i = stem.firstSegment; i < stem.firstSegment + stem.segmentCount; ++i) {
            const CSegment& segment = all.segments[i];
            const int count = segment.helixRadius > 0 ? kPiecesPerTurn : 1;
            for (int k = 0; k < count; ++k) {
                const double outside = segment.length > 0 ? (free - segment.start) / segment.length : 1;
                const double low = std::max(double(k) / count, outside), high = double(k + 1) / count;
                if (low >= high) continue;
                const double radius = glm::mix(segment.radiusBase, segment.radiusEnd, (low + high) / 2);
                pieces.push_back({segment.centre(low), segment.centre(high), radius, name, stem.parent});
            }
        }
    }
};

bool isChild(const Piece& child, const Piece& parent) {
    return child.of.generation == parent.of.generation + 1 && child.parent == static_cast<std::int32_t>(parent.of.stem);
}

bool cross(const Piece& a, const Piece& b) {
    return a.of != b.of && !isChild(a, b) && !isChild(b, a) && distanceBetween(a, b) < a.radius + b.radius;
}

/// A piece in one of the cells of a grid that it may touch.
struct InCell {
    std::int64_t x, y, z;
    std::uint32_t piece;
    auto operator<=>(const InCell&) const = default;
    bool sameCell(const InCell& other) const { return std::tie(x, y, z) == std::tie(other.x, other.y, other.z); }
};

std::vector<InCell> sortedIntoCells(const std::vector<Piece>& pieces, const CProgress& progress) {
    double mean = 0, largest = 0;
    for (const Piece& piece : pieces) {
        const double own = glm::distance(piece.from, piece.to) + 2 * piece.radius;
        mean += own / double(pieces.size());
        largest = std::max(largest, own);
    }
    const double size = std::max({mean, largest / kCellsPerPiece, kLeastCell});
    std::vector<InCell> cells;
    for (std::uint32_t p = 0; p < pieces.size(); ++p) {
        progress.poll();
        const Piece& piece = pieces[p];
        const glm::dvec3 low = glm::floor((glm::min(piece.from, piece.to) - piece.radius) / size);
        const glm::dvec3 high = glm::floor((glm::max(piece.from, piece.to) + piece.radius) / size);
        for (double x = low.x; x <= high.x; ++x)
            for (double y = low.y; y <= high.y; ++y)
                for (double z = low.z; z <= high.z; ++z)
                    cells.push_back({std::int64_t(x), std::int64_t(y), std::int64_t(z), p});
    }
    std::ranges::sort(cells);
    return cells;
}
} // namespace

std::size_t countCrossings(const CTree& tree, const CProgress& progress) {
    const std::vector<Piece> pieces = CPieces(tree).pieces;
    const std::vector<InCell> cells = sortedIntoCells(pieces, progress);
    std::vector<std::pair<StemName, StemName>> pairs;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        progress.poll();
        for (std::size_t j = i + 1; j < cells.size() && cells[j].sameCell(cells[i]); ++j) {
            const Piece &a = pieces[cells[i].piece], &b = pieces[cells[j].piece];
            if (cross(a, b)) pairs.push_back(std::minmax(a.of, b.of));
        }
    }
    std::ranges::sort(pairs);
    return static_cast<std::size_t>(std::unique(pairs.begin(), pairs.end()) - pairs.begin());
}

} // namespace stromar
