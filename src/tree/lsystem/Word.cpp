#include "stromar/tree/lsystem/Word.h"
#include "stromar/util/Parallel.h"
#include "stromar/util/Random.h"
#include "stromar/util/Text.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace stromar {

namespace {
constexpr std::size_t kGrain = 16384;
constexpr std::uint64_t kAxiomId = 0x61786d, kChoice = 0x6368;

bool isDrawn(Symbol symbol) {
    return symbol == 'F' || symbol == 'f' || symbol == kLeafSymbol || symbol == kBlossomSymbol || symbol == kFruitSymbol;
}

[[noreturn]] void failTooLong(std::size_t max, std::string_view what) { throw CError(translated(what, max)); }

/// To so many significant digits.
double rounded(double value, int digits) {
    if (value == 0 || !std::isfinite(value)) return value;
    const double perUnit = std::pow(10, digits - 1 - std::floor(std::log10(std::abs(value))));
    return std::isfinite(perUnit) && perUnit > 0 ? std::round(value * perUnit) / perUnit : value;
}
} // namespace

void CWord::resize(std::size_t modules, std::size_t numbers) {
    m_symbols.resize(modules);
    m_ids.resize(modules);
    m_writers.resize(modules);
    m_firstNumber.resize(modules + 1);
    m_numbers.resize(numbers);
    m_firstNumber[modules] = static_cast<std::uint32_t>(numbers);
}

void CWord::add(Symbol symbol, std::uint64_t id, std::uint16_t writer) {
    if (m_firstNumber.empty()) m_firstNumber.push_back(0);
    m_symbols.push_back(symbol);
    m_ids.push_back(id);
    m_writers.push_back(writer);
    m_firstNumber.push_back(static_cast<std::uint32_t>(m_numbers.size()));
}

/// Of the module that was added last.
void CWord::addNumber(double number) {
    m_numbers.push_back(number);
    m_firstNumber.back() = static_cast<std::uint32_t>(m_numbers.size());
}

std::string CWord::text(std::size_t first, std::size_t count, int digits) const {
    std::string text;
    for (std::size_t i = first; i < std::min(size(), first + count); ++i) {
        text += symbolName(symbol(i));
        for (std::size_t k = 0; k < numbers(i).size(); ++k) text += (k == 0 ? "(" : ",") + numberText(rounded(numbers(i)[k], digits));
        if (!numbers(i).empty()) text += ")";
    }
    return text;
}

CRewriter::CRewriter(const Grammar& grammar, std::uint64_t seed, bool varied, std::size_t maxModules)
    : m_grammar(grammar), m_seed(seed), m_varied(varied), m_maxModules(maxModules) {
    const auto hasCut = [](const std::vector<SuccessorModule>& word) {
        return std::ranges::find(word, Symbol('%'), &SuccessorModule::symbol) != word.end();
    };
    m_cuts = hasCut(grammar.axiom);
    for (std::size_t p = 0; p < grammar.productions.size(); ++p) {
        m_productions[grammar.productions[p].predecessor.symbol].push_back(static_cast<std::uint16_t>(p));
        m_cuts = m_cuts || hasCut(grammar.productions[p].successor);
    }
}

CWord CRewriter::axiom() const {
    CWord word;
    std::size_t numbers = 0;
    for (const SuccessorModule& module : m_grammar.axiom) numbers += module.numbers.size();
    word.resize(m_grammar.axiom.size(), numbers);
    std::size_t number = 0;
    for (std::size_t i = 0; i < m_grammar.axiom.size(); ++i) {
        const SuccessorModule& module = m_grammar.axiom[i];
        word.m_symbols[i] = module.symbol;
        word.m_ids[i] = hashCombine(kAxiomId, i);
        word.m_writers[i] = kNoProduction;
        word.m_firstNumber[i] = static_cast<std::uint32_t>(number);
        for (const CExpression& value : module.numbers)
            word.m_numbers[number++] = value.evaluate({{}, hashCombine(m_seed, word.m_ids[i]), m_varied});
    }
    return m_cuts ? cut(word) : word;
}

CWord CRewriter::derive(int times, const CProgress& progress) const {
    CWord word = axiom();
    for (int i = 0; i < times; ++i) word = derive(word, progress);
    return word;
}

