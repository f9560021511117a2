#pragma once
#include "stromar/tree/SizeBound.h"
#include "stromar/tree/TreeBuilder.h"

namespace stromar {

/// The model of Weber & Penn, "Creation and Rendering of Realistic Trees", SIGGRAPH '95.
class CWeberPennBuilder : public ITreeBuilder {
public:
    /// `varied` false replaces every random number by its middle value.
    explicit CWeberPennBuilder(bool varied = true) : m_varied(varied) {}

    std::shared_ptr<const CTree> build(const CParams& params, const CTree* previous, int firstInvalid,
                                       const CProgress& progress) const override;
    std::shared_ptr<const COrgans> growOrgans(const CParams& params, const CTree& tree, Organ organ,
                                              const OrganDemand& demand, const CProgress& progress) const override;

private:
    bool m_varied;
};

SizeBound weberPennBound(const CParams& params, const CProgress& progress);

/// The height of the tree that a seed gives, metres (Weber & Penn §4.3).
double scaleOfTree(const CParams& params, bool varied);

} // namespace stromar
