#include "Checkout.h"
#include "PictureDifference.h"
#include <QDir>
#include <QDirIterator>
#include <QImage>
#include <QPainter>
#include <QProcess>
#include <QTemporaryDir>
#include <gtest/gtest.h>
#include <vector>

namespace stromar {
namespace {

/// Where a picture of the window tells how long something took.
std::vector<test::PictureArea> timesIn(const QString& name, const QSize& size) {
    if (name.contains(QLatin1Char('/'))) return {}; // no window
    constexpr int kStatusLine = 27;
    std::vector<test::PictureArea> areas{{0, size.height() - kStatusLine, size.width(), kStatusLine}};
    if (name == QLatin1String("guide.png")) areas.push_back({214, 171, 277, 18}); // the last line of the statistics
    return areas;
}

QImage manualPicture(const QString& name) { return QImage(QString::fromStdString(test::inSource("docs/images/")) + name); }

TEST(SlowPictures, OfTheManualShowTheProgramAsItIs) {
    QTemporaryDir folder;
    QProcess script;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("STROMAR"), QString::fromStdString(test::inBin("stromar")));
    script.setProcessEnvironment(environment);
    script.start(QString::fromStdString(test::inSource("script/make-pictures")), {folder.path()});
    ASSERT_TRUE(script.waitForFinished(280000));
    ASSERT_EQ(script.exitCode(), 0) << script.readAllStandardError().toStdString();
    int count = 0;
    for (QDirIterator files(folder.path(), {QStringLiteral("*.png")}, QDir::Files, QDirIterator::Subdirectories);
         files.hasNext(); ++count) {
        const QString path = files.next(), name = QDir(folder.path()).relativeFilePath(path);
        const QImage now(path), shown = manualPicture(name);
        ASSERT_FALSE(shown.isNull()) << name.toStdString() << ": run script/make-pictures";
        ASSERT_EQ(now.size(), shown.size()) << name.toStdString() << ": run script/make-pictures";
        const test::TileDifference worst = worstTile(now, shown, timesIn(name, now.size()));
        EXPECT_LT(worst.mean, test::kMaxTileDifference)
            << name.toStdString() << ' ' << worst << ": run script/make-pictures and look";
    }
    EXPECT_GT(count, 50);
}

TEST(Pictures, ShowWhenThePanelIsBlank) {
    const QString name = QStringLiteral("window.png");
    const QImage shown = manualPicture(name).convertToFormat(QImage::Format_RGB32);
    ASSERT_EQ(shown.size(), QSize(1280, 800));
    const QRect panel(820, 128, 444, 642), season(840, 530, 420, 28);
    for (const QRect& part : {panel, season}) {
        QImage blank = shown;
        const QImage mean = shown.copy(part).scaled(1, 1, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        QPainter(&blank).fillRect(part, mean.pixelColor(0, 0));
        const test::TileDifference worst = worstTile(blank, shown, timesIn(name, shown.size()));
        EXPECT_GT(worst.mean, 5 * test::kMaxTileDifference) << worst;
        EXPECT_TRUE(part.adjusted(-8, -8, 0, 0).contains(worst.x, worst.y)) << worst;
    }
}

} // namespace
} // namespace stromar
