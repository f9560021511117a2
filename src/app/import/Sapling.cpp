#include "ForeignFile.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/util/Translatable.h"
#include <cmath>

namespace stromar {

namespace {
constexpr ImportRow kSaplingTable[] = {
    {"shape", "Shape", N_("its shapes 8 and 10 have no formula here; the nearest is a tapered cylinder"), [](double shape) { return shape > 7 ? 4 : shape; }, 7},
    {"scale", "Scale"},
    {"scaleV", "ScaleV"},
    {"levels", "Levels"},
    {"ratio", "Ratio"},
    {"ratioPower", "RatioPower"},
    {"baseSize", "BaseSize"},
    {"baseSize_s", "", N_("branches have no bare base here")},
    {"baseSplits", "0BaseSplits", {}, [](double splits) { return std::abs(splits); }},
    {"splitHeight", "", N_("the trunk splits from its first segment on")},
    {"splitBias", "", N_("splits are spread evenly")},
    {"scale0", "0Scale"},
    {"scaleV0", "0ScaleV"},
    {"rootFlare", "Flare", {}, [](double flare) { return flare - 1; }},
    {"minRadius", "MinRadius"},
    {"seed", "Seed"},
    {"nLength", "nLength"},
    {"nLengthV", "nLengthV"},
    {"nTaper", "nTaper"},
    {"nRadiusTweak", "", N_("branches are as thick as RatioPower says"), nullptr, 1},
    {"nCurveRes", "nCurveRes"},
    {"nCurve", "nCurve"},
    {"nCurveBack", "nCurveBack"},
    {"nCurveV", "nCurveV"},
    {"nSegSplits", "nSegSplits"},
    {"nSplitAngle", "nSplitAngle"},
    {"nSplitAngleV", "nSplitAngleV"},
    {"nDownAngle", "nDownAngle"},
    {"nDownAngleV", "nDownAngleV"},
    {"nRotate", "nRotate"},
    {"nRotateV", "nRotateV"},
    {"nBranches", "nBranches"},
    {"nAttractOut", "", N_("branches are not drawn outwards here")},
    {"branchDist", "", N_("branches are spread evenly along the trunk"), nullptr, 1},
    {"nrings", "", N_("rings of branches are Whorl here")},
    {"taperCrown", "", N_("the trunk does not thin towards branches")},
    {"pruneRatio", "PruneRatio"},
    {"pruneWidth", "PruneWidth"},
    {"pruneWidthPeak", "PruneWidthPeak"},
    {"prunePowerLow", "PrunePowerLow"},
    {"prunePowerHigh", "PrunePowerHigh"},
    {"pruneBase", "", N_("the envelope ends at the crown's base")},
    {"leaves", "Leaves"},
    {"leafScale", "LeafScale"},
    {"leafScaleX", "LeafScaleX"},
    {"leafScaleT", "", N_("leaves of a stem are equally large")},
    {"leafScaleV", "", N_("leaves of a stem are equally large")},
    {"bend", "LeafBend"},
    {"leafangle", "", N_("leaves turn to the light by LeafBend")},
    {"customShape", ""}, {"shapeS", ""}, {"leafShape", ""}, {"leafDist", ""}, {"rMode", ""}, {"autoTaper", ""}, {"splitByLen", ""}, // see finish
    {"leafDownAngle", ""}, {"leafDownAngleV", ""}, {"leafRotate", ""}, {"leafRotateV", ""}, {"prune", ""}, {"useOldDownAngle", ""}, {"useParentAngle", ""},
    {"attractUp", ""}, {"horzLeaves", ""}, {"showLeaves", ""}, {"nradiusTweak", ""}, {"radiusTweak", ""}, {"closeTip", ""}, {"startCurv", ""},
    // Of Blender's curve, armature and wind.
    {"handleType", ""}, {"bevel", ""}, {"bevelRes", ""}, {"resU", ""}, {"makeMesh", ""}, {"useArm", ""}, {"armAnim", ""}, {"leafAnim", ""}, {"boneStep", ""},
    {"armLevels", ""}, {"previewArm", ""}, {"frameRate", ""}, {"loopFrames", ""}, {"wind", ""}, {"gust", ""}, {"gustF", ""}, {"windSpeed", ""}, {"windGust", ""},
    {"af1", ""}, {"af2", ""}, {"af3", ""}, {"chooseSet", ""}, {"limitImport", ""}, {"presetName", ""}, {"do_update", ""},
};

/// Newer files grade down angles by another formula: (110, 80) there is (60, −50) here.
void convertDownAngle(LevelParams& level) {
    constexpr double kGraded = 0.625;
    if (level.downAngleV.value > 0) {
        level.downAngle.value -= kGraded * level.downAngleV.value;
        level.downAngleV.value *= -kGraded;
    } else {
        level.downAngleV.value = std::abs(level.downAngleV.value);
    }
}

double numberOf(const ForeignValues& values, const char* key, double otherwise, std::size_t item = 0) {
    const ForeignValue* value = valueOf(values, key);
    return value ? value->number(std::min(item, value->items.size() - 1)).value_or(otherwise) : otherwise;
}
} // namespace

const std::span<const ImportRow> kSaplingRows = kSaplingTable;

void finishSapling(const ForeignValues& values, CParams& params) {
    WeberPennParams& own = weberPenn(params);
    if (const ForeignValue* prune = valueOf(values, "prune"); prune && !prune->isTrue()) own.pruneRatio = 0;
    if (const ForeignValue* old = valueOf(values, "useOldDownAngle"); old && !old->isTrue())
        for (std::size_t n = 1; n < own.level.size(); ++n) convertDownAngle(own.level[n]);
    const int leafLevel = std::min(own.levels, kParamLevels - 1);
    if (valueOf(values, "leafDownAngle")) {
        LevelParams& leaves = own.level[static_cast<std::size_t>(leafLevel)];
        leaves.downAngle.value = numberOf(values, "leafDownAngle", 45);
        leaves.downAngleV.value = numberOf(values, "leafDownAngleV", 0);
        leaves.rotate.value = numberOf(values, "leafRotate", 137.5);
        leaves.rotateV.value = numberOf(values, "leafRotateV", 0);
    }
    // One number in older files, one for each level in newer ones: ours acts from level 2 on.
    own.attractionUp = numberOf(values, "attractUp", 0, static_cast<std::size_t>(std::clamp(own.levels - 1, 0, 2)));
    const ForeignValue* shape = valueOf(values, "leafShape");
    params.common.leafShape = shape && shape->items[0] == "rect" ? 6 : 0;
    if (const ForeignValue* mode = valueOf(values, "rMode"); mode && mode->items[0] == "whorl") own.level[1].whorl = 4;
    params.common.lobeFade = 0;
}

} // namespace stromar
