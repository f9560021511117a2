#pragma once
#include "stromar/params/methods/strands/StrandsParams.h"
#include "stromar/tree/SizeBound.h"
#include "stromar/tree/TreeBuilder.h"

namespace stromar {

/// A branch of the strand model, from one split to the next: one segment of a stem.
struct StrandBranch {
    double strands;      ///< S; between two whole numbers while the tree grows
    double inherited;    ///< L, metres
    double height;       ///< of its base, metres
    double rootLength;   ///< from the root to its base along the wood, metres
    double diameter;     ///< d at its base, metres
    std::uint32_t order; ///< turns aside below it (Gravelius)
    std::uint32_t depth; ///< splits below it (Weibull)

    double share = 1;    ///< that has grown of a branch that has just appeared, 0..1

    /// What a curve runs over: a number, metres, or centimetres of thickness.
    double quantity(CurveOver over) const;
};

/// A stem is a branch with all leaders above it, to the end of one strand; its generation is its order.
struct CStrandGeneration : CGeneration {
    std::vector<StrandBranch> branches; ///< by segment
};

/// Trees of strands: Holton, "Strands, gravity and botanical tree imagery" (1994), as Zamuda & Strnad used it. Nothing is
/// drawn by chance unless StrandVariation or a seed ask for it.
class CStrandsBuilder : public ITreeBuilder {
public:
    /// `varied` false: as StrandVariation 0 and Seed 0.
    explicit CStrandsBuilder(bool varied = true) : m_varied(varied) {}

    std::shared_ptr<const CTree> build(const CParams& params, const CTree* previous, int firstInvalid,
                                       const CProgress& progress) const override;
    /// The tree at an age of 0..1 of its life (strands.md, growth): its strands go by the square of the age, so that it thickens
    /// evenly; trunk and lengths go by the age. Its branches are some of the grown tree's. At 1 it is build()'s tree, at 0
    /// it has no stems. Continuous in the age. Throws CCancelled.
    std::shared_ptr<const CTree> atAge(const CParams& params, const std::shared_ptr<const CTree>& grown, double age,
                                       const CProgress& progress) const override;
    /// On the ends of one strand, of every stem; those of a branch that splits shrink while its children grow.
    std::shared_ptr<const COrgans> growOrgans(const CParams& params, const CTree& tree, Organ organ,
                                              const OrganDemand& demand, const CProgress& progress) const override;

private:
    bool m_varied;
};

/// Which the tree has whatever its seed; it is grown to know.
SizeBound strandsBound(const CParams& params, const CProgress& progress);

} // namespace stromar
