#include "stromar/params/TreeParams.h"
#include "stromar/params/ParamTable.h"
#include <algorithm>

namespace stromar {

namespace {
/// Of the whole tree's values or a level's.
template <typename Params>
Params inRadians(Params params) {
    for (const ParamInfo& p : paramTable())
        if (const auto* field = std::get_if<double Params::*>(&p.field); field && p.unit == Unit::Degree)
            params.*(*field) *= kRadiansPerDegree;
    return params;
}

std::shared_ptr<const CCalculations> makeCalculations(int generation, const GlobalParams& global, double scaleTree) {
    if (generation == 0) return std::make_shared<CTrunkCalc>(global, scaleTree);
    if (generation == 1) return std::make_shared<C0BranchCalc>(global, scaleTree);
    return std::make_shared<C1BranchCalc>(global, scaleTree);
}
} // namespace

CTreeParams::CTreeParams(const CParams& params, int generation, double scaleTree)
    : m_generation(generation), m_global(inRadians(params.global)),
      m_level(inRadians(params.level[static_cast<std::size_t>(std::min(generation, kParamLevels - 1))])),
      m_calc(makeCalculations(generation, m_global, scaleTree)) {}

} // namespace stromar
