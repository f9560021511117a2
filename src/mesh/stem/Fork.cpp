#include "stem/Fork.h"
#include "stromar/util/Turn.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace stromar {

namespace {
constexpr double kLeastApart = 0.1; // radii from their middle that limbs have to part within their room
constexpr double kRoom = 0.75;      // of the way to a limb's next fork or tip: how high the saddle may lie
constexpr double kClearRoom = 0.9;  // likewise the first ring that is the path's own
constexpr double kFill = 0.15;      // radii that valleys lie outside of the line where the surfaces meet
constexpr double kApartOfMany = 1.3; // radii from their middle where three or more limbs have parted
constexpr double kLeastWidth = 0.1;  // radii from the middle to a valley below the saddle, where limbs part and near again
constexpr double kWearsOff = 1.5, kWearsOffOfMany = 3; // exponents: how fast what fills a valley fades around a ring, to nothing halfway round; of two limbs, and of more
constexpr double kClear = 0.4;      // radii between the saddle and that ring, at least
constexpr double kLeastAside = 0.4; // of the mean way of limbs from their middle: between all others a branch has no side of its own
constexpr double kLeastFacing = 0.05; // cosine between a lid's triangles and it
// Of branches: the sine of half the turn of one, or of the path beside it, beyond which it rather grows out of the side: 74 degrees; beyond
// 35 degrees a single one does where the segments are not so many times longer than its bend.
constexpr double kSharpestTurn = 0.6, kNarrow = 0.3, kLeastRoom = 1.6;
constexpr double kSteepestHelix = 0.7; // tangent of the angle between a helix and its axis
constexpr double kUnlimited = std::numeric_limits<double>::infinity();
constexpr double kLeastDrawn = 2; // times what single precision shows: between points
constexpr int kForkHalvings = 12;

glm::dvec2 directionOf(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Whether the paths of a helix, each of which turns its own way, leave a fork along its axis.
bool isGentle(const CSegment& helix) { return kTurn * helix.turns * helix.helixRadius < kSteepestHelix * helix.length; }

/// The angle plus whole turns that is nearest to another.
double nearest(double angle, double to) { return angle + kTurn * std::round((to - angle) / kTurn); }
} // namespace

LidShape lidOf(std::span<const glm::dvec3> line) {
    LidShape lid{glm::dvec3(0), glm::dvec3(0)};
    for (const glm::dvec3& corner : line) lid.middle += corner / double(line.size());
    for (std::size_t i = 0; i < line.size(); ++i) lid.normal += glm::cross(line[i] - lid.middle, line[(i + 1) % line.size()] - lid.middle);
    const double length = glm::length(lid.normal);
    lid.normal = length > 0 ? lid.normal / length : glm::dvec3(0, 0, 1);
    return lid;
}

std::vector<std::uint32_t> LimbLayout::boundary() const {
    std::vector<std::uint32_t> all;
    for (std::uint32_t r = rings - 1; r > 0; --r) all.push_back(firstOf(r));
    for (std::uint32_t i = 0; i <= share; ++i) all.push_back(i);
    for (std::uint32_t r = 1; r + 1 < rings; ++r) all.push_back(firstOf(r) + points);
    return all;
}

void CForkMaker::start(const CStem& stem, std::uint32_t path, double maxTurn, bool lobed) {
    m_stem = &stem;
    m_path = path;
    m_maxTurn = maxTurn;
    m_lobed = lobed;
    m_baseStarted = false;
}

std::optional<ForkNode> CForkMaker::nodeAt(std::uint32_t segment, double reach) const {
    const CStem& stem = *m_stem;
    const CPath& own = m_generation.paths[stem.firstPath + m_path];
    const std::uint32_t position = segment - own.firstSegment + own.firstPosition;
    ForkNode node{{m_path}, {}, segment - 1, reach};
    for (std::uint32_t p = m_path + 1; p < stem.pathCount; ++p) {
        const CPath& clone = m_generation.paths[stem.firstPath + p];
        if (clone.source == static_cast<std::int32_t>(m_path) && clone.firstPosition == position) node.paths.push_back(p);
    }
    if (m_nodes && stem.pathCount == 1) {
        node.branches = m_nodes->at(static_cast<std::uint32_t>(&stem - m_generation.stems.data()), position - 1);
        if (!node.branches.empty() && !addReach(segment, node)) node.branches.clear();
    }
    const CSegment& below = m_generation.segments[node.segmentBelow];
    if (below.helixRadius > 0) node.reach = isGentle(below) ? CCentreLine::reachBelowFork(below.length, m_surface.woodRadius(stem, below, 1), 0) : 0;
    if (node.limbs() < 2 || node.reach <= 0) return {};
    return node;
}

/// As among the paths of a fork: by the one that turns most. False where a branch rather grows out of the side.
bool CForkMaker::addReach(std::uint32_t segment, ForkNode& node) const {
    const CSegment &below = m_generation.segments[node.segmentBelow], &above = m_generation.segments[segment];
    const CGeneration& branches = m_tree.generation(m_number + 1);
    const double radius = m_surface.woodRadius(*m_stem, above, 0);
    double sine = CCentreLine::halfSine(below.frame[2], above.frame[2]), room = std::min(below.length, above.length);
    for (const std::uint32_t b : node.branches) {
        const CSegment& first = branches.segments[branches.stems[b].firstSegment];
        sine = std::max(sine, CCentreLine::halfSine(below.frame[2], first.frame[2]));
        room = std::min(room, first.length);
    }
    const bool needsRoom = node.branches.size() == 1 && sine > kNarrow;
    if (sine > kSharpestTurn || (needsRoom && room < kLeastRoom * CCentreLine::reachBelowFork(kUnlimited, radius, sine))) return false;
    node.reach = std::max(node.reach, CCentreLine::reachBelowFork(below.length, radius, sine));
    return true;
}

std::optional<ForkRings> CForkMaker::make(const ForkNode& node, std::uint32_t points) {
    m_points = points;
    if (points < node.limbs() || !startLimbs(node)) return {};
    const double top = alongWhereApart(isPair() ? 1 + kFill : kApartOfMany);
    const std::vector<double> alongs = levels(top);
    if (!standApart(alongs)) return {};
    clearLimbs(top, std::max(kClear * m_common.radius, top - (alongs.size() > 1 ? alongs[alongs.size() - 2] : m_common.along)));
    ForkRings rings;
    addCommonRing(rings);
    for (std::size_t l = 0; l < alongs.size(); ++l)
        addLevel(levelAt(alongs[l]), double(l + 1) / double(alongs.size()), rings);
    for (std::size_t i = 0; i < m_limbs.size(); ++i) {
        ForkLimb& made = rings.limbs[i];
        made.along.push_back(m_limbs[i].clear);
        made.seam = static_cast<std::int32_t>(std::lround(m_limbs[i].left / kTurn * points)) - m_limbs[i].turned;
        if (made.isBranch && !canBeClosed(made)) return {};
    }
    return rings;
}

/// And each limb's share of it.
void CForkMaker::addCommonRing(ForkRings& rings) const {
    for (std::uint32_t i = 0; i <= m_points; ++i) {
        const double angle = kTurn * (i % m_points) / m_points;
        rings.common.push_back({glm::vec3(m_base.pointAt(m_common, angle, directionOf(angle))),
                                glm::vec3(m_base.normalAt(m_common, angle, directionOf(angle))),
                                static_cast<float>(i) / static_cast<float>(m_points), static_cast<float>(m_common.along), 0});
    }
    for (const Limb& limb : m_limbs) {
        ForkLimb made{.isBranch = limb.bend.has_value(), .number = limb.number, .share = limb.share, .points = {}, .along = {m_common.along}, .turned = limb.turned};
        for (std::uint32_t i = 0; i <= limb.share; ++i) {
            made.points.push_back(rings.common[(limb.first + i) % m_points]);
            made.points.back().turn = static_cast<float>(static_cast<std::int32_t>(limb.first + i) - limb.turned) / static_cast<float>(m_points);
        }
        rings.limbs.push_back(std::move(made));
    }
}

/// Where their own rings start, so much above the saddle.
void CForkMaker::clearLimbs(double top, double step) {
    for (Limb& limb : m_limbs) {
        limb.clear = std::min(top + step, m_common.along + kClearRoom * (limb.limit - m_common.along));
        if (!limb.bend) continue;
        limb.clear = std::max(limb.clear, limb.bend->end());
        limb.turned = limb.bend->turnTo(*limb.surface, limb.clear, m_points);
    }
}

/// Once for all forks of a path: it takes time linear in its segments.
void CForkMaker::startBase() {
    if (!m_baseStarted) m_base.start(*m_stem, m_generation.paths[m_stem->firstPath + m_path], m_maxTurn, m_lobed);
    m_baseStarted = true;
}

/// False when they have no room to part.
bool CForkMaker::startLimbs(const ForkNode& node) {
    const double end = m_generation.segments[node.segmentBelow].end(), foot = end - node.reach;
    m_limbs.clear();
    startBase();
    for (const std::uint32_t p : node.paths) {
        const CPath& path = m_generation.paths[m_stem->firstPath + p];
        Limb& limb = m_limbs.emplace_back(Limb{.number = p, .limit = limitOf(m_generation, m_number, *m_stem, path, end)});
        if (p == m_path) continue;
        limb.surface.emplace(m_generation, m_surface);
        limb.surface->start(*m_stem, path, m_maxTurn, m_lobed);
    }
    m_common = m_base.shapeAt(foot);
    if (!startBranches(node, foot)) return false;
    m_limit = std::numeric_limits<double>::infinity();
    for (const Limb& limb : m_limbs) m_limit = std::min(m_limit, foot + kRoom * (limb.limit - foot));
    const Level top = levelAt(m_limit);
    return top.apart >= kLeastApart && (node.branches.empty() || allStandAside(top)) && shareOut(top);
}

bool CForkMaker::startBranches(const ForkNode& node, double foot) {
    if (node.branches.empty()) return true;
    const CGeneration& branches = m_tree.generation(m_number + 1);
    for (const std::uint32_t b : node.branches) {
        const CStem& branch = branches.stems[b];
        const CPath& path = branches.paths[branch.firstPath];
        const CSegment& first = branches.segments[path.firstSegment];
        const double limit = branch.offset + limitOf(branches, m_number + 1, branch, path, 0);
        const double bends = CCentreLine::reachAboveFork(first.length, m_branchSurface->woodRadius(branch, first, 0),
                                                         CCentreLine::halfSine(m_common.frame[2], first.frame[2]));
        const double above = std::min(bends, foot + kClearRoom * (limit - foot) - branch.offset);
        if (!(above > 0)) return false;
        Limb& limb = m_limbs.emplace_back(Limb{.number = b, .limit = limit, .bend = CBranchBend(branch, first, m_common, node.reach, above)});
        limb.surface.emplace(branches, *m_branchSurface);
        limb.surface->start(branch, path, m_branchSurface->turnOf(branch, m_detail.maxTurn), false);
    }
    return true;
}

bool CForkMaker::allStandAside(const Level& top) const {
    return std::ranges::all_of(top.rings, [&](const RingShape& ring) {
        return isPair() || glm::distance(ring.centre, top.middle) >= kLeastAside * top.apart * top.radius;
    });
}

/// The next fork of the path takes at most the upper half of the segment below it.
double CForkMaker::limitOf(const CGeneration& generation, std::size_t number, const CStem& stem, const CPath& path, double from) const {
    const CNodes nodes(m_tree, number);
    const auto parts = [&, s = static_cast<std::uint32_t>(&stem - generation.stems.data())](std::uint32_t segment) {
        return m_nodes && stem.pathCount == 1 && !nodes.at(s, segment).empty();
    };
    const std::span<const CSegment> segments = generation.segmentsOf(path);
    const auto first = std::ranges::lower_bound(segments, from, {}, &CSegment::start) - segments.begin();
    for (auto i = static_cast<std::uint32_t>(first); i < segments.size(); ++i)
        if (segments[i].forks || parts(i)) return segments[i].start + segments[i].length / 2;
    return segments.back().end();
}

/// Whether a lid about the middle of what bounds a limb's walls does not fold.
bool CForkMaker::canBeClosed(const ForkLimb& limb) const {
    std::vector<glm::dvec3> corners;
    for (const std::uint32_t i : LimbLayout{m_points, limb.share, limb.rings()}.boundary())
        corners.emplace_back(limb.points[i].position);
    const LidShape lid = lidOf(corners);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 face = glm::cross(corners[i] - lid.middle, corners[(i + 1) % corners.size()] - lid.middle);
        if (!(glm::dot(face, lid.normal) > kLeastFacing * glm::length(face))) return false;
    }
    return true;
}

