#pragma once
#include "stromar/tree/SizeBound.h"
#include "stromar/tree/TreeBuilder.h"
#include "stromar/tree/lsystem/Grammar.h"
#include "stromar/tree/lsystem/Turtle.h"

namespace stromar {

/// Trees of a grammar: its word is derived, drawn by a turtle, and what that draws is cut into stems. Messages about the
/// grammar name kGrammarKey as their file; their lines are those of the text.
class CLSystemBuilder : public ITreeBuilder {
public:
    static constexpr const char* kGrammarKey = "Grammar";

    /// `varied` false replaces every random number by its middle value.
    explicit CLSystemBuilder(bool varied = true) : m_varied(varied) {}

    /// Throws CInputError for a grammar that is wrong, CError for one that draws nothing.
    std::shared_ptr<const CTree> build(const CParams& params, const CTree* previous, int firstInvalid,
                                       const CProgress& progress) const override;
    /// The tree at an age of 0..1 of its life: its word grows evenly from nothing through all derivations. At 1 it is
    /// build()'s tree, at 0 it has no stems. Throws as build().
    std::shared_ptr<const CTree> atAge(const CParams& params, const std::shared_ptr<const CTree>& grown, double age,
                                       const CProgress& progress) const override;
    /// What the word writes, then what StemLeaves, Blossoms and Fruits put on stems without branches.
    std::shared_ptr<const COrgans> growOrgans(const CParams& params, const CTree& tree, Organ organ,
                                              const OrganDemand& demand, const CProgress& progress) const override;

private:
    bool m_varied;
};

/// The grammar of a tree. Throws CInputError.
Grammar grammarOf(const CParams& params);
TurtleParams turtleParamsOf(const CParams& params);
/// The word after so many derivations, as CLSystemBuilder makes it.
CWord wordOf(const CParams& params, const Grammar& grammar, int derivations, bool varied, const CProgress& progress,
             std::size_t maxModules = CRewriter::kMaxModules);

/// How large a word is.
struct WordSize {
    std::array<double, 256> modules{}; ///< of each letter
    double numbers = 0;                ///< of all modules

    double total() const; ///< modules
    double bytes() const;
};
/// After so many derivations, where neither conditions nor context nor chance decide; else nothing. By rewriting numbers
/// of modules: takes microseconds.
std::optional<WordSize> countModules(const Grammar& grammar, int derivations);

/// Of a tree of up to 500,000 segments and organs it is what its seed grows, for it is grown to know; of a larger one, what the
/// numbers of modules say. Throws as build() does, and CError when there are more modules than CRewriter allows.
SizeBound lsystemBound(const CParams& params, const CProgress& progress);

} // namespace stromar
