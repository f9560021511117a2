#pragma once
#include "stromar/tree/lsystem/Grammar.h"
#include "stromar/util/Progress.h"
#include "stromar/util/RawVector.h"
#include <cstdint>
#include <span>

namespace stromar {

constexpr std::uint16_t kNoProduction = 0xffff;

/// The modules that a grammar has derived so far. 15 bytes a module and 8 for each of its numbers.
class CWord {
public:
    std::size_t size() const { return m_symbols.size(); }
    Symbol symbol(std::size_t i) const { return m_symbols[i]; }
    std::span<const double> numbers(std::size_t i) const {
        return {m_numbers.data() + m_firstNumber[i], m_numbers.data() + m_firstNumber[i + 1]};
    }
    /// The same in every word in which the module came about in the same way: a hash of its parent's and of its place in
    /// the successor. A module that is copied keeps its own.
    std::uint64_t id(std::size_t i) const { return m_ids[i]; }
    /// Which production of the grammar wrote it; kNoProduction: the axiom. What a module grows into is written by what wrote
    /// the module.
    std::uint16_t writer(std::size_t i) const { return m_writers[i]; }
    std::size_t numberCount() const { return m_numbers.size(); }
    std::size_t bytes() const { return size() * kModuleBytes + m_numbers.size() * sizeof(double); }
    static constexpr std::size_t kModuleBytes = sizeof(Symbol) + sizeof(std::uint64_t) + sizeof(std::uint16_t) + sizeof(std::uint32_t);
    /// "F(1)[+A(0.5,2)]", numbers to so many digits.
    std::string text(std::size_t first, std::size_t count, int digits = 17) const;

private:
    friend class CRewriter;
    void resize(std::size_t modules, std::size_t numbers);
    void add(Symbol symbol, std::uint64_t id, std::uint16_t writer);
    void addNumber(double number);

    RawVector<Symbol> m_symbols;
    RawVector<std::uint64_t> m_ids;
    RawVector<std::uint16_t> m_writers;
    RawVector<std::uint32_t> m_firstNumber; ///< one more than there are modules
    RawVector<double> m_numbers;
};

/// A word between two derivations.
struct GrowingWord {
    CWord word;
    std::vector<float> shares; ///< by module: how much of it is there, 0..1; empty: all of every one

    float share(std::size_t i) const { return shares.empty() ? 1 : shares[i]; }
};

/// Rewrites words. All modules of a word are rewritten at once; those without a matching production are copied. Which of
/// several productions is taken is a pure function of the seed and the module's identity. The same result for every
/// number of threads.
class CRewriter {
public:
    static constexpr std::size_t kMaxModules = 100'000'000;
    static constexpr std::size_t kMaxNumbersEach = 4; ///< on average, of a word of so many modules

    /// `varied` false replaces every random number by its middle value.
    CRewriter(const Grammar& grammar, std::uint64_t seed, bool varied = true, std::size_t maxModules = kMaxModules);

    CWord axiom() const;
    /// The next word. Throws CInputError with the place of a number that is not finite, CError when there are more
    /// modules or numbers than allowed, before they are held, CCancelled.
    CWord derive(const CWord& word, const CProgress& progress) const;
    CWord derive(int times, const CProgress& progress) const;
    /// After so many derivations and a part of the next one; below 0 the axiom grows from nothing, at -1 it has nothing. The
    /// heir of a module is on its way to its new numbers, what else was written grows, what was drawn and has no heir shrinks.
    /// One thread for the last step; throws as derive().
    GrowingWord grow(double derivations, const CProgress& progress) const;
    /// How often each production would be applied to derive the next word.
    std::vector<std::size_t> applied(const CWord& word, const CProgress& progress) const;

private:
    /// The formal parameters of a production with context.
    struct Match {
        std::array<double, kMaxFormals> formals;
    };

    const Production* productionOf(const CWord& word, std::size_t i, Match& match) const;
    bool matches(const CWord& word, std::size_t i, const Production& production, Match& match) const;
    bool matchesLeft(const CWord& word, std::size_t i, const Production& production, Match& match) const;
    bool matchesRight(const CWord& word, std::size_t i, const Production& production, Match& match) const;
    const Production* drawn(const CWord& word, std::size_t i, std::size_t first, Match& match) const;
    ExpressionInput inputOf(const CWord& word, std::size_t i, const Production& production, const Match& match) const;
    void write(const CWord& word, std::size_t i, const Production* production, CWord& next, std::size_t module,
               std::size_t number) const;
    void growModule(const CWord& word, std::size_t i, const Production& production, const Match& match, float share, GrowingWord& next) const;
    double valueOf(const CExpression& value, const ExpressionInput& input, const SuccessorModule& made, const CWord& word, std::size_t i) const;
    static std::vector<std::uint32_t> keptByCuts(const CWord& word);
    static CWord cut(const CWord& word);

    const Grammar& m_grammar;
    std::uint64_t m_seed;
    bool m_varied;
    std::size_t m_maxModules;
    std::array<std::vector<std::uint16_t>, 256> m_productions; ///< by predecessor, in their order
    bool m_cuts; ///< some word may have a %
};

} // namespace stromar