/// Gives each limb the points of the common ring that lie to its side; false when one would have none.
bool CForkMaker::shareOut(const Level& top) {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < m_limbs.size(); ++i) {
        const glm::dvec3 aside = top.rings[i].centre - top.middle;
        const double azimuth = std::atan2(glm::dot(aside, top.frame[1]), glm::dot(aside, top.frame[0]));
        order.emplace_back(azimuth < 0 ? azimuth + kTurn : azimuth, i);
    }
    std::ranges::sort(order);
    std::vector<Limb> sorted;
    for (const auto& [azimuth, i] : order) {
        sorted.push_back(std::move(m_limbs[i]));
        sorted.back().azimuth = azimuth;
    }
    m_limbs = std::move(sorted);
    const auto points = static_cast<long>(m_points);
    std::vector<long> ends; // one for two neighbours, however it is rounded
    for (std::size_t i = 0; i < m_limbs.size(); ++i) {
        const double own = m_limbs[i].azimuth, after = m_limbs[next(i)].azimuth + (next(i) == 0 ? kTurn : 0);
        const double wide = top.rings[order[i].second].radius, narrow = top.rings[order[next(i)].second].radius;
        ends.push_back(std::lround((own + (after - own) * wide / (wide + narrow)) / kTurn * m_points));
    }
    for (std::size_t i = 1; i < ends.size(); ++i) ends[i] = std::max(ends[i], ends[i - 1] + 1);
    ends.back() = std::min(ends.back(), ends.front() - 1 + points);
    for (std::size_t i = ends.size() - 1; i-- > 1;) ends[i] = std::min(ends[i], ends[i + 1] - 1);
    for (std::size_t i = 0; i < m_limbs.size(); ++i) {
        Limb& limb = m_limbs[i];
        const long first = i > 0 ? ends[i - 1] : ends.back() - points, share = ends[i] - first;
        if (share < 1) return false;
        limb.first = static_cast<std::uint32_t>((first + points) % points);
        limb.share = static_cast<std::uint32_t>(share);
        limb.left = kTurn * limb.first / m_points;
        limb.right = limb.left + kTurn * limb.share / m_points;
    }
    return true;
}

