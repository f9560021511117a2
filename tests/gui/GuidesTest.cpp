#include "Support.h"
#include "stromar/app/Methods.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/params/TreeFile.h"
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace stromar {
namespace {

CParams pruned() {
    CParams params = CTreeFile::read(presetPath("weeping_willow").toStdString()).params();
    weberPenn(params).pruneRatio = 1;
    weberPenn(params).shape = 1;
    return params;
}

std::vector<GuideHandle> handles() {
    std::vector<GuideHandle> all;
    for (const Guide& guide : methodOf(pruned()).guides) all.insert(all.end(), guide.handles.begin(), guide.handles.end());
    return all;
}

TEST(Guides, AHandleStaysWhereItIsDragged) {
    const double scale = 15;
    for (const GuideHandle& handle : handles()) {
        CParams params = pruned();
        const glm::dvec2 before = handle.place(params, scale);
        const glm::dvec2 to(before.x == 0 ? 0 : before.x * 0.8, before.y + 1);
        handle.drag(params, scale, to);
        EXPECT_FALSE(params == pruned()) << handle.text;
        const glm::dvec2 after = handle.place(params, scale);
        EXPECT_LT(glm::length(after - to), glm::length(before - to)) << handle.text;
    }
}

TEST(Guides, DraggingToItsPlaceChangesNothingToSpeakOf) {
    for (const GuideHandle& handle : handles()) {
        CParams params = pruned();
        const glm::dvec2 before = handle.place(params, 15);
        handle.drag(params, 15, before);
        EXPECT_LT(glm::length(handle.place(params, 15) - before), 0.05) << handle.text;
    }
}

TEST(Guides, DraggingTheEnvelopeTurnsPruningOn) {
    const auto after = [](std::size_t handle, int shape, double ratio) {
        CParams params = pruned();
        weberPenn(params).shape = shape;
        weberPenn(params).pruneRatio = ratio;
        handles()[handle].drag(params, 15, {2, 8});
        return weberPenn(params).pruneRatio;
    };
    for (const std::size_t handle : {0u, 1u, 2u}) {
        EXPECT_EQ(after(handle, 1, 0), 1) << handle;
        EXPECT_EQ(after(handle, 1, 0.4), 0.4) << handle;
        EXPECT_EQ(after(handle, 8, 0), 0) << handle << ": the crown has this shape already";
    }
    EXPECT_EQ(after(3, 1, 0), 0) << "the bare trunk is there without";
}

TEST(Guides, DraggingTheEnvelopeKeepsAWidthThatHasNoEffect) {
    CParams params = pruned();
    weberPenn(params).shape = 8;
    weberPenn(params).pruneRatio = 0;
    const CParams before = params;
    handles()[0].drag(params, 15, {2, 8});
    EXPECT_EQ(weberPenn(params).pruneWidth, weberPenn(before).pruneWidth);
    EXPECT_NE(weberPenn(params).pruneWidthPeak, weberPenn(before).pruneWidthPeak);
}

TEST(Guides, TheEnvelopeIsWidestWhereItSaysSo) {
    const CParams params = pruned();
    const auto profile = methodOf(params).guides[0].profile(params, 10);
    double widest = 0;
    for (const glm::dvec2& p : profile) widest = std::max(widest, p.x);
    EXPECT_NEAR(widest, weberPenn(params).pruneWidth * 10, 0.02);
    EXPECT_DOUBLE_EQ(profile.front().y, weberPenn(params).baseSize * 10);
    EXPECT_DOUBLE_EQ(profile.back().y, 10);
}

} // namespace
} // namespace stromar
