// What one sees when a program changes from one level of detail to the next: as much tree, in the same colours.
#include "mesh/SampleTrees.h"
#include "util/Lab.h"
#include "stromar/app/Pictures.h"
#include "stromar/app/TreeCreator.h"
#include "stromar/model/ExportModel.h"
#include "stromar/scene/Headless.h"
#include "stromar/scene/Outline.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

namespace stromar::test {
namespace {

constexpr int kSamples = 4;
constexpr std::size_t kCameras = 4, kManyCameras = 8; // around a tree
constexpr double kPitch = 5;            // degrees
constexpr double kMaxCoverage = 0.05;   // of change
constexpr double kMaxColour = 3;        // ΔE, CIE76

/// Of a tree on nothing.
struct Seen {
    double covered = 0;      ///< pixels
    glm::dvec3 colour{0};    ///< sum over them, linear

    glm::dvec3 lab() const { return labOf(colour / covered); }
};

Seen seen(const Pixels& pixels) {
    Seen all;
    for (const auto& p : pixels) {
        const double cover = p[3] / 255.0;
        all.covered += cover;
        all.colour += cover * glm::dvec3(linear(p[0]), linear(p[1]), linear(p[2]));
    }
    return all;
}

/// A level of detail, ready to be drawn.
struct Level {
    std::shared_ptr<const TreeModel> model;
    std::vector<ViewPart> parts;
};

Level levelOf(CTreeCreator& creator, const CParams& params, int lod) {
    const CProgress progress(2);
    Level level{creator.create(params, detailOf(Model::Full, lod), progress), {}};
    makePictures(*level.model, {}, progress);
    level.parts = viewPartsOf(*level.model, {}, progress);
    return level;
}

std::vector<CCamera> camerasAround(const Level& level, std::size_t count) {
    const std::vector<osg::Vec3f> points = outlineOf(level.parts);
    std::vector<CCamera> cameras(count);
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        cameras[i].lookFrom(360.0 * double(i) / double(cameras.size()), kPitch);
        cameras[i].fit(points, 1);
    }
    return cameras;
}

/// Looks at one level after the other.
class CEye {
public:
    CEye() {
        ViewLook look;
        look.backdrop = Backdrop::Nothing;
        m_scene.setLook(look);
    }
    Seen look(const Level& level, const std::vector<CCamera>& cameras, int side) {
        m_scene.show(level.parts);
        for (const ViewPart& part : level.parts)
            m_scene.setSurface(part.surface, *readSurface(part.surface, textureOf(*level.model, part.surface, {}).string()));
        Seen all;
        for (const CCamera& camera : cameras) {
            const Seen one = seen(m_painter.paint(camera, side, side));
            all.covered += one.covered;
            all.colour += one.colour;
        }
        return all;
    }

private:
    CViewScene m_scene;
    CHeadlessPainter m_painter{m_scene, kSamples};
};

const std::vector<std::string> kTrees{"quaking_aspen", "rowan", "coconut_palm", "hazel", "hop"};

std::string nameOf(const ::testing::TestParamInfo<std::string>& one) { return one.param; }

class LevelsOfDetail : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Slow, LevelsOfDetail, ::testing::ValuesIn(kTrees), nameOf);
INSTANTIATE_TEST_SUITE_P(Exhaustive, LevelsOfDetail, ::testing::ValuesIn(presetsWithout(kTrees)), nameOf);

TEST_P(LevelsOfDetail, DoNotPop) {
    const bool isExhaustive = std::ranges::find(kTrees, GetParam()) == kTrees.end();
    CTreeCreator creator;
    CEye eye;
    const CParams params = preset(GetParam());
    Level fine = levelOf(creator, params, 0);
    for (int lod = 1; lod <= kMaxLod; ++lod) {
        Level coarse = levelOf(creator, params, lod);
        const int side = static_cast<int>(kScreenHeight * kScreenCoverage[static_cast<std::size_t>(lod) - 1]);
        const std::vector<CCamera> cameras = camerasAround(fine, isExhaustive ? kManyCameras : kCameras);
        const Seen before = eye.look(fine, cameras, side), after = eye.look(coarse, cameras, side);
        const double coverage = after.covered / before.covered - 1, colour = glm::distance(before.lab(), after.lab());
        EXPECT_LE(std::abs(coverage), kMaxCoverage) << "to level " << lod;
        EXPECT_LE(colour, kMaxColour) << "to level " << lod;
        fine = std::move(coarse);
    }
}

} // namespace
} // namespace stromar::test
