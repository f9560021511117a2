#include "stromar/params/methods/weberpenn/TreeParams.h"

namespace stromar {

namespace {
std::shared_ptr<const CCalculations> makeCalculations(int generation, const WeberPennParams& tree, double scaleTree) {
    if (generation == 0) return std::make_shared<CTrunkCalc>(tree, scaleTree);
    if (generation == 1) return std::make_shared<C0BranchCalc>(tree, scaleTree);
    return std::make_shared<C1BranchCalc>(tree, scaleTree);
}
} // namespace

CTreeParams::CTreeParams(const CParams& params, int generation, double scaleTree)
    : m_generation(generation), m_tree(weberPenn(params)), m_level(levelOf(params, generation)),
      m_calc(makeCalculations(generation, m_tree, scaleTree)) {}

} // namespace stromar
