#include "stromar/tree/lsystem/TurtleStems.h"
#include <algorithm>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
constexpr double kAlike = 1e-6;  // of the cosines of turns
constexpr double kNothing = 1e-9; // of a length or width, metres
constexpr std::uint32_t kNone = ~0u;

/// Which segments start at the end of which, as lists in the order of the word.
class CChildLists {
public:
    explicit CChildLists(const std::vector<TurtleSegment>& segments) : m_next(segments.size(), kNone), m_first(segments.size(), kNone) {
        for (std::size_t i = segments.size(); i-- > 0;) { // from the last, so that the first comes first
            const auto own = static_cast<std::uint32_t>(i);
            std::uint32_t& first = segments[i].below < 0 ? m_root : m_first[static_cast<std::size_t>(segments[i].below)];
            m_next[i] = first;
            first = own;
        }
    }

    template <typename Visit>
    void visitRoots(Visit&& visit) const {
        for (std::uint32_t i = m_root; i != kNone; i = m_next[i]) visit(i);
    }
    template <typename Visit>
    void visitChildren(std::uint32_t of, Visit&& visit) const {
        for (std::uint32_t i = m_first[of]; i != kNone; i = m_next[i]) visit(i);
    }

private:
    std::vector<std::uint32_t> m_next, m_first;
    std::uint32_t m_root = kNone;
};

/// A stem of the next generation to be: its first segment, and where it sits.
struct Branch {
    std::uint32_t segment;
    std::int32_t parent; ///< stem
    std::uint32_t position;
};

class CStemCollector {
public:
    /// `shares` by module; empty: all of every one.
    CStemCollector(const CWord& word, const std::vector<float>& shares, const TurtlePath& path)
        : m_word(word), m_shares(shares), m_segments(path.segments), m_children(path.segments), m_organs(path.organs), m_bearers(path.segments.size(), Bearer{0, 0}) {}

    std::vector<std::shared_ptr<const CTurtleGeneration>> collect(const CProgress& progress) {
        std::vector<Branch> branches;
        m_children.visitRoots([&](std::uint32_t i) { branches.push_back({i, -1, 0}); });
        while (!branches.empty()) {
            progress.poll();
            branches = collectGeneration(branches);
        }
        addOrgans();
        return {m_generations.begin(), m_generations.end()};
    }

private:
    struct Bearer {
        std::uint32_t generation, stem;
    };

    /// What grows on the stems of that generation.
    std::vector<Branch> collectGeneration(const std::vector<Branch>& branches) {
        auto generation = std::make_shared<CTurtleGeneration>();
        std::vector<Branch> next;
        for (const Branch& branch : branches) addStem(branch, *generation, next);
        if (!generation->stems.empty()) m_generations.push_back(generation);
        return generation->stems.empty() ? std::vector<Branch>() : next;
    }

    void addStem(const Branch& branch, CTurtleGeneration& generation, std::vector<Branch>& next) {
        CStem stem{};
        stem.firstSegment = static_cast<std::uint32_t>(generation.segments.size());
        stem.firstPath = static_cast<std::uint32_t>(generation.paths.size());
        stem.pathCount = 1;
        stem.id = m_word.id(m_segments[branch.segment].module);
        const auto number = static_cast<std::uint32_t>(generation.stems.size());
        const std::size_t firstBranch = next.size();
        for (std::uint32_t i = branch.segment; i != kNone; i = addSegment(i, stem, number, generation, next)) {}
        if (stem.segmentCount == 0) { // only segments without a length
            next.resize(firstBranch);
            return;
        }
        stem.radius = generation.segments[stem.firstSegment].radiusBase;
        stem.profile.form = RadiusProfile::Form::Steps;
        stem.parent = branch.parent;
        stem.position = branch.position;
        if (branch.parent >= 0) sitOn(stem);
        generation.paths.push_back({stem.id, stem.firstSegment, stem.segmentCount, 0, -1});
        generation.stems.push_back(stem);
        generation.shares.push_back(m_shares.empty() ? 1 : m_shares[m_segments[branch.segment].module]);
    }

