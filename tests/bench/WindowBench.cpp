#include "Checkout.h"
#include "window/Display.h"
#include "window/MainWindow.h"
#include "document/FileController.h"
#include "work/ExportController.h"
#include "work/GrowthController.h"
#include "params/ParamPanel.h"
#include "motion/WindPanel.h"
#include "stromar/params/ParamText.h"
#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QMouseEvent>
#include <QTemporaryDir>
#include <benchmark/benchmark.h>

namespace {
using namespace stromar;

QString preset(const char* name) { return QString::fromStdString(test::inSource("presets/%1.tree")).arg(QLatin1String(name)); }

constexpr QSize kUsual(1280, 800), k4K(3840, 2160);

/// Until the viewport has drawn the next model.
void waitForPicture(CMainWindow& window) {
    QEventLoop loop;
    QObject::connect(&window, &CMainWindow::modelShown, &loop, [&] {
        QObject::connect(&window.viewport(), &CViewport::drawn, &loop, &QEventLoop::quit);
        window.viewport().update();
    });
    loop.exec();
}

/// From nothing to the first picture of a tree. The program itself takes the time of loading its libraries besides.
void BM_FirstTree(benchmark::State& state) {
    for (auto _ : state) {
        CMainWindow window;
        window.show();
        window.files().open(preset("quaking_aspen"));
        waitForPicture(window);
    }
}
BENCHMARK(BM_FirstTree)->Name("Window/FirstTree")->Unit(benchmark::kMillisecond)->UseRealTime();

/// One step of a dragged slider, to and fro between two values: the simple model grown, meshed and drawn.
void BM_SliderStep(benchmark::State& state, const char* name, const char* key, double from, double to, double by) {
    CMainWindow window;
    window.show();
    window.files().open(preset(name));
    window.growth().showOnly(Model::Simple);
    waitForPicture(window);
    const ParamRef dragged = *findParam(key);
    double value = from;
    while (window.busy()) QCoreApplication::processEvents();
    for (auto _ : state) {
        window.document().setValue(dragged, value = value < to ? value + by : from, 1);
        waitForPicture(window);
    }
}
BENCHMARK_CAPTURE(BM_SliderStep, aspen, "quaking_aspen", "1DownAngle", 30, 60, 1)->Name("Window/SliderStep/quaking_aspen")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(BM_SliderStep, oak, "english_oak", "1DownAngle", 30, 60, 1)->Name("Window/SliderStep/english_oak")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(BM_SliderStep, willow, "weeping_willow", "1DownAngle", 30, 60, 1)->Name("Window/SliderStep/weeping_willow")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(BM_SliderStep, aspenMonth, "quaking_aspen", "Season", 4, 10, 0.1)->Name("Window/MonthStep/quaking_aspen")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(BM_SliderStep, oakMonth, "english_oak", "Season", 4, 10, 0.1)->Name("Window/MonthStep/english_oak")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(BM_SliderStep, willowMonth, "weeping_willow", "Season", 4, 10, 0.1)->Name("Window/MonthStep/weeping_willow")->Unit(benchmark::kMillisecond)->UseRealTime();

/// One picture of a view that a hand turns. `first_ms`: the first pictures, before the viewport saves what the hand cannot wait for.
void BM_OrbitFrame(benchmark::State& state, const char* name, QSize size) {
    CMainWindow window;
    window.resize(size);
    window.show();
    window.files().open(preset(name));
    waitForPicture(window); // of the simple model, then the full one
    while (window.busy()) QCoreApplication::processEvents();
    CViewport& view = window.viewport();
    int x = 130;
    const auto turn = [&] {
        QEventLoop loop;
        QObject::connect(&view, &CViewport::drawn, &loop, &QEventLoop::quit);
        const QPointF at(x = x < 300 ? x + 3 : 130, 200);
        QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&view, &move);
        loop.exec();
    };
    const QPointF start(100, 200);
    QMouseEvent press(QEvent::MouseButtonPress, start, view.mapToGlobal(start), Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&view, &press);
    QElapsedTimer timer;
    timer.start();
    turn();
    state.counters["first_ms"] = double(timer.elapsed());
    for (int i = 0; i < 10; ++i) turn();
    for (auto _ : state) turn();
}
BENCHMARK_CAPTURE(BM_OrbitFrame, quaking_aspen, "quaking_aspen", kUsual)->Name("Window/OrbitFrame/quaking_aspen")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(BM_OrbitFrame, english_oak, "english_oak", kUsual)->Name("Window/OrbitFrame/english_oak")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(BM_OrbitFrame, weeping_willow, "weeping_willow", kUsual)->Name("Window/OrbitFrame/weeping_willow")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(BM_OrbitFrame, quaking_aspen4K, "quaking_aspen", k4K)->Name("Window/OrbitFrame/quaking_aspen/4K")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(BM_OrbitFrame, english_oak4K, "english_oak", k4K)->Name("Window/OrbitFrame/english_oak/4K")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(BM_OrbitFrame, weeping_willow4K, "weeping_willow", k4K)->Name("Window/OrbitFrame/weeping_willow/4K")->Unit(benchmark::kMillisecond)->UseRealTime();

