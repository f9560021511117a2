#include "Checkout.h"
#include "window/Languages.h"
#include "window/MainWindow.h"
#include "params/ParamPanel.h"
#include "Support.h"
#include <QAbstractButton>
#include <QAction>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QProcess>
#include <QRegularExpression>
#include <QTabWidget>
#include <QTemporaryDir>
#include "stromar/app/Import.h"
#include "stromar/params/TreeFile.h"
#include "stromar/util/Translatable.h"
#include <gtest/gtest.h>

namespace stromar {
namespace {

QString contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

TEST(Languages, AllTextsAreTranslated) {
    // A copy is brought up to date with the sources: what is new or gone would show.
    QTemporaryDir folder;
    const QDir own(QString::fromStdString(test::inSource("translations")));
    ASSERT_EQ(own.entryList({QStringLiteral("*.ts")}).size(), int(languageTable().size()));
    for (const QString& name : own.entryList({QStringLiteral("*.ts")}))
        ASSERT_TRUE(QFile::copy(own.filePath(name), folder.filePath(name)));
    QProcess update;
    update.start(QString::fromStdString(test::inSource("script/translate")), {folder.path()});
    ASSERT_TRUE(update.waitForFinished(120000));
    ASSERT_EQ(update.exitCode(), 0) << update.readAllStandardError().toStdString();
    for (const Language& language : languageTable()) {
        const QString name = QStringLiteral("stromar_%1.ts").arg(QLatin1String(language.code));
        const QString text = contentOf(folder.filePath(name));
        EXPECT_FALSE(text.contains(QLatin1String("unfinished"))) << language.code;
        EXPECT_EQ(text.count(QLatin1String("<source>")), contentOf(own.filePath(name)).count(QLatin1String("<source>")))
            << language.code << ": run script/translate";
        EXPECT_GT(text.count(QLatin1String("<source>")), 0);
    }
}

TEST(Languages, PlaceholdersSurvive) {
    static const QRegularExpression message(
        QStringLiteral("<source>(.*?)</source>\\s*<translation>(.*?)</translation>"),
        QRegularExpression::DotMatchesEverythingOption);
    static const QRegularExpression place(QStringLiteral("%[0-9n]"));
    for (const Language& language : languageTable()) {
        const QString text =
            contentOf(QString::fromStdString(test::inSource("translations/stromar_%1.ts")).arg(QLatin1String(language.code)));
        for (auto match = message.globalMatch(text); match.hasNext();) {
            const QRegularExpressionMatch pair = match.next();
            QStringList wanted;
            for (auto p = place.globalMatch(pair.captured(1)); p.hasNext();) wanted << p.next().captured();
            for (const QString& one : wanted)
                EXPECT_TRUE(pair.captured(2).contains(one)) << language.code << ": " << pair.captured(2).toStdString();
        }
    }
}

class LanguageTest : public ::testing::TestWithParam<const char*> {
protected:
    void SetUp() override { speak(QStringLiteral("en")); }
    void TearDown() override { speak(QStringLiteral("en")); }
};

TEST_P(LanguageTest, TheWindowSpeaksItAndNothingIsCutOff) {
    ASSERT_TRUE(speak(QLatin1String(GetParam())));
    CMainWindow window;
    window.resize(1280, 800);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    EXPECT_EQ(window.findChild<QAction*>(QStringLiteral("save"))->text() == QLatin1String("&Save"),
              GetParam() == std::string("en"));
    EXPECT_EQ(window.panel().tabs().tabText(1) == QLatin1String("Trunk"), GetParam() == std::string("en"))
        << "texts of the tables";
    window.findChild<QDockWidget*>(QStringLiteral("variants"))->raise();
    ASSERT_TRUE(waitFor([&] { return !window.busy(); }, 60000));
    QTest::qWait(500); // the full model, too
    for (int tab = 0; tab < window.panel().tabs().count(); ++tab) {
        window.panel().tabs().setCurrentIndex(tab);
        QTest::qWait(20);
        for (QWidget* widget : window.findChildren<QWidget*>()) {
            const auto* label = qobject_cast<QLabel*>(widget);
            const auto* button = qobject_cast<QAbstractButton*>(widget);
            const QString text = label ? label->text() : button ? button->text() : QString();
            if (!widget->isVisible() || text.isEmpty() || (label && label->wordWrap()) ||
                widget->objectName() == QLatin1String("notice") ||
                widget->sizePolicy().horizontalPolicy() == QSizePolicy::Ignored)
                continue;
            EXPECT_GE(widget->width() + 1, widget->sizeHint().width()) << text.toStdString();
        }
    }
}

/// What is said of `text` as a file.
std::string faultOf(const std::string& text) {
    try {
        CTreeFile::parse(text, "a.tree");
    } catch (const CInputError& e) {
        return e.what();
    }
    return {};
}

TEST_P(LanguageTest, FaultsOfFilesAreSaidInIt) {
    constexpr const char* kWrong[] = {"Scale = high", "Scale", "Shape = conicle", "0BaseSize = \"1", "Format = 99", "Method = oracle",
                                      "Method = l-system\nGrammar = \"\"\"\naxiom: F(\n"};
    std::vector<std::string> english;
    for (const char* wrong : kWrong) english.push_back(faultOf(wrong));
    ASSERT_TRUE(speak(QLatin1String(GetParam())));
    for (std::size_t i = 0; i < english.size(); ++i) {
        const std::string said = faultOf(kWrong[i]);
        EXPECT_EQ(said == english[i], GetParam() == std::string("en")) << said;
        EXPECT_EQ(said.substr(0, said.find(' ')), english[i].substr(0, english[i].find(' '))) << "the place in the file";
    }
    EXPECT_NE(faultOf("Shape = conicle").find("conical"), std::string::npos) << "the suggestion";
}

TEST_P(LanguageTest, WhatAnImportChangesIsSaidInIt) {
    ASSERT_TRUE(speak(QLatin1String(GetParam())));
    for (const ImportFormat& format : importTable())
        for (const ImportRow& row : format.rows)
            EXPECT_EQ(translated(row.note) == row.note, row.note.empty() || GetParam() == std::string("en")) << row.note;
}

INSTANTIATE_TEST_SUITE_P(All, LanguageTest, ::testing::Values("en", "cs", "sl", "ru"),
                         [](const auto& language) { return std::string(language.param); });

TEST(Languages, TheSystemsIsTakenWhenItIsKnown) {
    EXPECT_EQ(chosenLanguage(QStringLiteral("sl")), QLatin1String("sl"));
    EXPECT_FALSE(chosenLanguage(QStringLiteral("system")).isEmpty());
    EXPECT_EQ(chosenLanguage(QStringLiteral("xx")), chosenLanguage(QStringLiteral("system")));
}

} // namespace
} // namespace stromar
