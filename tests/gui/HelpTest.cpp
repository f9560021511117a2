#include "Checkout.h"
#include "window/HelpWindow.h"
#include "window/MainWindow.h"
#include "PictureDifference.h"
#include "Support.h"
#include <QAbstractTextDocumentLayout>
#include <QAction>
#include <QDir>
#include <QFileInfo>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocument>
#include <QToolBar>
#include <gtest/gtest.h>

namespace stromar {
namespace {

QString shownPage(CHelpWindow& help) { return QFileInfo(help.browser().source().path()).fileName(); }

/// The pieces of text and the pictures of the page that is shown.
QList<QTextFragment> pieces(CHelpWindow& help) {
    QList<QTextFragment> all;
    const QTextDocument& page = *help.browser().document();
    for (QTextBlock block = page.begin(); block.isValid(); block = block.next())
        for (auto piece = block.begin(); !piece.atEnd(); ++piece) all << piece.fragment();
    return all;
}

class Help : public ::testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(CHelpWindow::available());
        help.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&help));
        help.open(QStringLiteral("manual"));
    }
    QAction* command(const char* text) {
        for (QAction* action : help.findChild<QToolBar*>()->actions())
            if (action->text() == QLatin1String(text)) return action;
        return nullptr;
    }
    QStringList links() {
        QStringList all;
        for (const QTextFragment& piece : pieces(help))
            if (piece.charFormat().isAnchor()) all << piece.charFormat().anchorHref();
        return all;
    }
    /// Clicks into the first letter of a link.
    void click(const QString& link) {
        QTextBrowser& browser = help.browser();
        for (const QTextFragment& piece : pieces(help)) {
            if (piece.charFormat().anchorHref() != link) continue;
            QTextCursor cursor(browser.document());
            cursor.setPosition(piece.position() + 1);
            browser.setTextCursor(cursor);
            browser.ensureCursorVisible();
            const QPoint end = browser.cursorRect(cursor).center();
            QTest::mouseClick(browser.viewport(), Qt::LeftButton, {}, end - QPoint(2, 0));
            return;
        }
        ADD_FAILURE() << "no link to " << link.toStdString();
    }

    CHelpWindow help;
};

TEST(HelpOfTheWindow, IsTheManual) {
    CMainWindow window;
    auto* manual = window.findChild<QAction*>(QStringLiteral("manual"));
    manual->trigger();
    auto* help = window.findChild<CHelpWindow*>();
    ASSERT_TRUE(help);
    EXPECT_TRUE(help->isVisible());
    EXPECT_EQ(shownPage(*help), QStringLiteral("manual.md"));
    EXPECT_TRUE(help->browser().toPlainText().contains(QLatin1String("Stromar grows trees")));
    help->close();
    manual->trigger();
    EXPECT_TRUE(help->isVisible()) << "again";
    EXPECT_EQ(window.findChildren<CHelpWindow*>().size(), 1);
}

TEST_F(Help, FollowsLinksAndGoesBack) {
    EXPECT_FALSE(command("Back")->isEnabled());
    click(QStringLiteral("crown.md"));
    EXPECT_EQ(shownPage(help), QStringLiteral("crown.md"));
    EXPECT_TRUE(help.browser().toPlainText().startsWith(QLatin1String("Crown"))) << "as headings, not as marks";
    command("Back")->trigger();
    EXPECT_EQ(shownPage(help), QStringLiteral("manual.md"));
    EXPECT_TRUE(help.browser().toPlainText().contains(QLatin1String("Stromar grows trees")));
    command("Forward")->trigger();
    EXPECT_EQ(shownPage(help), QStringLiteral("crown.md"));
    command("Contents")->trigger();
    EXPECT_EQ(shownPage(help), QStringLiteral("manual.md"));
}

TEST_F(Help, AllPagesAreThereWithTheirPictures) {
    QStringList pages{QStringLiteral("manual.md")};
    int pictures = 0;
    for (int i = 0; i < pages.size(); ++i) {
        help.open(QFileInfo(pages[i]).completeBaseName());
        EXPECT_GT(help.browser().toPlainText().size(), 300) << pages[i].toStdString();
        for (const QTextFragment& piece : pieces(help)) {
            if (!piece.charFormat().isImageFormat()) continue;
            const QString name = piece.charFormat().toImageFormat().name();
            const auto image = help.browser().loadResource(QTextDocument::ImageResource, QUrl(name)).value<QImage>();
            EXPECT_FALSE(image.isNull()) << pages[i].toStdString() << ": " << name.toStdString();
            EXPECT_LT(image.width() / image.devicePixelRatio(), help.browser().viewport()->width());
            ++pictures;
        }
        for (const QString& link : links()) {
            const QString page = link.section(QLatin1Char('#'), 0, 0);
            if (page.endsWith(QLatin1String(".md")) && !pages.contains(page)) pages << page;
        }
    }
    EXPECT_EQ(pages.size(), QDir(QString::fromStdString(test::inSource("docs"))).entryList({QStringLiteral("*.md")}).size() - 1)
        << "all but the architecture";
    EXPECT_GT(pictures, 60);
}

TEST_F(Help, ShowsThePictureOnThePage) {
    const QTextDocument& page = *help.browser().document();
    QTextBlock block = page.begin();
    while (block.isValid() && !block.begin().fragment().charFormat().isImageFormat()) block = block.next();
    ASSERT_TRUE(block.isValid());
    const QUrl name(block.begin().fragment().charFormat().toImageFormat().name());
    const int width = help.browser().loadResource(QTextDocument::ImageResource, name).value<QImage>().width();
    ASSERT_GT(width, help.browser().viewport()->width() / 2);
    const QImage picture(QString::fromStdString(test::inSource("docs/")) + name.path());
    const QImage wanted = picture.scaledToWidth(width, Qt::SmoothTransformation);
    const QPoint corner = page.documentLayout()->blockBoundingRect(block).topLeft().toPoint();
    const QImage seen = help.browser().viewport()->grab({corner, wanted.size()}).toImage();
    ASSERT_EQ(seen.size(), wanted.size());
    const test::TileDifference worst = worstTile(seen, wanted);
    EXPECT_LT(worst.mean, test::kMaxTileDifference) << worst;
}

} // namespace
} // namespace stromar
