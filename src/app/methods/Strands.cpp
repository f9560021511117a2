#include "Strands.h"
#include "stromar/tree/strands/StrandsBuilder.h"

namespace stromar {

namespace {
const StrandBranch& branchAt(const CTree& tree, const SegmentPlace& place) {
    return static_cast<const CStrandGeneration&>(tree.generation(place.generation)).branches[place.segment];
}

constexpr SegmentQuantity kQuantities[] = {
    {"strands", [](const CTree& t, const SegmentPlace& at) { return branchAt(t, at).strands; }, true, true},
    {"gravelius", [](const CTree& t, const SegmentPlace& at) { return double(branchAt(t, at).order); }, true, true},
    {"weibull", [](const CTree& t, const SegmentPlace& at) { return double(branchAt(t, at).depth); }, true, true},
    {"inherited", [](const CTree& t, const SegmentPlace& at) { return branchAt(t, at).inherited; }},
    {"length", [](const CTree& t, const SegmentPlace& at) { return t.generation(at.generation).segments[at.segment].length; }},
    {"diameter", [](const CTree& t, const SegmentPlace& at) { return branchAt(t, at).diameter; }},
};
} // namespace

std::span<const SegmentQuantity> strandQuantities() { return kQuantities; }

double strandCurveAt(const ParamInfo& curve, const CParams& params, const CTree& tree, const SegmentPlace& place) {
    const StrandBranch& branch = branchAt(tree, place);
    const auto over = overOf(curve, params);
    return over ? branch.quantity(*over) : branch.depth;
}

} // namespace stromar
