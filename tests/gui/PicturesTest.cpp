#include <QDir>
#include <QDirIterator>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <gtest/gtest.h>

namespace stromar {
namespace {

/// Mean difference of the channels, 0..255.
double difference(const QImage& a, const QImage& b) {
    double sum = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
            sum += std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q)) +
                   std::abs(qAlpha(p) - qAlpha(q));
        }
    return sum / (4.0 * a.width() * a.height());
}

TEST(Pictures, OfTheManualShowTheProgramAsItIs) {
    QTemporaryDir folder;
    QProcess script;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("STROMAR"), QStringLiteral(STROMAR_BIN "/stromar"));
    script.setProcessEnvironment(environment);
    script.start(QStringLiteral(STROMAR_SOURCE "/script/make-pictures"), {folder.path()});
    ASSERT_TRUE(script.waitForFinished(280000));
    ASSERT_EQ(script.exitCode(), 0) << script.readAllStandardError().toStdString();
    int count = 0;
    for (QDirIterator files(folder.path(), {QStringLiteral("*.png")}, QDir::Files, QDirIterator::Subdirectories);
         files.hasNext(); ++count) {
        const QString path = files.next(), name = QDir(folder.path()).relativeFilePath(path);
        const QImage now(path), shown(QStringLiteral(STROMAR_SOURCE "/docs/images/") + name);
        ASSERT_FALSE(shown.isNull()) << name.toStdString() << ": run script/make-pictures";
        ASSERT_EQ(now.size(), shown.size()) << name.toStdString() << ": run script/make-pictures";
        // Times in the status line and the edges of leaves may differ.
        EXPECT_LT(difference(now, shown), 3) << name.toStdString() << ": run script/make-pictures and look";
    }
    EXPECT_GT(count, 50);
}

} // namespace
} // namespace stromar