CWord CRewriter::derive(const CWord& word, const CProgress& progress) const {
    std::vector<std::uint16_t> chosen(word.size());
    std::vector<std::pair<std::size_t, std::size_t>> starts(word.size() / kGrain + 2); // modules, numbers
    const auto count = [&](std::size_t begin, std::size_t end) {
        Match match;
        std::size_t modules = 0, numbers = 0;
        for (std::size_t i = begin; i < end; ++i) {
            const Production* production = productionOf(word, i, match);
            chosen[i] = production ? static_cast<std::uint16_t>(production - m_grammar.productions.data()) : kNoProduction;
            modules += production ? production->successor.size() : 1;
            numbers += production ? production->numbers : word.numbers(i).size();
        }
        starts[begin / kGrain + 1] = {modules, numbers};
    };
    parallelFor(word.size(), kGrain, count, progress);
    for (std::size_t c = 1; c < starts.size(); ++c) {
        starts[c].first += starts[c - 1].first;
        starts[c].second += starts[c - 1].second;
    }
    const auto [modules, numbers] = starts.back();
    static_assert(kMaxNumbersEach * kMaxModules <= std::numeric_limits<std::uint32_t>::max());
    if (modules > m_maxModules)
        failTooLong(m_maxModules, NC_("stromar", "the word of this grammar would have more than %1 modules"));
    if (numbers > kMaxNumbersEach * m_maxModules)
        failTooLong(kMaxNumbersEach * m_maxModules,
                    NC_("stromar", "the word of this grammar would have more than %1 numbers"));
    CWord next;
    next.resize(modules, numbers);
    const auto rewrite = [&](std::size_t begin, std::size_t end) {
        auto [module, number] = starts[begin / kGrain];
        for (std::size_t i = begin; i < end; ++i) {
            const Production* production = chosen[i] == kNoProduction ? nullptr : &m_grammar.productions[chosen[i]];
            write(word, i, production, next, module, number);
            module += production ? production->successor.size() : 1;
            number += production ? production->numbers : word.numbers(i).size();
        }
    };
    parallelFor(word.size(), kGrain, rewrite, progress);
    return m_cuts ? cut(next) : std::move(next);
}

GrowingWord CRewriter::grow(double derivations, const CProgress& progress) const {
    const double whole = std::floor(derivations);
    const auto share = static_cast<float>(derivations - whole);
    if (whole < 0) {
        GrowingWord all{axiom(), {}};
        all.shares.assign(all.word.size(), share);
        return all;
    }
    CWord word = derive(static_cast<int>(whole), progress);
    if (share == 0) return {std::move(word), {}};
    GrowingWord next;
    Match match;
    for (std::size_t i = 0; i < word.size(); ++i) {
        if (i % kGrain == 0) progress.poll();
        if (next.word.size() > m_maxModules)
            failTooLong(m_maxModules, NC_("stromar", "the word of this grammar would have more than %1 modules"));
        if (const Production* production = productionOf(word, i, match)) {
            growModule(word, i, *production, match, share, next);
            continue;
        }
        next.word.add(word.symbol(i), word.id(i), word.writer(i));
        for (const double number : word.numbers(i)) next.word.addNumber(number);
        next.shares.push_back(1);
    }
    if (!m_cuts) return next;
    GrowingWord left{cut(next.word), {}};
    for (const std::uint32_t i : keptByCuts(next.word)) left.shares.push_back(next.shares[i]);
    return left;
}

void CRewriter::growModule(const CWord& word, std::size_t i, const Production& production, const Match& match, float share,
                           GrowingWord& next) const {
    const auto writer = static_cast<std::uint16_t>(&production - m_grammar.productions.data());
    const bool hasHeir = production.heir < production.successor.size();
    if (!hasHeir && isDrawn(word.symbol(i))) {
        next.word.add(word.symbol(i), word.id(i), word.writer(i));
        for (const double number : word.numbers(i)) next.word.addNumber(number);
        next.shares.push_back(1 - share);
    }
    const ExpressionInput input = inputOf(word, i, production, match);
    for (std::size_t k = 0; k < production.successor.size(); ++k) {
        const SuccessorModule& made = production.successor[k];
        const bool isHeir = k == production.heir;
        next.word.add(made.symbol, hashCombine(word.id(i), k), isHeir ? word.writer(i) : writer);
        for (std::size_t n = 0; n < made.numbers.size(); ++n) {
            const double grown = valueOf(made.numbers[n], input, made, word, i);
            const bool wasThere = isHeir && n < word.numbers(i).size();
            next.word.addNumber(wasThere ? (1 - double(share)) * word.numbers(i)[n] + double(share) * grown : grown);
        }
        next.shares.push_back(isHeir ? 1 : share);
    }
}

