#include "Young.h"
#include "CommonValues.h"
#include "Maturity.h"
#include "stromar/params/methods/weberpenn/TreeParams.h"
#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <span>

namespace stromar {

namespace {
constexpr double kMinYoungLength = 1e-6;      // metres; shorter ones are not there yet
constexpr double kPalmBase = 0.8;        // BaseSize from which the crown sits at the trunk's tip

/// Cuts the stems of one generation.
class CStemCutter {
public:
    /// `parents` null for trunks; `travels`: the stems keep their place between their parents' bases and tips.
    CStemCutter(std::shared_ptr<const CGrownGeneration> grown, const CYoungGeneration* parents, double taper,
                double parentTaper, const BaseForm& parentBase, bool travels, double age, double grownHeight)
        : m_grown(*grown), m_parents(parents), m_taper(taperProfile(taper)), m_parentTaper(taperProfile(parentTaper)),
          m_parentBase(parentBase), m_travels(travels), m_age(age), m_young(std::make_shared<CYoungGeneration>()) {
        m_young->grown = std::move(grown);
        m_young->age = age;
        m_young->grownHeight = grownHeight;
        if (!parents) return;
        m_youngParent.assign(parents->grown->stems.size(), kUnborn);
        for (std::uint32_t s = 0; s < parents->origin.size(); ++s) m_youngParent[parents->origin[s]] = s;
    }

    std::shared_ptr<const CYoungGeneration> cut(const CProgress& progress) {
        for (std::uint32_t s = 0; s < m_grown.stems.size(); ++s) {
            if (s % 4096 == 0) progress.poll();
            cutStem(s);
        }
        return m_young;
    }

private:
    void cutStem(std::uint32_t s) {
        const CStem& whole = m_grown.stems[s];
        const std::uint32_t parent = whole.parent < 0 ? 0 : m_youngParent[static_cast<std::size_t>(whole.parent)];
        if (parent == kUnborn) return;
        CStem stem = whole;
        if (whole.parent >= 0) stem.birth = birthOn(m_parents->stems[parent], whole);
        const double grown = maturity(m_age, stem.birth);
        stem.length = grown * whole.length;
        stem.radius = grown * whole.radius;
        if (stem.length < kMinYoungLength) return;
        Carriage carriage;
        if (whole.parent >= 0 && !sitOn(parent, stem, carriage)) return;
        addPaths(whole, stem, carriage);
        m_young->stems.push_back(stem);
        m_young->origin.push_back(s);
        m_young->carriage.push_back(carriage);
    }

    double birthOn(const CStem& parent, const CStem& whole) const {
        if (m_travels) return parent.birth;
        return passedAt(parent.birth, whole.offset / m_parents->grown->stems[static_cast<std::size_t>(whole.parent)].length);
    }

    /// Where the stem sits on its young parent; false when that has not come so far.
    bool sitOn(std::uint32_t parent, CStem& stem, Carriage& carriage) const {
        const CStem& young = m_parents->stems[parent];
        const CStem& grown = m_parents->grown->stems[static_cast<std::size_t>(stem.parent)];
        carriage = m_parents->carriage[parent];
        if (m_travels) {
            const double along = stem.offset * young.length / grown.length;
            const Place place = placeOn(grown, stem.path, along);
            carriage = carried(carriage, grown, placeOn(grown, stem.path, stem.offset), stem.offset, place, along);
            stem.offset = along;
            stem.path = place.path;
            stem.position = place.position;
        }
        const auto path = pathAmong(young, m_parents->grown->paths[grown.firstPath + stem.path].id);
        if (!path || stem.offset > young.length) return false;
        stem.path = *path;
        stem.parent = static_cast<std::int32_t>(parent);
        const double flare = m_parentBase.flare == 0 ? 1 : m_parentBase.flareAt(stem.offset / young.length);
        stem.parentRadius = flare * m_parentTaper.radiusAt(stem.offset, young.length, young.radius);
        stem.radius = std::min(stem.radius, stem.parentRadius); // a round end, or its tip, may be thinner for a while
        return true;
    }

    struct Place {
        std::uint32_t path, position; ///< in the stem; which segment, from its base
    };
    /// On the way to one of a stem's paths.
    Place placeOn(const CStem& stem, std::uint32_t path, double along) const {
        const CGrownGeneration& all = *m_parents->grown;
        while (all.paths[stem.firstPath + path].source >= 0 && all.segmentsOf(all.paths[stem.firstPath + path]).front().start > along)
            path = static_cast<std::uint32_t>(all.paths[stem.firstPath + path].source);
        const CPath& own = all.paths[stem.firstPath + path];
        std::uint32_t position = own.firstPosition;
        while (position + 1 < own.firstPosition + own.segmentCount && all.segmentAt(stem, path, position).end() < along) ++position;
        return {path, position};
    }

