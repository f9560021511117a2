#include "CommonValues.h"
#include "MeasuredBound.h"
#include "lsystem/OrganPlacer.h"
#include "stromar/params/methods/lsystem/LSystemParams.h"
#include "stromar/tree/lsystem/LSystemBuilder.h"
#include "stromar/tree/lsystem/TurtleStems.h"
#include "stromar/util/Text.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace stromar {

namespace {
constexpr double kMeasured = 500'000;       // segments and organs up to which a tree is grown to know its size
constexpr std::size_t kMaxDerived = 20'000'000; // modules, where only deriving them tells how many there are
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

/// Of one that is too large to be grown for this: every segment is a stem as thick as the trunk, and one of its limbs.
void estimate(double segments, SizeBound& bound) {
    GenerationBound all;
    all.stems = segments;
    all.several = {1, 1};
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
        throw CError(
            translated(NC_("stromar", "this grammar makes %1 modules in %2 derivations; at most %3 are allowed"),
                       wholeText(counted->total()), l.derivations, CRewriter::kMaxModules));
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
            const auto leaves = COrganPlacer(params, tree, Organ::Leaf).grow(OrganDemand::none(), progress);
            bound.twigs = twigBoundOf(tree, *leaves, poseOf(params.common, Organ::Leaf).length);
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