CForkMaker::Level CForkMaker::levelAt(double along) const {
    Level level{along, 0, 0, glm::dvec3(0), m_common.frame, {}};
    const auto count = double(m_limbs.size());
    double radius = 0, weights = 0;
    glm::dvec3 axis(0);
    for (const Limb& limb : m_limbs) {
        const RingShape& ring = level.rings.emplace_back(shapeAt(limb, along));
        level.middle += ring.centre / ring.radius;
        weights += 1 / ring.radius;
        radius += ring.radius / count;
        axis += ring.frame[2];
    }
    level.middle /= weights;
    if (glm::length(axis) > 1e-6) level.frame = transported(m_common.frame, glm::normalize(axis));
    for (const RingShape& ring : level.rings)
        level.apart += glm::distance(ring.centre, level.middle) / (count * radius);
    level.radius = radius;
    return level;
}

/// The place along the stem, or the limit.
double CForkMaker::alongWhereApart(double apart) const {
    if (levelAt(m_limit).apart <= apart) return m_limit;
    double low = m_common.along, high = m_limit;
    for (int halving = 0; halving < kForkHalvings; ++halving) {
        const double middle = (low + high) / 2;
        (levelAt(middle).apart < apart ? low : high) = middle;
    }
    return high;
}

/// Where rings stand up to the saddle: between evenly along the stem, for its bends, and evenly by angle about two limbs,
/// where these are round.
std::vector<double> CForkMaker::levels(double top) const {
    constexpr double kPointsPerLevel = 4, kSpacing = 24;
    const double bySize = m_points / kPointsPerLevel, byLength = (top - m_common.along) * m_points / (kSpacing * m_common.radius);
    const int count = static_cast<int>(std::clamp(std::max(bySize, byLength), 1.0, kMaxLevels));
    const double apart = levelAt(top).apart;
    std::vector<double> alongs;
    for (int l = 1; l < count; ++l) {
        const double share = double(l) / count, evenly = m_common.along + share * (top - m_common.along);
        alongs.push_back((evenly + alongWhereApart(apart * (isPair() ? std::sin(kTurn / 4 * share) : share))) / 2);
    }
    alongs.push_back(top);
    return alongs;
}

