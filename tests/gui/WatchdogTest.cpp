// Nothing but drawing keeps the event loop.
#include "WatchedApplication.h"
#include "WindowFixture.h"
#include "library/TextureWorkshop.h"
#include "library/Variants.h"
#include <QDoubleSpinBox>
#include <QTemporaryDir>
#include <QUndoStack>

namespace stromar::test {

class SlowWatchdog : public WindowFixture {
protected:
    void SetUp() override {
        CWatchedApplication::refine(true);
        WindowFixture::SetUp();
    }
    void TearDown() override { CWatchedApplication::refine(false); }

    static constexpr double kMost = 50; // milliseconds

    CWatchedApplication& app() { return *static_cast<CWatchedApplication*>(qApp); }
    void expectFree(const char* during) {
        EXPECT_LT(app().worstMilliseconds(), kMost) << during << ": " << app().what().toStdString();
        app().restart();
    }
    bool grown() {
        return waitFor([&] {
            const ViewModel* shown = window.shown();
            return shown && shown->model->detail->model == Model::Full && shown->model->params == window.document().params();
        }, 120000);
    }
};

TEST_F(SlowWatchdog, TheWillowNeverStopsTheWindow) {
    app().restart();
    ASSERT_TRUE(window.files().open(presetPath("weeping_willow")));
    ASSERT_TRUE(grown());
    expectFree("opening");
    for (int step = 1; step <= 5; ++step) {
        window.document().setValue(paramRef("1Length"), 0.5 + 0.01 * step, 1);
        QTest::qWait(60);
    }
    ASSERT_TRUE(grown());
    expectFree("growing and handing over");
    window.document().history().undo();
    ASSERT_TRUE(grown());
    expectFree("undo");
    QTemporaryDir folder;
    window.exporter().exportTo(folder.filePath(QStringLiteral("x.glb")), {});
    ASSERT_TRUE(waitFor([&] { return !window.exporter().progress(); }, 120000));
    expectFree("exporting");
    const auto all = allParams(window.document().params().block());
    emit window.variants().randomiseWanted({all.begin(), all.end()}, 0.1);
    ASSERT_TRUE(waitFor([&] { return window.document().history().undoText().contains(QStringLiteral("andom")) || !notice().isEmpty(); }, 120000));
    expectFree("looking for random values");
}

TEST_F(SlowWatchdog, TheWorkshopDrawsOnAThread) {
    ASSERT_TRUE(window.files().open(presetPath("english_oak")));
    ASSERT_TRUE(grown());
    app().restart();
    window.files().openWorkshop(paramRef("LeafTexture"));
    auto* workshop = window.findChild<CTextureWorkshop*>();
    ASSERT_TRUE(workshop);
    auto* lobe = workshop->findChild<QDoubleSpinBox*>(QStringLiteral("lobe"));
    for (int step = 1; step <= 5; ++step) {
        lobe->setValue(0.3 + 0.02 * step);
        QTest::qWait(60);
    }
    ASSERT_TRUE(grown());
    expectFree("drawing a leaf");
}

} // namespace stromar::test
