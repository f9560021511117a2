#include "Strands.h"
#include "stromar/tree/strands/StrandsBuilder.h"
#include "stromar/util/Translatable.h"

namespace stromar {

namespace {
const StrandBranch& branchAt(const CTree& tree, const SegmentPlace& place) {
    return static_cast<const CStrandGeneration&>(tree.generation(place.generation)).branches[place.segment];
}

constexpr SegmentQuantity kQuantities[] = {
    {"strands", [](const CTree& t, const SegmentPlace& at) { return branchAt(t, at).strands; }, N_("Strands"), true, true},
    {"gravelius", [](const CTree& t, const SegmentPlace& at) { return double(branchAt(t, at).order); }, N_("Turns aside (Gravelius order)"), true, true},
    {"weibull", [](const CTree& t, const SegmentPlace& at) { return double(branchAt(t, at).depth); }, N_("Splits below (Weibull order)"), true, true},
    {"inherited", [](const CTree& t, const SegmentPlace& at) { return branchAt(t, at).inherited; }},
    {"length", [](const CTree& t, const SegmentPlace& at) { return t.generation(at.generation).segments[at.segment].length; }},
    {"diameter", [](const CTree& t, const SegmentPlace& at) { return branchAt(t, at).diameter; }},
};
} // namespace

std::span<const SegmentQuantity> strandQuantities() { return kQuantities; }

CurvePlaces strandPlaces(const ParamInfo& curve, const CParams& params, const CTree& tree) {
    const auto over = overOf(curve, params);
    CurvePlaces places;
    for (const auto& generation : tree.generations()) {
        std::vector<double>& own = places.emplace_back();
        for (const StrandBranch& branch : static_cast<const CStrandGeneration&>(*generation).branches)
            own.push_back(over ? branch.quantity(*over) : branch.depth);
    }
    return places;
}

CurveAxis strandAxis(const ParamInfo& curve, const CParams& params) {
    const auto over = overOf(curve, params);
    if (!over) return {curve.overLabel, curve.overStep};
    switch (*over) {
    case CurveOver::Height: return {N_("height, m"), 0.1};
    case CurveOver::RootLength: return {N_("from the root, m"), 0.1};
    case CurveOver::Thickness: return {N_("thickness, cm"), 0.1};
    default: return {curve.overLabel, curve.overStep};
    }
}

} // namespace stromar
