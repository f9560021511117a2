#include "Checkout.h"
#include "window/Commands.h"
#include "work/ExportDialog.h"
#include "window/MainWindow.h"
#include "window/MessageBar.h"
#include "window/Mnemonics.h"
#include "params/ParamEditor.h"
#include "params/ParamPanel.h"
#include "window/QtText.h"
#include "window/Theme.h"
#include "Support.h"
#include "view/Viewport.h"
#include "WindowFixture.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/app/Formats.h"
#include "stromar/app/Prediction.h"
#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPainter>
#include <QProcess>
#include <QPushButton>
#include <QScreen>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QStyleOptionButton>
#include <QTemporaryDir>
#include <QTextBrowser>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <gtest/gtest.h>

namespace stromar {
namespace {

class WindowTest : public WindowFixture {};
class SlowWindowTest : public WindowTest {};

TEST(Start, NothingIsSeenOfTheTreeBeforeTheOneThatIsOpened) {
    CMainWindow window;
    std::vector<bool> own;
    QObject::connect(&window, &CMainWindow::modelShown, &window,
                     [&] { own.push_back(window.shown()->model->params == window.document().params()); });
    window.show();
    ASSERT_TRUE(window.files().open(presetPath("quaking_aspen")));
    ASSERT_TRUE(waitFor([&] { return own.size() > 1; }));
    for (const bool one : own) EXPECT_TRUE(one);
}

TEST_F(WindowTest, ADragShowsTheSimpleModelThenTheFullOneAndIsOneStep) {
    window.panel().tabs().setCurrentIndex(2);
    QSlider* down = slider("1DownAngle");
    QTest::qWait(50);
    std::vector<Model> models;
    QObject::connect(&window, &CMainWindow::modelShown, &window,
                     [&] { models.push_back(window.shown()->model->detail->model); });
    const double before = value("1DownAngle");
    const int y = down->height() / 2;
    const int start = down->width() / 2; // not on the handle: it comes to the mouse
    QTest::mousePress(down, Qt::LeftButton, {}, {start, y});
    ASSERT_TRUE(down->isSliderDown());
    for (int i = 1; i <= 10; ++i) {
        QTest::mouseMove(down, {start + 5 * i, y});
        QTest::qWait(20);
    }
    QTest::qWait(600); // longer than the pause: the hand holds the slider, so the full model waits
    EXPECT_EQ(std::ranges::count(models, Model::Full), 0);
    EXPECT_GT(std::ranges::count(models, Model::Simple), 2);
    QTest::mouseRelease(down, Qt::LeftButton, {}, {start + 50, y});
    EXPECT_TRUE(showsNow(Model::Full));
    EXPECT_GT(value("1DownAngle"), before + 5);
    EXPECT_EQ(window.document().history().count(), 1);
    EXPECT_TRUE(window.isWindowModified());
    action("undo")->trigger();
    EXPECT_EQ(value("1DownAngle"), before);
    EXPECT_FALSE(window.isWindowModified());
    EXPECT_TRUE(showsNow(Model::Full));
    action("redo")->trigger();
    EXPECT_GT(value("1DownAngle"), before + 5);
}

TEST_F(WindowTest, TheMouseTurnsZoomsPansAndSpaceRecentres) {
    CViewport& view = window.viewport();
    QTest::qWait(50);
    view.recentre();
    const osg::Vec3d home = view.camera().eye();
    const double distance = view.camera().distance();
    const QPoint middle = view.rect().center();
    const auto drag = [&](Qt::MouseButton button, QPoint by) {
        QTest::mousePress(&view, button, {}, middle);
        for (int i = 1; i <= 4; ++i) {
            QMouseEvent move(QEvent::MouseMove, QPointF(middle + by * i / 4),
                             view.mapToGlobal(QPointF(middle + by * i / 4)), Qt::NoButton, button, {});
            QCoreApplication::sendEvent(&view, &move);
            QTest::qWait(10);
        }
        QTest::mouseRelease(&view, button, {}, middle + by);
        QTest::qWait(30);
    };
    const QImage before = picture();
    drag(Qt::LeftButton, {120, 0});
    EXPECT_GT((view.camera().eye() - home).length(), 1) << "left drag turns";
    EXPECT_NEAR(view.camera().distance(), distance, 1e-6);
    EXPECT_NE(picture(), before);
    drag(Qt::RightButton, {0, 60});
    EXPECT_GT(std::abs(view.camera().distance() - distance), 0.1) << "right drag zooms";
    QTest::keyClick(&view, Qt::Key_Space);
    QTest::qWait(50);
    EXPECT_LT((view.camera().eye() - home).length(), 1e-6) << "space recentres";
    drag(Qt::MiddleButton, {80, 0});
    EXPECT_GT((view.camera().eye() - home).length(), 0.1) << "middle drag pans";
    EXPECT_NEAR(view.camera().distance(), distance, 1e-6);
    view.recentre();
    QTest::qWait(30);
    QWheelEvent wheel(middle, view.mapToGlobal(QPointF(middle)), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view, &wheel);
    QTest::qWait(50);
    EXPECT_LT(view.camera().distance(), distance) << "wheel forward comes nearer";
    window.panel().setFocus();
    QTest::keyClick(&window, Qt::Key_Space);
    QTest::qWait(50);
    EXPECT_LT((view.camera().eye() - home).length(), 1e-6);
}

TEST_F(WindowTest, DrawsOnlyWhenSomethingChanges) {
    QTest::qWait(200);
    const int frames = window.viewport().framesDrawn();
    QTest::qWait(700);
    EXPECT_LE(window.viewport().framesDrawn(), frames + 1);
    action("wireframe")->trigger();
    QTest::qWait(100);
    EXPECT_GT(window.viewport().framesDrawn(), frames);
}

TEST_F(WindowTest, WiredChangesThePicture) {
    const QImage filled = picture();
    action("wireframe")->trigger();
    QTest::qWait(100);
    const QImage wired = picture();
    EXPECT_NE(filled, wired);
    action("wireframe")->trigger();
    QTest::qWait(100);
    EXPECT_EQ(filled, picture());
}

TEST_F(WindowTest, ThePictureShowsATree) {
    const QImage image = picture();
    int green = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QColor c = image.pixelColor(x, y);
            green += c.green() > c.red() + 15 && c.green() > c.blue() + 40;
        }
    EXPECT_GT(green, image.width() * image.height() / 50);
}

TEST_F(WindowTest, GenerateAndDice) {
    const auto before = window.shown()->model;
    action("generate")->trigger();
    ASSERT_TRUE(waitFor([&] { return window.shown()->model != before; }));
    EXPECT_EQ(window.shown()->model->vertexCount(), before->vertexCount());
    const double seed = value("Seed");
    QTest::mouseClick(window.panel().editor(paramRef("Seed"))->findChild<QWidget*>(QStringLiteral("dice")),
                      Qt::LeftButton);
    action("randomSeed")->trigger();
    EXPECT_NE(value("Seed"), seed);
    action("undo")->trigger();
    action("undo")->trigger();
    EXPECT_EQ(value("Seed"), seed);
}

TEST_F(WindowTest, SavesReopensAndRemembers) {
    QTemporaryDir folder;
    window.document().setValue(paramRef("Scale"), 17, 0);
    EXPECT_TRUE(window.isWindowModified());
    const QString path = folder.filePath(QStringLiteral("mine.tree"));
    ASSERT_TRUE(window.files().save(path));
    EXPECT_FALSE(window.isWindowModified());
    EXPECT_TRUE(window.windowTitle().startsWith(QLatin1String("mine.tree[*]")));
    ASSERT_TRUE(window.files().open(presetPath("black_tupelo")));
    EXPECT_EQ(value("Scale"), 23);
    ASSERT_TRUE(window.files().open(path));
    EXPECT_EQ(value("Scale"), 17);
    bool listed = false;
    for (QMenu* menu : window.findChildren<QMenu*>())
        for (QAction* entry : menu->actions()) listed |= entry->statusTip() == path;
    EXPECT_TRUE(listed);
}

TEST_F(WindowTest, AsksBeforeChangesAreLost) {
    window.document().setValue(paramRef("Scale"), 17, 0);
    answerNext(QMessageBox::Cancel);
    EXPECT_FALSE(window.close());
    EXPECT_TRUE(asked);
    EXPECT_TRUE(question.contains(QLatin1String("quaking_aspen.tree")));
    EXPECT_EQ(value("Scale"), 17);
    answerNext(QMessageBox::Discard);
    EXPECT_TRUE(window.close());
    EXPECT_TRUE(asked);
}

TEST_F(WindowTest, ABadFileIsShownAndTheTreeStays) {
    QTemporaryDir folder;
    const QString bad = folder.filePath(QStringLiteral("bad.tree"));
    QFile file(bad);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("Format = 1\nScal = 3\nLevels = 3.5\n");
    file.close();
    answerNext(QMessageBox::Ok);
    EXPECT_FALSE(window.files().open(bad));
    EXPECT_TRUE(asked);
    EXPECT_TRUE(question.contains(QLatin1String("bad.tree:3:10"))) << question.toStdString();
    EXPECT_EQ(window.document().path(), presetPath("quaking_aspen"));
}

TEST_F(WindowTest, WarningsStayReadable) {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("w.tree"));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("Format = 1\nScal = 3\nLevels = 99\n");
    file.close();
    ASSERT_TRUE(window.files().open(path));
    const auto* list = window.findChild<QListWidget*>(QStringLiteral("messageList"));
    ASSERT_EQ(list->count(), 2);
    EXPECT_TRUE(list->isVisible());
    EXPECT_TRUE(list->item(0)->text().contains(QLatin1String("did you mean 'Scale'")));
    EXPECT_TRUE(list->item(1)->text().contains(QLatin1String("w.tree:3:10")));
}

