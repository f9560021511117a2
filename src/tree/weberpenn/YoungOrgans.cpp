#include "YoungOrgans.h"
#include "LeafGrower.h"
#include "Maturity.h"
#include "Young.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>

namespace stromar {

namespace {
constexpr double kUnfolding = 0.04;         // of the tree's age, that an organ needs to grow up
constexpr double kYoung = 0.06;             // since its tip has passed
constexpr double kFading = 0.02;            // of that
constexpr double kLastLeafy = 0.85;         // age from which young wood of other generations loses its leaves

double unfolded(double age, double born) { return smoothstep((age - born) / std::min(kUnfolding, 1 - born)); }

class CYoungOrgans {
public:
    CYoungOrgans(const CParams& params, const CTree& tree, Organ organ, const CRandom& random, const OrganDemand& demand,
                 const CProgress& progress)
        : m_params(params), m_tree(tree), m_rule(organRule(params, organ)), m_random(random), m_demand(demand), m_progress(progress),
          m_age(generation(0).age), m_organs(std::make_shared<COrgans>()) {
        m_organs->counts.resize(tree.generationCount());
    }

    std::shared_ptr<const COrgans> grow(bool areLeaves) {
        const int levels = weberPenn(m_params).levels;
        if (levels < 2 || m_rule.number == 0) return m_organs;
        const auto last = static_cast<std::size_t>(levels) - 1;
        if (areLeaves && m_rule.number > 0)
            for (std::size_t g = 0; g < std::min(last, m_tree.generationCount()); ++g) growOnYoungWood(g);
        if (m_tree.generationCount() == last + 1) growOnBearers(last);
        for (const auto& counts : m_organs->counts) m_organs->total += std::accumulate(counts.begin(), counts.end(), std::size_t{0});
        return m_organs;
    }

private:
    const CYoungGeneration& generation(std::size_t g) const { return static_cast<const CYoungGeneration&>(m_tree.generation(g)); }

    /// Those of the grown tree whose places the tips have passed.
    void growOnBearers(std::size_t g) {
        const CYoungGeneration& young = generation(g);
        OrganDemand all{.stems = StemSet{}}, wanted = m_demand;
        all.stems->stems.resize(g + 1);
        all.stems->stems[g].resize(young.grown->stems.size());
        wanted.stems = all.stems;
        std::vector<std::uint32_t> youngOf(young.grown->stems.size(), kUnborn);
        for (std::uint32_t s = 0; s < young.origin.size(); ++s) {
            youngOf[young.origin[s]] = s;
            all.stems->stems[g][young.origin[s]] = true;
            wanted.stems->stems[g][young.origin[s]] = m_demand.mayBear(g, s);
        }
        const CTreeParams bearing(m_params, static_cast<int>(g), young.grownHeight), leafLevel(m_params, static_cast<int>(g) + 1, young.grownHeight);
        const CLeafGrower grower(bearing, leafLevel, m_random, m_rule);
        m_organs->counts[g].assign(young.stems.size(), 0);
        const auto counted = grower.grow(*young.grown, all, m_progress), shown = grower.grow(*young.grown, wanted, m_progress);
        for (CLeaf leaf : counted->grown)
            if (ageLeaf(young, youngOf, leaf)) ++m_organs->counts[g][leaf.stem];
        for (CLeaf leaf : shown->grown)
            if (ageLeaf(young, youngOf, leaf)) m_organs->grown.push_back(leaf);
    }

    /// False when it is not there yet.
    bool ageLeaf(const CYoungGeneration& young, const std::vector<std::uint32_t>& youngOf, CLeaf& leaf) const {
        const CStem& whole = young.grown->stems[leaf.stem];
        const std::uint32_t s = youngOf[leaf.stem];
        const CStem& stem = young.stems[s];
        double born = stem.birth;
        glm::dvec3 position(leaf.position);
        if (m_rule.number < 0) { // a fan travels with the tip
            const auto tip = tipNow(young, whole, stem, position);
            if (!tip) return false;
            position = *tip;
        } else {
            born = passedAt(stem.birth, placeOn(*young.grown, whole, position) / whole.length);
            position = young.carriage[s].place(position);
        }
        const double size = unfolded(m_age, born);
        if (!(size > 0)) return false;
        leaf.position = position;
        leaf.axis = young.carriage[s].turn * glm::dvec3(leaf.axis);
        leaf.normal = young.carriage[s].turn * glm::dvec3(leaf.normal);
        leaf.length *= static_cast<float>(size);
        leaf.width *= static_cast<float>(size);
        leaf.stem = s;
        return true;
    }