    /// Appends a segment; gives the one that goes on, or none.
    std::uint32_t addSegment(std::uint32_t i, CStem& stem, std::uint32_t number, CTurtleGeneration& generation,
                             std::vector<Branch>& next) {
        const TurtleSegment& drawn = m_segments[i];
        if (drawn.length > kNothing) {
            const double radius = drawn.width / 2;
            generation.segments.push_back({drawn.position, drawn.frame, stem.length, drawn.length, radius, radius, 0, false});
            generation.writers.push_back(m_word.writer(drawn.module));
            stem.length += drawn.length;
            ++stem.segmentCount;
        }
        m_bearers[i] = {static_cast<std::uint32_t>(m_generations.size()), number};
        const std::uint32_t heir = heirOf(i);
        const std::uint32_t position = stem.segmentCount > 0 ? stem.segmentCount - 1 : 0;
        m_children.visitChildren(i, [&](std::uint32_t child) {
            if (child != heir) next.push_back({child, static_cast<std::int32_t>(number), position});
        });
        return heir;
    }

    std::uint32_t heirOf(std::uint32_t i) const {
        std::uint32_t heir = kNone;
        double straightest = -2;
        m_children.visitChildren(i, [&](std::uint32_t child) {
            const bool outside = m_segments[child].depth <= m_segments[i].depth;
            const double cosine = outside ? 2 : glm::dot(m_segments[child].frame[2], m_segments[i].frame[2]);
            if (cosine <= straightest + kAlike) return;
            straightest = cosine;
            heir = child;
        });
        return heir;
    }

    /// Sorted by stem; where it is the same, in the order of the word.
    void addOrgans() {
        if (m_generations.empty()) return;
        for (const TurtleOrgan& organ : m_organs) {
            const Bearer bearer = organ.below < 0 ? Bearer{0, 0} : m_bearers[static_cast<std::size_t>(organ.below)];
            if (bearer.generation >= m_generations.size() || organ.size == 0) continue;
            CTurtleGeneration& generation = *m_generations[bearer.generation];
            if (bearer.stem >= generation.stems.size()) continue; // it has no length
            const Frame& frame = organ.frame;
            generation.organs[static_cast<std::size_t>(organ.organ)].push_back(
                {glm::vec3(organ.position), glm::vec3(frame[2]), glm::vec3(frame[0]), static_cast<float>(organ.size),
                 static_cast<float>(organ.share), bearer.stem});
        }
        for (const auto& generation : m_generations)
            for (auto& written : generation->organs)
                std::stable_sort(written.begin(), written.end(),
                                 [](const auto& a, const auto& b) { return a.stem < b.stem; });
    }

    void sitOn(CStem& stem) const {
        const CGeneration& below = *m_generations.back();
        const CStem& parent = below.stems[static_cast<std::size_t>(stem.parent)];
        const CSegment& wood = below.segments[parent.firstSegment + stem.position];
        stem.offset = wood.end();
        stem.parentRadius = wood.radiusEnd;
        stem.atNode = true;
    }

    const CWord& m_word;
    const std::vector<float>& m_shares;
    const std::vector<TurtleSegment>& m_segments;
    CChildLists m_children;
    const std::vector<TurtleOrgan>& m_organs;
    std::vector<Bearer> m_bearers; ///< by segment
    std::vector<std::shared_ptr<CTurtleGeneration>> m_generations;
};
} // namespace

std::vector<std::shared_ptr<const CTurtleGeneration>> stemsOf(const CWord& word, const TurtlePath& path,
                                                              const CProgress& progress) {
    return CStemCollector(word, {}, path).collect(progress);
}

std::vector<std::shared_ptr<const CTurtleGeneration>> stemsOf(const GrowingWord& word, const TurtlePath& path,
                                                              const CProgress& progress) {
    return CStemCollector(word.word, word.shares, path).collect(progress);
}

} // namespace stromar