TEST_F(SlowWindowTest, ExportsEveryFormat) {
    QTemporaryDir folder;
    for (const Format& format : formatTable()) {
        const QString path = folder.filePath(QStringLiteral("tree") + toQString(format.ending));
        QSignalSpy ended(&window.exporter(), &CExportController::ended);
        window.exporter().exportTo(path);
        ASSERT_TRUE(waitFor([&] { return ended.count() == 1; }, 120000)) << format.ending;
        EXPECT_TRUE(ended[0][0].toString().isEmpty()) << ended[0][0].toString().toStdString();
        EXPECT_GT(QFileInfo(path).size(), 5000) << format.ending;
        EXPECT_TRUE(notice().contains(path));
    }
}

TEST_F(WindowTest, AFailedExportIsShown) {
    QTemporaryDir folder;
    QSignalSpy ended(&window.exporter(), &CExportController::ended);
    answerNext(QMessageBox::Ok);
    window.exporter().exportTo(folder.filePath(QStringLiteral("no/such/folder/a.obj")));
    ASSERT_TRUE(waitFor([&] { return ended.count() == 1; }));
    EXPECT_TRUE(asked);
    EXPECT_TRUE(question.contains(QLatin1String("there is no folder"))) << question.toStdString();
    EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

TEST_F(WindowTest, TheExportDialogComesBackAfterAnError) {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("no/such/folder/mine.obj"));
    QStringList seen;
    auto* answer = new QTimer(&window);
    QObject::connect(answer, &QTimer::timeout, &window, [&, path] {
        QWidget* dialog = QApplication::activeModalWidget();
        if (auto* error = qobject_cast<QMessageBox*>(dialog)) return error->accept();
        auto* choices = qobject_cast<CExportDialog*>(dialog);
        if (!choices) return;
        auto* file = choices->findChild<QLineEdit*>(QStringLiteral("path"));
        seen << file->text();
        if (seen.size() > 1) return choices->reject();
        file->setText(path);
        choices->accept();
    });
    answer->start(50);
    window.exporter().chooseAndExport();
    ASSERT_TRUE(waitFor([&] { return seen.size() > 1; }));
    EXPECT_EQ(seen[1], path) << "as it was chosen";
    ASSERT_TRUE(waitFor([&] { return !QApplication::activeModalWidget(); }));
    QTest::qWait(200);
    EXPECT_EQ(seen.size(), 2) << "cancelled";
}

