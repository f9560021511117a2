#include "document/Autosave.h"
#include "window/Display.h"
#include "document/FileController.h"
#include "window/MainWindow.h"
#include "Support.h"
#include "WatchedApplication.h"
#include <QApplication>
#include <QDir>
#include <QTemporaryDir>
#include <cstdio>
#include <gtest/gtest.h>

namespace {
/// A program with unsaved changes, for the test that kills it.
int waitToBeKilled() {
    stromar::CMainWindow window;
    window.show();
    window.files().open(presetPath("quaking_aspen"));
    window.document().setValue(paramRef("Scale"), 17, 0);
    window.files().autosave().flush();
    std::puts("kept");
    std::fflush(stdout);
    return QApplication::exec();
}
/// Recipes and the presets' thumbnails are drawn and shaders compiled once for all processes of a run: most of the time a
/// window needs for its first picture, and of what it does beside it.
void shareCaches(const QString& home) {
    const QString shared = QString::fromLocal8Bit(qgetenv("XDG_RUNTIME_DIR")) + QStringLiteral("/stromar-tests");
    if (qEnvironmentVariableIsEmpty("XDG_RUNTIME_DIR")) return;
    QDir().mkpath(home + QStringLiteral("/stromar"));
    for (const char* kind : {"/textures", "/thumbnails"}) {
        QDir().mkpath(shared + QLatin1String(kind));
        QFile::link(shared + QLatin1String(kind), home + QStringLiteral("/stromar") + QLatin1String(kind));
    }
    qputenv("MESA_SHADER_CACHE_DIR", (shared + QStringLiteral("/shaders")).toLocal8Bit());
}
} // namespace

int main(int argc, char** argv) {
    ::testing::InitGoogleTest(&argc, argv);
    if (::testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS(); // no display is needed to tell the names
    QTemporaryDir folder;                                          // a user's own settings stay as they are
    if (qEnvironmentVariableIsEmpty("STROMAR_TEST_HOME")) qputenv("STROMAR_TEST_HOME", folder.path().toLocal8Bit());
    for (const char* kind : {"XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME"})
        qputenv(kind, qgetenv("STROMAR_TEST_HOME"));
    shareCaches(QString::fromLocal8Bit(qgetenv("STROMAR_TEST_HOME")));
    QCoreApplication::setOrganizationName(QStringLiteral("Stromar"));
    QCoreApplication::setApplicationName(QStringLiteral("Test"));
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QSurfaceFormat::setDefaultFormat(stromar::display::surfaceFormat(0));
    stromar::test::CWatchedApplication app(argc, argv);
    if (app.arguments().contains(QStringLiteral("--be-killed"))) return waitToBeKilled();
    return RUN_ALL_TESTS();
}
