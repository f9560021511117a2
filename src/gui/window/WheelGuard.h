#pragma once
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QScrollBar>

namespace stromar {

/// Controls without the focus leave the wheel to what scrolls behind them, and do not get the focus by it. Filters the events of the
/// whole program, or of one control.
class CWheelGuard : public QObject {
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Wheel && event->type() != QEvent::Polish) return false;
        const bool slider = qobject_cast<QAbstractSlider*>(watched) && !qobject_cast<QScrollBar*>(watched);
        if (!slider && !qobject_cast<QComboBox*>(watched) && !qobject_cast<QAbstractSpinBox*>(watched)) return false;
        auto* control = static_cast<QWidget*>(watched);
        if (control->focusPolicy() == Qt::WheelFocus) control->setFocusPolicy(Qt::StrongFocus);
        if (event->type() == QEvent::Polish || control->hasFocus()) return false;
        event->ignore();
        return true;
    }
};

} // namespace stromar
