#include "mesh/SampleTrees.h"
#include "stromar/app/TreeCreator.h"
#include "stromar/scene/Headless.h"
#include <gtest/gtest.h>

namespace stromar::test {
namespace {

TEST(ViewPass, TheFirstIsThePlainOneAndTheOthersSpread) {
    for (const int count : {1, 4, 16}) {
        const ViewPass first = ViewPass::of(0, count);
        EXPECT_EQ(first.pixel, osg::Vec2d(0, 0));
        EXPECT_EQ(first.sun, osg::Vec2d(0, 0));
        osg::Vec2d pixels;
        for (int i = 0; i < count; ++i) {
            const ViewPass pass = ViewPass::of(i, count);
            EXPECT_LE(std::abs(pass.pixel.x()), 0.5);
            EXPECT_LE(std::abs(pass.pixel.y()), 0.5);
            EXPECT_LT(pass.sun.length(), 1);
            pixels += pass.pixel;
            for (int j = 0; j < i; ++j) EXPECT_GT((pass.pixel - ViewPass::of(j, count).pixel).length(), 0.5 / count);
        }
        EXPECT_LT((pixels / count).length(), 0.2) << "the picture stays where it is";
    }
}

TEST(PictureMean, IsRoundedByteByByte) {
    CPictureMean mean;
    const std::uint8_t first[] = {0, 255, 10}, second[] = {1, 255, 20};
    mean.add(first);
    mean.add(second);
    std::uint8_t result[3];
    mean.write(result);
    EXPECT_EQ(result[0], 1);
    EXPECT_EQ(result[1], 255);
    EXPECT_EQ(result[2], 15);
    mean.clear();
    mean.add(second);
    mean.write(result);
    EXPECT_EQ(result[2], 20) << "what was before is gone";
    const std::uint8_t larger[] = {7, 8, 9, 10};
    mean.add(larger);
    std::uint8_t four[4];
    mean.write(four);
    EXPECT_EQ(mean.count(), 1);
    EXPECT_EQ(four[3], 10) << "another size begins anew";
}

double meanDifference(const Pixels& a, const Pixels& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) sum += std::abs(int(a[i][c]) - int(b[i][c]));
    return sum / double(3 * a.size());
}

/// Any number of samples can be asked for, and more come nearer to the picture of very many.
TEST(SlowHeadlessPainter, MoreSamplesThanTheCardHasAreDrawnInPasses) {
    CTreeCreator creator;
    const auto model = creator.create(preset("winter_oak"), detailOf(Model::Simple), CProgress());
    const auto parts = viewPartsOf(*model, {}, CProgress());
    const auto painted = [&](int samples) {
        CViewScene scene;
        scene.show(parts);
        CCamera camera;
        camera.lookFrom(0, 4);
        camera.frame(osg::BoundingBoxd(-8, -8, 2, 8, 8, 18), 1);
        return CHeadlessPainter(scene, samples).paint(camera, 200, 200);
    };
    const Pixels best = painted(96);
    const double four = meanDifference(painted(4), best), five = meanDifference(painted(5), best),
                 sixteen = meanDifference(painted(16), best);
    EXPECT_LT(five, four);
    EXPECT_LT(sixteen, 0.75 * four); // a single pass draws thin wood as lines
}

/// Over nothing a pixel that is covered in part has the colour of what covers it.
TEST(HeadlessPainter, PicturesOverNothingHaveStraightAlpha) {
    CTreeCreator creator;
    const auto model = creator.create(preset("winter_oak"), detailOf(Model::Simple), CProgress());
    CViewScene scene;
    ViewLook look;
    look.backdrop = Backdrop::Nothing;
    look.shading = Shading::Material;
    scene.setLook(look);
    scene.show(viewPartsOf(*model, {}, CProgress()));
    CCamera camera;
    camera.lookFrom(0, 4);
    camera.frame(osg::BoundingBoxd(-8, -8, 2, 8, 8, 18), 1);
    double whole = 0, part = 0, wholes = 0, parts = 0;
    for (const auto& p : CHeadlessPainter(scene, 8).paint(camera, 200, 200)) {
        if (p[3] == 255) whole += p[0], ++wholes;
        if (p[3] > 40 && p[3] < 150) part += p[0], ++parts;
    }
    ASSERT_GT(std::min(wholes, parts), 100);
    EXPECT_NEAR(part / parts, whole / wholes, 0.05 * whole / wholes);
}

} // namespace
} // namespace stromar::test
