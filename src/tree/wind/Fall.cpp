#include "stromar/tree/Fall.h"
#include "stromar/util/Parallel.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace stromar {

namespace {
constexpr double kStep = 1.0 / 240, kGravity = 9.81;
constexpr double kFirstAngle = std::numbers::pi / 180, kBounce = 0.15;
constexpr double kLongest = 120; // seconds
constexpr double kGale = 22;     // m/s of strength 1
constexpr std::size_t kStemGrain = 256;

double volumeOf(const CSegment& s) {
    return std::numbers::pi / 3 * s.length *
           (s.radiusBase * s.radiusBase + s.radiusBase * s.radiusEnd + s.radiusEnd * s.radiusEnd);
}
} // namespace

CFall::CFall(std::shared_ptr<const CWindTable> table, const Felling& felling)
    : m_table(std::move(table)), m_felling(felling), m_direction(windDirection(felling.direction)),
      m_falls(m_table->nodeCount()) {
    m_axis = glm::cross(glm::dvec3(0, 0, 1), m_direction);
    const std::size_t trunks = m_table->tree().generationCount() > 0 ? m_table->tree().generation(0).stems.size() : 0;
    m_cuts.resize(trunks);
    for (std::size_t s = 0; s < trunks; ++s) cutTrunk(s);
    if (const auto first = std::ranges::find_if_not(m_cuts, &TrunkCut::none); first != m_cuts.end())
        m_hinge = first->at;
    hangBranches();
    weigh();
    simulate();
}

/// Every path where it first reaches the height; clones above a cut fall with what bears them.
void CFall::cutTrunk(std::size_t index) {
    const CGeneration& all = m_table->tree().generation(0);
    const CStem& stem = all.stems[index];
    for (std::uint32_t p = 0; p < stem.pathCount; ++p) {
        const CPath& path = all.paths[stem.firstPath + p];
        const std::uint32_t first = m_table->nodeOf(0, path.firstSegment);
        const CSegment* below = all.segmentBelow(stem, path);
        double cut = std::numeric_limits<double>::infinity();
        glm::dvec3 at(0);
        if (m_felling.height <= 0 ||
            (below && m_falls[m_table->nodeOf(0, static_cast<std::uint32_t>(below - all.segments.data())) + 1]))
            cut = 0;
        for (const CSegment& segment : all.segmentsOf(path)) {
            const double low = segment.position.z, high = segment.axisPoint(1).z;
            if (cut < std::numeric_limits<double>::infinity() || high < m_felling.height || high <= low) continue;
            const double t = std::clamp((m_felling.height - low) / (high - low), 0.0, 1.0);
            cut = segment.start + t * segment.length;
            at = segment.axisPoint(t);
        }
        const auto segments = all.segmentsOf(path);
        for (std::uint32_t n = 0; n <= path.segmentCount; ++n)
            m_falls[first + n] = (n < path.segmentCount ? segments[n].start : segments[n - 1].end()) >= cut;
        if (p > 0) continue;
        m_cuts[index].along = cut;
        m_cuts[index].at = m_felling.height <= 0 ? all.segments[path.firstSegment].position : at;
    }
}

SwayPlace CFall::onOneSide(const SwayPlace& place, bool above) const {
    const std::size_t node = place.index();
    if (m_falls[node] == m_falls[node + 1]) return place;
    return {place.node + (above ? 1.f : 0.f), 0};
}

void CFall::hangBranches() {
    m_on.resize(m_table->stems().size());
    for (std::size_t s = 0; s < m_on.size(); ++s) {
        const WindStem& stem = m_table->stems()[s];
        if (stem.parent < 0) continue;
        m_on[s] = stem.on;
        bool above = m_falls[stem.on.index()];
        if (stem.generation == 1 && above != m_falls[stem.on.index() + 1]) above = stem.base.z >= m_felling.height;
        m_on[s] = onOneSide(m_on[s], above);
        const CGeneration& all = m_table->tree().generation(stem.generation);
        const CStem& own = all.stems[stem.stem];
        for (std::uint32_t n = stem.firstNode; n < stem.firstNode + own.segmentCount + own.pathCount; ++n)
            m_falls[n] = above;
    }
}

/// Of all wood above the cut, each segment a rod.
void CFall::weigh() {
    for (std::size_t g = 0; g < m_table->tree().generationCount(); ++g) {
        const CGeneration& all = m_table->tree().generation(g);
        for (std::uint32_t s = 0; s < all.segments.size(); ++s) {
            if (!m_falls[m_table->nodeOf(g, s)]) continue;
            const CSegment& segment = all.segments[s];
            const double mass = volumeOf(segment);
            const glm::dvec3 r = segment.axisPoint(0.5) - m_hinge, along = segment.frame[2];
            const auto off = [&](const glm::dvec3& v) {
                return glm::dot(v, v) - glm::dot(v, m_axis) * glm::dot(v, m_axis);
            };
            m_mass += mass;
            m_lever += mass * r.z;
            m_inertia += mass * (off(r) + segment.length * segment.length / 12 * off(along));
        }
    }
    if (m_mass > 0) m_lever /= m_mass;
    if (m_lever <= 0) m_inertia = 0; // nothing that could fall
}

namespace {
/// The first angle at which z·cos θ − p·sin θ comes down to `height`; a half turn where it never does.
double angleDown(double z, double p, double height) {
    const double reach = std::hypot(z, p);
    if (z <= height) return kFirstAngle;
    if (-reach > height) return std::numbers::pi;
    return std::clamp(std::acos(height / reach) - std::atan2(p, z), kFirstAngle, std::numbers::pi);
}
} // namespace