double CRewriter::valueOf(const CExpression& value, const ExpressionInput& input, const SuccessorModule& made, const CWord& word,
                          std::size_t i) const {
    const double number = value.evaluate(input);
    if (!std::isfinite(number))
        throw CInputError({{Severity::Error,
                            {},
                            made.place.line,
                            made.place.column,
                            translated(NC_("stromar", "a number of %1 is not finite when %2 is rewritten"),
                                       symbolName(made.symbol), word.text(i, 1))}});
    return number;
}

std::vector<std::size_t> CRewriter::applied(const CWord& word, const CProgress& progress) const {
    std::vector<std::size_t> counts(m_grammar.productions.size(), 0);
    Match match;
    for (std::size_t i = 0; i < word.size(); ++i) {
        if (i % kGrain == 0) progress.poll();
        if (const Production* production = productionOf(word, i, match))
            ++counts[static_cast<std::size_t>(production - m_grammar.productions.data())];
    }
    return counts;
}

/// Of the productions that match: the first, or if that has a probability, one drawn among all that have.
const Production* CRewriter::productionOf(const CWord& word, std::size_t i, Match& match) const {
    const std::vector<std::uint16_t>& candidates = m_productions[word.symbol(i)];
    for (std::size_t c = 0; c < candidates.size(); ++c) {
        const Production& production = m_grammar.productions[candidates[c]];
        if (!matches(word, i, production, match)) continue;
        return production.probability ? drawn(word, i, c, match) : &production;
    }
    return nullptr;
}

const Production* CRewriter::drawn(const CWord& word, std::size_t i, std::size_t first, Match& match) const {
    const std::vector<std::uint16_t>& candidates = m_productions[word.symbol(i)];
    const bool context = m_grammar.productions[candidates[first]].hasContext();
    std::vector<std::pair<const Production*, double>> weights;
    double sum = 0;
    for (std::size_t c = first; c < candidates.size(); ++c) {
        const Production& production = m_grammar.productions[candidates[c]];
        if (!production.probability || production.hasContext() != context || !matches(word, i, production, match)) continue;
        const double weight = production.probability->evaluate(inputOf(word, i, production, match));
        if (!(weight > 0)) continue;
        weights.emplace_back(&production, weight);
        sum += weight;
    }
    double left = sum * (m_varied ? unitOf(hashCombine(hashCombine(m_seed, word.id(i)), kChoice)) : 0.5);
    for (const auto& [production, weight] : weights)
        if ((left -= weight) < 0) return production;
    return weights.empty() ? nullptr : weights.back().first;
}

ExpressionInput CRewriter::inputOf(const CWord& word, std::size_t i, const Production& production,
                                   const Match& match) const {
    const std::uint64_t place = hashCombine(m_seed, word.id(i));
    if (!production.hasContext()) return {word.numbers(i), place, m_varied};
    return {std::span(match.formals).first(production.formals), place, m_varied};
}

bool CRewriter::matches(const CWord& word, std::size_t i, const Production& production, Match& match) const {
    if (word.numbers(i).size() != production.predecessor.numbers) return false;
    if (production.hasContext()) {
        std::ranges::copy(word.numbers(i), match.formals.begin() + production.predecessor.firstFormal);
        if (!matchesLeft(word, i, production, match) || !matchesRight(word, i, production, match)) return false;
    }
    if (const auto constant = production.condition.constant()) return *constant != 0;
    return production.condition.evaluate(inputOf(word, i, production, match)) != 0;
}

