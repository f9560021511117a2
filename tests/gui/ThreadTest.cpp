#include "Checkout.h"
#include "Support.h"
#include "work/TreeCreatorThread.h"
#include "stromar/params/methods/lsystem/LSystemParams.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/params/TreeFile.h"
#include <QSignalSpy>
#include <atomic>
#include <gtest/gtest.h>
#include <latch>
#include <thread>

namespace stromar {
namespace {

CParams willow() { return CTreeFile::read(test::inSource("presets/weeping_willow.tree")).params(); }
CParams aspen() { return CTreeFile::read(test::inSource("presets/quaking_aspen.tree")).params(); }

/// A thread with its results.
struct Fixture {
    explicit Fixture(const SizeLimits& limits = {})
        : thread(std::make_unique<CTreeCreator>(true, limits)) {
        QObject::connect(&thread, &CTreeCreatorThread::created, &receiver, [this](const auto& view) {
            last = view;
            ++results;
        });
        QObject::connect(&thread, &CTreeCreatorThread::failed, &receiver,
                         [this](const QString& why) { failure = why; });
    }
    QObject receiver; ///< lives in this thread, so that results arrive here
    std::shared_ptr<const ViewModel> last;
    int results = 0;
    QString failure;
    CTreeCreatorThread thread;
};

TEST(Thread, AHundredRequestsEndInTheLast) {
    Fixture f;
    CParams params = aspen();
    for (int i = 0; i < 100; ++i) {
        params.common.seed = i;
        f.thread.request({params, {}, &detailOf(i % 3 ? Model::Simple : Model::Full)});
        if (i % 10 == 0) QTest::qWait(1);
    }
    params.common.seed = 100;
    f.thread.request({params, {}, &detailOf(Model::Simple)});
    ASSERT_TRUE(waitFor([&] { return f.last && f.last->model->params.common.seed == 100; }));
    EXPECT_LT(f.results, 100);
    QTest::qWait(100);
    EXPECT_EQ(f.last->model->params.common.seed, 100);
    EXPECT_EQ(f.last->model->detail->model, Model::Simple);
}

TEST(Thread, WorksElsewhere) {
    Fixture f;
    std::atomic<std::thread::id> worker{};
    QObject::connect(&f.thread, &CTreeCreatorThread::created,
                     [&] { worker = std::this_thread::get_id(); }); // in the emitting thread
    f.thread.request({aspen(), {}, &detailOf(Model::Simple)});
    ASSERT_TRUE(waitFor([&] { return f.results == 1; }));
    EXPECT_NE(worker.load(), std::thread::id());
    EXPECT_NE(worker.load(), std::this_thread::get_id());
}

TEST(Thread, StepsThatComeFasterThanTreesStillShowSome) {
    Fixture f;
    CParams params = willow();
    QElapsedTimer clock;
    clock.start();
    for (int i = 0; f.results < 2 && clock.elapsed() < 60000; ++i) {
        weberPenn(params).level[1].downAngle = 20 + i % 40;
        f.thread.request({params, {}, &detailOf(Model::Simple)});
        QTest::qWait(10);
    }
    EXPECT_GE(f.results, 2); // cancelling each would have shown none
}

TEST(Thread, AnErrorReachesTheUserAndTheNextTreeGrows) {
    Fixture f;
    CParams broken(lsystemBlock());
    lsystem(broken).grammar = "axiom: F(";
    f.thread.request({broken, {}, &detailOf(Model::Full)});
    ASSERT_TRUE(waitFor([&] { return !f.failure.isEmpty(); }));
    EXPECT_TRUE(f.failure.startsWith(QLatin1String("Grammar:1:10: error: "))) << f.failure.toStdString();
    f.thread.request({aspen(), {}, &detailOf(Model::Simple)});
    EXPECT_TRUE(waitFor([&] { return f.results == 1; }));
}

TEST(Thread, ATreeThatIsTooLargeIsRefusedWithTheNearestThatIsNot) {
    Fixture f;
    std::shared_ptr<const TooLargeTree> refused;
    QObject::connect(&f.thread, &CTreeCreatorThread::tooLarge, &f.thread, [&](const std::shared_ptr<const TooLargeTree>& tree) { refused = tree; });
    CParams params = willow();
    const SizeLimits limits{.vertices = predictSize(params, detailOf(Model::Full)).vertices};
    f.thread.request({params, {}, &detailOf(Model::Simple), limits});
    ASSERT_TRUE(waitFor([&] { return f.results == 1; }));
    const int fits = weberPenn(params).level[1].branches;
    weberPenn(params).level[1].branches += 40;
    f.thread.request({params, {}, &detailOf(Model::Simple), limits});
    ASSERT_TRUE(waitFor([&] { return refused != nullptr; }));
    EXPECT_GT(refused->size.vertices, limits.vertices);
    EXPECT_EQ(refused->params, params);
    ASSERT_TRUE(refused->fits);
    EXPECT_EQ(refused->fits->first.key(), "1Branches");
    EXPECT_EQ(refused->fits->second, fits);
    EXPECT_EQ(f.results, 1);
}

TEST(Thread, QuitsWhileBusy) {
    QElapsedTimer clock;
    {
        Fixture f;
        f.thread.request({willow(), {}, &detailOf(Model::Full)});
        ASSERT_TRUE(waitFor([&] { return f.thread.progress().has_value(); }));
        clock.start();
    }
    EXPECT_LT(clock.elapsed(), 5000); // far below what a busy machine under a sanitizer would take to finish
}

TEST(Thread, UnchangedGenerationsKeepTheirGeometry) {
    Fixture f;
    CParams params = aspen();
    f.thread.request({params, {}, &detailOf(Model::Simple)});
    ASSERT_TRUE(waitFor([&] { return f.results == 1; }));
    const auto before = f.last;
    weberPenn(params).level[2].curve.value += 5;
    f.thread.request({params, {}, &detailOf(Model::Simple)});
    ASSERT_TRUE(waitFor([&] { return f.results == 2; }));
    ASSERT_EQ(before->parts.size(), 4u);
    ASSERT_EQ(f.last->parts.size(), 4u);
    EXPECT_EQ(before->parts[0].geometry, f.last->parts[0].geometry);
    EXPECT_EQ(before->parts[1].geometry, f.last->parts[1].geometry);
    EXPECT_NE(before->parts[2].geometry, f.last->parts[2].geometry);
    EXPECT_NE(before->parts[3].geometry, f.last->parts[3].geometry);
}

TEST(Thread, GenerateStartsFromNothing) {
    Fixture f;
    f.thread.request({aspen(), {}, &detailOf(Model::Simple)});
    ASSERT_TRUE(waitFor([&] { return f.results == 1; }));
    const auto before = f.last;
    f.thread.request({aspen(), {}, &detailOf(Model::Simple), {}, true});
    ASSERT_TRUE(waitFor([&] { return f.results == 2; }));
    EXPECT_NE(before->model->tree, f.last->model->tree);
    EXPECT_EQ(before->model->vertexCount(), f.last->model->vertexCount());
}

} // namespace
} // namespace stromar
