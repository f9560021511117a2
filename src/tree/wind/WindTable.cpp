#include "stromar/tree/Wind.h"
#include "stromar/util/Parallel.h"
#include "stromar/util/Random.h"
#include "stromar/util/Turn.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>

namespace stromar {

namespace {
constexpr std::size_t kPosedStems = 256; // at a time
constexpr double kMaxTurn = std::numbers::pi / 3;
constexpr double kBend = 0.35;         // radians of a slender stem across a strong gale
constexpr double kSlender = 60;        // length over diameter that bends so far
constexpr double kSway = 0.35;         // how much of the bend comes and goes
constexpr double kTremble = 0.05;      // radians
constexpr double kGustLength = 12;     // metres
constexpr double kGustFrequency = 0.8; // Hz
constexpr std::uint32_t kGustSeed = 0x51ed270bu;
constexpr std::uint64_t kPhase = 1, kNoise = 2; // what a number of a stem's name is for

struct Stiffness {
    double length, diameter;
};

/// Of grown stems by name; empty where the tree is grown itself.
std::unordered_map<std::uint64_t, Stiffness> stiffnessOf(const CTree& tree, const CTree& grown,
                                                         std::size_t generation) {
    std::unordered_map<std::uint64_t, Stiffness> all;
    if (generation >= grown.generationCount() || tree.generations()[generation] == grown.generations()[generation])
        return all;
    for (const CStem& stem : grown.generation(generation).stems) all[stem.id] = {stem.length, 2 * stem.radius};
    return all;
}

/// exp of half a rotation vector; its length is below 3.
glm::dquat turnBy(const glm::dvec3& v) {
    const double h = glm::dot(v, v) / 4; // the square of half the angle
    const double cosine = 1 - h / 2 * (1 - h / 12 * (1 - h / 30 * (1 - h / 56 * (1 - h / 90 * (1 - h / 132)))));
    const double sine = 0.5 * (1 - h / 6 * (1 - h / 20 * (1 - h / 42 * (1 - h / 72 * (1 - h / 110 * (1 - h / 156))))));
    return {cosine, sine * v.x, sine * v.y, sine * v.z};
}

glm::vec4 rowOf(const glm::dquat& q) { return {q.x, q.y, q.z, q.w}; }

/// How far a point lies along a segment, 0..1, and the square of its distance.
std::pair<double, double> projected(const CSegment& segment, const glm::dvec3& point) {
    const glm::dvec3 to = point - segment.position;
    const double t = segment.length > 0 ? glm::clamp(glm::dot(to, segment.frame[2]) / segment.length, 0.0, 1.0) : 0;
    const glm::dvec3 off = point - segment.axisPoint(t);
    return {t, glm::dot(off, off)};
}
} // namespace

double WindStem::slenderness() const {
    return diameter > 0 ? std::min(1.0, length / diameter / kSlender) : 1;
}

CWindTable::CWindTable(std::shared_ptr<const CTree> tree, const CTree& grown, double flexibility, int seed)
    : m_tree(std::move(tree)) {
    for (std::size_t g = 0; g < m_tree->generationCount(); ++g) addStems(g, grown, flexibility, seed);
}

void CWindTable::addStems(std::size_t generation, const CTree& grown, double flexibility, int seed) {
    const CGeneration& all = m_tree->generation(generation);
    const auto stiffness = stiffnessOf(*m_tree, grown, generation);
    m_firstStem.push_back(m_stems.size());
    std::vector<std::uint32_t>& nodes = m_nodeOf.emplace_back(all.segments.size());
    for (const CStem& stem : all.stems) {
        const auto firstNode = static_cast<std::uint32_t>(m_still.size());
        for (std::uint32_t p = 0; p < stem.pathCount; ++p) {
            const CPath& path = all.paths[stem.firstPath + p];
            for (std::uint32_t s = path.firstSegment; s < path.firstSegment + path.segmentCount; ++s) {
                nodes[s] = static_cast<std::uint32_t>(m_still.size());
                m_still.emplace_back(all.segments[s].position);
                m_pieces.emplace_back(glm::vec3(all.segments[s].frame[2]), static_cast<float>(all.segments[s].length));
            }
            m_pieces.emplace_back(0);
            m_still.emplace_back(all.segments[path.firstSegment + path.segmentCount - 1].axisPoint(1));
        }
        const CSegment &first = all.segments[all.paths[stem.firstPath].firstSegment],
                       &last = all.segmentsOf(all.paths[stem.firstPath]).back();
        const glm::dvec3 way = last.axisPoint(1) - first.position;
        const auto known = stiffness.find(stem.id);
        const Stiffness own = known != stiffness.end() ? known->second : Stiffness{stem.length, 2 * stem.radius};
        const std::uint64_t name = hashCombine(static_cast<std::uint64_t>(seed), stem.id);
        WindStem row{.base = first.position,
                     .axis = glm::length(way) > 1e-12 ? glm::normalize(way) : first.frame[2],
                     .x = first.frame[0],
                     .y = first.frame[1],
                     .length = std::max(own.length, 1e-9),
                     .diameter = own.diameter,
                     .flexibility = flexibility,
                     .angularSpeed = 6 / std::sqrt(std::max(own.length, 0.05)),
                     .phase = 2 * std::numbers::pi * unitOf(hashCombine(name, kPhase)),
                     .seed = static_cast<std::uint32_t>(hashCombine(name, kNoise)),
                     .parent = -1,
                     .on = {0, 0},
                     .generation = static_cast<std::uint32_t>(generation),
                     .stem = static_cast<std::uint32_t>(&stem - all.stems.data()),
                     .firstNode = firstNode,
                     .segments = all.paths[stem.firstPath].segmentCount,
                     .forks = stem.pathCount > 1};
        if (stem.parent >= 0) {
            const CGeneration& before = m_tree->generation(generation - 1);
            const CStem& parent = before.stems[static_cast<std::size_t>(stem.parent)];
            const CSegment& below = before.segmentAt(parent, stem.path, stem.position);
            row.parent = static_cast<std::int32_t>(m_firstStem[generation - 1]) + stem.parent;
            const std::uint32_t node = m_nodeOf[generation - 1][static_cast<std::size_t>(&below - before.segments.data())];
            const double part = below.length > 0 ? glm::clamp((stem.offset - below.start) / below.length, 0.0, 1.0) : 0;
            row.on = {static_cast<float>(node), static_cast<float>(part)};
        }
        m_stems.push_back(row);
    }
}

SwayPlace CWindTable::nearestOn(std::size_t generation, std::size_t stem, const glm::dvec3& point) const {
    const CGeneration& all = m_tree->generation(generation);
    const CStem& own = all.stems[stem];
    double nearest = std::numeric_limits<double>::infinity();
    SwayPlace place{};
    for (std::uint32_t s = own.firstSegment; s < own.firstSegment + own.segmentCount; ++s) {
        const auto [t, distance] = projected(all.segments[s], point);
        if (distance >= nearest) continue;
        nearest = distance;
        place = {static_cast<float>(m_nodeOf[generation][s]), static_cast<float>(t)};
    }
    return place;
}

CWindTable::Push CWindTable::pushOn(const WindStem& stem, const Wind& wind, double seconds) const {
    const Rhythm gust(kGustFrequency, wind.loop), own(stem.angularSpeed / (2 * std::numbers::pi), wind.loop);
    const double gustAt = glm::dot(stem.base, wind.direction) / kGustLength - gust.frequency * seconds;
    const double s = wind.strength * (1 + wind.gusts * windNoise(gustAt, kGustSeed, gust.steps));
    const double give = stem.flexibility * s;
    const glm::dvec3 across = glm::cross(stem.axis, wind.direction);
    const double sine = glm::length(across);
    glm::dvec3 turn(0);
    if (sine > 1e-9) {
        const double sway = 1 + kSway * std::sin(2 * std::numbers::pi * own.frequency * seconds + stem.phase);
        double bend = kBend * give * stem.slenderness() * sine * sway;
        if (bend > sine)
            bend =
                std::min(bend, std::atan2(sine, glm::dot(stem.axis, wind.direction))); // an angle is more than its sine
        turn = bend / sine * across;
    }
    const double beat = own.frequency * seconds;
    turn += kTremble * give *
            (windNoise(beat, stem.seed, own.steps) * stem.x + windNoise(beat, ~stem.seed, own.steps) * stem.y);
    const double size = glm::length(turn);
    if (size > kMaxTurn) turn *= kMaxTurn / size;
    return {turn, s, size};
}

void CWindTable::poseStem(const WindStem& own, const Push& push, const SwayPlace& on,
                          std::vector<glm::vec4>& rows) const {
    glm::dquat carried(1, 0, 0, 0);
    glm::dvec3 base = own.base;
    if (own.parent >= 0) {
        const std::size_t node = on.index();
        const double part = on.part;
        const glm::vec4* below = &rows[2 * node];
        const glm::dvec4 p = glm::mix(glm::dvec4(below[0]), glm::dvec4(below[2]), part);
        const glm::dvec4 a(below[1]), b(below[3]), q = glm::normalize(glm::mix(a, glm::dot(a, b) < 0 ? -b : b, part));
        carried = glm::dquat(q.w, q.x, q.y, q.z);
        const glm::dvec3 axis = glm::mix(glm::dvec3(m_still[node]), glm::dvec3(m_still[node + 1]), part);
        base = glm::dvec3(p) + carried * (own.base - axis);
    }
    posePath(own.firstNode, own.segments, 0, base, carried, push.turn / own.length, static_cast<float>(push.strength),
             rows);
    if (own.forks) poseClones(own, push, carried, rows);
}

void CWindTable::poseClones(const WindStem& own, const Push& push, const glm::dquat& carried,
                            std::vector<glm::vec4>& rows) const {
    const CGeneration& all = m_tree->generation(own.generation);
    const CStem& stem = all.stems[own.stem];
    for (std::uint32_t p = 1; p < stem.pathCount; ++p) {
        const CPath& path = all.paths[stem.firstPath + p];
        const CSegment* below = all.segmentBelow(stem, path);
        const std::uint32_t fork = m_nodeOf[own.generation][static_cast<std::size_t>(below - all.segments.data())] + 1;
        posePath(m_nodeOf[own.generation][path.firstSegment], path.segmentCount, all.segments[path.firstSegment].start,
                 glm::dvec3(rows[2 * std::size_t{fork}]), carried, push.turn / own.length,
                 static_cast<float>(push.strength), rows);
    }
}

/// Half a piece turns as far as the next half: their quaternion is worked out once for all pieces of a length.
void CWindTable::posePath(std::uint32_t first, std::uint32_t segments, double start, glm::dvec3 at,
                          const glm::dquat& carried, const glm::dvec3& perMetre, float strength,
                          std::vector<glm::vec4>& rows) const {
    glm::dquat turn = carried * turnBy(start * perMetre), half(1, 0, 0, 0);
    double known = 0;
    glm::vec4* row = &rows[2 * std::size_t{first}];
    for (std::uint32_t i = 0; i < segments; ++i) {
        const glm::dvec4 piece(m_pieces[first + i]);
        if (piece.w != known) half = turnBy(piece.w / 2 * perMetre);
        known = piece.w;
        *row++ = glm::vec4(glm::vec3(at), strength);
        *row++ = rowOf(turn);
        turn = turn * half;
        at += piece.w * (turn * glm::dvec3(piece));
        turn = turn * half;
    }
    *row++ = glm::vec4(glm::vec3(at), strength);
    *row++ = rowOf(turn);
}

void CWindTable::pose(const Wind& wind, double seconds, WindPose& pose, const CProgress& progress) const {
    pose.rows.resize(2 * nodeCount());
    for (std::size_t g = 0; g < m_firstStem.size(); ++g) {
        const WindStem* stems = &m_stems[m_firstStem[g]];
        parallelFor(
            m_tree->generation(g).stems.size(), kPosedStems,
            [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i)
                    poseStem(stems[i], pushOn(stems[i], wind, seconds), stems[i].on, pose.rows);
            },
            progress);
    }
}

