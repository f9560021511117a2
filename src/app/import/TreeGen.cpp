#include "ForeignFile.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
/// Its outlines of leaves by their nearest here.
double leafShape(double shape) {
    constexpr int kOurs[] = {0, 0, 8, 9, 4, 11, 2, 2, 0, 6, 1};
    return kOurs[static_cast<std::size_t>(std::clamp(shape, 0.0, 10.0))];
}

/// 0 alternate, 1 opposite, more: whorls of one more.
double whorl(double dist) { return dist >= 1 ? std::floor(dist) + 1 : 1; }

constexpr ImportRow kTreeGenTable[] = {
    {"shape", "Shape"},
    {"g_scale", "Scale"},
    {"g_scale_v", "ScaleV"},
    {"levels", "Levels"},
    {"ratio", "Ratio"},
    {"ratio_power", "RatioPower"},
    {"flare", "Flare"},
    {"base_splits", "0BaseSplits", N_("a negative number there is a random one"), [](double splits) { return std::abs(splits); }},
    {"base_size", "BaseSize", N_("branches have no bare base here")},
    {"nbase_size", ""},
    {"ndown_angle", "nDownAngle"},
    {"ndown_angle_v", "nDownAngleV"},
    {"nrotate", "nRotate"},
    {"nrotate_v", "nRotateV"},
    {"nbranches", "nBranches"},
    {"nlength", "nLength"},
    {"nlength_v", "nLengthV"},
    {"ntaper", "nTaper"},
    {"nseg_splits", "nSegSplits"},
    {"nsplit_angle", "nSplitAngle"},
    {"nsplit_angle_v", "nSplitAngleV"},
    {"ncurve_res", "nCurveRes"},
    {"ncurve", "nCurve"},
    {"ncurve_back", "nCurveBack"},
    {"ncurve_v", "nCurveV"},
    {"nbend_v", "", N_("stems bend by CurveV")},
    {"nbranch_dist", "nWhorl", N_("whorls are counted by their branches, and between alternate and opposite there is nothing"), whorl},
    {"nradius_mod", "", N_("branches are as thick as RatioPower says"), nullptr, 1},
    {"nbevel_res", ""}, // of its mesh
    {"leaf_blos_num", "Leaves"},
    {"leaf_shape", "LeafShape", {}, leafShape},
    {"leaf_scale", "LeafScale"},
    {"leaf_scale_x", "LeafScaleX"},
    {"leaf_bend", "LeafBend"},
    {"blossom_shape", ""},
    {"blossom_scale", "BlossomScale"},
    {"blossom_rate", ""}, // see finish
    {"tropism", ""},
    {"prune_ratio", "PruneRatio"},
    {"prune_width", "PruneWidth"},
    {"prune_width_peak", "PruneWidthPeak"},
    {"prune_power_low", "PrunePowerLow"},
    {"prune_power_high", "PrunePowerHigh"},
    {"floor_splits", "", N_("the trunk splits from its first segment on")},
};
} // namespace

const std::span<const ImportRow> kTreeGenRows = kTreeGenTable;

void finishTreeGen(const ForeignValues& values, CParams& params) {
    WeberPennParams& own = weberPenn(params);
    params.common.lobeFade = 0;
    if (const ForeignValue* trunks = valueOf(values, "branches")) own.trunks = static_cast<int>(std::clamp(trunks->number().value_or(1), 1.0, 200.0));
    if (const ForeignValue* tropism = valueOf(values, "tropism"); tropism && tropism->items.size() == 3) {
        own.attractionUp = tropism->number(2).value_or(0);
        own.attractionAxis = static_cast<int>(AttractionAxis::Horizontal); // about which it turns every stem
    }
    const ForeignValue* rate = valueOf(values, "blossom_rate");
    if (const double share = rate ? std::clamp(rate->number().value_or(0), 0.0, 1.0) : 0; share > 0) {
        params.common.blossoms = static_cast<int>(std::round(share * std::abs(own.leaves)));
        own.leaves = static_cast<int>(std::round((1 - share) * own.leaves));
    }
}

} // namespace stromar
