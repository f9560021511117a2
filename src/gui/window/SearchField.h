#pragma once
#include <QKeyEvent>
#include <QLineEdit>

namespace stromar {

/// A line that searches: what it asks for stands in it while it is empty, Esc empties it.
class CSearchField : public QLineEdit {
public:
    explicit CSearchField(const QString& placeholder, QWidget* parent = nullptr) : QLineEdit(parent) {
        setPlaceholderText(placeholder);
        setAccessibleName(placeholder);
        setClearButtonEnabled(true);
    }

protected:
    bool event(QEvent* event) override {
        const bool asks = event->type() == QEvent::ShortcutOverride;
        if (!asks && event->type() != QEvent::KeyPress) return QLineEdit::event(event);
        if (static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape || text().isEmpty()) return QLineEdit::event(event);
        if (asks)
            event->accept(); // else it is the window's
        else
            clear();
        return true;
    }
};

} // namespace stromar
