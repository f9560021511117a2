#include "work/ExportDialog.h"
#include "window/QtText.h"
#include "Support.h"
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTemporaryDir>
#include <gtest/gtest.h>

namespace stromar {
namespace {

/// Finds its parts by the names of the table's rows.
struct Dialog : CExportDialog {
    explicit Dialog(std::size_t rowTrees = 0) : CExportDialog(QStringLiteral("oak"), 1e6, rowTrees) {}
    QComboBox* combo(const char* name) { return findChild<QComboBox*>(QLatin1String(name)); }
    QLineEdit* place() { return findChild<QLineEdit*>(QStringLiteral("path")); }
    QString conflict() { return findChild<QLabel*>(QStringLiteral("conflict"))->text(); }
    bool canExport() {
        for (const QPushButton* button : findChildren<QPushButton*>())
            if (button->text() == QLatin1String("Export")) return button->isEnabled();
        return false;
    }
    void chooseFormat(const char* ending) {
        combo("format")->setCurrentIndex(combo("format")->findData(QLatin1String(ending)));
    }
};

TEST(ExportDialog, HasAnEditorForEveryChoice) {
    Dialog dialog;
    for (const ExportChoice& choice : exportChoices()) {
        auto* editor = dialog.findChild<QWidget*>(toQString(choice.key));
        ASSERT_TRUE(editor) << choice.key;
        EXPECT_EQ(editor->toolTip(), toQString(choice.help));
        if (choice.words.empty()) continue;
        EXPECT_EQ(dialog.combo(std::string(choice.key).c_str())->count(), int(choice.words.size()));
    }
    EXPECT_EQ(dialog.combo("format")->count(), int(formatTable().size()));
    EXPECT_TRUE(dialog.canExport()) << dialog.conflict().toStdString();
}

TEST(ExportDialog, TreesSideBySideAreOneSceneUnlessOneIsWanted) {
    Dialog row(9), alone(0);
    EXPECT_FALSE(alone.wantsRow());
    EXPECT_FALSE(alone.combo("trees")->isVisibleTo(&alone));
    ASSERT_TRUE(row.combo("trees")->isVisibleTo(&row));
    EXPECT_TRUE(row.combo("trees")->currentText().contains(QLatin1String("9")));
    EXPECT_TRUE(row.wantsRow());
    row.chooseFormat(".glb");
    row.combo("lods")->setCurrentIndex(static_cast<int>(ExportedLods::InOneFile));
    EXPECT_FALSE(row.canExport());
    row.combo("trees")->setCurrentIndex(0);
    EXPECT_FALSE(row.wantsRow());
    EXPECT_TRUE(row.canExport()) << row.conflict().toStdString();
}

TEST(ExportDialog, FitsOnASmallScreenAndCutsNoText) {
    Dialog dialog;
    dialog.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
    dialog.resize(560, 600);
    dialog.chooseFormat(".dae");
    dialog.combo("engine")->setCurrentIndex(1);
    QTest::qWait(50);
    EXPECT_LE(dialog.minimumSizeHint().height(), 640);
    for (const QLabel* label : dialog.findChildren<QLabel*>())
        if (label->isVisible() && label->wordWrap()) {
            EXPECT_GE(label->height(), label->heightForWidth(label->width())) << label->text().toStdString();
        }
    for (const char* always : {"path", "conflict"}) {
        const auto* widget = dialog.findChild<QWidget*>(QLatin1String(always));
        EXPECT_TRUE(dialog.rect().contains(QRect(widget->mapTo(&dialog, QPoint()), widget->size()))) << always;
    }
}

TEST(ExportDialog, WhatDoesNotCountIsGrey) {
    Dialog dialog;
    const auto* bones = dialog.findChild<QWidget*>(QStringLiteral("bones"));
    EXPECT_FALSE(bones->isEnabled());
    dialog.combo("wind")->setCurrentIndex(static_cast<int>(ExportedWind::Bones));
    EXPECT_TRUE(bones->isEnabled());
    dialog.combo("wind")->setCurrentIndex(static_cast<int>(ExportedWind::None));
}

TEST(ExportDialog, StartsWithTheDefaults) {
    QSettings().remove(QStringLiteral("export"));
    Dialog dialog;
    const ExportOptions defaults;
    for (const ExportChoice& choice : exportChoices()) {
        const QString key = toQString(choice.key);
        if (choice.number)
            EXPECT_EQ(dialog.findChild<QDoubleSpinBox*>(key)->value(), defaults.*choice.number) << choice.key;
        else if (choice.words.empty())
            EXPECT_EQ(dialog.findChild<QSpinBox*>(key)->value(), defaults.*choice.field) << choice.key;
        else
            EXPECT_EQ(dialog.findChild<QComboBox*>(key)->currentIndex(), defaults.*choice.field) << choice.key;
    }
}

TEST(ExportDialog, AnotherFormatsEndingChoosesIt) {
    Dialog dialog;
    dialog.chooseFormat(".glb");
    dialog.place()->setText(QStringLiteral("/tmp/my.oak.dae"));
    EXPECT_EQ(dialog.combo("format")->currentData().toString(), QStringLiteral(".dae"));
    EXPECT_EQ(dialog.path(), QStringLiteral("/tmp/my.oak.dae"));
    EXPECT_TRUE(dialog.canExport());
}

TEST(ExportDialog, TheFormatChangesTheEnding) {
    Dialog dialog;
    for (const Format& format : formatTable()) {
        dialog.chooseFormat(std::string(format.ending).c_str());
        EXPECT_TRUE(dialog.path().endsWith(QLatin1String("/oak") + toQString(format.ending)))
            << dialog.path().toStdString();
        EXPECT_TRUE(dialog.canExport()) << format.ending;
    }
    dialog.place()->setText(QStringLiteral("/tmp/oak.txt"));
    EXPECT_FALSE(dialog.canExport());
}

TEST(ExportDialog, SaysWhatAFormatCannotDo) {
    Dialog dialog;
    dialog.chooseFormat(".stl");
    dialog.combo("lods")->setCurrentIndex(int(ExportedLods::InOneFile));
    EXPECT_FALSE(dialog.canExport());
    EXPECT_TRUE(dialog.conflict().contains(QLatin1String(".stl"))) << dialog.conflict().toStdString();
    dialog.chooseFormat(".glb");
    EXPECT_TRUE(dialog.canExport());
    EXPECT_EQ(dialog.options().lods, int(ExportedLods::InOneFile));
    dialog.combo("lods")->setCurrentIndex(0);
}

TEST(ExportDialog, RemembersTheLastChoices) {
    QTemporaryDir folder;
    {
        Dialog dialog;
        dialog.chooseFormat(".ply");
        dialog.findChild<QDoubleSpinBox*>(QStringLiteral("scale"))->setValue(100);
        dialog.findChild<QSpinBox*>(QStringLiteral("lod"))->setValue(2);
        dialog.place()->setText(folder.filePath(QStringLiteral("a.ply")));
        dialog.accept();
    }
    Dialog again;
    EXPECT_EQ(again.options().scale, 100);
    EXPECT_EQ(again.options().lod, 2);
    EXPECT_EQ(again.path(), folder.filePath(QStringLiteral("oak.ply")));
    again.findChild<QDoubleSpinBox*>(QStringLiteral("scale"))->setValue(1);
    again.findChild<QSpinBox*>(QStringLiteral("lod"))->setValue(0);
    again.chooseFormat(".glb");
    again.accept();
}

} // namespace
} // namespace stromar
