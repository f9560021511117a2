#include "Commands.h"
#include "MainWindow.h"

namespace stromar {

namespace {
using W = CMainWindow;

// clang-format off
constexpr Command kCommands[] = {
    {"new", Menu::File, QT_TRANSLATE_NOOP("Commands", "&New"), "Ctrl+N", "new",
     QT_TRANSLATE_NOOP("Commands", "Start with a plain tree"), &W::startNew, true},
    {"open", Menu::File, QT_TRANSLATE_NOOP("Commands", "&Open…"), "Ctrl+O", "open",
     QT_TRANSLATE_NOOP("Commands", "Open a .tree file"), &W::chooseAndOpen, true},
    {"save", Menu::File, QT_TRANSLATE_NOOP("Commands", "&Save"), "Ctrl+S", "save",
     QT_TRANSLATE_NOOP("Commands", "Save the tree"), &W::saveAgain, true},
    {"saveAs", Menu::File, QT_TRANSLATE_NOOP("Commands", "Save &As…"), "Ctrl+Shift+S", "",
     QT_TRANSLATE_NOOP("Commands", "Save the tree in another file"), &W::chooseAndSave},
    {"export", Menu::File, QT_TRANSLATE_NOOP("Commands", "&Export…"), "Ctrl+E", "export",
     QT_TRANSLATE_NOOP("Commands", "Write the full model for another program"), &W::chooseAndExport, true, false, true},
    {"loadBark", Menu::File, QT_TRANSLATE_NOOP("Commands", "Load &Bark Texture…"), "", "",
     QT_TRANSLATE_NOOP("Commands", "Choose the picture on the stems"), &W::chooseBark, false, false, true},
    {"loadLeaf", Menu::File, QT_TRANSLATE_NOOP("Commands", "Load &Leaf Texture…"), "", "",
     QT_TRANSLATE_NOOP("Commands", "Choose the picture on the leaves"), &W::chooseLeaf},
    {"quit", Menu::File, QT_TRANSLATE_NOOP("Commands", "&Quit"), "Ctrl+Q", "",
     QT_TRANSLATE_NOOP("Commands", "Leave Stromar"), &W::closeWindow, false, false, true},
    {"undo", Menu::Edit, QT_TRANSLATE_NOOP("Commands", "&Undo"), "Ctrl+Z", "undo",
     QT_TRANSLATE_NOOP("Commands", "Take the last change back"), &W::undo, true},
    {"redo", Menu::Edit, QT_TRANSLATE_NOOP("Commands", "&Redo"), "Ctrl+Shift+Z", "redo",
     QT_TRANSLATE_NOOP("Commands", "Make the change again"), &W::redo, true},
    {"randomSeed", Menu::Tree, QT_TRANSLATE_NOOP("Commands", "&Another Seed"), "Ctrl+R", "dice",
     QT_TRANSLATE_NOOP("Commands", "Another tree of the same kind"), &W::throwDice, true},
    {"generate", Menu::Tree, QT_TRANSLATE_NOOP("Commands", "&Generate"), "F5", "generate",
     QT_TRANSLATE_NOOP("Commands", "Build the tree again from scratch"), &W::generate, true},
    {"fullModel", Menu::Tree, QT_TRANSLATE_NOOP("Commands", "&Full Model"), "F6", "full",
     QT_TRANSLATE_NOOP("Commands", "Show the full model now"), &W::showFullModel, true},
    {"wired", Menu::View, QT_TRANSLATE_NOOP("Commands", "&Wired"), "W", "wired",
     QT_TRANSLATE_NOOP("Commands", "Show the wire frame"), &W::toggleWired, true, true},
    {"recentre", Menu::View, QT_TRANSLATE_NOOP("Commands", "&Recentre"), "Space", "recentre",
     QT_TRANSLATE_NOOP("Commands", "See the whole tree from the front"), &W::recentre, true},
    {"shortcuts", Menu::Help, QT_TRANSLATE_NOOP("Commands", "&Mouse and Keys"), "F1", "",
     QT_TRANSLATE_NOOP("Commands", "How to move about, and all shortcuts"), &W::showShortcuts},
    {"about", Menu::Help, QT_TRANSLATE_NOOP("Commands", "&About Stromar"), "", "",
     QT_TRANSLATE_NOOP("Commands", "Version and origin"), &W::showAbout},
};
// clang-format on
} // namespace

std::span<const Command> commandTable() { return kCommands; }

const char* menuTitle(Menu menu) {
    constexpr const char* kTitles[] = {QT_TRANSLATE_NOOP("Commands", "&File"), QT_TRANSLATE_NOOP("Commands", "&Edit"),
                                       QT_TRANSLATE_NOOP("Commands", "&Tree"), QT_TRANSLATE_NOOP("Commands", "&View"),
                                       QT_TRANSLATE_NOOP("Commands", "&Help")};
    return kTitles[static_cast<std::size_t>(menu)];
}

} // namespace stromar
