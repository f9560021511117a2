#pragma once
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QScrollBar>
#include <QWidget>

namespace stromar {

/// Controls without the focus leave the wheel to what scrolls behind them.
class CWheelGuard : public QObject {
public:
    using QObject::QObject;

    void guard(QWidget* control) {
        if (control->focusPolicy() == Qt::WheelFocus) control->setFocusPolicy(Qt::StrongFocus);
        control->installEventFilter(this);
    }
    void guardAll(const QWidget& parent) {
        for (auto* box : parent.findChildren<QComboBox*>()) guard(box);
        for (auto* box : parent.findChildren<QAbstractSpinBox*>()) guard(box);
        for (auto* slider : parent.findChildren<QAbstractSlider*>())
            if (!qobject_cast<QScrollBar*>(slider)) guard(slider);
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus()) return false;
        event->ignore();
        return true;
    }
};

} // namespace stromar
