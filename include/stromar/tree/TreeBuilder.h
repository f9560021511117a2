#pragma once
#include "stromar/params/ParamTable.h"
#include "stromar/tree/Tree.h"
#include "stromar/util/Progress.h"
#include <memory>

namespace stromar {

/// A way to grow a tree from parameters.
class ITreeBuilder {
public:
    virtual ~ITreeBuilder() = default;

    /// Grows the stems. Generations before `firstInvalid` are taken over from `previous`, which was grown by the same
    /// builder from parameters that differ only as invalidationOf() says; null grows everything. Throws CCancelled.
    virtual std::shared_ptr<const CTree> build(const CParams& params, const CTree* previous, int firstInvalid,
                                               const CProgress& progress) const = 0;
    /// The stems at an age of 0..1 of the tree's life. `grown` is what build() made of the same parameters; at 1 it is the
    /// result, at 0 there are no stems. Continuous in the age. Throws as build().
    virtual std::shared_ptr<const CTree> atAge(const CParams& params, const std::shared_ptr<const CTree>& grown, double age,
                                               const CProgress& progress) const = 0;
    /// Grows the organs of a kind that are asked for on a tree that this builder made of the same parameters, at any age.
    /// All are counted. Throws CCancelled.
    virtual std::shared_ptr<const COrgans> growOrgans(const CParams& params, const CTree& tree, Organ organ,
                                                      const OrganDemand& demand, const CProgress& progress) const = 0;
};

/// A tree with all its organs.
std::shared_ptr<const CTree> growTree(const ITreeBuilder& builder, const CParams& params, const CProgress& progress, double age = 1);

} // namespace stromar
