#include "CommonValues.h"
#include "lsystem/OrganPlacer.h"
#include "stromar/params/methods/lsystem/LSystemParams.h"
#include "stromar/tree/lsystem/LSystemBuilder.h"
#include "stromar/tree/lsystem/TurtleStems.h"
#include "stromar/util/Text.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

namespace stromar {

namespace {
constexpr double kMeasured = 500'000;       // segments and organs up to which a tree is grown to know its size
constexpr std::size_t kMaxDerived = 20'000'000; // modules, where only deriving them tells how many there are
constexpr double kMargin = 1 + 1e-9;        // of sums
constexpr std::size_t kThicknesses = 8;     // classes of one generation
constexpr double kSegmentBytes = sizeof(TurtleSegment) + 3 * sizeof(std::uint32_t); // of the path, and lists of children
constexpr double kOrganBytes = sizeof(TurtleOrgan) + sizeof(CTurtleGeneration::Written);
constexpr double kWords = 2; // that are held at once

/// A kind of module as productions tell them apart.
using ModuleKind = std::pair<Symbol, std::size_t>;

/// What one module of a kind becomes in one derivation.
class CCountRules {
public:
    explicit CCountRules(const Grammar& grammar) : m_grammar(grammar) {}

    /// Null when conditions, context or chance decide.
    const Production* productionOf(const ModuleKind& kind) {
        for (const Production& production : m_grammar.productions) {
            if (production.predecessor.symbol != kind.first || production.predecessor.numbers != kind.second) continue;
            const auto condition = production.condition.constant();
            if (production.hasContext() || production.probability || !condition) m_isPlain = false;
            if (condition.value_or(1) != 0) return &production;
        }
        return nullptr;
    }
    bool isPlain() const { return m_isPlain; }

private:
    const Grammar& m_grammar;
    bool m_isPlain = true;
};

using Counts = std::map<ModuleKind, double>;

void addWord(Counts& counts, const std::vector<SuccessorModule>& word, double times) {
    for (const SuccessorModule& module : word) counts[{module.symbol, module.numbers.size()}] += times;
}

bool cuts(const std::vector<SuccessorModule>& word) {
    return std::ranges::find(word, Symbol('%'), &SuccessorModule::symbol) != word.end();
}

WordSize sizeOf(const CWord& word) {
    WordSize size;
    for (std::size_t i = 0; i < word.size(); ++i) ++size.modules[word.symbol(i)];
    size.numbers = double(word.numberCount());
    return size;
}

double written(const WordSize& size, Organ organ) { return size.modules[kLeafSymbol + static_cast<std::size_t>(organ)]; }
double organsIn(const WordSize& size) {
    double sum = 0;
    for (const Organ organ : kOrgans) sum += written(size, organ);
    return sum;
}
/// Segments and organs.
double drawnBy(const WordSize& size) { return size.modules['F'] + organsIn(size); }

/// With all digits, as far as an integer holds them.
std::string wholeText(double number) {
    return number < 9e18 ? std::to_string(static_cast<std::uint64_t>(number)) : numberText(number);
}

/// How thick stems are, in classes of equally many.
std::vector<ThicknessShare> thicknessOf(const std::vector<const CStem*>& stems, double trunkRadius) {
    std::vector<double> radii;
    for (const CStem* stem : stems) radii.push_back(trunkRadius > 0 ? stem->radius / trunkRadius : 1);
    std::ranges::sort(radii);
    std::vector<ThicknessShare> shares;
    const std::size_t classes = std::min(kThicknesses, radii.size());
    for (std::size_t c = 0; c < classes; ++c) {
        const std::size_t first = c * radii.size() / classes, end = (c + 1) * radii.size() / classes;
        shares.push_back({double(end - first) / double(radii.size()), radii[end - 1]});
    }
    return shares;
}

GenerationBound boundOf(const CGeneration& generation, const std::vector<const CStem*>& stems, double trunkRadius) {
    GenerationBound bound;
    bound.stems = double(stems.size());
    double segments = 0, along = std::numeric_limits<double>::infinity(), cosine = 1;
    for (const CStem* stem : stems) {
        segments += stem->segmentCount;
        along = std::min(along, double(stem->segmentCount));
        for (std::uint32_t s = 1; s < stem->segmentCount; ++s) {
            const CSegment* segment = &generation.segments[stem->firstSegment + s];
            cosine = std::min(cosine, glm::dot(segment[-1].frame[2], segment->frame[2]));
        }
    }
    if (stems.empty()) return bound;
    bound.segments = segments / bound.stems * kMargin;
    bound.along = std::max(1.0, along);
    bound.thickness = thicknessOf(stems, trunkRadius);
    bound.turn = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
    return bound;
}

/// Of a tree that was grown: of all stems, or of those that are not in a set.
std::vector<GenerationBound> boundsOf(const CTree& tree, const StemSet& without = {}) {
    const double trunkRadius = tree.generation(0).stems[0].radius;
    std::vector<GenerationBound> bounds;
    for (std::size_t g = 0; g < tree.generationCount(); ++g) {
        std::vector<const CStem*> stems;
        for (std::size_t s = 0; s < tree.generation(g).stems.size(); ++s)
            if (!without.has(g, s)) stems.push_back(&tree.generation(g).stems[s]);
        bounds.push_back(boundOf(tree.generation(g), stems, trunkRadius));
    }
    return bounds;
}

TwigBound twigBoundOf(const CParams& params, const CTree& tree, const CProgress& progress) {
    const auto leaves = COrganPlacer(params, tree, Organ::Leaf).grow(OrganDemand::none(), progress);
    const StemSet twigs = twigsOf(tree, *leaves);
    TwigBound bound{.leafLength = poseOf(params.common, Organ::Leaf).length, .wood = boundsOf(tree, twigs)};
    for (std::size_t g = 0; g < twigs.stems.size(); ++g)
        for (std::size_t s = 0; s < twigs.stems[g].size(); ++s) {
            if (!twigs.stems[g][s]) continue;
            ++bound.stems;
            bound.leaves += leaves->countOn(g, s);
            bound.length += tree.generation(g).stems[s].length;
        }
    bound.otherLeaves = double(leaves->total) - bound.leaves;
    bound.leaves *= 2 / std::max(1.0, bound.stems);
    bound.length *= 2 / std::max(1.0, bound.stems);
    return bound;
}

/// Of one that is too large to be grown for this: every segment is a stem as thick as the trunk.
void estimate(double segments, SizeBound& bound) {
    GenerationBound all;
    all.stems = segments;
    bound.generations.push_back(all);
}
} // namespace

double WordSize::total() const { return std::accumulate(modules.begin(), modules.end(), 0.0); }
double WordSize::bytes() const { return total() * CWord::kModuleBytes + numbers * sizeof(double); }

std::optional<WordSize> countModules(const Grammar& grammar, int derivations) {
    CCountRules rules(grammar);
    Counts counts;
    addWord(counts, grammar.axiom, 1);
    if (cuts(grammar.axiom)) return {};
    for (int i = 0; i < derivations; ++i) {
        Counts next;
        for (const auto& [kind, number] : counts) {
            const Production* production = rules.productionOf(kind);
            if (!rules.isPlain() || (production && cuts(production->successor))) return {};
            if (production)
                addWord(next, production->successor, number);
            else
                next[kind] += number;
        }
        counts = std::move(next);
    }
    WordSize size;
    for (const auto& [kind, number] : counts) {
        size.modules[kind.first] += number;
        size.numbers += number * double(kind.second);
    }
    return size;
}

namespace {
SizeBound boundOf(const CParams& params, const CProgress& progress) {
    const LSystemParams& l = lsystem(params);
    const Grammar grammar = grammarOf(params);
    const auto counted = countModules(grammar, l.derivations);
    if (counted && counted->total() > double(CRewriter::kMaxModules))
        throw CError("this grammar makes " + wholeText(counted->total()) + " modules in " + std::to_string(l.derivations) +
                     " derivations; at most " + std::to_string(CRewriter::kMaxModules) + " are allowed");
    SizeBound bound;
    bound.base = baseFormOf(params.common);
    std::optional<CWord> word;
    if (!counted || drawnBy(*counted) <= kMeasured) word = wordOf(params, grammar, l.derivations, true, progress, kMaxDerived);
    const WordSize size = word ? sizeOf(*word) : *counted;
    if (drawnBy(size) <= kMeasured) {
        const auto stems = stemsOf(*word, interpret(*word, turtleParamsOf(params), progress), progress);
        if (!stems.empty()) {
            const CTree tree(1, {stems.begin(), stems.end()});
            bound.generations = boundsOf(tree);
            bound.twigs = twigBoundOf(params, tree, progress);
        }
    } else
        estimate(std::max(1.0, size.modules['F']), bound);
    bound.scratchPerSegment =
        kSegmentBytes + (kWords * size.bytes() + kOrganBytes * organsIn(size)) / std::max(1.0, size.modules['F']);
    for (const Organ organ : kOrgans) {
        const double perBearer = std::max(0, COrganPlacer::perBearer(params, organ));
        bound.organs[static_cast<std::size_t>(organ)] = written(size, organ) + perBearer * bound.stems();
    }
    return bound;
}
} // namespace

SizeBound lsystemBound(const CParams& params, const CProgress& progress) {
    // A step of a hand asks several times for the same tree.
    thread_local std::optional<std::pair<CParams, SizeBound>> last;
    if (!last || !(last->first == params)) last = {params, boundOf(params, progress)};
    return last->second;
}

} // namespace stromar