TEST_F(WindowTest, CommandsHaveTextsIconsAndShortcutsOfTheirOwn) {
    QStringList shortcuts;
    for (const Command& command : commandTable()) {
        QAction* made = action(command.name);
        ASSERT_TRUE(made) << command.name;
        EXPECT_FALSE(made->statusTip().isEmpty()) << command.name;
        EXPECT_EQ(made->icon().pixmap(24).isNull(), !*command.icon) << command.name;
        EXPECT_FALSE(made->shortcut().isEmpty()) << command.name;
        EXPECT_FALSE(shortcuts.contains(made->shortcut().toString())) << command.name;
        shortcuts << made->shortcut().toString();
    }
}

TEST_F(WindowTest, EntriesOfAMenuHaveLettersOfTheirOwn) {
    const auto expectOwn = [](const QList<QAction*>& actions) {
        QString letters;
        for (const QAction* action : actions) {
            const qsizetype at = action->text().indexOf(QLatin1Char('&'));
            if (at < 0) continue;
            EXPECT_FALSE(letters.contains(action->text()[at + 1].toUpper())) << action->text().toStdString();
            letters += action->text()[at + 1].toUpper();
        }
        return letters.size();
    };
    const auto titles = window.menuBar()->actions();
    EXPECT_EQ(expectOwn(titles), titles.size());
    for (const QAction* title : titles) EXPECT_GT(expectOwn(title->menu()->actions()), 2) << title->text().toStdString();
}

