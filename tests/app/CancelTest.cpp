#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "app/SameModel.h"
#include "mesh/SampleTrees.h"
#include <chrono>
#include <gtest/gtest.h>
#include <thread>

namespace stromar::test {

namespace {
using namespace std::chrono_literals;

/// Whether a creation that is cancelled from another thread after a while was cut short.
bool cutShort(CTreeCreator& creator, const CParams& params, std::chrono::microseconds after) {
    const CProgress progress(2);
    const std::jthread canceller([&] {
        std::this_thread::sleep_for(after);
        progress.cancel();
    });
    try {
        creator.create(params, detailOf(Model::Full), progress);
        return false;
    } catch (const CCancelled&) {
        return true;
    }
}
} // namespace

TEST(Cancel, BeforeTheStartMakesNothing) {
    CTreeCreator creator;
    const CProgress cancelled(2);
    cancelled.cancel();
    const CParams params = preset("quaking_aspen");
    EXPECT_THROW(creator.create(params, detailOf(Model::Full), cancelled), CCancelled);
    const auto model = creator.create(params, detailOf(Model::Full), CProgress(2));
    EXPECT_EQ(modelDifference(*model, *createAnew(params, detailOf(Model::Full))), "");
}

TEST(Cancel, KeepsWhatWasMadeBefore) {
    CTreeCreator creator;
    CParams params = preset("quaking_aspen");
    const auto before = creator.create(params, detailOf(Model::Full), CProgress(2));
    CParams other = params;
    other.common.seed += 1;
    const CProgress cancelled(2);
    cancelled.cancel();
    EXPECT_THROW(creator.create(other, detailOf(Model::Full), cancelled), CCancelled);
    EXPECT_EQ(modelDifference(*creator.create(params, detailOf(Model::Full), CProgress(2)), *before), "");
}

TEST(Cancel, FromAnotherThreadAtAnyMomentLeavesTheCreatorSound) {
    const CParams willow = preset("weeping_willow");
    const auto wanted = createAnew(willow, detailOf(Model::Full));
    CTreeCreator creator;
    int cuts = 0;
    for (const auto after : {0us, 300us, 1000us, 5000us, 20'000us, 50'000us, 90'000us}) {
        cuts += cutShort(creator, willow, after);
        if (after < 10'000us) creator.forget(); // later ones go on with what the earlier left
    }
    EXPECT_GE(cuts, 3) << "the work is over before it can be cancelled";
    EXPECT_EQ(modelDifference(*creator.create(willow, detailOf(Model::Full), CProgress(2)), *wanted), "");
}

TEST(Cancel, AMeshChangeAfterACancelledStructureChangeIsRight) {
    CTreeCreator creator;
    CParams params = preset("quaking_aspen");
    creator.create(params, detailOf(Model::Full), CProgress(2));
    const CProgress cancelled(2);
    cancelled.cancel();
    weberPenn(params).level[1].downAngle.value += 10;
    EXPECT_THROW(creator.create(params, detailOf(Model::Full), cancelled), CCancelled);
    params.common.minRadius = 0.004;
    const auto model = creator.create(params, detailOf(Model::Full), CProgress(2));
    EXPECT_EQ(modelDifference(*model, *createAnew(params, detailOf(Model::Full))), "");
}

TEST(Cancel, AnswersSoon) {
    const CParams willow = preset("weeping_willow");
    for (const int threads : {1, 2}) {
        const CProgress progress(threads);
        std::chrono::steady_clock::time_point asked;
        const std::jthread canceller([&] {
            std::this_thread::sleep_for(10ms);
            asked = std::chrono::steady_clock::now();
            progress.cancel();
        });
        EXPECT_THROW(CTreeCreator().create(willow, detailOf(Model::Full), progress), CCancelled);
        // About one range of stems per thread; generous for busy machines and sanitizers.
        EXPECT_LT(std::chrono::steady_clock::now() - asked, 5s) << threads << " threads";
    }
}

TEST(Progress, RisesToOne) {
    const CProgress progress(2);
    CTreeCreator().create(preset("quaking_aspen"), detailOf(Model::Full), progress);
    EXPECT_EQ(progress.done(), 1);
}

} // namespace stromar::test
