#include "Viewport.h"
#include <QApplication>
#include <QTemporaryDir>
#include <gtest/gtest.h>

int main(int argc, char** argv) {
    ::testing::InitGoogleTest(&argc, argv);
    if (::testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS(); // no display is needed to tell the names
    QTemporaryDir settings;                                        // a user's own stay as they are
    qputenv("XDG_CONFIG_HOME", settings.path().toLocal8Bit());
    QCoreApplication::setOrganizationName(QStringLiteral("Stromar"));
    QCoreApplication::setApplicationName(QStringLiteral("Test"));
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QSurfaceFormat::setDefaultFormat(stromar::CViewport::surfaceFormat(0));
    QApplication app(argc, argv);
    return RUN_ALL_TESTS();
}
