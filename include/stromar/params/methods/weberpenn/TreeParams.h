#pragma once
#include "stromar/params/methods/weberpenn/Calculations.h"
#include <memory>

namespace stromar {

/// What one generation of stems sees: the values of its level (generation 4 and deeper: level 3's), the whole tree's
/// values and the formulas of its kind of stem.
class CTreeParams {
public:
    /// `scaleTree` is the height of this very tree in metres.
    CTreeParams(const CParams& params, int generation, double scaleTree);

    int generation() const { return m_generation; }
    const WeberPennParams& tree() const { return m_tree; }
    const LevelParams& level() const { return m_level; }
    const CCalculations& calc() const { return *m_calc; }

private:
    int m_generation;
    WeberPennParams m_tree;
    LevelParams m_level;
    std::shared_ptr<const CCalculations> m_calc;
};

} // namespace stromar
