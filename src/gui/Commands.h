#pragma once
#include <QtGlobal>
#include <span>

namespace stromar {

class CMainWindow;

enum class Menu { File, Edit, Tree, View, Help };

/// One row of the table of commands: menus, tool bar, shortcuts and their list in Help are loops over it.
struct Command {
    const char* name; ///< unique; objectName of its QAction
    Menu menu;
    const char* text;     ///< with & mnemonic; translated in the context "Commands"
    const char* shortcut; ///< as QKeySequence reads it; "" none
    const char* icon;     ///< in the resources; "" none
    const char* help;     ///< one sentence for the status bar
    void (CMainWindow::*run)();
    bool onToolBar = false;
    bool checkable = false;
    bool startsGroup = false; ///< a separator in front
};

std::span<const Command> commandTable();
const char* menuTitle(Menu menu);

} // namespace stromar
