#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "params/HelpPictures.h"
#include "params/ParamEditor.h"
#include "params/ParamPanel.h"
#include "params/ParamRow.h"
#include "Support.h"
#include "stromar/mesh/LeafMeshes.h"
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QTabBar>
#include <QTimer>
#include <QToolButton>
#include <QToolTip>
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

TEST(Panel, FilesAreTypedOrChosenAmongWhatIsBuiltIn) {
    CParamPanel panel;
    CParams params;
    QObject::connect(&panel, &CParamPanel::edited,
                     [&](const ParamRef& ref, const ParamValue& value, int) { ref.setValue(params, value); });
    const auto* line = panel.findChild<QLineEdit*>(QStringLiteral("LeafMesh"));
    ASSERT_TRUE(line);
    const auto buttons = line->parentWidget()->findChildren<QToolButton*>();
    const auto menu = std::ranges::find_if(buttons, [](const QToolButton* button) { return button->menu(); });
    ASSERT_NE(menu, buttons.end());
    const QList<QAction*> built = (*menu)->menu()->actions();
    ASSERT_EQ(static_cast<std::size_t>(built.size()), builtInLeaves().size());
    built[1]->trigger();
    EXPECT_EQ(params.text.leafMesh, "mesh:" + std::string(builtInLeaves()[1].name));
    panel.showParams(params, params);
    EXPECT_EQ(line->text().toStdString(), params.text.leafMesh);
}

TEST(Panel, EveryRowHasAnEditorThatShowsAndSets) {
    CParamPanel panel;
    CParams params;
    QObject::connect(&panel, &CParamPanel::edited,
                     [&](const ParamRef& ref, const ParamValue& value, int) { ref.setValue(params, value); });
    for (const ParamRef& ref : numberParams()) {
        const CParamEditor* editor = panel.editor(ref);
        ASSERT_EQ(editor != nullptr, !ref.info->unused()) << ref.key();
        if (!editor) continue;
        EXPECT_FALSE(panel.row(ref)->toolTip().isEmpty());
        for (const double value : {ref.info->range.max, ref.info->range.min}) {
            enter(*editor, value);
            EXPECT_NEAR(ref.get(params), value, std::pow(10, -ref.info->decimals) / 2 + 1e-12) << ref.key();
        }
    }
    const CParams defaults;
    panel.showParams(defaults, defaults);
    for (const ParamRef& ref : numberParams()) {
        const CParamEditor* editor = panel.editor(ref);
        if (!editor) continue;
        EXPECT_NEAR(shownValue(*editor), ref.get(defaults), std::pow(10, -ref.info->decimals) / 2 + 1e-12) << ref.key();
    }
}

TEST(Panel, TabsAreThoseOfTheTree) {
    CParamPanel panel;
    QStringList tabs;
    for (int i = 0; i < panel.tabs().count(); ++i) tabs << panel.tabs().tabText(i);
    EXPECT_EQ(tabs.join(QLatin1Char('|')).toStdString(),
              "Tree|Trunk|Branches 1|Branches 2|Branches 3|Leaves|Blossom|Pruning|Textures");
}

TEST(Panel, ShowingValuesTellsNothing) {
    CParamPanel panel;
    QSignalSpy edited(&panel, &CParamPanel::edited);
    CParams params;
    for (const ParamRef& ref : numberParams()) ref.set(params, ref.info->range.max);
    panel.showParams(params, params);
    EXPECT_EQ(edited.count(), 0);
}