/// Whether the points of rings at these places are told apart in single precision.
bool CForkMaker::standApart(const std::vector<double>& alongs) const {
    const double least = kLeastDrawn * CStemSurface::minDrawn(*m_stem, m_generation.segments[m_stem->firstSegment]);
    double gap = kTurn * m_common.radius / m_points, below = m_common.along;
    for (const double along : alongs) {
        gap = std::min(gap, along - below);
        below = along;
    }
    return gap > least;
}

/// To the right of each limb, where the surfaces of neighbours meet; at the top all are one. `share`: 1 there.
std::vector<glm::dvec3> CForkMaker::valleysAt(const Level& level, double share) const {
    std::vector<glm::dvec3> valleys;
    for (std::size_t i = 0; i < m_limbs.size(); ++i) {
        const double gap = m_limbs[next(i)].azimuth - m_limbs[i].azimuth + (next(i) == 0 ? kTurn : 0);
        const double apart = level.apart / (1 + kFill), aside = apart * std::sin(gap / 2);
        const double out = apart * std::cos(gap / 2) + std::sqrt(std::max(0.0, 1 - aside * aside));
        const double onRing = kTurn * (m_limbs[i].first + m_limbs[i].share) / m_points;
        const double exact = nearest(m_limbs[i].azimuth + gap / 2, onRing);
        const glm::dvec2 at = directionOf(onRing + share * (exact - onRing));
        const double narrowed = share == 1 ? 0 : level.radius * std::max(kLeastWidth * (1 - share), out) * (isPair() ? 1 : std::sqrt(1 - share * share));
        valleys.push_back(level.middle + narrowed * (at.x * level.frame[0] + at.y * level.frame[1]));
    }
    return valleys;
}

