#pragma once
#include <QDialog>

namespace stromar {

/// The table of preferences as a form; every change acts at once.
class CPreferencesDialog : public QDialog {
    Q_OBJECT
public:
    explicit CPreferencesDialog(QWidget* parent = nullptr);
};

} // namespace stromar
