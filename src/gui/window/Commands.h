#pragma once
#include <QtGlobal>
#include <span>

namespace stromar {

class CMainWindow;

enum class Menu { File, Edit, Tree, View, Window, Help };

/// One row of the table of commands: menus, tool bar, shortcuts and their list in Help are loops over it.
struct Command {
    const char* name; ///< unique; objectName of its QAction
    Menu menu;
    const char* text;                          ///< with & mnemonic; translated in the context "Commands"
    const char* shortcut;                      ///< as QKeySequence reads it; "" none
    const char* icon;                          ///< in the resources; "" none
    const char* help;                          ///< one sentence for the status bar
    void (*run)(CMainWindow& window, bool on); ///< `on` of a switch
    bool onToolBar = false;
    bool startsGroup = false; ///< a separator in front
    enum class Kind {
        Plain,
        Switch,
        KeptSwitch ///< its state is kept between runs
    } kind = Kind::Plain;
    const char* group = "";   ///< of switches of which one is on
    const char* submenu = ""; ///< of the menu; "" none
};

std::span<const Command> commandTable();
const char* menuTitle(Menu menu);

} // namespace stromar
