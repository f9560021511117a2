#pragma once
#include "stromar/scene/ViewScene.h"
#include <limits>
#include <utility>

namespace stromar {

/// Where the parts have vertices; of leaves feet and tips. About so many of each part at most, spread over it.
std::vector<osg::Vec3f> outlineOf(const std::vector<ViewPart>& parts, std::size_t most = std::numeric_limits<std::size_t>::max());

/// How far the parts reach from the origin against a direction of length 1, and along it; metres. By outlineOf() with `most`.
std::pair<double, double> reachOf(const std::vector<ViewPart>& parts, const osg::Vec3d& along,
                                  std::size_t most = std::numeric_limits<std::size_t>::max());

/// How far from one tree's foot the next one stands in a row: `right` and `left` are their reach towards each other, `size` the
/// larger of the next one's height and width.
inline double distanceInRow(double right, double left, double size) {
    constexpr double kGap = 0.04; // of the size
    return right + kGap * size + left;
}

} // namespace stromar
