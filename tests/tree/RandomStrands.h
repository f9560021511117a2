#pragma once
#include "stromar/params/methods/strands/StrandsParams.h"
#include <random>

namespace stromar::test {

/// A curve of 1..4 points over the first orders.
inline CCurve randomCurve(std::mt19937& random, double low, double high) {
    const auto unit = [&] { return std::uniform_real_distribution<>(0, 1)(random); };
    std::vector<CCurve::Point> points;
    const auto count = 1 + random() % 4;
    double x = std::floor(3 * unit());
    for (unsigned i = 0; i < count; ++i) {
        points.push_back({x, low + (high - low) * unit()});
        x += 0.5 + std::floor(6 * unit()) / 2;
    }
    return CCurve(points);
}

/// Any values of the model but for the curves by depth, which are 1 in most trees.
inline CParams randomStrands(unsigned number, int maxStrands) {
    std::mt19937 random(number);
    const auto unit = [&] { return std::uniform_real_distribution<>(0, 1)(random); };
    CParams params(strandsBlock());
    StrandsParams& s = strands(params);
    s.strands = 1 + static_cast<int>(std::floor(maxStrands * unit() * unit()));
    s.trunkHeight = 0.1 + 5 * unit();
    s.inheritedLength = 0.1 + 5 * unit();
    s.strandThickness = random() % 2 ? 0.02 : 0.05 * unit();
    s.strandShareG = randomCurve(random, 0.5, 1);
    s.splitAngleG = randomCurve(random, 0, 180);
    s.planeTurnG = randomCurve(random, 0, 180);
    s.gravimorphismG = randomCurve(random, 0, random() % 2 ? 5 : 60);
    s.lengthLeastG = randomCurve(random, 0, 1);
    s.lengthMostG = randomCurve(random, 0, 1);
    s.lengthFactorG = randomCurve(random, 0, random() % 2 ? 1 : 3);
    s.gravicentralismG = randomCurve(random, 0, 1);
    if (random() % 3 == 0) s.splitAngleW = randomCurve(random, 0, 2);
    if (random() % 3 == 0) s.splitAngleOver = static_cast<int>(random() % 4);
    s.strandVariation = random() % 2 ? 0 : unit();
    s.stemLeaves = random() % 2 ? 0 : 8;
    params.common.seed = random() % 2 ? 0 : 7;
    return params;
}

} // namespace stromar::test
