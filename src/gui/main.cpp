#include "document/FileController.h"
#include "work/GrowthController.h"
#include "window/Commands.h"
#include "window/Display.h"
#include "params/HelpPictures.h"
#include "params/ParamPanel.h"
#include "window/QtText.h"
#include "window/Settings.h"
#include "window/Theme.h"
#include "window/WindowKeeper.h"
#include <QAction>
#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QFileInfo>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <cstring>

namespace {
using namespace stromar;

/// What the command line asks for.
struct Options {
    QString file, screenshot, helpPictures;
    QStringList commands;
    std::string shown; ///< a key
    QSize size;
    Model model = Model::Full;
    bool wireframe = false;
    SizeLimits limits;
};

int wrongUsage(const QString& why) {
    std::fprintf(stderr, "stromar: %s\n", qPrintable(why));
    return 2;
}

/// Fills `options`; the text is what is wrong with the command line.
QString read(const QApplication& app, Options& options) {
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Shows and edits trees."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("FILE.tree"), QStringLiteral("The tree to open."),
                                 QStringLiteral("[FILE.tree]"));
    const QCommandLineOption screenshot(QStringLiteral("screenshot"),
                                        QStringLiteral("Saves a picture of the window and leaves."),
                                        QStringLiteral("OUT.png"));
    const QCommandLineOption size(QStringLiteral("size"), QStringLiteral("Size of the window."), QStringLiteral("WxH"));
    const QCommandLineOption model(QStringLiteral("model"), QStringLiteral("The model of the picture: full or simple."),
                                   QStringLiteral("NAME"), QStringLiteral("full"));
    const QCommandLineOption maxVertices(QStringLiteral("max-vertices"), QStringLiteral("Refuses trees that may be larger."),
                                  QStringLiteral("N"));
    const QCommandLineOption wireframe(QStringLiteral("wireframe"), QStringLiteral("Shows the wireframe."));
    const QCommandLineOption pictures(
        QStringLiteral("help-pictures"),
        QStringLiteral("Writes the pictures of the parameters for the manual and leaves."), QStringLiteral("FOLDER"));
    const QCommandLineOption commands(QStringLiteral("do"),
                                      QStringLiteral("Runs commands of the menus at the start, by their names."),
                                      QStringLiteral("NAME,…"));
    const QCommandLineOption shown(QStringLiteral("show"), QStringLiteral("Goes to a parameter."),
                                   QStringLiteral("KEY"));
    parser.addOptions({screenshot, size, model, wireframe, maxVertices, pictures, commands, shown});
    parser.process(app);
    const QStringList files = parser.positionalArguments();
    if (files.size() > 1) return QStringLiteral("only one file can be opened");
    options.file = files.value(0);
    options.screenshot = parser.value(screenshot);
    options.wireframe = parser.isSet(wireframe);
    options.helpPictures = parser.value(pictures);
    options.commands = parser.value(commands).split(QLatin1Char(','), Qt::SkipEmptyParts);
    for (const QString& name : std::as_const(options.commands))
        if (std::ranges::none_of(commandTable(), [&](const Command& c) { return name == QLatin1String(c.name); }))
            return QStringLiteral("--do: there is no command %1").arg(name);
    if (parser.isSet(shown)) {
        options.shown = parser.value(shown).toStdString();
        if (std::ranges::none_of(paramBlocks(), [&](const ParamBlock* block) { return findParam(options.shown, *block).has_value(); }))
            return QStringLiteral("--show: there is no parameter %1").arg(parser.value(shown));
    }
    if (parser.isSet(size)) {
        const QStringList sides = parser.value(size).split(QLatin1Char('x'));
        options.size = QSize(sides.value(0).toInt(), sides.value(1).toInt());
        if (sides.size() != 2 || options.size.width() < 100 || options.size.height() < 100 ||
            options.size.width() > 16384 || options.size.height() > 16384)
            return QStringLiteral("--size wants WxH, at least 100x100");
    }
    if (parser.value(model) != QLatin1String("full") && parser.value(model) != QLatin1String("simple"))
        return QStringLiteral("--model is full or simple");
    if (parser.value(model) == QLatin1String("simple")) options.model = Model::Simple;
    if (parser.isSet(maxVertices)) {
        options.limits.vertices = parser.value(maxVertices).toDouble();
        if (!(options.limits.vertices > 0)) return QStringLiteral("--max-vertices wants a number");
    }
    return {};
}

