#include "stromar/scene/Camera.h"
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

TEST(Camera, PointsThatAreFittedJustFillTheWindow) {
    const std::vector<osg::Vec3f> points{{0, 0, 0}, {3, -2, 5}, {-1, 4, 7}, {0.5f, 0.5f, 11}, {-2, -3, 4}};
    for (const double fieldOfView : {12.0, 30.0, 70.0})
        for (const auto& [yaw, pitch] : {std::pair(0.0, 4.0), std::pair(130.0, 40.0), std::pair(-70.0, -5.0)})
            for (const double aspect : {0.5, 1.0, 1.8}) {
                CCamera camera;
                camera.setFieldOfView(fieldOfView);
                camera.lookFrom(yaw, pitch);
                const osg::Vec3d ahead = camera.forward();
                camera.fit(points, aspect);
                EXPECT_LT((camera.forward() - ahead).length(), 1e-9);
                osg::Vec3d low(1, 1, 0), high(-1, -1, 0);
                for (const osg::Vec3f& point : points) {
                    const osg::Vec3d seen = camera.project(osg::Vec3d(point), aspect);
                    EXPECT_GT(seen.z(), 0) << "before the eye";
                    for (int i = 0; i < 2; ++i) {
                        low[i] = std::min(low[i], seen[i]);
                        high[i] = std::max(high[i], seen[i]);
                    }
                }
                for (int i = 0; i < 2; ++i) {
                    EXPECT_GE(low[i], -0.981);
                    EXPECT_LE(high[i], 0.981);
                }
                const bool wide = low.x() < -0.979 && high.x() > 0.979, tall = low.y() < -0.979 && high.y() > 0.979;
                EXPECT_TRUE(wide || tall) << fieldOfView << " " << yaw << " " << aspect;
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

} // namespace
} // namespace stromar
