#include "stromar/app/Demonstration.h"
#include "stromar/app/Methods.h"
#include "stromar/params/ParamText.h"
#include <algorithm>
#include <cassert>
#include <cmath>
#include <sstream>

namespace stromar {

namespace {
/// Sets `Key=value …`; `n` in a key stands for the level.
void apply(CParams& params, std::string_view settings, int level) {
    std::istringstream words{std::string(settings)};
    for (std::string word; words >> word;) {
        if (word.front() == 'n') word.front() = static_cast<char>('0' + level);
        const std::size_t equals = word.find('=');
        const auto ref = findParam(word.substr(0, equals), params.block());
        SetProblem problem;
        assert(ref);
        const SetResult result = setFromText(params, *ref, word.substr(equals + 1), problem);
        assert(result == SetResult::Done);
        static_cast<void>(result);
    }
}

/// The first method that has the row: common ones are shown by Weber and Penn's trees.
const TreeMethod& methodShowing(const ParamRef& ref) {
    const auto has = [&](const TreeMethod& method) {
        const std::vector<const ParamInfo*> rows = rowsOf(*method.block);
        return std::ranges::find(rows, ref.info) != rows.end();
    };
    const auto found = std::ranges::find_if(treeMethods(), has);
    assert(found != treeMethods().end());
    return *found;
}

double inSteps(const ParamInfo& info, double value) { return std::round(value / info.step) * info.step; }

std::vector<double> valuesOf(const ParamInfo& info) {
    std::vector<double> values;
    if (!info.words.empty())
        for (std::size_t i = 0; i < info.words.size(); ++i) values.push_back(static_cast<double>(i));
    else if (std::ranges::any_of(info.demo.values, [](double v) { return v != 0; }))
        values.assign(info.demo.values.begin(), info.demo.values.end());
    else
        for (const double share : {0.1, 0.5, 0.9})
            values.push_back(inSteps(info, info.useful.min + share * (info.useful.max - info.useful.min)));
    return values;
}
} // namespace

std::vector<Demonstration> demonstrationsOf(const ParamRef& ref) {
    std::vector<Demonstration> all;
    if (!ref.info->numeric() || ref.info->unused() || ref.info->group == Group::Textures) return all; // no shape shows the bark
    const ParamRef shown{ref.info, std::min(ref.level, 1)};
    const TreeMethod& method = methodShowing(ref);
    const DemoPlant& plant = method.demonstration;
    CParams params(*method.block);
    for (const std::string_view settings :
         {plant.settings, plant.settingsOf ? plant.settingsOf(shown) : std::string_view(), ref.info->demo.settings})
        apply(params, settings, shown.level);
    for (const double value : valuesOf(*ref.info)) {
        all.push_back({params, value});
        shown.set(all.back().params, value);
    }
    return all;
}

} // namespace stromar
