#include "CommonValues.h"
#include "lsystem/OrganPlacer.h"
#include "stromar/params/methods/lsystem/LSystemParams.h"
#include "stromar/tree/lsystem/LSystemBuilder.h"
#include "stromar/tree/lsystem/TurtleStems.h"
#include "stromar/util/Text.h"
#include "stromar/util/Translatable.h"
#include <algorithm>

namespace stromar {

namespace {
/// Runs `work`, whose messages have lines of the grammar's text.
template <typename Work>
auto withGrammarNamed(Work&& work) {
    try {
        return work();
    } catch (const CInputError& e) {
        Messages messages = e.messages();
        for (Message& message : messages) message.file = CLSystemBuilder::kGrammarKey;
        throw CInputError(std::move(messages));
    }
}

double heightOf(const std::vector<TurtleSegment>& segments) {
    double height = 0;
    for (const TurtleSegment& segment : segments)
        height = std::max(height, segment.position.z + segment.length * std::max(0.0, segment.frame[2].z));
    return std::max(height, 1e-3);
}
} // namespace

Grammar grammarOf(const CParams& params) {
    return withGrammarNamed([&] { return parseGrammar(lsystem(params).grammar); });
}

TurtleParams turtleParamsOf(const CParams& params) {
    const LSystemParams& l = lsystem(params);
    return {l.lengthUnit, l.widthUnit, l.turnAngle.radians(), {l.tropismX, l.tropismY, l.tropismZ}, l.tropismBend};
}

CWord wordOf(const CParams& params, const Grammar& grammar, int derivations, bool varied, const CProgress& progress,
             std::size_t maxModules) {
    const auto seed = static_cast<std::uint64_t>(static_cast<std::int64_t>(params.common.seed));
    return withGrammarNamed([&] { return CRewriter(grammar, seed, varied, maxModules).derive(derivations, progress); });
}

std::shared_ptr<const CTree> CLSystemBuilder::build(const CParams& params, const CTree* previous, int firstInvalid,
                                                    const CProgress& progress) const {
    const BaseForm base = baseFormOf(params.common);
    if (previous && firstInvalid >= static_cast<int>(previous->generationCount()))
        return std::make_shared<const CTree>(previous->height(), previous->generations(), base);
    const Grammar grammar = grammarOf(params);
    const int derivations = lsystem(params).derivations;
    const CWord word = wordOf(params, grammar, derivations, m_varied, progress);
    const TurtlePath path = interpret(word, turtleParamsOf(params), progress);
    const auto stems = stemsOf(word, path, progress);
    if (stems.empty())
        throw CError(translated(NC_("stromar", "the grammar draws nothing: its word has no F with a length after %1 derivations"), derivations));
    return std::make_shared<const CTree>(heightOf(path.segments),
                                         std::vector<std::shared_ptr<const CGeneration>>(stems.begin(), stems.end()), base);
}

std::shared_ptr<const CTree> CLSystemBuilder::atAge(const CParams& params, const std::shared_ptr<const CTree>& grown, double age,
                                                    const CProgress& progress) const {
    if (age >= 1) return grown;
    const BaseForm base = baseFormOf(params.common);
    const Grammar grammar = grammarOf(params);
    const auto seed = static_cast<std::uint64_t>(static_cast<std::int64_t>(params.common.seed));
    const double derivations = std::max(0.0, age) * (lsystem(params).derivations + 1) - 1;
    const GrowingWord word = withGrammarNamed([&] { return CRewriter(grammar, seed, m_varied).grow(derivations, progress); });
    const TurtlePath path = interpret(word, turtleParamsOf(params), progress);
    const auto stems = stemsOf(word, path, progress);
    return std::make_shared<const CTree>(heightOf(path.segments),
                                         std::vector<std::shared_ptr<const CGeneration>>(stems.begin(), stems.end()), base);
}

std::shared_ptr<const COrgans> CLSystemBuilder::growOrgans(const CParams& params, const CTree& tree, Organ organ,
                                                           const OrganDemand& demand, const CProgress& progress) const {
    return COrganPlacer(params, tree, organ).grow(demand, progress);
}

} // namespace stromar
