#include "Camera.h"
#include "Guides.h"
#include "Support.h"
#include "stromar/params/TreeFile.h"
#include <gtest/gtest.h>

namespace stromar {
namespace {

const osg::BoundingBoxd kBox(-3, -2, 0, 4, 2, 11);

void expectNear(const osg::Vec3d& a, const osg::Vec3d& b, double tolerance = 1e-9) {
    EXPECT_LT((a - b).length(), tolerance)
        << a.x() << " " << a.y() << " " << a.z() << " / " << b.x() << " " << b.y() << " " << b.z();
}

TEST(Camera, LooksFromWhereItIsTold) {
    CCamera camera;
    camera.lookFrom(0, 0);
    expectNear(camera.forward(), {0, 1, 0});
    expectNear(camera.right(), {1, 0, 0});
    expectNear(camera.up(), {0, 0, 1});
    camera.lookFrom(90, 0);
    expectNear(camera.forward(), {-1, 0, 0});
    camera.lookFrom(0, 90);
    expectNear(camera.forward(), {0, 0, -1});
    expectNear(camera.right(), {1, 0, 0});
}

TEST(Camera, AFramedBoxIsSeenWholeAndFillsTheWindow) {
    for (const bool orthographic : {false, true})
        for (const double aspect : {0.5, 1.0, 2.0})
            for (const auto& [yaw, pitch] : {std::pair{0.0, 0.0}, {30.0, 20.0}, {0.0, 90.0}}) {
                CCamera camera;
                camera.setOrthographic(orthographic);
                camera.lookFrom(yaw, pitch);
                camera.frame(kBox, aspect);
                double most = 0;
                for (unsigned i = 0; i < 8; ++i) {
                    const osg::Vec3d seen = camera.project(kBox.corner(i), aspect);
                    EXPECT_GT(seen.z(), 0);
                    most = std::max({most, std::abs(seen.x()), std::abs(seen.y())});
                }
                EXPECT_LT(most, 1);
                EXPECT_GT(most, 0.85);
            }
}

TEST(Camera, ARayGoesThroughWhatIsSeenThere) {
    for (const bool orthographic : {false, true}) {
        CCamera camera;
        camera.setOrthographic(orthographic);
        camera.lookFrom(25, 15);
        camera.frame(kBox, 1.6);
        const osg::Vec3d point(1, -1, 4);
        const osg::Vec3d seen = camera.project(point, 1.6);
        const auto [from, direction] = camera.rayAt({seen.x(), seen.y()}, 1.6);
        EXPECT_LT(((point - from) ^ direction).length(), 1e-6);
    }
}

TEST(Camera, TurningKeepsDistanceAndUprightness) {
    CCamera camera;
    camera.frame(kBox, 1);
    const double distance = camera.distance();
    for (int i = 0; i < 50; ++i) camera.turn(17, 9);
    EXPECT_DOUBLE_EQ(camera.distance(), distance);
    EXPECT_NEAR(camera.right().z(), 0, 1e-9) << "no roll";
    EXPECT_GT(camera.up().z(), 0) << "never over the top";
}

TEST(Camera, RollingTiltsAndStraighteningUndoesIt) {
    CCamera camera;
    camera.roll({-0.9, 0}, {0, 0.9});
    EXPECT_GT(std::abs(camera.right().z()), 0.05);
    const osg::Vec3d ahead = camera.forward();
    camera.straighten();
    EXPECT_NEAR(camera.right().z(), 0, 1e-9);
    expectNear(camera.forward(), ahead, 1e-6);
}

TEST(Camera, WhatIsPannedFollowsTheMouse) {
    CCamera camera;
    camera.frame(kBox, 1.5);
    const osg::Vec3d point = camera.centre();
    camera.pan({0.3, -0.2}, 1.5);
    const osg::Vec3d seen = camera.project(point, 1.5);
    EXPECT_NEAR(seen.x(), 0.3, 1e-9);
    EXPECT_NEAR(seen.y(), -0.2, 1e-9);
}

CParams pruned() {
    CParams params = CTreeFile::read(presetPath("weeping_willow").toStdString()).params();
    params.global.pruneRatio = 1;
    params.global.shape = 1;
    return params;
}

TEST(Guides, AHandleStaysWhereItIsDragged) {
    const double scale = 15;
    for (const GuideHandle& handle : guideHandles()) {
        CParams params = pruned();
        const osg::Vec2d before = handle.place(params, scale);
        const osg::Vec2d to(before.x() == 0 ? 0 : before.x() * 0.8, before.y() + 1);
        handle.drag(params, scale, to);
        EXPECT_FALSE(params == pruned()) << handle.text;
        const osg::Vec2d after = handle.place(params, scale);
        EXPECT_LT((after - to).length(), (before - to).length()) << handle.text;
    }
}

TEST(Guides, DraggingToItsPlaceChangesNothingToSpeakOf) {
    for (const GuideHandle& handle : guideHandles()) {
        CParams params = pruned();
        const osg::Vec2d before = handle.place(params, 15);
        handle.drag(params, 15, before);
        EXPECT_LT((handle.place(params, 15) - before).length(), 0.05) << handle.text;
    }
}

TEST(Guides, TheEnvelopeIsWidestWhereItSaysSo) {
    const CParams params = pruned();
    const auto profile = guideProfile(Guide::Envelope, params, 10);
    double widest = 0;
    for (const osg::Vec2d& p : profile) widest = std::max(widest, p.x());
    EXPECT_NEAR(widest, params.global.pruneWidth * 10, 0.02);
    EXPECT_DOUBLE_EQ(profile.front().y(), params.global.baseSize * 10);
    EXPECT_DOUBLE_EQ(profile.back().y(), 10);
    EXPECT_TRUE(guideProfile(Guide::None, params, 10).empty());
}

} // namespace
} // namespace stromar
