#include "params/CurveEditor.h"
#include "document/Gesture.h"
#include "window/QtText.h"
#include <QContextMenuEvent>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
constexpr double kGrip = 9; // pixels around a point
constexpr int kHeight = 110;
constexpr double kApart = 1e-3; // of what x covers, that points keep between them

double rounded(double value, double step) { return std::round(value / step) * step; }

QString shortNumber(double value) { return QLocale().toString(value, 'g', 4); }
} // namespace

CCurveEditor::CCurveEditor(const ParamInfo& info, QWidget* parent)
    : QWidget(parent), m_info(info), m_over(info.shownOver), m_shown(info.useful), m_x(new QDoubleSpinBox), m_y(new QDoubleSpinBox) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleName(trText(info.label));
    setMinimumHeight(kHeight + 34);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addStretch(1);
    auto* numbers = new QHBoxLayout;
    numbers->addWidget(new QLabel(trText(info.overLabel)));
    numbers->addWidget(m_x);
    numbers->addWidget(new QLabel(tr("value")));
    numbers->addWidget(m_y);
    numbers->addStretch(1);
    column->addLayout(numbers);
    m_x->setObjectName(QStringLiteral("curveX"));
    m_y->setObjectName(QStringLiteral("curveY"));
    m_x->setRange(info.over.min, info.over.max);
    m_x->setSingleStep(info.overStep);
    m_x->setDecimals(3);
    m_y->setRange(info.range.min, info.range.max);
    m_y->setSingleStep(info.step);
    m_y->setDecimals(info.decimals);
    for (QDoubleSpinBox* box : {m_x, m_y}) {
        box->setKeyboardTracking(false);
        connect(box, &QDoubleSpinBox::valueChanged, this, &CCurveEditor::typed);
    }
    choose(0);
}

QSize CCurveEditor::sizeHint() const { return {220, kHeight + 34}; }

QRectF CCurveEditor::plot() const {
    const double left = 8 + fontMetrics().horizontalAdvance(shortNumber(m_shown.max));
    return {left, 6, std::max(10.0, width() - left - 8.0), std::max(10.0, m_x->geometry().top() - 26.0)};
}

QPointF CCurveEditor::placeOf(const CCurve::Point& point) const {
    const QRectF area = plot();
    const double x = (point.x - m_over.min) / (m_over.max - m_over.min),
                 y = (point.y - m_shown.min) / (m_shown.max - m_shown.min);
    return {area.left() + x * area.width(), area.bottom() - y * area.height()};
}

CCurve::Point CCurveEditor::pointAt(const QPointF& place, bool snaps) const {
    const QRectF area = plot();
    CCurve::Point point{m_over.min + (place.x() - area.left()) / area.width() * (m_over.max - m_over.min),
                        m_shown.min + (area.bottom() - place.y()) / area.height() * (m_shown.max - m_shown.min)};
    if (snaps) point = {rounded(point.x, m_info.overStep), rounded(point.y, m_info.step)};
    const double digits = std::pow(10, m_info.decimals);
    return {std::clamp(rounded(point.x, 1e-3), m_info.over.min, m_info.over.max),
            std::clamp(std::round(point.y * digits) / digits, m_info.range.min, m_info.range.max)};
}

void CCurveEditor::showCurve(const CCurve& curve) {
    if (curve == m_curve && m_x->isEnabled()) return;
    m_curve = curve;
    if (!m_dragged) { // the picture grows to hold all points, but not under the hand
        m_over = m_info.shownOver;
        m_shown = m_info.useful;
        for (const auto& [x, y] : curve.points()) {
            m_over = {std::min(m_over.min, x), std::max(m_over.max, x)};
            m_shown = {std::min(m_shown.min, y), std::max(m_shown.max, y)};
        }
    }
    choose(m_chosen ? std::min(*m_chosen, curve.points().size() - 1) : 0);
    update();
}

void CCurveEditor::choose(std::optional<std::size_t> point) {
    m_chosen = point;
    const QSignalBlocker quietX(m_x), quietY(m_y);
    for (QDoubleSpinBox* box : {m_x, m_y}) box->setEnabled(point.has_value());
    if (point) {
        m_x->setValue(m_curve.points()[*point].x);
        m_y->setValue(m_curve.points()[*point].y);
    }
    update();
}

std::optional<std::size_t> CCurveEditor::grip(const QPointF& at) const {
    std::optional<std::size_t> nearest;
    double smallest = kGrip;
    for (std::size_t i = 0; i < m_curve.points().size(); ++i)
        if (const double distance = QLineF(placeOf(m_curve.points()[i]), at).length(); distance < smallest) {
            smallest = distance;
            nearest = i;
        }
    return nearest;
}

void CCurveEditor::change(std::vector<CCurve::Point> points, int gesture) {
    CCurve curve(std::move(points));
    if (curve == m_curve) return;
    m_curve = std::move(curve);
    choose(m_chosen);
    emit edited(m_curve, gesture);
}

/// A point stays between its neighbours.
void CCurveEditor::move(std::size_t point, const CCurve::Point& to, int gesture) {
    std::vector<CCurve::Point> points = m_curve.points();
    const double apart = kApart * (m_info.over.max - m_info.over.min);
    const double low = point > 0 ? points[point - 1].x + apart : m_info.over.min;
    const double high = point + 1 < points.size() ? points[point + 1].x - apart : m_info.over.max;
    points[point] = {std::clamp(to.x, std::min(low, high), std::max(low, high)), to.y};
    change(std::move(points), gesture);
}