/// Towards the root: branches that start before are passed over (The Algorithmic Beauty of Plants §1.8).
bool CRewriter::matchesLeft(const CWord& word, std::size_t i, const Production& production, Match& match) const {
    std::size_t at = i;
    for (auto wanted = production.left.rbegin(); wanted != production.left.rend(); ++wanted) {
        for (int depth = 0;;) {
            if (at == 0) return false;
            const Symbol symbol = word.symbol(--at);
            if (symbol == ']') ++depth;
            if (symbol == '[' && depth > 0) {
                --depth;
                continue;
            }
            if (depth > 0 || symbol == '[' || symbol == ']' || m_grammar.ignored[symbol]) continue;
            break;
        }
        if (word.symbol(at) != wanted->symbol || word.numbers(at).size() != wanted->numbers) return false;
        std::ranges::copy(word.numbers(at), match.formals.begin() + wanted->firstFormal);
    }
    return true;
}

/// Towards the tip of the own branch.
bool CRewriter::matchesRight(const CWord& word, std::size_t i, const Production& production, Match& match) const {
    std::size_t at = i;
    for (const ModulePattern& wanted : production.right) {
        for (int depth = 0;;) {
            if (++at >= word.size()) return false;
            const Symbol symbol = word.symbol(at);
            if (symbol == ']' && depth == 0) return false;
            if (symbol == '[') ++depth;
            if (symbol == ']') {
                --depth;
                continue;
            }
            if (depth > 0 || m_grammar.ignored[symbol]) continue;
            break;
        }
        if (word.symbol(at) != wanted.symbol || word.numbers(at).size() != wanted.numbers) return false;
        std::ranges::copy(word.numbers(at), match.formals.begin() + wanted.firstFormal);
    }
    return true;
}

void CRewriter::write(const CWord& word, std::size_t i, const Production* production, CWord& next, std::size_t module,
                      std::size_t number) const {
    if (!production) {
        next.m_symbols[module] = word.symbol(i);
        next.m_ids[module] = word.id(i);
        next.m_writers[module] = word.writer(i);
        next.m_firstNumber[module] = static_cast<std::uint32_t>(number);
        std::ranges::copy(word.numbers(i), next.m_numbers.begin() + static_cast<std::ptrdiff_t>(number));
        return;
    }
    Match match;
    if (production->hasContext()) matches(word, i, *production, match); // the formals once more
    const ExpressionInput input = inputOf(word, i, *production, match);
    for (std::size_t k = 0; k < production->successor.size(); ++k, ++module) {
        const SuccessorModule& made = production->successor[k];
        next.m_symbols[module] = made.symbol;
        next.m_ids[module] = hashCombine(word.id(i), k);
        next.m_writers[module] = k == production->heir ? word.writer(i) : static_cast<std::uint16_t>(production - m_grammar.productions.data());
        next.m_firstNumber[module] = static_cast<std::uint32_t>(number);
        for (const CExpression& value : made.numbers) next.m_numbers[number++] = valueOf(value, input, made, word, i);
    }
}

/// The modules that do not follow a % in their branch.
std::vector<std::uint32_t> CRewriter::keptByCuts(const CWord& word) {
    std::vector<std::uint32_t> kept;
    int depth = 0, cutDepth = -1; // of brackets; of the branch that is being cut
    for (std::size_t i = 0; i < word.size(); ++i) {
        const Symbol symbol = word.symbol(i);
        if (symbol == ']' && depth-- == cutDepth) cutDepth = -1;
        if (symbol == '%' && cutDepth < 0) cutDepth = depth;
        if (cutDepth < 0) kept.push_back(static_cast<std::uint32_t>(i));
        if (symbol == '[') ++depth;
    }
    return kept;
}

CWord CRewriter::cut(const CWord& word) {
    const std::vector<std::uint32_t> kept = keptByCuts(word);
    std::size_t numbers = 0;
    for (const std::uint32_t i : kept) numbers += word.numbers(i).size();
    CWord left;
    left.resize(kept.size(), numbers);
    std::size_t number = 0;
    for (std::size_t k = 0; k < kept.size(); ++k) {
        left.m_symbols[k] = word.symbol(kept[k]);
        left.m_ids[k] = word.id(kept[k]);
        left.m_writers[k] = word.writer(kept[k]);
        left.m_firstNumber[k] = static_cast<std::uint32_t>(number);
        for (const double value : word.numbers(kept[k])) left.m_numbers[number++] = value;
    }
    return left;
}

} // namespace stromar
