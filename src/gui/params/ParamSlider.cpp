#include "params/ParamSlider.h"
#include <QKeyEvent>
#include <QMouseEvent>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
constexpr double kFineSpeed = 0.1;
constexpr int kCoarse = 10;

/// How many positions the keys make one stride of.
int strideOf(Qt::KeyboardModifiers keys) {
    if (keys & Qt::ShiftModifier) return 1;
    return CParamSlider::kFinePerStep * (keys & Qt::ControlModifier ? kCoarse : 1);
}
} // namespace

CParamSlider::CParamSlider(int steps, QWidget* parent) : QSlider(Qt::Horizontal, parent) {
    setRange(0, steps * kFinePerStep);
    setSingleStep(kFinePerStep);
    setPageStep(kCoarse * kFinePerStep);
}

double CParamSlider::positionAt(double x) const {
    QStyleOptionSlider option;
    initStyleOption(&option);
    const QRect groove = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderGroove, this);
    const int handle = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this).width();
    const double room = std::max(1, groove.width() - handle);
    const double share = std::clamp((x - groove.x() - handle / 2.0) / room, 0.0, 1.0);
    return maximum() * (layoutDirection() == Qt::RightToLeft ? 1 - share : share);
}

void CParamSlider::moveTo(double position, Qt::KeyboardModifiers keys) {
    const int stride = strideOf(keys);
    setSliderPosition(static_cast<int>(std::lround(position / stride)) * stride);
}

void CParamSlider::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || maximum() == minimum()) return event->ignore();
    event->accept();
    m_fine = event->modifiers() & Qt::ShiftModifier;
    m_anchorX = event->position().x();
    m_anchorPosition = sliderPosition();
    setSliderDown(true);
    if (!m_fine) moveTo(positionAt(m_anchorX), event->modifiers());
}

void CParamSlider::mouseMoveEvent(QMouseEvent* event) {
    if (!isSliderDown()) return event->ignore();
    event->accept();
    const double x = event->position().x();
    if (const bool fine = event->modifiers() & Qt::ShiftModifier; fine != m_fine) {
        m_fine = fine;
        m_anchorX = x;
        m_anchorPosition = sliderPosition();
    }
    if (m_fine)
        moveTo(m_anchorPosition + kFineSpeed * (positionAt(x) - positionAt(m_anchorX)), event->modifiers());
    else
        moveTo(positionAt(x), event->modifiers());
}

void CParamSlider::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !isSliderDown()) return event->ignore();
    event->accept();
    setSliderDown(false);
}

void CParamSlider::stepBy(int steps, Qt::KeyboardModifiers keys) {
    moveTo(sliderPosition() + steps * strideOf(keys), keys);
}

void CParamSlider::keyPressEvent(QKeyEvent* event) {
    const bool mirrored = layoutDirection() == Qt::RightToLeft;
    switch (event->key()) {
    case Qt::Key_Up: return stepBy(1, event->modifiers());
    case Qt::Key_Down: return stepBy(-1, event->modifiers());
    case Qt::Key_Right: return stepBy(mirrored ? -1 : 1, event->modifiers());
    case Qt::Key_Left: return stepBy(mirrored ? 1 : -1, event->modifiers());
    default: QSlider::keyPressEvent(event);
    }
}

void CParamSlider::wheelEvent(QWheelEvent* event) {
    // Some systems turn the wheel sideways while a modifier is held.
    const QPoint turned = event->angleDelta();
    const int amount = turned.y() != 0 ? turned.y() : turned.x();
    if (amount == 0) return event->ignore();
    event->accept();
    stepBy(amount > 0 ? 1 : -1, event->modifiers());
}

} // namespace stromar
