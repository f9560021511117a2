#include "view/PictureDialog.h"
#include "window/QtText.h"
#include "WindowFixture.h"
#include "stromar/util/FileSet.h"
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QPointer>
#include <QProgressDialog>
#include <QPushButton>
#include <QRegularExpression>
#include <QSpinBox>
#include <QTemporaryDir>
#include <csignal>
#include <sys/resource.h>

namespace stromar {
namespace {

class SavePicture : public WindowFixture {
protected:
    void SetUp() override {
        WindowFixture::SetUp();
        action("backdropSky")->trigger();
        action("recentre")->trigger();
    }

    /// Goes through the dialogs of the command as a user does, until the files are written.
    void save(const PictureOptions& wanted) {
        messages.clear();
        QPointer<QWidget> answered;
        QTimer poll;
        QObject::connect(&poll, &QTimer::timeout, &poll, [&] {
            QWidget* dialog = QApplication::activeModalWidget();
            if (!dialog || dialog == answered) return;
            answered = dialog;
            if (auto* box = qobject_cast<QMessageBox*>(dialog)) {
                messages << box->text();
                QAbstractButton* yes = box->button(QMessageBox::Yes);
                press(yes ? yes : box->buttons().front());
            } else if (auto* files = qobject_cast<QFileDialog*>(dialog)) {
                auto* name = files->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
                offered = files->nameFilters().join(QLatin1Char(' '));
                QApplication::setActiveWindow(files);
                name->setFocus(); // else what the dialog proposes stays selected
                name->setText(wanted.path);
                press(files->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save));
            } else if (auto* choices = qobject_cast<CPictureDialog*>(dialog)) {
                choices->findChild<QSpinBox*>(QStringLiteral("width"))->setValue(wanted.size.width());
                choices->findChild<QSpinBox*>(QStringLiteral("height"))->setValue(wanted.size.height());
                choices->findChild<QSpinBox*>(QStringLiteral("frames"))->setValue(wanted.frames);
                choices->findChild<QCheckBox*>()->setChecked(wanted.transparent);
                press(choices->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save));
            } else if (auto* progress = qobject_cast<QProgressDialog*>(dialog); progress && wanted.frames > kPatience) {
                press(progress->findChild<QPushButton*>());
            }
        });
        poll.start(5);
        action("picture")->trigger();
    }
    QImage seenFrom(const CCamera& camera, const QSize& size, int passes) {
        return window.viewport().picture(size, window.viewport().look(), camera, passes).convertToFormat(kPixels);
    }
    QString path(const QString& name) const { return folder.filePath(name); }
    QStringList files() const { return QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot); }

    static constexpr QImage::Format kPixels = QImage::Format_ARGB32;
    static constexpr int kPatience = 100; ///< frames: longer turntables are cancelled
    QTemporaryDir folder;
    QStringList messages; ///< of the message boxes on the way
    QString offered;      ///< what the dialog calls pictures

    /// Later: pressed inside the timer's slot, the dialog that follows would stop the timer.
    static void press(QAbstractButton* button) { QTimer::singleShot(0, button, &QAbstractButton::click); }
};
class SlowSavePicture : public SavePicture {};

TEST_F(SavePicture, APictureOfOnesOwnMayBeBehind) {
    QImage red(40, 30, QImage::Format_RGB32);
    red.fill(Qt::red);
    ASSERT_TRUE(red.save(path(QStringLiteral("red.png"))));
    QTimer poll;
    QObject::connect(&poll, &QTimer::timeout, &poll, [&] {
        auto* files = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        if (!files) return;
        poll.stop();
        files->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(path(QStringLiteral("red.png")));
        press(files->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open));
    });
    poll.start(5);
    action("backdropPicture")->trigger();
    EXPECT_FALSE(action("backdropSky")->isChecked());
    const auto corner = [&] { return seenFrom(window.viewport().camera(), {200, 150}, 1).pixelColor(3, 3); };
    EXPECT_GT(corner().red(), 200);
    EXPECT_LT(corner().blue(), 60);
    action("backdropSky")->trigger();
    EXPECT_GT(corner().blue(), 100) << "the sky is back";
}

