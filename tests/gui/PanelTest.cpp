#include "ParamEditor.h"
#include "ParamPanel.h"
#include "Support.h"
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QTabBar>
#include <QWheelEvent>
#include <gtest/gtest.h>

namespace stromar {
namespace {

/// What an editor shows, whatever it is made of.
double shownValue(const CParamEditor& editor) {
    if (const auto* box = editor.findChild<QDoubleSpinBox*>()) return box->value();
    if (const auto* box = editor.findChild<QSpinBox*>()) return box->value();
    if (const auto* choice = editor.findChild<QComboBox*>()) return choice->currentIndex();
    return editor.findChild<QCheckBox*>()->isChecked() ? 1 : 0;
}

/// Sets an editor as a user would.
void enter(const CParamEditor& editor, double value) {
    if (auto* real = editor.findChild<QDoubleSpinBox*>())
        real->setValue(value);
    else if (auto* whole = editor.findChild<QSpinBox*>())
        whole->setValue(static_cast<int>(value));
    else if (auto* choice = editor.findChild<QComboBox*>())
        choice->setCurrentIndex(static_cast<int>(value));
    else
        editor.findChild<QCheckBox*>()->setChecked(value != 0);
}

TEST(Panel, EveryRowHasAnEditorThatShowsAndSets) {
    CParamPanel panel;
    CParams params;
    QObject::connect(&panel, &CParamPanel::edited,
                     [&](const ParamRef& ref, double value, int) { ref.set(params, value); });
    for (const ParamRef& ref : allParams()) {
        const CParamEditor* editor = panel.editor(ref);
        ASSERT_EQ(editor != nullptr, !ref.info->unused()) << ref.key();
        if (!editor) continue;
        EXPECT_FALSE(editor->toolTip().isEmpty());
        for (const double value : {ref.info->range.max, ref.info->range.min}) {
            enter(*editor, value);
            EXPECT_NEAR(ref.get(params), value, std::pow(10, -ref.info->decimals) / 2 + 1e-12) << ref.key();
        }
    }
    const CParams defaults;
    panel.showParams(defaults);
    for (const ParamRef& ref : allParams()) {
        const CParamEditor* editor = panel.editor(ref);
        if (!editor) continue;
        EXPECT_NEAR(shownValue(*editor), ref.get(defaults), std::pow(10, -ref.info->decimals) / 2 + 1e-12) << ref.key();
    }
}

TEST(Panel, TabsAreThoseOfTheTree) {
    const CParamPanel panel;
    QStringList tabs;
    for (int i = 0; i < panel.count(); ++i) tabs << panel.tabText(i);
    EXPECT_EQ(tabs.join(QLatin1Char('|')).toStdString(),
              "Tree|Trunk|Branches 1|Branches 2|Branches 3|Leaves|Pruning|Textures");
}

TEST(Panel, ShowingValuesTellsNothing) {
    CParamPanel panel;
    QSignalSpy edited(&panel, &CParamPanel::edited);
    CParams params;
    for (const ParamRef& ref : allParams()) ref.set(params, ref.info->range.max);
    panel.showParams(params);
    EXPECT_EQ(edited.count(), 0);
}

TEST(Panel, ValuesBeyondTheSliderStay) {
    CParamPanel panel;
    CParams params;
    params.global.scale = 400; // the slider ends at 40
    QSignalSpy edited(&panel, &CParamPanel::edited);
    panel.showParams(params);
    const CParamEditor* editor = panel.editor(paramRef("Scale"));
    EXPECT_EQ(shownValue(*editor), 400);
    EXPECT_EQ(editor->findChild<QSlider*>()->value(), editor->findChild<QSlider*>()->maximum());
    EXPECT_EQ(edited.count(), 0);
}

/// Whether the widget took the event; else Qt offers it to the parents, and the panel scrolls.
bool takesWheel(QWidget* over) {
    const QPointF at = QRectF(over->rect()).center();
    QWheelEvent event(at, over->mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(over, &event);
    return event.isAccepted();
}

TEST(Panel, TheWheelChangesOnlyAnEditorWithTheFocus) {
    CParamPanel panel;
    panel.setCurrentIndex(2);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    QApplication::setActiveWindow(&panel); // a bare X server has no window manager to do it
    const CParamEditor* editor = panel.editor(paramRef("1Branches"));
    auto* box = editor->findChild<QSpinBox*>();
    auto* slider = editor->findChild<QSlider*>();
    auto* choice = panel.editor(paramRef("Shape"))->findChild<QComboBox*>();
    panel.tabBar()->setFocus();
    const int before = box->value();
    for (QWidget* over : {static_cast<QWidget*>(box), static_cast<QWidget*>(slider), static_cast<QWidget*>(choice)})
        EXPECT_FALSE(takesWheel(over));
    EXPECT_EQ(box->value(), before);
    EXPECT_EQ(choice->currentIndex(), 0);
    box->setFocus();
    ASSERT_TRUE(box->hasFocus());
    EXPECT_TRUE(takesWheel(box));
    EXPECT_EQ(box->value(), before - 1);
}

} // namespace
} // namespace stromar
