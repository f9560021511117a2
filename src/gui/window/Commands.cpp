#include "window/Commands.h"
#include "window/MainWindow.h"
#include "document/FileController.h"
#include "motion/Timeline.h"
#include "view/Comparison.h"
#include "view/SideBySide.h"
#include "motion/WindPanel.h"
#include "work/ExportController.h"
#include "work/GrowthController.h"

namespace stromar {

namespace {
using W = CMainWindow;

// clang-format off
constexpr const char *kFrom = QT_TRANSLATE_NOOP("Commands", "Look From"), *kBackdrop = QT_TRANSLATE_NOOP("Commands", "Backdrop"),
                     *kShading = QT_TRANSLATE_NOOP("Commands", "Shading"), *kLod = QT_TRANSLATE_NOOP("Commands", "Level of Detail"),
                     *kCompare = QT_TRANSLATE_NOOP("Commands", "Compare"), *kRow = QT_TRANSLATE_NOOP("Commands", "Side by Side");
constexpr Command kCommands[] = {
    {"new", Menu::File, QT_TRANSLATE_NOOP("Commands", "&New"), "Ctrl+N", "new",
     QT_TRANSLATE_NOOP("Commands", "Start with a plain tree"), [](W& w, bool) { w.files().startNew(weberPennBlock()); }, true},
    {"open", Menu::File, QT_TRANSLATE_NOOP("Commands", "&Open…"), "Ctrl+O", "open",
     QT_TRANSLATE_NOOP("Commands", "Open a .tree file"), [](W& w, bool) { w.files().chooseAndOpen(); }, true},
    {"import", Menu::File, QT_TRANSLATE_NOOP("Commands", "I&mport…"), "Ctrl+I", "",
     QT_TRANSLATE_NOOP("Commands", "Read a tree of Arbaro, Sapling or tree-gen"), [](W& w, bool) { w.files().chooseAndImport(); }},
    {"save", Menu::File, QT_TRANSLATE_NOOP("Commands", "&Save"), "Ctrl+S", "save",
     QT_TRANSLATE_NOOP("Commands", "Save the tree"), [](W& w, bool) { w.files().saveOrChoose(); }, true},
    {"saveAs", Menu::File, QT_TRANSLATE_NOOP("Commands", "Save &As…"), "Ctrl+Shift+S", "",
     QT_TRANSLATE_NOOP("Commands", "Save the tree in another file"), [](W& w, bool) { w.files().chooseAndSave(); }},
    {"savePreset", Menu::File, QT_TRANSLATE_NOOP("Commands", "Save as &Preset…"), "Ctrl+Shift+P", "",
     QT_TRANSLATE_NOOP("Commands", "Keep the tree among your own presets"), [](W& w, bool) { w.files().savePreset(); }},
    {"export", Menu::File, QT_TRANSLATE_NOOP("Commands", "&Export…"), "Ctrl+E", "export",
     QT_TRANSLATE_NOOP("Commands", "Write the tree for another program"), [](W& w, bool) { w.exporter().chooseAndExport(); }, true, true},
    {"picture", Menu::File, QT_TRANSLATE_NOOP("Commands", "Save P&icture…"), "Ctrl+P", "picture",
     QT_TRANSLATE_NOOP("Commands", "A picture of the tree, or the frames of a turntable"), [](W& w, bool) { w.view().savePicture(&w); }},
    {"record", Menu::File, QT_TRANSLATE_NOOP("Commands", "&Record…"), "Ctrl+Shift+E", "",
     QT_TRANSLATE_NOOP("Commands", "Pictures or a video of the tree as it grows or sways"), [](W& w, bool) { w.record(); }},
    {"loadBark", Menu::File, QT_TRANSLATE_NOOP("Commands", "Load &Bark Texture…"), "Ctrl+Shift+B", "",
     QT_TRANSLATE_NOOP("Commands", "Choose the picture on the stems"), [](W& w, bool) { w.chooseTexture("BarkTexture"); }, false, true},
    {"loadLeaf", Menu::File, QT_TRANSLATE_NOOP("Commands", "Load &Leaf Texture…"), "Ctrl+Shift+L", "",
     QT_TRANSLATE_NOOP("Commands", "Choose the picture on the leaves"), [](W& w, bool) { w.chooseTexture("LeafTexture"); }},
    {"quit", Menu::File, QT_TRANSLATE_NOOP("Commands", "&Quit"), "Ctrl+Q", "",
     QT_TRANSLATE_NOOP("Commands", "Leave Stromar"), [](W& w, bool) { w.close(); }, false, true},

    {"undo", Menu::Edit, QT_TRANSLATE_NOOP("Commands", "&Undo"), "Ctrl+Z", "undo",
     QT_TRANSLATE_NOOP("Commands", "Take the last change back"), [](W& w, bool) { w.document().history().undo(); }, true},
    {"redo", Menu::Edit, QT_TRANSLATE_NOOP("Commands", "&Redo"), "Ctrl+Shift+Z", "redo",
     QT_TRANSLATE_NOOP("Commands", "Make the change again"), [](W& w, bool) { w.document().history().redo(); }, true},
    {"find", Menu::Edit, QT_TRANSLATE_NOOP("Commands", "&Find Parameter"), "Ctrl+F", "",
     QT_TRANSLATE_NOOP("Commands", "Look for a parameter by its name"), [](W& w, bool) { w.findParameter(); }, false, true},
    {"preferences", Menu::Edit, QT_TRANSLATE_NOOP("Commands", "&Preferences…"), "Ctrl+,", "",
     QT_TRANSLATE_NOOP("Commands", "Theme, language, mouse, units"), [](W& w, bool) { w.showPreferences(); }, false, true},

    {"randomSeed", Menu::Tree, QT_TRANSLATE_NOOP("Commands", "&Another Seed"), "Ctrl+R", "dice",
     QT_TRANSLATE_NOOP("Commands", "Another tree of the same kind"), [](W& w, bool) { w.throwDice(); }, true},
    {"generate", Menu::Tree, QT_TRANSLATE_NOOP("Commands", "&Generate"), "F5", "generate",
     QT_TRANSLATE_NOOP("Commands", "Build the tree again from scratch"), [](W& w, bool) { w.growth().generate(); }, true},
    {"fullModel", Menu::Tree, QT_TRANSLATE_NOOP("Commands", "&Full Model"), "F6", "full",
     QT_TRANSLATE_NOOP("Commands", "Show the full model now"), [](W& w, bool) { w.growth().growFull(); }, true},
    {"play", Menu::Tree, QT_TRANSLATE_NOOP("Commands", "&Play Growth"), "P", "",
     QT_TRANSLATE_NOOP("Commands", "Let the tree grow from its first day"), [](W& w, bool on) { w.timeline().setPlaying(on); }, false, false, Command::Kind::Switch},
    {"stop", Menu::Tree, QT_TRANSLATE_NOOP("Commands", "&Stop Growing"), "Esc", "",
     QT_TRANSLATE_NOOP("Commands", "Give up the tree that is growing, and let go of what is selected"), [](W& w, bool) { w.stop(); }},

    {"recentre", Menu::View, QT_TRANSLATE_NOOP("Commands", "&Recentre"), "Space", "recentre",
     QT_TRANSLATE_NOOP("Commands", "See the whole tree from the front"), [](W& w, bool) { w.viewport().recentre(); }, true},
    {"frame", Menu::View, QT_TRANSLATE_NOOP("Commands", "&Frame the Tree"), "F", "",
     QT_TRANSLATE_NOOP("Commands", "See the whole tree from where you are"), [](W& w, bool) { w.viewport().frame(); }},
    {"front", Menu::View, QT_TRANSLATE_NOOP("Commands", "From the Fr&ont"), "1", "",
     QT_TRANSLATE_NOOP("Commands", "Look along the Y axis"), [](W& w, bool) { w.viewport().lookFrom(0, 0); }, false, false, Command::Kind::Plain, "", kFrom},
    {"back", Menu::View, QT_TRANSLATE_NOOP("Commands", "From the Back"), "2", "",
     QT_TRANSLATE_NOOP("Commands", "Look along the negative Y axis"), [](W& w, bool) { w.viewport().lookFrom(180, 0); }, false, false, Command::Kind::Plain, "", kFrom},
    {"right", Menu::View, QT_TRANSLATE_NOOP("Commands", "From the Right"), "3", "",
     QT_TRANSLATE_NOOP("Commands", "Look along the negative X axis"), [](W& w, bool) { w.viewport().lookFrom(90, 0); }, false, false, Command::Kind::Plain, "", kFrom},
    {"left", Menu::View, QT_TRANSLATE_NOOP("Commands", "From the Left"), "4", "",
     QT_TRANSLATE_NOOP("Commands", "Look along the X axis"), [](W& w, bool) { w.viewport().lookFrom(-90, 0); }, false, false, Command::Kind::Plain, "", kFrom},
    {"top", Menu::View, QT_TRANSLATE_NOOP("Commands", "From A&bove"), "7", "",
     QT_TRANSLATE_NOOP("Commands", "Look down"), [](W& w, bool) { w.viewport().lookFrom(0, 90); }, false, false, Command::Kind::Plain, "", kFrom},
    {"bottom", Menu::View, QT_TRANSLATE_NOOP("Commands", "From Below"), "8", "",
     QT_TRANSLATE_NOOP("Commands", "Look up"), [](W& w, bool) { w.viewport().lookFrom(0, -90); }, false, false, Command::Kind::Plain, "", kFrom},
    {"saveCamera", Menu::View, QT_TRANSLATE_NOOP("Commands", "Save Camera…"), "Ctrl+Shift+K", "",
     QT_TRANSLATE_NOOP("Commands", "Keep this view of the tree under a name"), [](W& w, bool) { w.saveCamera(); }},
    {"orthographic", Menu::View, QT_TRANSLATE_NOOP("Commands", "Ort&hographic"), "5", "",
     QT_TRANSLATE_NOOP("Commands", "Without perspective"), [](W& w, bool on) { w.viewport().setOrthographic(on); }, false, false, Command::Kind::KeptSwitch},
    {"trackball", Menu::View, QT_TRANSLATE_NOOP("Commands", "Turn &Freely"), "T", "",
     QT_TRANSLATE_NOOP("Commands", "Roll the tree in all directions instead of keeping it upright"), [](W& w, bool on) { w.viewport().setTrackball(on); }, false, false, Command::Kind::KeptSwitch},
    {"wireframe", Menu::View, QT_TRANSLATE_NOOP("Commands", "&Wireframe"), "W", "wireframe",
     QT_TRANSLATE_NOOP("Commands", "Show the wireframe"), [](W& w, bool on) { w.setWireframe(on ? Wireframe::Only : Wireframe::Off, "wireframeOver"); }, true, true, Command::Kind::Switch},
    {"wireframeOver", Menu::View, QT_TRANSLATE_NOOP("Commands", "Wireframe &over the Tree"), "Shift+W", "",
     QT_TRANSLATE_NOOP("Commands", "Show the wireframe on the shaded tree"), [](W& w, bool on) { w.setWireframe(on ? Wireframe::Over : Wireframe::Off, "wireframe"); }, false, false, Command::Kind::Switch},
    {"bare", Menu::View, QT_TRANSLATE_NOOP("Commands", "&Bare"), "B", "bare",
     QT_TRANSLATE_NOOP("Commands", "Hide the leaves"), [](W& w, bool on) { w.view().setLook([on](ViewLook& look) { look.leaves = !on; }); }, true, false, Command::Kind::Switch},
    {"ground", Menu::View, QT_TRANSLATE_NOOP("Commands", "&Grid and Person"), "G", "ground",
     QT_TRANSLATE_NOOP("Commands", "Show a grid of metres and a person beside the tree"), [](W& w, bool on) { w.view().setLook([on](ViewLook& look) { look.ground = on; }); }, true, false, Command::Kind::KeptSwitch},
    {"wind", Menu::View, QT_TRANSLATE_NOOP("Commands", "W&ind"), "N", "",
     QT_TRANSLATE_NOOP("Commands", "Let the tree sway in the wind"), [](W& w, bool on) { w.wind().setBlowing(on); }, false, false, Command::Kind::Switch},
    {"fell", Menu::View, QT_TRANSLATE_NOOP("Commands", "F&ell…"), "X", "",
     QT_TRANSLATE_NOOP("Commands", "Cut the tree and let it fall; the timeline runs over its fall"), [](W& w, bool on) { w.setFelled(on); }, false, false, Command::Kind::Switch},
    {"ruler", Menu::View, QT_TRANSLATE_NOOP("Commands", "R&uler"), "M", "",
     QT_TRANSLATE_NOOP("Commands", "Drag from one place to another to measure"), [](W& w, bool on) { w.viewport().setMeasuring(on); }, false, false, Command::Kind::Switch},
    {"statistics", Menu::View, QT_TRANSLATE_NOOP("Commands", "&Statistics"), "I", "",
     QT_TRANSLATE_NOOP("Commands", "Show sizes and counts in the picture"), [](W& w, bool on) { w.view().setStatistics(on); }, false, false, Command::Kind::KeptSwitch},
    {"tintEdited", Menu::View, QT_TRANSLATE_NOOP("Commands", "Tint What Is &Edited"), "Shift+T", "",
     QT_TRANSLATE_NOOP("Commands", "Keep the tint of what the value in hand changes; else it only flashes"), [](W& w, bool on) { w.view().setTintKept(on); }, false, false, Command::Kind::KeptSwitch},
    {"backdropSky", Menu::View, QT_TRANSLATE_NOOP("Commands", "S&ky"), "Ctrl+1", "",
     QT_TRANSLATE_NOOP("Commands", "Sky and ground behind the tree"), [](W& w, bool) { w.view().setLook([](ViewLook& look) { look.backdrop = Backdrop::Sky; }); }, false, true, Command::Kind::KeptSwitch, "backdrop", kBackdrop},
    {"backdropLight", Menu::View, QT_TRANSLATE_NOOP("Commands", "&Light Grey"), "Ctrl+2", "",
     QT_TRANSLATE_NOOP("Commands", "A light, plain backdrop"), [](W& w, bool) { w.view().setLook([](ViewLook& look) { look.backdrop = Backdrop::Light; }); }, false, false, Command::Kind::KeptSwitch, "backdrop", kBackdrop},
    {"backdropDark", Menu::View, QT_TRANSLATE_NOOP("Commands", "&Dark Grey"), "Ctrl+3", "",
     QT_TRANSLATE_NOOP("Commands", "A dark, plain backdrop"), [](W& w, bool) { w.view().setLook([](ViewLook& look) { look.backdrop = Backdrop::Dark; }); }, false, false, Command::Kind::KeptSwitch, "backdrop", kBackdrop},
    {"backdropPicture", Menu::View, QT_TRANSLATE_NOOP("Commands", "&Picture or Panorama…"), "Ctrl+4", "",
     QT_TRANSLATE_NOOP("Commands", "A photograph, or an HDRI panorama that lights the tree"), [](W& w, bool) { w.chooseBackdrop(); }, false, false, Command::Kind::Plain, "", kBackdrop},
    {"reference", Menu::View, QT_TRANSLATE_NOOP("Commands", "Reference Picture…"), "Ctrl+5", "",
     QT_TRANSLATE_NOOP("Commands", "A picture of a real tree, in its true size, behind the one in the window"), [](W& w, bool on) { w.setReference(on); }, false, false, Command::Kind::Switch, "", kBackdrop},
    {"shadingLit", Menu::View, QT_TRANSLATE_NOOP("Commands", "&Lit"), "Alt+1", "",
     QT_TRANSLATE_NOOP("Commands", "The tree in the light"), [](W& w, bool) { w.view().setLook([](ViewLook& look) { look.shading = Shading::Lit; }); }, false, true, Command::Kind::Switch, "shading", kShading},
    {"shadingMaterial", Menu::View, QT_TRANSLATE_NOOP("Commands", "&Material Alone"), "Alt+2", "",
     QT_TRANSLATE_NOOP("Commands", "The pictures without light"), [](W& w, bool) { w.view().setLook([](ViewLook& look) { look.shading = Shading::Material; }); }, false, false, Command::Kind::Switch, "shading", kShading},
    {"shadingOcclusion", Menu::View, QT_TRANSLATE_NOOP("Commands", "O&cclusion Alone"), "Alt+3", "",
     QT_TRANSLATE_NOOP("Commands", "How much of the sky each place sees"), [](W& w, bool) { w.view().setLook([](ViewLook& look) { look.shading = Shading::Occlusion; }); }, false, false, Command::Kind::Switch, "shading", kShading},
    {"shadingNormals", Menu::View, QT_TRANSLATE_NOOP("Commands", "&Normals Alone"), "Alt+4", "",
     QT_TRANSLATE_NOOP("Commands", "Where each place faces, as a colour"), [](W& w, bool) { w.view().setLook([](ViewLook& look) { look.shading = Shading::Normals; }); }, false, false, Command::Kind::Switch, "shading", kShading},
    {"lod0", Menu::View, QT_TRANSLATE_NOOP("Commands", "Level of Detail &0"), "Alt+5", "",
     QT_TRANSLATE_NOOP("Commands", "The full model, for near views"), [](W& w, bool) { w.growth().setLod(0); }, false, true, Command::Kind::Switch, "lod", kLod},
    {"lod1", Menu::View, QT_TRANSLATE_NOOP("Commands", "Level of Detail &1"), "Alt+6", "",
     QT_TRANSLATE_NOOP("Commands", "The full model as it is seen from some way off"), [](W& w, bool) { w.growth().setLod(1); }, false, false, Command::Kind::Switch, "lod", kLod},
    {"lod2", Menu::View, QT_TRANSLATE_NOOP("Commands", "Level of Detail &2"), "Alt+7", "",
     QT_TRANSLATE_NOOP("Commands", "The full model from afar, with cards of whole twigs"), [](W& w, bool) { w.growth().setLod(2); }, false, false, Command::Kind::Switch, "lod", kLod},
    {"lod3", Menu::View, QT_TRANSLATE_NOOP("Commands", "Level of Detail &3"), "Alt+8", "",
     QT_TRANSLATE_NOOP("Commands", "The coarsest full model, for trees on the horizon"), [](W& w, bool) { w.growth().setLod(3); }, false, false, Command::Kind::Switch, "lod", kLod},
    {"lodSimple", Menu::View, QT_TRANSLATE_NOOP("Commands", "Simple Model"), "Alt+0", "",
     QT_TRANSLATE_NOOP("Commands", "The model that follows a slider, instead of the full one"), [](W& w, bool) { w.growth().showOnly(Model::Simple); }, false, false, Command::Kind::Switch, "lod", kLod},
    {"lodDistance", Menu::View, QT_TRANSLATE_NOOP("Commands", "At Its Distance"), "Alt+9", "",
     QT_TRANSLATE_NOOP("Commands", "Move to where a program would begin to show this level of detail"), [](W& w, bool) { w.view().goToLod(); }, false, false, Command::Kind::Plain, "", kLod},

    {"keepState", Menu::View, QT_TRANSLATE_NOOP("Commands", "Keep as “Before”"), "Shift+A", "",
     QT_TRANSLATE_NOOP("Commands", "Keep the tree as it is now, to compare with what you make of it"), [](W& w, bool) { w.comparison().keep(); }, false, true, Command::Kind::Plain, "", kCompare},
    {"showBefore", Menu::View, QT_TRANSLATE_NOOP("Commands", "Show “Before”"), "A", "",
     QT_TRANSLATE_NOOP("Commands", "The tree as it was kept, until this is switched off or a value changes"), [](W& w, bool on) { w.comparison().show(on); }, false, false, Command::Kind::Switch, "", kCompare},
    {"wipe", Menu::View, QT_TRANSLATE_NOOP("Commands", "Wipe between “Before” and Now"), "Ctrl+Shift+A", "",
     QT_TRANSLATE_NOOP("Commands", "Both trees with a line between them, which can be dragged"), [](W& w, bool on) { w.comparison().setWiping(on); }, false, false, Command::Kind::Switch, "", kCompare},
    {"alone", Menu::View, QT_TRANSLATE_NOOP("Commands", "One Tree"), "Ctrl+6", "",
     QT_TRANSLATE_NOOP("Commands", "The tree alone"), [](W& w, bool) { w.setRow(CSideBySide::Row::Alone); }, false, true, Command::Kind::Switch, "row", kRow},
    {"seeds", Menu::View, QT_TRANSLATE_NOOP("Commands", "Nine Seeds Side by Side"), "Ctrl+7", "",
     QT_TRANSLATE_NOOP("Commands", "The tree among eight others of its kind"), [](W& w, bool) { w.setRow(CSideBySide::Row::Seeds); }, false, false, Command::Kind::Switch, "row", kRow},
    {"ages", Menu::View, QT_TRANSLATE_NOOP("Commands", "Five Ages Side by Side"), "Ctrl+8", "",
     QT_TRANSLATE_NOOP("Commands", "The tree from its youth to its full age"), [](W& w, bool) { w.setRow(CSideBySide::Row::Ages); }, false, false, Command::Kind::Switch, "row", kRow},
    {"seasons", Menu::View, QT_TRANSLATE_NOOP("Commands", "Four Seasons Side by Side"), "Ctrl+9", "",
     QT_TRANSLATE_NOOP("Commands", "The tree in winter, spring, summer and autumn"), [](W& w, bool) { w.setRow(CSideBySide::Row::Seasons); }, false, false, Command::Kind::Switch, "row", kRow},
    {"levels", Menu::View, QT_TRANSLATE_NOOP("Commands", "Levels of Detail Side by Side"), "Ctrl+0", "",
     QT_TRANSLATE_NOOP("Commands", "The four levels of detail and the simple model, with their triangles"), [](W& w, bool) { w.setRow(CSideBySide::Row::Levels); }, false, false, Command::Kind::Switch, "row", kRow},

    {"resetLayout", Menu::Window, QT_TRANSLATE_NOOP("Commands", "&Reset Layout"), "Ctrl+Shift+R", "",
     QT_TRANSLATE_NOOP("Commands", "Put all docks back to where they were at first"), [](W& w, bool) { w.resetLayout(); }, false, true},

    {"manual", Menu::Help, QT_TRANSLATE_NOOP("Commands", "&Manual"), "F1", "",
     QT_TRANSLATE_NOOP("Commands", "Read how Stromar works"), [](W& w, bool) { w.showManual(); }},
    {"shortcuts", Menu::Help, QT_TRANSLATE_NOOP("Commands", "Mouse and &Keys"), "F2", "",
     QT_TRANSLATE_NOOP("Commands", "How to move about, and all shortcuts"), [](W& w, bool) { w.showShortcuts(); }},
    {"welcome", Menu::Help, QT_TRANSLATE_NOOP("Commands", "Welcome"), "Ctrl+F1", "",
     QT_TRANSLATE_NOOP("Commands", "The ways to begin, as at the first start"), [](W& w, bool) { w.showWelcome(); }},
    {"about", Menu::Help, QT_TRANSLATE_NOOP("Commands", "&About Stromar"), "Shift+F1", "",
     QT_TRANSLATE_NOOP("Commands", "Version and origin"), [](W& w, bool) { w.showAbout(); }},
};
// clang-format on
} // namespace

std::span<const Command> commandTable() { return kCommands; }

const char* menuTitle(Menu menu) {
    constexpr const char* kTitles[] = {
        QT_TRANSLATE_NOOP("Commands", "&File"),   QT_TRANSLATE_NOOP("Commands", "&Edit"),
        QT_TRANSLATE_NOOP("Commands", "&Tree"),   QT_TRANSLATE_NOOP("Commands", "&View"),
        QT_TRANSLATE_NOOP("Commands", "&Window"), QT_TRANSLATE_NOOP("Commands", "&Help")};
    return kTitles[static_cast<std::size_t>(menu)];
}

} // namespace stromar