/// One step of a point of a curve that is held: likewise, with the branches it touches lit up.
void BM_CurveStep(benchmark::State& state) {
    CMainWindow window;
    window.show();
    window.files().open(preset("strand_winter"));
    window.growth().showOnly(Model::Simple);
    window.document().setValue(*findParam("Strands", window.document().params().block()), 2000.0, 0);
    waitForPicture(window);
    const ParamRef angle = *findParam("SplitAngleG", window.document().params().block());
    while (window.busy()) QCoreApplication::processEvents();
    double degrees = 60;
    for (auto _ : state) {
        degrees = degrees < 90 ? degrees + 1 : 60;
        emit window.panel().rangeHeld(angle, 0, 5);
        window.document().setValue(angle, CCurve({{0, 64}, {2, degrees}, {5, 80}}), 1);
        waitForPicture(window);
    }
}
BENCHMARK(BM_CurveStep)->Name("Window/CurveStep/2000 strands")->Unit(benchmark::kMillisecond)->UseRealTime();

/// The same picture again: what drawing alone takes of it.
void BM_CurveFrame(benchmark::State& state) {
    CMainWindow window;
    window.show();
    window.files().open(preset("strand_winter"));
    window.growth().showOnly(Model::Simple);
    window.document().setValue(*findParam("Strands", window.document().params().block()), 2000.0, 0);
    waitForPicture(window);
    while (window.busy()) QCoreApplication::processEvents();
    emit window.panel().rangeHeld(*findParam("SplitAngleG", window.document().params().block()), 0, 5);
    for (auto _ : state) {
        QEventLoop loop;
        QObject::connect(&window.viewport(), &CViewport::drawn, &loop, &QEventLoop::quit);
        window.viewport().update();
        loop.exec();
    }
}
BENCHMARK(BM_CurveFrame)->Name("Window/CurveFrame/2000 strands")->Unit(benchmark::kMillisecond)->UseRealTime();


/// One frame of a turned tree in its best looks.
void BM_Frame(benchmark::State& state, const char* name, Model model) {
    CMainWindow window;
    window.show();
    window.files().open(preset(name));
    window.growth().showOnly(model);
    waitForPicture(window);
    while (window.busy()) QCoreApplication::processEvents();
    QCoreApplication::processEvents(); // the pictures of its recipes have come
    CCamera camera = window.viewport().camera();
    const auto draw = [&] {
        camera.turn(3, 0);
        return window.viewport().picture({800, 700}, ViewLook(), camera);
    };
    benchmark::DoNotOptimize(draw()); // textures and meshes go to the graphics card
    for (auto _ : state) benchmark::DoNotOptimize(draw());
}
BENCHMARK_CAPTURE(BM_Frame, full, "quaking_aspen", Model::Full)
    ->Name("Window/Frame/quaking_aspen")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_Frame, simple, "quaking_aspen", Model::Simple)
    ->Name("Window/Frame/quaking_aspen/simple")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_Frame, oak, "english_oak", Model::Full)
    ->Name("Window/Frame/english_oak")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// A picture of the viewport, and the same while the wind blows: its pose, its rows and its shadows besides.
void BM_ViewportFrame(benchmark::State& state, const char* name, bool wind) {
    CMainWindow window;
    window.show();
    window.files().open(preset(name));
    window.growth().showOnly(Model::Full);
    waitForPicture(window);
    while (window.busy()) QCoreApplication::processEvents();
    window.wind().setBlowing(wind);
    while (wind && !window.shown()->sway) QCoreApplication::processEvents();
    for (auto _ : state) {
        const int before = window.viewport().framesDrawn();
        if (!wind) window.viewport().update();
        while (window.viewport().framesDrawn() == before) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    window.wind().setBlowing(false);
}
BENCHMARK_CAPTURE(BM_ViewportFrame, still, "quaking_aspen", false)
    ->Name("Window/Viewport/quaking_aspen/still")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_ViewportFrame, wind, "quaking_aspen", true)
    ->Name("Window/Viewport/quaking_aspen/wind")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_ViewportFrame, oak, "english_oak", false)
    ->Name("Window/Viewport/english_oak/still")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_ViewportFrame, willow, "weeping_willow", false)
    ->Name("Window/Viewport/weeping_willow/still")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_ViewportFrame, willowWind, "weeping_willow", true)
    ->Name("Window/Viewport/weeping_willow/wind")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// A step of a life that is played: the simple model at another age, grown, meshed and drawn.
void BM_GrowthStep(benchmark::State& state) {
    CMainWindow window;
    window.show();
    window.files().open(preset("quaking_aspen"));
    window.growth().showOnly(Model::Simple);
    waitForPicture(window);
    while (window.busy()) QCoreApplication::processEvents();
    double age = 0;
    for (auto _ : state) {
        age = age < 1 ? age + 0.01 : 0.01;
        window.growth().setAge(age);
        waitForPicture(window);
    }
}
BENCHMARK(BM_GrowthStep)->Name("Window/GrowthStep/quaking_aspen")->Unit(benchmark::kMillisecond)->UseRealTime();
} // namespace

int main(int argc, char** argv) {
    QTemporaryDir folder; // a user's own settings stay as they are
    for (const char* kind : {"XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME"})
        qputenv(kind, folder.path().toLocal8Bit());
    QCoreApplication::setOrganizationName(QStringLiteral("Stromar"));
    QCoreApplication::setApplicationName(QStringLiteral("Bench"));
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QSurfaceFormat::setDefaultFormat(display::surfaceFormat(0));
    QApplication app(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