TEST(Panel, ValuesBeyondTheSliderStay) {
    CParamPanel panel;
    CParams params;
    weberPenn(params).scale = 400; // the slider ends at 40
    QSignalSpy edited(&panel, &CParamPanel::edited);
    panel.showParams(params, params);
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

TEST(Panel, NumbersBeyondTheRangeBecomeTheNearestAndItIsSaid) {
    CParamPanel panel;
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    QApplication::setActiveWindow(&panel);
    const auto type = [&](QAbstractSpinBox* box, const char* text) {
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, QLatin1String(text));
        QTest::keyClick(box, Qt::Key_Return);
        return QToolTip::text();
    };
    panel.tabs().setCurrentIndex(panel.tabOf(Group::Leaves));
    auto* whole = panel.editor(paramRef("Leaves"))->findChild<QSpinBox*>();
    const QString said = type(whole, "90000");
    EXPECT_EQ(whole->value(), whole->maximum());
    EXPECT_EQ(said, QStringLiteral("The maximum is %1").arg(whole->cleanText()));
    type(whole, "90");
    EXPECT_EQ(whole->value(), 90);
    panel.tabs().setCurrentIndex(panel.tabOf(Group::Tree));
    auto* real = panel.editor(paramRef("Scale"))->findChild<QDoubleSpinBox*>();
    const QString high = type(real, "12345678");
    EXPECT_EQ(real->value(), real->maximum());
    EXPECT_EQ(high, QStringLiteral("The maximum is %1").arg(real->text()));
    const QString low = type(real, "0.001");
    EXPECT_EQ(real->value(), real->minimum());
    EXPECT_EQ(low, QStringLiteral("The minimum is %1").arg(real->text()));
    type(real, "7.123456789");
    EXPECT_NEAR(real->value(), 7.123456789, 0.5 * std::pow(10, -real->decimals())) << "more digits than it shows";
}

TEST(Panel, WhereLeavesPointStandsWithTheLeaves) {
    CParamPanel panel;
    const auto tabOf = [&](const char* key) {
        for (int tab = 0; tab < panel.tabs().count(); ++tab)
            if (panel.tabs().widget(tab)->isAncestorOf(panel.editor(paramRef(key)))) return panel.tabs().tabText(tab).toStdString();
        return std::string("none");
    };
    CParams params;
    for (const auto& [levels, of2, of3] : {std::tuple{3, "Branches 2", "Leaves"}, {2, "Leaves", "Branches 3"}, {4, "Branches 2", "Branches 3"}, {3, "Branches 2", "Leaves"}}) {
        weberPenn(params).levels = levels;
        panel.showParams(params, params);
        for (const char* name : {"DownAngle", "Rotate"}) {
            EXPECT_EQ(tabOf((std::string("2") + name).c_str()), of2) << levels << name;
            EXPECT_EQ(tabOf((std::string("3") + name).c_str()), of3) << levels << name;
        }
        EXPECT_EQ(tabOf("3Curve"), "Branches 3");
    }
    panel.show();
    panel.showParam(paramRef("3DownAngle"));
    EXPECT_EQ(panel.tabs().tabText(panel.tabs().currentIndex()), QStringLiteral("Leaves"));
    EXPECT_TRUE(panel.editor(paramRef("3DownAngle"))->isVisible());
    EXPECT_TRUE(panel.editor(paramRef("3BranchDistV"))->isVisible()) << "beside the spread, which leaves have not";
    EXPECT_LT(panel.editor(paramRef("3DownAngle"))->mapTo(&panel, QPoint()).y(), panel.editor(paramRef("3Rotate"))->mapTo(&panel, QPoint()).y());
}