    /// Metres along the stem, of the place on its wood that is nearest to a point.
    static double placeOn(const CGeneration& all, const CStem& stem, const glm::dvec3& point) {
        double best = 0, nearest = -1;
        for (std::uint32_t s = stem.firstSegment; s < stem.firstSegment + stem.segmentCount; ++s) {
            const CSegment& segment = all.segments[s];
            const double along = std::clamp(glm::dot(point - segment.position, segment.frame[2]), 0.0, segment.length);
            const double distance = glm::distance(point, segment.centre(along / segment.length));
            if (nearest >= 0 && distance >= nearest) continue;
            nearest = distance;
            best = segment.start + along;
        }
        return best;
    }

    /// Where the path ends now whose grown tip is nearest to a point.
    static std::optional<glm::dvec3> tipNow(const CYoungGeneration& young, const CStem& whole, const CStem& stem, const glm::dvec3& point) {
        std::uint64_t path = 0;
        double nearest = -1;
        for (std::uint32_t p = whole.firstPath; p < whole.firstPath + whole.pathCount; ++p) {
            const double distance = glm::distance(point, young.grown->segmentsOf(young.grown->paths[p]).back().centre(1));
            if (nearest >= 0 && distance >= nearest) continue;
            nearest = distance;
            path = young.grown->paths[p].id;
        }
        for (std::uint32_t p = stem.firstPath; p < stem.firstPath + stem.pathCount; ++p)
            if (young.paths[p].id == path) return young.segmentsOf(young.paths[p]).back().centre(1);
        return {};
    }

    /// As dense as on the last generation, where the tips have passed a short while ago.
    void growOnYoungWood(std::size_t g) {
        const double share = 1 - smoothstep((m_age - kLastLeafy) / (1 - kLastLeafy)), apart = spacing();
        if (share <= 0 || apart <= 0) return;
        const CYoungGeneration& young = generation(g);
        m_organs->counts[g].assign(young.stems.size(), 0);
        for (std::uint32_t s = 0; s < young.stems.size(); ++s)
            for (std::uint32_t p = 0; p < young.stems[s].pathCount; ++p) growOnPath(g, s, young.paths[young.stems[s].firstPath + p], share, apart);
    }

    void growOnPath(std::size_t g, std::uint32_t s, const CPath& path, double share, double apart) {
        const CYoungGeneration& young = generation(g);
        const CStem& stem = young.stems[s];
        const double whole = young.grown->stems[young.origin[s]].length;
        const auto segments = young.segmentsOf(path);
        const CTreeParams leafLevel(m_params, weberPenn(m_params).levels, young.grownHeight);
        std::size_t at = 0;
        for (double k = std::ceil(segments.front().start / apart - 0.5);; ++k) {
            const double along = (k + 0.5) * apart;
            if (along >= stem.length) return;
            const double since = m_age - passedAt(stem.birth, along / whole);
            if (since > kYoung) continue;
            while (at + 1 < segments.size() && segments[at].end() < along) ++at;
            const double size = share * unfolded(m_age, m_age - since) * smoothstep((kYoung - since) / kFading);
            if (along < segments[at].start || !(size > 0)) continue;
            const std::uint32_t number = m_organs->counts[g][s]++;
            if (!m_demand.mayBear(g, s) || !OrganDemand::keeps(m_demand.share, hashCombine(hashCombine(stem.id, path.id), static_cast<std::uint64_t>(k)))) continue;
            const CSegment& wood = segments[at];
            const glm::dvec3 position = wood.centre((along - wood.start) / wood.length);
            const Frame off = rotatedX(rotatedZ(wood.frame, k * leafLevel.level().rotate.radians()), leafLevel.level().downAngle.radians());
            const Frame frame = m_rule.pose.applied(off, position);
            m_organs->grown.push_back({glm::vec3(position), glm::vec3(frame[2]), glm::vec3(frame[1]), static_cast<float>(size * m_rule.pose.length),
                                       static_cast<float>(size * m_rule.pose.width), s, static_cast<std::uint32_t>(g), number});
        }
    }

    /// Metres between two leaves of a grown twig, on the average.
    double spacing() {
        const WeberPennParams& w = weberPenn(m_params);
        double length = w.scale;
        for (int g = 0; g < w.levels; ++g) length *= w.level[static_cast<std::size_t>(std::min(g, kParamLevels - 1))].length;
        const double number = m_rule.number * m_rule.density;
        return number > 0 ? std::max(length / number, 0.2 * m_rule.pose.length) : 0;
    }

    const CParams& m_params;
    const CTree& m_tree;
    OrganRule m_rule;
    const CRandom& m_random;
    const OrganDemand& m_demand;
    const CProgress& m_progress;
    double m_age;
    std::shared_ptr<COrgans> m_organs;
};
} // namespace

std::shared_ptr<const COrgans> growYoungOrgans(const CParams& params, const CTree& tree, Organ organ, const CRandom& random,
                                               const OrganDemand& demand, const CProgress& progress) {
    return CYoungOrgans(params, tree, organ, random, demand, progress).grow(organ == Organ::Leaf);
}

} // namespace stromar
