#include "stromar/app/Demonstration.h"
#include "stromar/params/ParamText.h"
#include <algorithm>
#include <cassert>
#include <cmath>
#include <sstream>

namespace stromar {

namespace {
constexpr std::string_view kPlant = "Levels=2 Scale=8 Shape=1 BaseSize=0.2 Ratio=0.025 RatioPower=1.2 Flare=0.3 "
                                    "0CurveRes=6 1Branches=14 1Length=0.32 1DownAngle=55 1Rotate=140 1CurveRes=5 "
                                    "2Branches=8 2Length=0.35 2DownAngle=45 MinRadius=0.008";

/// What the pictures of a group of parameters have in common, on top of kPlant.
std::string_view settingsOf(const ParamRef& ref) {
    if (ref.info->perLevel() && ref.level == 0) return "Levels=1 0CurveRes=8 Ratio=0.035";
    switch (ref.group()) {
    case Group::Tree: return "Levels=3 1Branches=18";
    case Group::Leaves:
        return "Scale=1.6 BaseSize=0 Levels=2 1Branches=3 1Length=0.7 1DownAngle=35 Leaves=12 LeafScale=0.2 LeafForm=1 "
               "2DownAngle=50 2Rotate=140 LeafStalk=0.15 MinRadius=0.002 LeafScaleX=0.6";
    case Group::Pruning:
        return "Shape=3 1Branches=60 1Length=0.6 1DownAngle=70 BaseSize=0.15 PruneRatio=1 PruneWidth=0.3 "
               "PruneWidthPeak=0.4 MinRadius=0.02";
    default: return "";
    }
}

/// Sets `Key=value …`; `n` in a key stands for the level.
void apply(CParams& params, std::string_view settings, int level) {
    std::istringstream words{std::string(settings)};
    for (std::string word; words >> word;) {
        if (word.front() == 'n') word.front() = static_cast<char>('0' + level);
        const std::size_t equals = word.find('=');
        const auto target = findParam(word.substr(0, equals));
        std::string problem;
        assert(target);
        const SetResult result = setFromText(params, *target, word.substr(equals + 1), problem);
        assert(result == SetResult::Done);
        static_cast<void>(result);
    }
}

double inSteps(const ParamInfo& info, double value) { return std::round(value / info.step) * info.step; }

std::vector<double> valuesOf(const ParamInfo& info) {
    std::vector<double> values;
    if (!info.words.empty())
        for (std::size_t i = 0; i < info.words.size(); ++i) values.push_back(static_cast<double>(i));
    else if (std::ranges::any_of(info.shown.values, [](double v) { return v != 0; }))
        values.assign(info.shown.values.begin(), info.shown.values.end());
    else
        for (const double share : {0.1, 0.5, 0.9})
            values.push_back(inSteps(info, info.useful.min + share * (info.useful.max - info.useful.min)));
    return values;
}
} // namespace

std::vector<Demonstration> demonstrationsOf(const ParamRef& ref) {
    std::vector<Demonstration> all;
    if (ref.info->unused() || ref.info->group == Group::Textures) return all; // no shape shows the bark
    const ParamRef shown{ref.info, std::min(ref.level, 1)};
    CParams params;
    for (const std::string_view settings : {kPlant, settingsOf(shown), ref.info->shown.settings})
        apply(params, settings, shown.level);
    for (const double value : valuesOf(*ref.info)) {
        all.push_back({params, value});
        shown.set(all.back().params, value);
    }
    return all;
}

} // namespace stromar