TEST(Mnemonics, KeepWhatIsMarkedAndTakeFreeLetters) {
    QObject owner;
    const auto assigned = [&](const QStringList& texts) {
        QList<QAction*> actions;
        for (const QString& text : texts) actions << new QAction(text, &owner);
        assignMnemonics(actions);
        QStringList result;
        for (const QAction* action : actions) result << action->text();
        return result;
    };
    const auto words = [](std::initializer_list<const char*> all) {
        QStringList list;
        for (const char* one : all) list << QString::fromUtf8(one);
        return list;
    };
    EXPECT_EQ(assigned(words({"&Lit", "Before &Light Grey", "Presets", "&P", "lp"})), words({"&Lit", "&Before Light Grey", "P&resets", "&P", "lp"}));
    EXPECT_EQ(assigned(words({"", "&Вид", "&Ветер", "Save"})), words({"", "&Вид", "В&етер", "&Save"}));
}

TEST_F(WindowTest, TheListOfKeysFitsOnALowScreen) {
    QTimer::singleShot(0, &window, [&] {
        QWidget* dialog = QApplication::activeModalWidget();
        ASSERT_TRUE(dialog);
        EXPECT_LE(dialog->height(), 0.8 * dialog->screen()->availableSize().height());
        EXPECT_LE(dialog->minimumSizeHint().height(), 400);
        const QString text = dialog->findChild<QTextBrowser*>()->toPlainText();
        for (const Command& command : commandTable())
            EXPECT_TRUE(text.contains(QKeySequence(QLatin1String(command.shortcut)).toString(QKeySequence::NativeText))) << command.name;
        dialog->close();
    });
    action("shortcuts")->trigger();
}

TEST_F(WindowTest, InTheDarkThemeTheRestOfTheToolBarIsFound) {
    auto* bar = window.findChild<QToolBar*>(QStringLiteral("tools"));
    auto* more = bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"));
    ASSERT_TRUE(more);
    applyTheme(QStringLiteral("dark"));
    bar->setMaximumWidth(200);
    ASSERT_TRUE(waitFor([&] { return more->isVisible(); }));
    const QImage shown = more->grab().toImage();
    int light = 0;
    for (int y = 0; y < shown.height(); ++y)
        for (int x = 0; x < shown.width(); ++x) light += shown.pixelColor(x, y).lightness() > 160;
    EXPECT_GT(light, 4);
    bar->setMaximumWidth(QWIDGETSIZE_MAX);
    applyTheme(QStringLiteral("light"));
}

TEST_F(WindowTest, InTheDarkThemeBoxesToCheckHaveAnOutline) {
    applyTheme(QStringLiteral("dark"));
    QCheckBox box;
    box.setEnabled(true);
    box.resize(box.sizeHint());
    QStyleOptionButton option;
    option.initFrom(&box);
    option.rect = QRect(0, 0, 14, 14);
    option.state |= QStyle::State_Off;
    QImage shown(14, 14, QImage::Format_RGB32);
    shown.fill(option.palette.color(QPalette::Base));
    QPainter painter(&shown);
    QApplication::style()->drawPrimitive(QStyle::PE_IndicatorCheckBox, &option, &painter);
    painter.end();
    EXPECT_GT(shown.pixelColor(7, 0).lightness(), shown.pixelColor(7, 7).lightness() + 60);
    applyTheme(QStringLiteral("light"));
}

