#include "stromar/scene/Outline.h"
#include <algorithm>

namespace stromar {

namespace {
osg::Vec3f toOsg(const glm::vec3& v) { return {v.x, v.y, v.z}; }

/// A step that visits about so many of all.
std::size_t strideOf(std::size_t all, std::size_t most) { return std::max<std::size_t>(1, all / std::max<std::size_t>(1, most)); }
} // namespace

std::vector<osg::Vec3f> outlineOf(const std::vector<ViewPart>& parts, std::size_t most) {
    std::vector<osg::Vec3f> points;
    for (const ViewPart& part : parts) {
        if (part.mesh)
            for (std::size_t i = 0; i < part.mesh->positions.size(); i += strideOf(part.mesh->positions.size(), most))
                points.push_back(toOsg(part.mesh->positions[i]));
        for (std::size_t i = 0; part.organs && i < part.organs->count(); i += strideOf(part.organs->count(), most)) {
            const CLeaf& leaf = part.organs->leaf(i);
            for (const float along : {0.f, static_cast<float>(leaf.length)})
                points.push_back(toOsg(glm::vec3(leaf.position) + along * glm::vec3(leaf.axis)));
        }
    }
    return points;
}

std::pair<double, double> reachOf(const std::vector<ViewPart>& parts, const osg::Vec3d& along, std::size_t most) {
    double left = 0, right = 0;
    for (const osg::Vec3f& point : outlineOf(parts, most)) {
        left = std::max(left, -(osg::Vec3d(point) * along));
        right = std::max(right, osg::Vec3d(point) * along);
    }
    return {left, right};
}

} // namespace stromar