/// Where the surface of a trunk's upper half meets the ground.
double CFall::restAngle() const {
    double rest = std::numbers::pi;
    const CGeneration& all = m_table->tree().generation(0);
    for (const CStem& stem : all.stems)
        for (std::uint32_t s = stem.firstSegment; s < stem.firstSegment + stem.segmentCount; ++s) {
            const CSegment& segment = all.segments[s];
            if (!m_falls[m_table->nodeOf(0, s)] || segment.end() < 0.5 * stem.length) continue;
            const glm::dvec3 tip = segment.axisPoint(1) - m_hinge;
            const double p = glm::dot(tip, m_direction);
            rest = std::min(rest, angleDown(tip.z, p, segment.radiusEnd - m_hinge.z));
        }
    return rest;
}

void CFall::simulate() {
    m_angles = {0};
    m_speeds = {0};
    if (m_inertia <= 0) return;
    const double rest = restAngle(), pull = m_mass * kGravity * m_lever / m_inertia;
    double angle = std::min(kFirstAngle, rest), speed = 0;
    bool bounced = false;
    while (double(m_angles.size()) * kStep < kLongest) {
        m_angles.push_back(static_cast<float>(angle));
        m_speeds.push_back(static_cast<float>(speed));
        speed += kStep * pull * std::sin(angle);
        angle += kStep * speed;
        if (angle < rest) continue;
        angle = rest;
        if (bounced) break;
        bounced = true;
        speed *= -kBounce;
    }
    m_angles.push_back(static_cast<float>(angle));
    m_speeds.push_back(0);
}

namespace {
/// Between two time steps.
double valueAt(const std::vector<float>& steps, double seconds) {
    const double at = std::clamp(seconds / kStep, 0.0, double(steps.size() - 1));
    const auto low = static_cast<std::size_t>(at), high = std::min(low + 1, steps.size() - 1);
    return steps[low] + (at - double(low)) * (steps[high] - steps[low]);
}
} // namespace

double CFall::seconds() const { return double(m_angles.size() - 1) * kStep; }
double CFall::angleAt(double seconds) const { return valueAt(m_angles, seconds); }
double CFall::speedAt(double seconds) const { return valueAt(m_speeds, seconds); }

/// Of the air that it moves through; in the frame of the standing tree.
CWindTable::Push CFall::pushOn(const WindStem& stem, double speed) const {
    const glm::dvec3 way = speed * glm::cross(m_axis, stem.base + stem.axis * (stem.length / 2) - m_hinge);
    const double fast = glm::length(way);
    if (fast < 1e-9) return {glm::dvec3(0), 0, 0};
    return m_table->pushOn(
        stem, {.direction = -way / fast, .strength = std::min(kMaxWindStrength, fast / kGale), .gusts = 0}, 0);
}

void CFall::poseTrunk(const WindStem& own, const CWindTable::Push& push, double angle,
                      std::vector<glm::vec4>& rows) const {
    const CGeneration& all = m_table->tree().generation(0);
    const CStem& stem = all.stems[own.stem];
    const glm::dquat turn = glm::angleAxis(angle, m_axis);
    const TrunkCut& cut = m_cuts[own.stem];
    for (std::uint32_t p = 0; p < stem.pathCount; ++p) {
        const CPath& path = all.paths[stem.firstPath + p];
        const std::uint32_t first = m_table->nodeOf(0, path.firstSegment);
        std::uint32_t skipped = 0;
        while (skipped <= path.segmentCount && !m_falls[first + skipped]) ++skipped;
        if (skipped > path.segmentCount) continue;
        const CSegment* below = all.segmentBelow(stem, path);
        const bool onClone = below && skipped == 0;
        const glm::dvec3 foot(m_table->still()[first + skipped]);
        const glm::dvec3 at =
            onClone
                ? glm::dvec3(
                      rows[2 * std::size_t{m_table->nodeOf(0, static_cast<std::uint32_t>(below - all.segments.data())) +
                                           1}])
                : m_hinge + turn * (foot - m_hinge);
        const auto segments = all.segmentsOf(path);
        const double along = skipped < path.segmentCount ? segments[skipped].start : all.lengthOf(path);
        m_table->posePath(first + skipped, path.segmentCount - skipped,
                          std::max(0.0, along - (cut.none() ? along : cut.along)), at, turn, push.turn / own.length,
                          static_cast<float>(push.strength), rows);
    }
}

void CFall::pose(double seconds, WindPose& pose, const CProgress& progress) const {
    pose.rows.resize(2 * m_table->nodeCount());
    for (std::size_t n = 0; n < m_table->nodeCount(); ++n) { // what stands
        pose.rows[2 * n] = glm::vec4(m_table->still()[n], 0);
        pose.rows[2 * n + 1] = {0, 0, 0, 1};
    }
    if (!anythingFalls() || seconds <= 0) return;
    const double angle = angleAt(seconds), speed = speedAt(seconds);
    std::size_t first = 0;
    for (std::size_t g = 0; g < m_table->tree().generationCount(); ++g) {
        const std::size_t count = m_table->tree().generation(g).stems.size();
        parallelFor(
            count, kStemGrain,
            [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = first + begin; i < first + end; ++i) {
                    const WindStem& stem = m_table->stems()[i];
                    if (g == 0)
                        poseTrunk(stem, pushOn(stem, speed), angle, pose.rows);
                    else if (m_falls[stem.firstNode])
                        m_table->poseStem(stem, pushOn(stem, speed), m_on[i], pose.rows);
                }
            },
            progress);
        first += count;
    }
}

} // namespace stromar