/// Follows the valleys beside each limb around it.
void CForkMaker::turnTo(const Level& level, const std::vector<glm::dvec3>& valleys, bool top) {
    for (std::size_t i = 0; i < m_limbs.size(); ++i) {
        Limb& limb = m_limbs[next(i)];
        const auto angleOf = [&](std::size_t l, const glm::dvec3& valley) {
            const RingShape& ring = level.rings[l];
            const glm::dvec3 out = valley - ring.centre;
            return std::atan2(glm::dot(out, ring.frame[1]), glm::dot(out, ring.frame[0]));
        };
        limb.left = nearest(angleOf(next(i), valleys[i]), limb.left);
        m_limbs[i].right = nearest(angleOf(i, valleys[i]), m_limbs[i].right);
    }
    if (top)
        for (Limb& limb : m_limbs) limb.right = limb.left + kTurn;
}

void CForkMaker::addLevel(const Level& level, double share, ForkRings& rings) {
    const bool top = share == 1;
    const std::vector<glm::dvec3> places = valleysAt(level, share);
    turnTo(level, places, top);
    std::vector<Valley> valleys;
    for (std::size_t i = 0; i < m_limbs.size(); ++i) valleys.push_back(valleyAt(level, i, places[i], top));
    for (std::size_t i = 0; i < m_limbs.size(); ++i)
        addRing(level, next(i), valleys[i], valleys[next(i)], rings.limbs[next(i)]);
}

/// To the right of a limb; its normal is the mean of the surfaces' that meet there.
CForkMaker::Valley CForkMaker::valleyAt(const Level& level, std::size_t limb, const glm::dvec3& position, bool top) const {
    const auto normalOf = [&](std::size_t l, double angle) {
        return surfaceOf(m_limbs[l]).normalAt(level.rings[l], angle, directionOf(angle));
    };
    const glm::dvec3 own = normalOf(limb, m_limbs[limb].right), other = normalOf(next(limb), m_limbs[next(limb)].left);
    const glm::dvec3 sum = top ? level.frame[2] : own + other;
    return {position, glm::length(sum) > 1e-3 ? glm::normalize(sum) : level.frame[2], (1 - glm::dot(own, other)) / 2};
}

/// From valley to valley around a limb; what the valleys lie off its surface wears off between them.
void CForkMaker::addRing(const Level& level, std::size_t l, const Valley& left, const Valley& right,
                         ForkLimb& made) const {
    const Limb& limb = m_limbs[l];
    const RingShape& ring = level.rings[l];
    const auto pointAt = [&](double angle) { return surfaceOf(limb).pointAt(ring, angle, directionOf(angle)); };
    const glm::dvec3 leftOff = left.position - pointAt(limb.left), rightOff = right.position - pointAt(limb.right);
    const double wearsOff = isPair() ? kWearsOff : kWearsOffOfMany;
    for (std::uint32_t i = 0; i <= m_points; ++i) {
        const double share = double(i) / m_points, angle = limb.left + share * (limb.right - limb.left);
        const double toLeft = std::pow(std::max(0.0, 1 - 2 * share), wearsOff), toRight = std::pow(std::max(0.0, 2 * share - 1), wearsOff);
        const glm::dvec3 own = surfaceOf(limb).normalAt(ring, angle, directionOf(angle));
        const glm::dvec3 position = i == 0        ? left.position
                                    : i == m_points ? right.position
                                                  : pointAt(angle) + toLeft * leftOff + toRight * rightOff;
        const glm::dvec3 normal = (1 - toLeft) * (1 - toRight) * own + toLeft * left.normal + toRight * right.normal;
        made.points.push_back({glm::vec3(position), glm::vec3(glm::normalize(normal)), static_cast<float>(angle / kTurn - double(limb.turned) / m_points),
                               static_cast<float>(level.along),
                               static_cast<float>(toLeft * left.depth + toRight * right.depth)});
    }
    made.along.push_back(level.along);
}

} // namespace stromar