TEST_F(WindowTest, ATreeThatWouldBeTooLargeAsksFirstAndOffersWhatFits) {
    window.document().setValue(paramRef("2Branches"), 5000, 0);
    CMessageBar& bar = window.bar();
    ASSERT_TRUE(waitFor([&] { return bar.isVisible(); }));
    EXPECT_TRUE(bar.text().contains(QLatin1String("limit is 20 million"))) << bar.text().toStdString();
    const auto buttons = bar.findChildren<QPushButton*>();
    ASSERT_GE(buttons.size(), 2);
    EXPECT_TRUE(buttons.front()->text().startsWith(QStringLiteral("Branches 2 ▸ Number = ")));
    buttons.front()->click();
    ASSERT_TRUE(waitFor([&] { return !bar.isVisible(); }));
    const double fits = value("2Branches");
    EXPECT_GT(fits, 100);
    EXPECT_LE(predictSize(window.document().params(), detailOf(Model::Full)).vertices, 20e6);
    CParams more = window.document().params();
    ++weberPenn(more).level[2].branches;
    EXPECT_GT(predictSize(more, detailOf(Model::Full)).vertices, 20e6) << "the nearest that fits";
    action("undo")->trigger();
    ASSERT_TRUE(waitFor([&] { return bar.isVisible(); })) << "back at the large one";
    action("undo")->trigger();
    ASSERT_TRUE(waitFor([&] { return !bar.isVisible(); }));
    EXPECT_TRUE(showsNow(Model::Full));
}

TEST_F(WindowTest, AQuestionTakesThePlaceOfTheOneBefore) {
    CMessageBar& bar = window.bar();
    for (const char* text : {"one", "two"}) bar.ask(QStringLiteral("test"), QLatin1String(text), {{QLatin1String(text), [] {}}});
    QCoreApplication::processEvents(); // shows what is new
    QStringList seen;
    for (const auto* button : bar.findChildren<QPushButton*>())
        if (button->isVisible()) seen << button->text();
    EXPECT_EQ(seen, QStringList{QStringLiteral("two")});
}

TEST(Program, TakesAScreenshotOfTheWholeWindow) {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("shot.png"));
    QProcess program;
    program.start(QString::fromStdString(test::inBin("stromar")),
                  {presetPath("quaking_aspen"), QStringLiteral("--screenshot"), path, QStringLiteral("--size"),
                   QStringLiteral("900x700"), QStringLiteral("--model"), QStringLiteral("simple")});
    ASSERT_TRUE(program.waitForFinished(60000));
    EXPECT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
    EXPECT_EQ(QImage(path).size(), QSize(900, 700));
}

TEST(Program, WorksWithoutOpenGl) {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("shot.png"));
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("QT_XCB_GL_INTEGRATION"), QStringLiteral("none"));
    program.setProcessEnvironment(environment);
    program.start(QString::fromStdString(test::inBin("stromar")),
                  {presetPath("quaking_aspen"), QStringLiteral("--screenshot"), path});
    ASSERT_TRUE(program.waitForFinished(60000));
    EXPECT_EQ(program.exitStatus(), QProcess::NormalExit);
    EXPECT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
    EXPECT_TRUE(QFileInfo::exists(path));
}

TEST(Program, SaysWhatIsWrongWithItsCommandLine) {
    const QString missing = QStringLiteral("/no/such.tree"), picture = QStringLiteral("/tmp/never.png");
    for (const auto& [arguments, status] :
         {std::pair{QStringList{QStringLiteral("a.tree"), QStringLiteral("b.tree")}, 2},
          {QStringList{QStringLiteral("--size"), QStringLiteral("12")}, 2},
          {QStringList{QStringLiteral("--model"), QStringLiteral("best")}, 2},
          {QStringList{missing, QStringLiteral("--screenshot"), picture}, 1}}) {
        QProcess program;
        program.start(QString::fromStdString(test::inBin("stromar")), arguments);
        ASSERT_TRUE(program.waitForFinished(60000));
        EXPECT_EQ(program.exitCode(), status);
        EXPECT_FALSE(program.readAllStandardError().isEmpty());
    }
}

} // namespace
} // namespace stromar
