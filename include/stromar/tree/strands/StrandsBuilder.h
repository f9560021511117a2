#pragma once
#include "stromar/params/methods/strands/StrandsParams.h"
#include "stromar/tree/SizeBound.h"
#include "stromar/tree/TreeBuilder.h"

namespace stromar {

/// A branch of the strand model, from one split to the next: one segment of a stem.
struct StrandBranch {
    double strands;     ///< S
    double inherited;   ///< L, metres
    double height;      ///< of its base, metres
    double rootLength;  ///< from the root to its base along the wood, metres
    double diameter;    ///< d at its base, metres
    std::uint32_t order; ///< turns aside below it (Gravelius)
    std::uint32_t depth; ///< splits below it (Weibull)

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
    /// On the ends of one strand, of every stem.
    std::shared_ptr<const COrgans> growOrgans(const CParams& params, const CTree& tree, Organ organ,
                                              const OrganDemand& demand, const CProgress& progress) const override;

private:
    bool m_varied;
};

/// Which the tree has whatever its seed; it is grown to know.
SizeBound strandsBound(const CParams& params, const CProgress& progress);

} // namespace stromar
