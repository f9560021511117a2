#pragma once
#include "stromar/params/Calculations.h"
#include "stromar/params/Params.h"
#include <memory>

namespace stromar {

/// What one generation of stems sees: the values of its level (generation 4 and deeper: level 3's), the whole tree's
/// values and the formulas of its kind of stem. Angles are in radians here: this is where degrees end.
class CTreeParams {
public:
    /// `scaleTree` is the height of this very tree in metres.
    CTreeParams(const CParams& params, int generation, double scaleTree);

    int generation() const { return m_generation; }
    const GlobalParams& global() const { return m_global; }
    const LevelParams& level() const { return m_level; }
    const CCalculations& calc() const { return *m_calc; }

private:
    int m_generation;
    GlobalParams m_global;
    LevelParams m_level;
    std::shared_ptr<const CCalculations> m_calc;
};

constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180;

} // namespace stromar
