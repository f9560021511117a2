#pragma once
#include "window/MainWindow.h"
#include "document/FileController.h"
#include "work/ExportController.h"
#include "work/GrowthController.h"
#include "params/ParamEditor.h"
#include "params/ParamPanel.h"
#include "Support.h"
#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMessageBox>
#include <QSlider>
#include <QTabWidget>
#include <QTimer>
#include <gtest/gtest.h>

namespace stromar {

/// A window that shows the quaking aspen.
class WindowFixture : public ::testing::Test {
protected:
    void SetUp() override {
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
        QApplication::setActiveWindow(&window); // a bare X server has no window manager to do it
        ASSERT_TRUE(window.files().open(presetPath("quaking_aspen")));
        ASSERT_TRUE(showsNow(Model::Full));
    }
    /// Waits until the viewport shows the document's tree by this model.
    bool showsNow(Model model) {
        return waitFor([&] {
            const ViewModel* shown = window.shown();
            return shown && shown->model->detail->model == model && shown->model->params == window.document().params();
        });
    }
    QDockWidget* dock(const char* name) { return window.findChild<QDockWidget*>(QLatin1String(name)); }
    QAction* action(const char* name) { return window.findChild<QAction*>(QLatin1String(name)); }
    QSlider* slider(const char* key) { return window.panel().editor(paramRef(key))->findChild<QSlider*>(); }
    double value(const char* key) { return paramRef(key).get(window.document().params()); }
    QString notice() { return window.findChild<QLabel*>(QStringLiteral("notice"))->text(); }
    /// Of a tree that rests.
    QImage picture() {
        waitFor([&] { return !window.viewport().settling(); });
        return window.viewport().grabFramebuffer();
    }

    /// Presses a button of the next message box.
    void answerNext(QMessageBox::StandardButton button) {
        asked = false;
        auto* poll = new QTimer(&window);
        QObject::connect(poll, &QTimer::timeout, poll, [this, poll, button] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (!box) return;
            asked = true;
            question = box->text();
            poll->deleteLater();
            box->button(button)->click();
        });
        poll->start(20);
    }

    CMainWindow window;
    bool asked = false;
    QString question;
};

} // namespace stromar
