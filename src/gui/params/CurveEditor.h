#pragma once
#include "stromar/params/ParamTable.h"
#include "stromar/app/Methods.h"
#include <QColor>
#include <QWidget>
#include <optional>

class QDoubleSpinBox;
class QLabel;
class QPainterPath;
class QToolButton;

namespace stromar {

/// Control points over a quantity, as a picture: drag a point, double click to add one, Delete or the right button to
/// take one away. Places snap to the row's steps; with Shift they do not. The numbers of the point in hand can be typed.
/// Of several in one picture (CCurveGroup) one is unfolded, the others are strips that a click unfolds.
class CCurveEditor : public QWidget {
    Q_OBJECT
public:
    /// Another curve of the picture.
    struct Beside {
        CCurve curve;
        QColor colour;
    };
    /// How branches of the tree that is shown lie along x.
    struct Use {
        std::vector<double> branches; ///< x of each
        std::vector<double> marked;   ///< of those that are pointed at
    };

    explicit CCurveEditor(const ParamInfo& info, QWidget* parent = nullptr);

    /// Shows a curve without telling.
    void showCurve(const CCurve& curve);
    const CCurve& curve() const { return m_curve; }
    /// Whether a point is being dragged.
    bool held() const { return m_dragged; }
    const ParamInfo& info() const { return m_info; }
    /// What x is.
    void setAxis(const CurveAxis& axis);
    const CurveAxis& axis() const { return m_axis; }
    void showUse(Use use);
    const Use& use() const { return m_use; }

    void setFolded(bool folded);
    bool folded() const { return m_folded; }
    void setColour(const QColor& colour) { m_colour = colour; }
    /// Of the palette where none was set.
    QColor colour() const;
    /// The rest of the picture, and what y it covers at least.
    void showBeside(std::vector<Beside> others, const Range& covered);
    /// Where a point of the curve is drawn, and the other way.
    QPointF placeOf(const CCurve::Point& point) const;
    CCurve::Point pointAt(const QPointF& place, bool snaps) const;
    QRectF plot() const;
    std::optional<std::size_t> chosen() const { return m_chosen; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    /// A folded one was clicked.
    void unfoldWanted();
    /// It shows another curve, or one over something else.
    void shown();
    /// A point is held that acts between these x, which are not included.
    void rangeHeld(double low, double high);
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
    void tellRange();
    void cover();
    double shownStep() const;
    void paintStrip(QPainter& painter) const;
    void paintUse(QPainter& painter) const;
    void paintGrid(QPainter& painter) const;
    QPainterPath pathOf(const CCurve& curve) const;
    void paintCurve(QPainter& painter) const;

    const ParamInfo& m_info;
    CCurve m_curve;
    CurveAxis m_axis;
    Range m_over, m_shown; ///< what the picture covers
    Range m_covered;       ///< of y, at least
    Use m_use;
    std::vector<Beside> m_beside;
    std::optional<QColor> m_colour;
    bool m_folded = false;
    std::optional<std::size_t> m_chosen, m_hot;
    bool m_dragged = false;
    int m_gesture = 0;
    QDoubleSpinBox *m_x, *m_y;
    QLabel* m_xLabel;
    QWidget* m_numbers;
};

} // namespace stromar