TEST(Panel, TheWheelChangesOnlyAnEditorWithTheFocus) {
    CParamPanel panel;
    panel.tabs().setCurrentIndex(2);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    QApplication::setActiveWindow(&panel); // a bare X server has no window manager to do it
    const CParamEditor* editor = panel.editor(paramRef("1Branches"));
    auto* box = editor->findChild<QSpinBox*>();
    auto* slider = editor->findChild<QSlider*>();
    auto* choice = panel.editor(paramRef("Shape"))->findChild<QComboBox*>();
    panel.tabs().tabBar()->setFocus();
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

TEST(Panel, AVariationStandsBesideItsValue) {
    CParamPanel panel;
    int pairs = 0;
    for (const ParamRef& ref : numberParams()) {
        const ParamInfo* variation = variationOf(*ref.info);
        if (!variation || ref.info->unused()) continue;
        EXPECT_EQ(panel.row(ref), panel.row({variation, ref.level})) << ref.key();
        EXPECT_FALSE(panel.editor({variation, ref.level})->findChild<QSlider*>());
        ++pairs;
    }
    EXPECT_EQ(pairs, 2 + 4 * 3 + 3 * 3); // height, radius; length, curve, split; place, down, rotation
}

TEST(Panel, TheFilterReachesAllTabs) {
    CParamPanel panel;
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    panel.filter().setText(QStringLiteral("angle"));
    QStringList tabs;
    for (int i = 0; i < panel.tabs().count(); ++i)
        if (panel.tabs().isTabVisible(i)) tabs << panel.tabs().tabText(i);
    EXPECT_EQ(tabs.join(QLatin1Char('|')).toStdString(), "Trunk|Branches 1|Branches 2|Branches 3|Leaves"); // 3DownAngle places leaves
    EXPECT_FALSE(panel.row(paramRef("1DownAngle"))->isHidden());
    EXPECT_FALSE(panel.row(paramRef("0SplitAngle"))->isHidden());
    EXPECT_TRUE(panel.row(paramRef("1Length"))->isHidden());
    panel.filter().setText(QStringLiteral("leaves fold"));
    EXPECT_FALSE(panel.row(paramRef("LeafFold"))->isHidden()) << "the tab's name counts";
    panel.filter().clear();
    EXPECT_FALSE(panel.row(paramRef("1Length"))->isHidden());
    EXPECT_TRUE(panel.tabs().isTabVisible(0));
}

TEST(Panel, TheFilterKnowsOtherWordsAndSaysWhenItFindsNothing) {
    CParamPanel panel;
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    for (const auto& [word, key] : {std::pair("gravity", "AttractionUp"), {"droop", "AttractionUp"}, {"autumn", "Season"}, {"phyllotaxis", "2Rotate"}}) {
        panel.filter().setText(QLatin1String(word));
        EXPECT_FALSE(panel.row(paramRef(key))->isHidden()) << word;
        EXPECT_TRUE(panel.row(paramRef("0Length"))->isHidden()) << word;
        EXPECT_TRUE(panel.nothing().isHidden());
    }
    panel.filter().setText(QStringLiteral("chlorophyll"));
    EXPECT_TRUE(panel.nothing().isVisible());
    EXPECT_TRUE(panel.nothing().text().contains(QLatin1String("chlorophyll")));
    EXPECT_TRUE(panel.tabs().isHidden());
    QTest::keyClick(&panel.filter(), Qt::Key_Escape);
    EXPECT_TRUE(panel.filter().text().isEmpty());
    EXPECT_TRUE(panel.nothing().isHidden());
    EXPECT_TRUE(panel.tabs().isVisible());
}

TEST(Panel, FoldedSectionsStayFolded) {
    const auto heading = [](CParamPanel& panel) {
        for (auto* button : panel.findChildren<QAbstractButton*>())
            if (button->text() == QLatin1String("Lobes") && button->isCheckable()) return button;
        return static_cast<QAbstractButton*>(nullptr);
    };
    {
        CParamPanel panel;
        ASSERT_TRUE(heading(panel));
        EXPECT_FALSE(panel.row(paramRef("Lobes"))->isHidden());
        heading(panel)->click();
        EXPECT_TRUE(panel.row(paramRef("Lobes"))->isHidden());
        panel.filter().setText(QStringLiteral("lobe"));
        EXPECT_FALSE(panel.row(paramRef("Lobes"))->isHidden()) << "what is looked for is shown";
    }
    CParamPanel again;
    EXPECT_TRUE(again.row(paramRef("Lobes"))->isHidden());
    heading(again)->click();
}

TEST(Panel, ADoubleClickOnALabelResetsTheRow) {
    CParamPanel panel;
    CParams params;
    weberPenn(params).level[1].downAngle = 77;
    weberPenn(params).level[1].downAngleV = 11;
    panel.showParams(params, CParams());
    CParamRow* row = panel.row(paramRef("1DownAngle"));
    EXPECT_TRUE(row->marked()) << "differs from the saved values";
    EXPECT_FALSE(panel.row(paramRef("1Rotate"))->marked());
    ParamValues assigned;
    QObject::connect(&panel, &CParamPanel::assigned, [&](const QString&, const auto& values) { assigned = values; });
    QTest::mouseDClick(row->findChild<QLabel*>(), Qt::LeftButton);
    ASSERT_EQ(assigned.size(), 2u) << "value and variation in one step";
    EXPECT_EQ(assigned[0].second, ParamValue(30.0));
    EXPECT_EQ(assigned[1].second, ParamValue(0.0));
}

TEST(Panel, WhatDoesNothingIsGreyedWithTheReason) {
    CParamPanel panel;
    CParams params;
    panel.showParams(params, params);
    for (const char* idle : {"LobeDepth", "0SplitAngle", "PruneWidth", "LeafScale", "1SplitAngle"})
        EXPECT_FALSE(panel.editor(paramRef(idle))->isEnabled()) << idle;
    params.common.lobes = 5;
    weberPenn(params).pruneRatio = 1;
    weberPenn(params).leaves = 10;
    weberPenn(params).level[1].segSplits = 0.5;
    panel.showParams(params, params);
    for (const char* acts : {"LobeDepth", "PruneWidth", "LeafScale", "1SplitAngle"})
        EXPECT_TRUE(panel.editor(paramRef(acts))->isEnabled()) << acts;
    weberPenn(params).levels = 2;
    panel.showParams(params, params);
    EXPECT_FALSE(panel.editor(paramRef("2Curve"))->isEnabled()) << "there are no stems of level 2";
    EXPECT_TRUE(panel.editor(paramRef("2DownAngle"))->isEnabled()) << "it places the leaves";
    EXPECT_FALSE(panel.editor(paramRef("3DownAngle"))->isEnabled());
}

TEST(Panel, LocksAreKept) {
    const ParamRef ref = paramRef("1Curve");
    {
        CParamPanel panel;
        panel.showLocksOf(QStringLiteral("/trees/aspen.tree"));
        EXPECT_FALSE(panel.locked(ref));
        emit panel.row(ref)->lockToggled(true);
        EXPECT_TRUE(panel.locked(ref));
        EXPECT_TRUE(panel.locked(paramRef("1CurveV"))) << "with its variation";
    }
    CParamPanel again;
    again.showLocksOf(QStringLiteral("/trees/other.tree"));
    EXPECT_FALSE(again.locked(ref)) << "of the tree alone";
    again.showLocksOf(QStringLiteral("/trees/aspen.tree"));
    EXPECT_TRUE(again.locked(ref));
    emit again.row(ref)->lockToggled(false);
    EXPECT_FALSE(again.locked(ref));
}

TEST(Panel, ShiftDragsFinelyCtrlCoarsely) {
    CParamPanel panel;
    panel.resize(700, 700);
    panel.tabs().setCurrentIndex(2);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    CParams params;
    QObject::connect(&panel, &CParamPanel::edited, [&](const ParamRef& ref, const ParamValue& value, int) {
        ref.setValue(params, value);
        panel.showParams(params, params);
    });
    const ParamRef ref = paramRef("1DownAngle");
    auto* slider = panel.editor(ref)->findChild<QSlider*>();
    const auto dragBy = [&](int pixels, Qt::KeyboardModifiers keys) {
        const QPoint start = slider->rect().center();
        QTest::mousePress(slider, Qt::LeftButton, keys, start);
        const double before = ref.get(params);
        const QPointF to = start + QPoint(pixels, 0);
        QMouseEvent move(QEvent::MouseMove, to, slider->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, keys);
        QCoreApplication::sendEvent(slider, &move);
        QTest::mouseRelease(slider, Qt::LeftButton, keys, to.toPoint());
        return ref.get(params) - before;
    };
    dragBy(1, {});
    const double plain = dragBy(20, {}), fine = dragBy(20, Qt::ShiftModifier);
    EXPECT_GT(plain, 10);
    EXPECT_GT(fine, 0);
    EXPECT_LT(fine, plain / 5);
    dragBy(20, Qt::ControlModifier);
    EXPECT_EQ(std::fmod(ref.get(params), 10), 0) << "ten steps of one degree";
    slider->setFocus();
    const double before = ref.get(params);
    QTest::keyClick(slider, Qt::Key_Right);
    EXPECT_EQ(ref.get(params), before + 1);
    QTest::keyClick(slider, Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_NEAR(ref.get(params), before + 1.1, 1e-9);
}

TEST(Panel, ABurstOfKeysIsOneGesture) {
    CParamPanel panel;
    std::vector<int> gestures;
    QObject::connect(&panel, &CParamPanel::edited,
                     [&](const ParamRef&, const ParamValue&, int gesture) { gestures.push_back(gesture); });
    auto* slider = panel.editor(paramRef("1DownAngle"))->findChild<QSlider*>();
    for (int i = 0; i < 3; ++i) QTest::keyClick(slider, Qt::Key_Right);
    QTest::qWait(900);
    QTest::keyClick(slider, Qt::Key_Right);
    ASSERT_EQ(gestures.size(), 4u);
    EXPECT_EQ(gestures[0], gestures[2]);
    EXPECT_NE(gestures[2], gestures[3]);
}

/// Chooses an entry of the menu that is about to pop up.
void chooseFromMenu(QWidget& over, const QString& text) {
    QTimer::singleShot(50, &over, [text] {
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        ASSERT_TRUE(menu);
        for (QAction* action : menu->actions())
            if (action->text().remove(QLatin1Char('&')) == text) action->trigger();
        menu->close();
    });
    QContextMenuEvent event(QContextMenuEvent::Mouse, {5, 5}, over.mapToGlobal(QPoint(5, 5)));
    QCoreApplication::sendEvent(&over, &event);
    QTest::qWait(80);
}

TEST(Panel, CopiesAndPastesBetweenLevels) {
    CParamPanel panel;
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    CParams params;
    weberPenn(params).level[1].curve = 33;
    weberPenn(params).level[1].curveV = 44;
    panel.showParams(params, params);
    QObject::connect(&panel, &CParamPanel::assigned, [&](const QString&, const auto& values) {
        for (const auto& [ref, value] : values) ref.setValue(params, value);
    });
    chooseFromMenu(*panel.row(paramRef("1Curve")), QStringLiteral("Copy"));
    EXPECT_EQ(QApplication::clipboard()->text().toStdString(), "1Curve = 33\n1CurveV = 44\n");
    chooseFromMenu(*panel.row(paramRef("2Curve")), QStringLiteral("Paste"));
    EXPECT_EQ(weberPenn(params).level[2].curve, 33);
    EXPECT_EQ(weberPenn(params).level[2].curveV, 44);
}

TEST(HelpPictures, BlossomsAndFruitsAreSeen) {
    for (const char* key : {"Blossoms", "BlossomDome", "Fruits", "FruitMonth"}) {
        const QImage image = helpPicture(paramRef(key), QApplication::palette(), 1);
        int red = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const QColor colour = image.pixelColor(x, y);
                red += colour.alpha() > 128 && colour.red() > colour.green() + 40 && colour.red() > colour.blue() + 30;
            }
        EXPECT_GT(red, 40) << key;
    }
}

TEST(HelpPictures, EveryValueThatActsHasOneAndItsTreesDiffer) {
    for (const ParamRef& ref : numberParams()) {
        if (ref.level > 1) continue; // shown at level 1
        const QImage image = helpPicture(ref, QApplication::palette(), 1);
        EXPECT_EQ(image.isNull(), ref.info->unused() || ref.group() == Group::Textures) << ref.key();
        if (image.isNull()) continue;
        const QImage left = image.copy(0, 0, image.width() / 3, 120);
        const QImage right = image.copy(image.width() - image.width() / 3, 0, image.width() / 3, 120);
        const bool onlyShading = ref.info->field == field<&CommonParams::leafRounding>;
        if (ref.info->words.empty() && !onlyShading) {
            EXPECT_TRUE(left != right) << ref.key();
        }
    }
}

} // namespace
} // namespace stromar