TEST_F(SlowSavePicture, HasTheWantedSizeAndBackdrop) {
    const QString file = path(QStringLiteral("tree.png"));
    save({.size = {320, 240}, .path = file});
    EXPECT_EQ(files(), QStringList{QStringLiteral("tree.png")});
    EXPECT_EQ(messages, QStringList());
    EXPECT_TRUE(notice().contains(file)) << notice().toStdString();
    const QImage image(file);
    ASSERT_EQ(image.size(), QSize(320, 240));
    EXPECT_EQ(image.convertToFormat(kPixels), seenFrom(window.viewport().camera(), image.size(), CRestPicture::kPasses));
    const QColor sky = image.pixelColor(4, 4), crown = image.pixelColor(160, 100);
    EXPECT_EQ(sky.alpha(), 255);
    EXPECT_GT(sky.blue(), sky.green());
    EXPECT_GT(crown.green(), crown.blue());

    const QString treeAlone = path(QStringLiteral("alone.png"));
    save({.size = {333, 222}, .transparent = true, .path = treeAlone});
    const QImage alone(treeAlone);
    ASSERT_EQ(alone.size(), QSize(333, 222));
    EXPECT_EQ(alone.pixelColor(4, 4).alpha(), 0);
    EXPECT_EQ(alone.pixelColor(4, 217).alpha(), 0) << "no ground";
    EXPECT_GT(alone.pixelColor(166, 93).alpha(), 128);
    EXPECT_EQ(window.viewport().look().backdrop, Backdrop::Sky) << "the window keeps its own";

    const CPictureDialog next({100, 100});
    EXPECT_EQ(next.options().size, QSize(333, 222)) << "remembered";
    EXPECT_TRUE(next.options().transparent);
    save({.size = {333, 222}, .path = path(QStringLiteral("again.png"))});
    EXPECT_FALSE(CPictureDialog({100, 100}).options().transparent);
}

TEST_F(SlowSavePicture, AsksBeforeItReplacesAnotherAndSaysWhatItCannotWrite) {
    const QString file = path(QStringLiteral("tree.png")), inside = path(QStringLiteral("tree.png/other.png"));
    save({.size = {64, 48}, .path = file});
    save({.size = {80, 60}, .path = file});
    ASSERT_EQ(messages.size(), 1);
    EXPECT_TRUE(messages[0].contains(QLatin1String("tree.png"))) << messages[0].toStdString();
    EXPECT_EQ(QImage(file).size(), QSize(80, 60));

    save({.size = {64, 48}, .path = inside});
    ASSERT_EQ(messages.size(), 1);
    EXPECT_TRUE(messages[0].contains(inside)) << messages[0].toStdString();
    EXPECT_FALSE(notice().contains(QLatin1String("other.png"))) << "nothing was saved";
    EXPECT_EQ(files(), QStringList{QStringLiteral("tree.png")});
    EXPECT_EQ(QImage(file).size(), QSize(80, 60));
}

TEST_F(SlowSavePicture, ATurntableGoesOnceAround) {
    save({.size = {160, 120}, .frames = 4, .path = path(QStringLiteral("turn.png"))});
    QStringList names;
    std::vector<QImage> frames;
    for (int i = 0; i < 4; ++i) {
        names << QStringLiteral("turn_000%1.png").arg(i);
        frames.emplace_back(path(names[i]));
        EXPECT_EQ(frames.back().size(), QSize(160, 120)) << i;
        for (int other = 0; other < i; ++other)
            EXPECT_NE(frames.back(), frames[std::size_t(other)]) << i << ' ' << other;
    }
    EXPECT_EQ(files(), names);
    EXPECT_TRUE(notice().contains(QLatin1String("4 frame"))) << notice().toStdString();
    CCamera camera = window.viewport().camera();
    for (const QImage& frame : frames) {
        EXPECT_EQ(frame.convertToFormat(kPixels), seenFrom(camera, frame.size(), CRestPicture::kFramePasses));
        camera.turn(90, 0);
    }
}

