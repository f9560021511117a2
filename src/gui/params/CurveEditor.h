#pragma once
#include "stromar/params/ParamTable.h"
#include <QWidget>
#include <optional>

class QDoubleSpinBox;
class QToolButton;

namespace stromar {

/// Control points over a quantity, as a picture: drag a point, double click to add one, Delete or the right button to
/// take one away. Places snap to the row's steps; with Shift they do not. The numbers of the point in hand can be typed.
class CCurveEditor : public QWidget {
    Q_OBJECT
public:
    explicit CCurveEditor(const ParamInfo& info, QWidget* parent = nullptr);

    /// Shows a curve without telling.
    void showCurve(const CCurve& curve);
    const CCurve& curve() const { return m_curve; }
    /// Whether a point is being dragged.
    bool held() const { return m_dragged; }
    /// Where a point of the curve is drawn, and the other way.
    QPointF placeOf(const CCurve::Point& point) const;
    CCurve::Point pointAt(const QPointF& place, bool snaps) const;
    QRectF plot() const;
    std::optional<std::size_t> chosen() const { return m_chosen; }
    QSize sizeHint() const override;

signals:
    /// The user changed the curve. All changes of one drag have the same positive gesture; 0 stands alone.
    void edited(const stromar::CCurve& curve, int gesture);
    void released();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    bool event(QEvent* event) override;

private:
    std::optional<std::size_t> grip(const QPointF& at) const;
    void choose(std::optional<std::size_t> point);
    void move(std::size_t point, const CCurve::Point& to, int gesture);
    void remove(std::size_t point);
    void typed();
    void change(std::vector<CCurve::Point> points, int gesture);
    void paintGrid(QPainter& painter) const;
    void paintCurve(QPainter& painter) const;

    const ParamInfo& m_info;
    CCurve m_curve;
    Range m_over, m_shown; ///< what the picture covers
    std::optional<std::size_t> m_chosen, m_hot;
    bool m_dragged = false;
    int m_gesture = 0;
    QDoubleSpinBox *m_x, *m_y;
};

} // namespace stromar
