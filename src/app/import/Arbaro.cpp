#include "ForeignFile.h"
#include "stromar/util/Translatable.h"
#include <pugixml.hpp>

namespace stromar {

namespace {
/// Arbaro's parameters have the paper's names, as ours.
constexpr ImportRow kArbaroTable[] = {
    {"Shape", "Shape"},
    {"Levels", "Levels"},
    {"Scale", "Scale"},
    {"ScaleV", "ScaleV"},
    {"ZScale", "ZScale"},
    {"ZScaleV", "ZScaleV"},
    {"BaseSize", "BaseSize"},
    {"Ratio", "Ratio"},
    {"RatioPower", "RatioPower"},
    {"Flare", "Flare"},
    {"Lobes", "Lobes"},
    {"LobeDepth", "LobeDepth"},
    {"AttractionUp", "AttractionUp"},
    {"Leaves", "Leaves"},
    {"LeafScale", "LeafScale"},
    {"LeafScaleX", "LeafScaleX"},
    {"LeafQuality", "LeafQuality"},
    {"LeafBend", "LeafBend"},
    {"LeafStemLen", "LeafStalk"},
    {"LeafDistrib", "", N_("leaves are spread along their stem as in the paper"), nullptr, 4},
    {"PruneRatio", "PruneRatio"},
    {"PruneWidth", "PruneWidth"},
    {"PruneWidthPeak", "PruneWidthPeak"},
    {"PrunePowerLow", "PrunePowerLow"},
    {"PrunePowerHigh", "PrunePowerHigh"},
    {"0Scale", "0Scale"},
    {"0ScaleV", "", N_("there it roughens the mesh of the trunk")},
    {"0BaseSplits", "0BaseSplits"},
    {"0Branches", "Trunks"},
    {"0DownAngle", "", N_("trunks lean by TrunksLean")},
    {"0DownAngleV", "", N_("trunks lean by TrunksLean")},
    {"0Rotate", "", N_("trunks are turned by chance")},
    {"0RotateV", "", N_("trunks are turned by chance")},
    {"0BranchDist", "TrunksSpread"},
    {"nDownAngle", "nDownAngle"},
    {"nDownAngleV", "nDownAngleV"},
    {"nRotate", "nRotate"},
    {"nRotateV", "nRotateV"},
    {"nBranches", "nBranches"},
    {"nBranchDist", "nBranchDist"},
    {"nLength", "nLength"},
    {"nLengthV", "nLengthV"},
    {"nTaper", "nTaper"},
    {"nSegSplits", "nSegSplits"},
    {"nSplitAngle", "nSplitAngle"},
    {"nSplitAngleV", "nSplitAngleV"},
    {"nCurveRes", "nCurveRes"},
    {"nCurve", "nCurve"},
    {"nCurveBack", "nCurveBack"},
    {"nCurveV", "nCurveV"},
    {"LeafShape", "", N_("of its shapes of discs and spheres an oval leaf is nearest")},
    {"Smooth", ""}, // of its mesh
};
} // namespace

const std::span<const ImportRow> kArbaroRows = kArbaroTable;

ForeignValues readArbaro(const ForeignText& source) {
    pugi::xml_document document;
    const pugi::xml_parse_result result = document.load_buffer(source.text.data(), source.text.size());
    if (!result) source.fail(static_cast<std::size_t>(result.offset), translated(NC_("stromar", "this is no XML: %1"), result.description()));
    const pugi::xml_node species = document.child("arbaro").child("species");
    if (!species) source.fail(0, translated(NC_("stromar", "there is no <arbaro> with a <species>")));
    ForeignValues values;
    values.push_back({"species", {species.attribute("name").as_string()}, false, 0});
    for (const pugi::xml_node& param : species.children("param")) {
        const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, param.offset_debug()));
        if (!param.attribute("name") || !param.attribute("value")) source.fail(at, translated(NC_("stromar", "a <param> has a name and a value")));
        values.push_back({param.attribute("name").as_string(), {param.attribute("value").as_string()}, false, at});
    }
    return values;
}

/// The paper's lobes run the whole trunk.
void finishArbaro(const ForeignValues& values, CParams& params) {
    params.common.lobeFade = 0;
    if (const ForeignValue* shape = valueOf(values, "LeafShape"); shape && shape->items[0] == "square") params.common.leafShape = 6;
}

} // namespace stromar