    /// Turned evenly from the middle of one segment to that of the next, so that nothing on it jumps.
    glm::dquat turnAt(const CStem& stem, const Place& place, double along) const {
        const CGrownGeneration& all = *m_parents->grown;
        const CPath& own = all.paths[stem.firstPath + place.path];
        const CSegment& here = all.segmentAt(stem, place.path, place.position);
        const double off = (along - here.start) / here.length - 0.5;
        const std::uint32_t last = own.firstPosition + own.segmentCount - 1;
        const bool atEnd = off < 0 ? place.position == own.firstPosition : place.position == last;
        const glm::dquat turn = glm::quat_cast(here.frame);
        if (atEnd) return turn;
        const CSegment& next = all.segmentAt(stem, place.path, off < 0 ? place.position - 1 : place.position + 1);
        return glm::slerp(turn, glm::quat_cast(next.frame), std::abs(off));
    }

    Carriage carried(const Carriage& with, const CStem& stem, const Place& from, double fromAlong, const Place& to, double toAlong) const {
        const auto at = [&](const Place& place, double along) {
            const CSegment& segment = m_parents->grown->segmentAt(stem, place.path, place.position);
            return segment.centre(std::clamp((along - segment.start) / segment.length, 0.0, 1.0));
        };
        Carriage own;
        own.turn = with.turn * glm::mat3_cast(turnAt(stem, to, toAlong) * glm::inverse(turnAt(stem, from, fromAlong)));
        own.from = at(from, fromAlong);
        own.to = with.place(at(to, toAlong));
        return own;
    }

    /// Its number in a young stem, by its name.
    std::optional<std::uint32_t> pathAmong(const CStem& young, std::uint64_t id) const {
        for (std::uint32_t p = 0; p < young.pathCount; ++p)
            if (m_parents->paths[young.firstPath + p].id == id) return p;
        return {};
    }

    /// Clones appear when the cut passes their forks.
    void addPaths(const CStem& whole, CStem& stem, const Carriage& carriage) {
        stem.firstPath = static_cast<std::uint32_t>(m_young->paths.size());
        stem.firstSegment = static_cast<std::uint32_t>(m_young->segments.size());
        stem.pathCount = 0;
        m_newPath.assign(whole.pathCount, -1);
        for (std::uint32_t p = 0; p < whole.pathCount; ++p) {
            CPath path = m_grown.paths[whole.firstPath + p];
            const std::span<const CSegment> segments = m_grown.segmentsOf(path);
            if (p > 0 && segments.front().start + kMinYoungLength > stem.length) continue;
            if (path.source >= 0) path.source = m_newPath[static_cast<std::size_t>(path.source)];
            path.firstSegment = static_cast<std::uint32_t>(m_young->segments.size());
            path.segmentCount = 0;
            for (const CSegment& segment : segments) {
                if (path.segmentCount > 0 && segment.start + kMinYoungLength > stem.length) break;
                addSegment(segment, stem, carriage);
                ++path.segmentCount;
            }
            m_newPath[p] = static_cast<std::int32_t>(stem.pathCount++);
            m_young->paths.push_back(path);
        }
        stem.segmentCount = static_cast<std::uint32_t>(m_young->segments.size()) - stem.firstSegment;
    }

    void addSegment(const CSegment& whole, const CStem& stem, const Carriage& carriage) {
        CSegment segment = whole;
        segment.position = carriage.place(whole.position);
        segment.frame = carriage.frame(whole.frame);
        segment.length = std::min(whole.length, stem.length - whole.start);
        segment.turns = static_cast<float>(segment.length / whole.length);
        segment.forks = whole.forks && whole.end() + kMinYoungLength <= stem.length;
        const auto radius = [&](double along) { return m_taper.radiusAt(std::min(along, stem.length), stem.length, stem.radius); };
        segment.radiusBase = radius(whole.start);
        segment.radiusEnd = radius(segment.end());
        m_young->segments.push_back(segment);
    }

    const CGrownGeneration& m_grown;
    const CYoungGeneration* m_parents;
    RadiusProfile m_taper, m_parentTaper;
    BaseForm m_parentBase;
    bool m_travels;
    double m_age;
    std::vector<std::uint32_t> m_youngParent; ///< by grown stem
    std::vector<std::int32_t> m_newPath;      ///< by path of the stem in hand
    std::shared_ptr<CYoungGeneration> m_young;
};
} // namespace

std::vector<std::shared_ptr<const CYoungGeneration>> youngGenerations(const CParams& params, const CTree& grown, double age,
                                                                      const CProgress& progress) {
    std::vector<std::shared_ptr<const CYoungGeneration>> young;
    const bool palm = weberPenn(params).baseSize > kPalmBase;
    for (std::size_t g = 0; g < grown.generationCount(); ++g) {
        const CTreeParams level(params, static_cast<int>(g), grown.height()), below(params, static_cast<int>(g) - (g > 0 ? 1 : 0), grown.height());
        CStemCutter cutter(std::static_pointer_cast<const CGrownGeneration>(grown.generations()[g]), g > 0 ? young.back().get() : nullptr,
                           level.level().taper, below.level().taper, g == 1 ? grown.base() : BaseForm(), palm && g == 1, age, grown.height());
        young.push_back(cutter.cut(progress));
        if (young.back()->stems.empty()) {
            young.pop_back();
            break;
        }
    }
    return young;
}

} // namespace stromar
