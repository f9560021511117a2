#include "stromar/params/TreeParams.h"
#include "stromar/params/ParamTable.h"
#include <algorithm>

namespace stromar {

namespace {
/// Every value in degrees belongs to a level.
LevelParams inRadians(LevelParams level) {
    for (const ParamInfo& p : paramTable())
        if (const auto* field = std::get_if<double LevelParams::*>(&p.field); field && p.unit == Unit::Degree)
            level.*(*field) *= kRadiansPerDegree;
    return level;
}

std::shared_ptr<const CCalculations> makeCalculations(int generation, const GlobalParams& global, double scaleTree) {
    if (generation == 0) return std::make_shared<CTrunkCalc>(global, scaleTree);
    if (generation == 1) return std::make_shared<C0BranchCalc>(global, scaleTree);
    return std::make_shared<C1BranchCalc>(global, scaleTree);
}
} // namespace

CTreeParams::CTreeParams(const CParams& params, int generation, double scaleTree)
    : m_generation(generation), m_global(params.global),
      m_level(inRadians(params.level[static_cast<std::size_t>(std::min(generation, kParamLevels - 1))])),
      m_calc(makeCalculations(generation, m_global, scaleTree)) {}

} // namespace stromar