Swayed::Swayed(const std::vector<glm::vec3>& still, const WindPose& pose, const SwayPlace& place) {
    const std::size_t node = place.index();
    const glm::vec4* rows = &pose.rows[2 * node];
    const glm::vec4 point = glm::mix(rows[0], rows[2], place.part);
    const glm::vec4 q =
        glm::normalize(glm::mix(rows[1], glm::dot(rows[1], rows[3]) < 0 ? -rows[3] : rows[3], place.part));
    turn = glm::quat(q.w, q.x, q.y, q.z);
    from = glm::mix(still[node], still[node + 1], place.part);
    to = glm::vec3(point);
    strength = point.w;
}

Flutter::Flutter(std::uint64_t id, float widthOverLength)
    : phase(static_cast<float>(2 * std::numbers::pi * unitOf(hashCombine(id, kPhase)))),
      hertz(static_cast<float>(2 + 1.7 * unitOf(hashCombine(id, kNoise)))),
      amount(std::clamp(4 * widthOverLength, 0.1f, 1.f)) {}

float Flutter::angle(float strength, double seconds, double loop) const {
    constexpr double kWide = 25 * std::numbers::pi / 180, kGolden = 1.618;
    const double slow = kTurn * Rhythm(hertz, loop).frequency * seconds,
                 fast = kTurn * Rhythm(kGolden * hertz, loop).frequency * seconds;
    const double wave = 0.6 * std::sin(slow + phase) + 0.4 * std::sin(fast + 2.4 * phase);
    return static_cast<float>(std::min(kMaxTurn, kWide * strength) * amount * wave);
}

} // namespace stromar
