#include "stromar/model/BarkLevels.h"
#include "stromar/mesh/Mesh.h"
#include <algorithm>

namespace stromar {

namespace {
double meanRadius(const CGeneration& generation) {
    double sum = 0;
    for (const CStem& stem : generation.stems) sum += stem.radius;
    return sum / std::max(1.0, double(generation.stems.size()));
}
} // namespace

CBarkLevels::CBarkLevels(const CTree& tree) {
    if (tree.generationCount() == 0 || tree.generation(0).stems.empty()) return;
    for (std::size_t level = 0; level < std::min(tree.generationCount(), kBarks.size()); ++level)
        m_thinness.push_back(thinnessOf(meanRadius(tree.generation(level)), tree.generation(0).stems[0].radius));
}

std::size_t CBarkLevels::levelOf(std::size_t own, int thinness) const {
    const auto middle = [&](std::size_t level) { return (m_thinness[level] + m_thinness[level + 1]) / 2; };
    std::size_t level = own;
    while (level > 0 && isApart(level, level - 1) && thinness < middle(level - 1)) --level;
    if (level < own) return level;
    while (level + 1 < count() && isApart(level, level + 1) && thinness > middle(level)) ++level;
    return level;
}

} // namespace stromar
