#include "Guides.h"
#include "Support.h"
#include "stromar/params/TreeFile.h"
#include <gtest/gtest.h>

namespace stromar {
namespace {

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
