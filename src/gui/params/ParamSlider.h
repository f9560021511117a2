#pragma once
#include <QSlider>

namespace stromar {

/// A slider that comes to the mouse. Its positions are tenths of a step: Shift moves by these, Ctrl by ten steps, and
/// without either the positions are whole steps.
class CParamSlider : public QSlider {
    Q_OBJECT
public:
    static constexpr int kFinePerStep = 10;

    /// From 0 to `steps`.
    explicit CParamSlider(int steps, QWidget* parent = nullptr);

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    double positionAt(double x) const;
    void moveTo(double position, Qt::KeyboardModifiers keys);
    void stepBy(int steps, Qt::KeyboardModifiers keys);

    double m_anchorX = 0, m_anchorPosition = 0; ///< where a fine drag starts
    bool m_fine = false;
};

} // namespace stromar
