#pragma once
#include <algorithm>
#include <QLabel>

namespace stromar {

/// A text of several lines that is never cut: it takes the height that its width asks for, in any layout.
class CWrappedLabel : public QLabel {
public:
    explicit CWrappedLabel(QWidget* parent = nullptr) : QLabel(parent) { setWordWrap(true); }

protected:
    void resizeEvent(QResizeEvent* event) override {
        QLabel::resizeEvent(event);
        keepHeight();
    }
    bool event(QEvent* event) override {
        const bool done = QLabel::event(event);
        if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Polish || event->type() == QEvent::Paint) keepHeight();
        return done;
    }

private:
    void keepHeight() {
        if (const int height = std::max(0, heightForWidth(width())); height != minimumHeight()) setMinimumHeight(height);
    }
};

} // namespace stromar