void CCurveEditor::remove(std::size_t point) {
    if (m_curve.points().size() < 2) return;
    std::vector<CCurve::Point> points = m_curve.points();
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(point));
    m_chosen = std::min(point, points.size() - 1);
    m_hot.reset();
    change(std::move(points), 0);
}

void CCurveEditor::typed() {
    if (m_chosen) move(*m_chosen, {m_x->value(), m_y->value()}, 0);
}

void CCurveEditor::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
    if (const auto point = grip(event->position())) {
        choose(point);
        m_dragged = true;
        m_gesture = nextGesture();
    }
}

void CCurveEditor::mouseMoveEvent(QMouseEvent* event) {
    if (m_dragged && m_chosen)
        move(*m_chosen, pointAt(event->position(), !(event->modifiers() & Qt::ShiftModifier)), m_gesture);
    else if (const auto hot = grip(event->position()); hot != m_hot) {
        m_hot = hot;
        setCursor(hot ? Qt::SizeAllCursor : Qt::ArrowCursor);
        update();
    }
}

void CCurveEditor::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !m_dragged) return;
    m_dragged = false;
    emit released();
    showCurve(CCurve(m_curve));
}

void CCurveEditor::mouseDoubleClickEvent(QMouseEvent* event) {
    m_dragged = false;
    if (grip(event->position()) || m_curve.points().size() >= CCurve::kMaxPoints) return;
    const CCurve::Point point = pointAt(event->position(), !(event->modifiers() & Qt::ShiftModifier));
    std::vector<CCurve::Point> points = m_curve.points();
    const auto right = std::ranges::upper_bound(points, point.x, {}, &CCurve::Point::x);
    if (right != points.begin() && (right - 1)->x == point.x) return; // two points cannot lie above each other
    m_chosen = static_cast<std::size_t>(right - points.begin());
    points.insert(right, point);
    change(std::move(points), 0);
}

void CCurveEditor::keyPressEvent(QKeyEvent* event) {
    if (m_chosen && (event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace)) return remove(*m_chosen);
    QWidget::keyPressEvent(event);
}

bool CCurveEditor::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride)
        if (const auto* key = static_cast<QKeyEvent*>(event); key->key() == Qt::Key_Delete || key->key() == Qt::Key_Backspace) {
            event->accept(); // it is not the window's
            return true;
        }
    return QWidget::event(event);
}

void CCurveEditor::contextMenuEvent(QContextMenuEvent* event) {
    const auto point = grip(event->pos());
    if (!point) return QWidget::contextMenuEvent(event); // the row's menu: reset, copy, paste
    QMenu menu;
    menu.addAction(tr("&Delete Point"), this, [this, point] { remove(*point); })->setEnabled(m_curve.points().size() > 1);
    menu.exec(event->globalPos());
}

void CCurveEditor::paintGrid(QPainter& painter) const {
    const QRectF area = plot();
    QColor line = palette().color(QPalette::Text);
    line.setAlphaF(0.15f);
    painter.setPen(QPen(line, 1));
    const double step = m_info.overStep * std::max(1.0, std::ceil((m_over.max - m_over.min) / m_info.overStep / 12));
    for (double x = std::ceil(m_over.min / step) * step; x <= m_over.max + 1e-9; x += step) {
        const double at = placeOf({x, 0}).x();
        painter.drawLine(QPointF(at, area.top()), QPointF(at, area.bottom()));
    }
    painter.drawRect(area);
    painter.setPen(palette().color(QPalette::Text));
    const auto text = [&](const QRectF& where, int align, double value) { painter.drawText(where, align, shortNumber(value)); };
    text({0, area.top() - 6, area.left() - 4, 16}, Qt::AlignRight | Qt::AlignTop, m_shown.max);
    text({0, area.bottom() - 12, area.left() - 4, 16}, Qt::AlignRight | Qt::AlignBottom, m_shown.min);
    for (double x = std::ceil(m_over.min / step) * step; x <= m_over.max + 1e-9; x += step)
        text({placeOf({x, 0}).x() - 20, area.bottom() + 2, 40, 16}, Qt::AlignHCenter | Qt::AlignTop, x);
}

void CCurveEditor::paintCurve(QPainter& painter) const {
    const auto& points = m_curve.points();
    QPainterPath path(placeOf({m_over.min, points.front().y}));
    for (const CCurve::Point& point : points) path.lineTo(placeOf(point));
    path.lineTo(placeOf({m_over.max, points.back().y}));
    const QColor colour = palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::Highlight);
    painter.setPen(QPen(colour, 2));
    painter.drawPath(path);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool chosen = m_chosen == i && hasFocus();
        painter.setPen(QPen(colour, 2));
        painter.setBrush(chosen ? QBrush(colour) : palette().brush(QPalette::Base));
        const double radius = m_hot == i ? 5.5 : 4.5;
        painter.drawEllipse(placeOf(points[i]), radius, radius);
    }
}

void CCurveEditor::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(plot(), palette().brush(QPalette::Base));
    paintGrid(painter);
    painter.setClipRect(plot().adjusted(-7, -7, 7, 7));
    paintCurve(painter);
}

} // namespace stromar
