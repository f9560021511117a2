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
    /// The stems of a tree that build() made of the same parameters at an age of 0..1 of its life: those that are born, cut
    /// where their tips have come. At 1 it is that tree, at 0 it has no stems. Throws CCancelled.
    std::shared_ptr<const CTree> atAge(const CParams& params, const std::shared_ptr<const CTree>& grown, double age,
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