TEST_F(SlowSavePicture, ATurntableThatEndsEarlyKeepsWholeFrames) {
    const QString blocked = path(QStringLiteral("turn_0001.png"));
    ASSERT_TRUE(QDir().mkdir(blocked));
    save({.size = {64, 48}, .frames = 3, .path = path(QStringLiteral("turn.png"))});
    ASSERT_EQ(messages.size(), 1);
    EXPECT_TRUE(messages[0].contains(blocked)) << messages[0].toStdString();
    EXPECT_EQ(files(), (QStringList{QStringLiteral("turn_0000.png"), QStringLiteral("turn_0001.png")}));
    EXPECT_EQ(QImage(path(QStringLiteral("turn_0000.png"))).size(), QSize(64, 48));

    ASSERT_TRUE(QDir().rmdir(blocked));
    save({.size = {400, 300}, .frames = 1000, .path = path(QStringLiteral("turn.png"))});
    const QStringList written = files();
    ASSERT_GT(written.size(), 0);
    ASSERT_LT(written.size(), 1000) << "it was cancelled";
    for (int i = 0; i < written.size(); ++i) {
        EXPECT_EQ(written[i], QStringLiteral("turn_%1.png").arg(i, 4, 10, QLatin1Char('0')));
        EXPECT_EQ(QImage(path(written[i])).size(), QSize(400, 300)) << i;
    }
    EXPECT_TRUE(notice().contains(QStringLiteral("%1 frame").arg(written.size()))) << notice().toStdString();
}

TEST_F(SlowSavePicture, OnAFullDiskTheOldOneStays) {
    const QString file = path(QStringLiteral("tree.png"));
    save({.size = {64, 48}, .path = file});
    const std::string before = readFile(toPath(file));
    rlimit usual{};
    ::getrlimit(RLIMIT_FSIZE, &usual);
    const rlimit full{4096, usual.rlim_max};
    const auto handler = ::signal(SIGXFSZ, SIG_IGN);
    ::setrlimit(RLIMIT_FSIZE, &full);
    save({.size = {640, 480}, .path = file});
    ::setrlimit(RLIMIT_FSIZE, &usual);
    ::signal(SIGXFSZ, handler);
    ASSERT_EQ(messages.size(), 2) << "whether to replace it, then why not";
    EXPECT_TRUE(messages[1].contains(file)) << messages[1].toStdString();
    EXPECT_EQ(files(), QStringList{QStringLiteral("tree.png")});
    EXPECT_TRUE(readFile(toPath(file)) == before);
}

TEST_F(SlowSavePicture, EveryFormatOfferedCanBeWritten) {
    save({.size = {64, 48}, .path = path(QStringLiteral("first.png"))});
    QStringList endings;
    for (auto found = QRegularExpression(QStringLiteral("\\*\\.(\\w+)")).globalMatch(offered); found.hasNext();)
        endings << found.next().captured(1);
    ASSERT_TRUE(endings.contains(QStringLiteral("png"))) << offered.toStdString();
    for (const QString& ending : endings) {
        const QString file = path(QStringLiteral("tree.") + ending);
        save({.size = {64, 48}, .transparent = true, .path = file});
        EXPECT_EQ(messages.join(QLatin1Char(' ')).toStdString(), "");
        const QImage image(file);
        ASSERT_EQ(image.size(), QSize(64, 48)) << ending.toStdString();
        const QColor corner = image.pixelColor(2, 2);
        EXPECT_TRUE(corner.alpha() == 0 || corner.lightness() > 40) << ending.toStdString() << ": a black backdrop";
    }
}

} // namespace
} // namespace stromar
