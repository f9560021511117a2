#pragma once
#include <QDialog>

namespace stromar {

/// What mouse and keys do: a list of the tables of gestures and commands, which scrolls where the screen is low.
class CShortcutsDialog : public QDialog {
    Q_OBJECT
public:
    explicit CShortcutsDialog(QWidget* parent);
};

} // namespace stromar