/// Waits until the wanted model is drawn and nothing is left to do, saves the window's picture and leaves.
void takeScreenshot(CMainWindow& window, const Options& options) {
    auto* poll = new QTimer(&window);
    QObject::connect(poll, &QTimer::timeout, &window, [&window, options] {
        const ViewModel* shown = window.shown();
        if (window.busy() || window.viewport().refining() || !shown || shown->model->detail->model != options.model ||
            shown->model->params != window.document().params())
            return;
        const bool done = window.grab().save(options.screenshot);
        if (!done) std::fprintf(stderr, "stromar: cannot write %s\n", qPrintable(options.screenshot));
        QApplication::exit(done ? 0 : 1);
    });
    poll->start(100);
}

/// One PNG for each parameter that changes a shape, by its key; level 1 stands for all levels.
bool writeHelpPictures(const QString& folder) {
    applyTheme(QStringLiteral("light"));
    bool fine = QDir().mkpath(folder);
    for (const ParamBlock* block : paramBlocks())
        for (const ParamRef& ref : allParams(*block)) {
            if (ref.level != (ref.info->perLevel() ? 1 : 0)) continue;
            const QImage image = helpPicture(ref, QApplication::palette(), 1);
            if (image.isNull()) continue;
            fine = fine && image.save(QDir(folder).filePath(toQString(ref.key()) + QStringLiteral(".png")));
        }
    if (!fine) std::fprintf(stderr, "stromar: cannot write into %s\n", qPrintable(folder));
    return fine;
}
} // namespace

int main(int argc, char** argv) {
    for (const char* answer : {"-h", "--help", "-v", "--version"}) // which needs no display
        if (std::any_of(argv + 1, argv + argc, [&](const char* word) { return std::strcmp(word, answer) == 0; }))
            qputenv("QT_QPA_PLATFORM", "offscreen");
    QCoreApplication::setOrganizationName(QStringLiteral("Stromar"));
    QCoreApplication::setApplicationName(QStringLiteral("Stromar"));
    QCoreApplication::setApplicationVersion(QStringLiteral(STROMAR_VERSION));
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QGuiApplication::setDesktopFileName(QStringLiteral("org.stromar.Stromar"));
    QSurfaceFormat::setDefaultFormat(display::surfaceFormat(0));
    QApplication app(argc, argv);
    Options options;
    if (const QString why = read(app, options); !why.isEmpty()) return wrongUsage(why);
    try {
        if (!options.helpPictures.isEmpty()) return writeHelpPictures(options.helpPictures) ? 0 : 1;
        applyTheme(CSettings::instance().text("theme"));
        CWindowKeeper keeper(options.limits);
        CMainWindow& window = keeper.window();
        if (options.size.isValid()) window.resize(options.size);
        if (!options.screenshot.isEmpty() && !options.file.isEmpty() && !QFileInfo::exists(options.file)) {
            std::fprintf(stderr, "stromar: cannot read %s\n", qPrintable(options.file));
            return 1;
        }
        window.show();
        if (options.file.isEmpty()) window.showStart();
        if (!options.screenshot.isEmpty()) window.growth().showOnly(options.model);
        if (!options.file.isEmpty() && !window.files().open(options.file) && !options.screenshot.isEmpty()) return 1;
        for (const QString& name : std::as_const(options.commands)) window.findChild<QAction*>(name)->trigger();
        if (const auto ref = findParam(options.shown, window.document().params().block())) window.panel().showParam(*ref);
        if (options.wireframe) window.findChild<QAction*>(QStringLiteral("wireframe"))->trigger();
        if (options.screenshot.isEmpty())
            QTimer::singleShot(0, &window.files(), &CFileController::offerRestore);
        else
            takeScreenshot(window, options);
        return QApplication::exec();
    } catch (const std::exception& e) {
        std::fprintf(stderr, "stromar: %s\n", e.what());
        return 1;
    }
}
