#include "stromar/app/Impostor.h"
#include "stromar/texture/Srgb.h"
#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
constexpr int kSteps = 4;        // along a ray to the depth that a view says
constexpr double kOnTheWay = 0.7; // it after the first: of a narrow crown seen from above they would go to and fro

const std::array<double, 256>& lightOfBytes() {
    static const auto table = [] {
        std::array<double, 256> light;
        for (std::size_t i = 0; i < light.size(); ++i) light[i] = double(linearOf(float(i) / 255));
        return light;
    }();
    return table;
}

/// Visits the four pixels around, with what each counts.
template <typename Visit>
void eachAround(const ImpostorPicture& picture, const glm::dvec2& pixel, Visit&& visit) {
    const glm::dvec2 corner = glm::floor(pixel - 0.5), part = pixel - 0.5 - corner;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            const int x = std::clamp(int(corner.x) + i, 0, picture.width - 1), y = std::clamp(int(corner.y) + j, 0, picture.height - 1);
            visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x),
                  (i ? part.x : 1 - part.x) * (j ? part.y : 1 - part.y));
        }
}

/// −1 … 1 radii.
double depthOf(const ImpostorPicture& picture, const glm::dvec2& pixel) {
    double sum = 0;
    eachAround(picture, pixel, [&](std::size_t i, double weight) { sum += weight * (picture.normalDepth[i][3] / 127.5 - 1); });
    return sum;
}
} // namespace

ImpostorSample sampleOf(const ImpostorPicture& picture, const glm::dvec2& pixel) {
    const auto& light = lightOfBytes();
    ImpostorSample sample;
    eachAround(picture, pixel, [&](std::size_t i, double weight) {
        const auto &a = picture.albedo[i], &n = picture.normalDepth[i];
        sample.cover += weight * a[3] / 255;
        sample.colour += weight * glm::dvec3(light[a[0]], light[a[1]], light[a[2]]);
        sample.normal += weight * (glm::dvec3(n[0], n[1], n[2]) / 127.5 - 1.0);
    });
    return sample;
}

ImpostorSample sampleAlong(const ImpostorAtlas& atlas, const glm::dvec3& origin, const glm::dvec3& ray) {
    ImpostorSample all;
    for (const CImpostorGrid::Share& share : atlas.grid.around(-ray)) {
        const ImpostorView view = atlas.grid.view(share.column, share.row);
        const double slope = std::min(-0.05, glm::dot(ray, view.towards));
        double depth = 0;
        glm::dvec2 inFrame, pixel;
        for (int i = 0; i < kSteps; ++i) {
            const glm::dvec3 place = origin + ray * ((depth - glm::dot(origin, view.towards)) / slope);
            inFrame = 0.5 + 0.5 * glm::dvec2(glm::dot(place, view.right), -glm::dot(place, view.up));
            pixel = glm::dvec2(share.column, share.row) * double(atlas.frame) + glm::clamp(inFrame * double(atlas.frame), 0.5, atlas.frame - 0.5);
            if (i + 1 < kSteps) depth = glm::mix(depth, depthOf(atlas.picture, pixel), i > 0 ? kOnTheWay : 1.0);
        }
        if (glm::clamp(inFrame, 0.0, 1.0) != inFrame) continue;
        const ImpostorSample one = sampleOf(atlas.picture, pixel);
        const double weight = share.weight * one.cover;
        all.cover += weight;
        all.colour += weight * one.colour;
        all.normal += weight * one.normal;
    }
    if (all.cover > 0) all.colour /= all.cover, all.normal /= all.cover;
    return all;
}

} // namespace stromar
