#pragma once
#include "stromar/app/Methods.h"

namespace stromar::test {

/// The values of a way to grow that only the tests know: one of each kind.
struct PoleParams {
    double height;
    Degrees lean;
    CCurve thickness;
    std::string plan;
    int pieces, top, bent;

    bool operator==(const PoleParams&) const = default;
};

/// A pole of unequal pieces, with leaves along it.
class CPoleBuilder : public ITreeBuilder {
public:
    std::shared_ptr<const CTree> build(const CParams& params, const CTree* previous, int firstInvalid,
                                       const CProgress& progress) const override;
    /// A pole does not grow.
    std::shared_ptr<const CTree> atAge(const CParams&, const std::shared_ptr<const CTree>& grown, double, const CProgress&) const override {
        return grown;
    }
    std::shared_ptr<const COrgans> growOrgans(const CParams& params, const CTree& tree, Organ organ,
                                              const OrganDemand& demand, const CProgress& progress) const override;
};

/// Its row; known from the first call on.
const TreeMethod& poleMethod();

} // namespace stromar::test
