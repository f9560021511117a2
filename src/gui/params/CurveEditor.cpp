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
#include <limits>

namespace stromar {

namespace {
constexpr double kGrip = 9; // pixels around a point
constexpr int kCurveHeight = 130, kStripHeight = 26;
constexpr double kUseHeight = 0.7; // of the picture, for most branches
constexpr int kBins = 40;          // where x is no number of something
constexpr double kApart = 1e-3; // that points keep between their x: the last digit that is shown

double snapped(double value, double step) { return std::round(value / step) * step; }

QString shortNumber(double value) { return QLocale().toString(value, 'g', 4); }
} // namespace

CCurveEditor::CCurveEditor(const ParamInfo& info, QWidget* parent)
    : QWidget(parent), m_info(info), m_axis{info.overLabel, info.overStep}, m_over(info.shownOver), m_shown(info.useful),
      m_covered(info.useful), m_x(new QDoubleSpinBox), m_y(new QDoubleSpinBox), m_xLabel(new QLabel(trText(info.overLabel))),
      m_numbers(new QWidget) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleName(trText(info.label));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addStretch(1);
    auto* numbers = new QHBoxLayout(m_numbers);
    numbers->setContentsMargins(0, 0, 0, 0);
    numbers->addWidget(m_xLabel);
    numbers->addWidget(m_x);
    numbers->addWidget(new QLabel(tr("value")));
    numbers->addWidget(m_y);
    numbers->addStretch(1);
    column->addWidget(m_numbers);
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

QSize CCurveEditor::sizeHint() const { return {220, m_folded ? kStripHeight : kCurveHeight + 34}; }

void CCurveEditor::setFolded(bool folded) {
    m_folded = folded;
    m_numbers->setVisible(!folded);
    setCursor(folded ? Qt::PointingHandCursor : Qt::ArrowCursor);
    setToolTip(QString());
    updateGeometry();
    update();
}

QColor CCurveEditor::colour() const {
    return m_colour.value_or(palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::Highlight));
}

void CCurveEditor::setAxis(const CurveAxis& axis) {
    if (axis.label == m_axis.label) return;
    m_axis = axis;
    m_xLabel->setText(trText(axis.label));
    m_x->setSingleStep(axis.step);
    cover();
    update();
    emit shown();
}

void CCurveEditor::showUse(Use use) {
    m_use = std::move(use);
    if (!m_dragged) cover();
    update();
}

void CCurveEditor::showBeside(std::vector<Beside> others, const Range& covered) {
    m_beside = std::move(others);
    m_covered = covered;
    if (!m_dragged) cover();
    update();
}

/// The picture holds all points, and the branches of the tree.
void CCurveEditor::cover() {
    m_over = m_info.shownOver;
    m_shown = m_covered;
    const auto hold = [this](const CCurve& curve) {
        for (const auto& [x, y] : curve.points()) {
            m_over = {std::min(m_over.min, x), std::max(m_over.max, x)};
            m_shown = {std::min(m_shown.min, y), std::max(m_shown.max, y)};
        }
    };
    hold(m_curve);
    for (const Beside& other : m_beside) hold(other.curve);
    if (m_use.branches.empty()) return;
    const auto [least, most] = std::ranges::minmax(m_use.branches);
    m_over = {std::min(m_over.min, least), std::max(m_over.max, most)};
}

QRectF CCurveEditor::plot() const {
    const double left = 8 + fontMetrics().horizontalAdvance(shortNumber(m_shown.max));
    return {left, 6, std::max(10.0, width() - left - 8.0), std::max(10.0, m_numbers->geometry().top() - 26.0)};
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
    if (snaps) point = {snapped(point.x, m_axis.step), snapped(point.y, m_info.step)};
    const double digits = std::pow(10, m_info.decimals);
    return {std::clamp(snapped(point.x, 1e-3), m_info.over.min, m_info.over.max),
            std::clamp(std::round(point.y * digits) / digits, m_info.range.min, m_info.range.max)};
}

void CCurveEditor::showCurve(const CCurve& curve) {
    if (curve == m_curve && m_x->isEnabled()) return;
    m_curve = curve;
    if (!m_dragged) cover(); // not under the hand
    choose(m_chosen ? std::min(*m_chosen, curve.points().size() - 1) : 0);
    update();
    emit shown();
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
    if (m_dragged) tellRange();
    emit edited(m_curve, gesture);
}

/// A point stays between its neighbours.
void CCurveEditor::move(std::size_t point, const CCurve::Point& to, int gesture) {
    std::vector<CCurve::Point> points = m_curve.points();
    const double low = point > 0 ? points[point - 1].x + kApart : m_info.over.min;
    const double high = point + 1 < points.size() ? points[point + 1].x - kApart : m_info.over.max;
    points[point] = {low <= high ? std::clamp(to.x, low, high) : points[point].x, to.y};
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

/// A point acts between its neighbours; the first and the last one all the way.
void CCurveEditor::tellRange() {
    constexpr double kAll = std::numeric_limits<double>::infinity();
    const auto& points = m_curve.points();
    const std::size_t i = *m_chosen;
    emit rangeHeld(i > 0 ? points[i - 1].x : -kAll, i + 1 < points.size() ? points[i + 1].x : kAll);
}

void CCurveEditor::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
    if (m_folded) return emit unfoldWanted();
    if (const auto point = grip(event->position())) {
        choose(point);
        m_dragged = true;
        m_gesture = nextGesture();
        tellRange();
    }
}

void CCurveEditor::mouseMoveEvent(QMouseEvent* event) {
    if (m_folded) return;
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
    if (m_folded) return;
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
    const auto point = m_folded ? std::nullopt : grip(event->pos());
    if (!point) return QWidget::contextMenuEvent(event); // the row's menu: reset, copy, paste
    QMenu menu;
    menu.addAction(tr("&Delete Point"), this, [this, point] { remove(*point); })->setEnabled(m_curve.points().size() > 1);
    menu.exec(event->globalPos());
}

double CCurveEditor::shownStep() const {
    const double room = plot().width() / (1.5 * fontMetrics().horizontalAdvance(QStringLiteral("000.0")));
    const double wanted = std::max(m_axis.step, (m_over.max - m_over.min) / std::max(1.0, room));
    const double power = std::pow(10, std::floor(std::log10(wanted) + 1e-9));
    for (const double nice : {1.0, 2.0, 5.0})
        if (nice * power >= wanted * (1 - 1e-9)) return nice * power;
    return 10 * power;
}

void CCurveEditor::paintGrid(QPainter& painter) const {
    const QRectF area = plot();
    QColor line = palette().color(QPalette::Text);
    line.setAlphaF(0.15f);
    painter.setPen(QPen(line, 1));
    const double step = shownStep();
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

/// How many branches stand at each x: of whole numbers each by itself.
void CCurveEditor::paintUse(QPainter& painter) const {
    const QRectF area = plot();
    const bool whole = m_axis.step == 1;
    const double width = whole ? 1 : (m_over.max - m_over.min) / kBins, first = whole ? m_over.min - 0.5 : m_over.min;
    std::vector<double> bins(static_cast<std::size_t>((m_over.max - first) / width) + 1, 0);
    for (const double x : m_use.branches)
        if (const double bin = (x - first) / width; bin >= 0 && bin < double(bins.size())) ++bins[static_cast<std::size_t>(bin)];
    const double most = std::max(1.0, *std::ranges::max_element(bins));
    QColor fill = palette().color(QPalette::Text);
    fill.setAlphaF(0.18f);
    for (std::size_t i = 0; i < bins.size(); ++i) {
        const double left = placeOf({first + width * double(i), 0}).x(), right = placeOf({first + width * double(i + 1), 0}).x();
        const double high = kUseHeight * area.height() * bins[i] / most;
        painter.fillRect(QRectF(left + 1, area.bottom() - high, right - left - 2, high), fill);
    }
    painter.setPen(QPen(palette().color(QPalette::Text), 1.5, Qt::DashLine));
    for (const double x : m_use.marked)
        painter.drawLine(QPointF(placeOf({x, 0}).x(), area.top()), QPointF(placeOf({x, 0}).x(), area.bottom()));
}

QPainterPath CCurveEditor::pathOf(const CCurve& curve) const {
    const auto& points = curve.points();
    QPainterPath path(placeOf({m_over.min, points.front().y}));
    for (const CCurve::Point& point : points) path.lineTo(placeOf(point));
    path.lineTo(placeOf({m_over.max, points.back().y}));
    return path;
}

void CCurveEditor::paintCurve(QPainter& painter) const {
    for (const Beside& other : m_beside) {
        QColor faint = other.colour;
        faint.setAlphaF(0.55f);
        painter.setPen(QPen(faint, 1.2));
        painter.drawPath(pathOf(other.curve));
    }
    const auto& points = m_curve.points();
    painter.setPen(QPen(colour(), 2));
    painter.drawPath(pathOf(m_curve));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool chosen = m_chosen == i && hasFocus();
        painter.setPen(QPen(colour(), 2));
        painter.setBrush(chosen ? QBrush(colour()) : palette().brush(QPalette::Base));
        const double radius = m_hot == i ? 5.5 : 4.5;
        painter.drawEllipse(placeOf(points[i]), radius, radius);
    }
}

/// The curve alone, and its first and last value.
void CCurveEditor::paintStrip(QPainter& painter) const {
    const auto& points = m_curve.points();
    const QRectF area = QRectF(rect()).adjusted(4, 4, -4, -4);
    painter.setPen(palette().color(QPalette::Text));
    const QString first = shortNumber(points.front().y), last = shortNumber(points.back().y);
    const double room = fontMetrics().horizontalAdvance(QStringLiteral("0.000 "));
    painter.drawText(area, Qt::AlignVCenter | Qt::AlignLeft, first);
    if (points.size() > 1) painter.drawText(area, Qt::AlignVCenter | Qt::AlignRight, last);
    const QRectF drawn = area.adjusted(room, 2, -room, -2);
    const auto place = [&](double x, double y) {
        const double u = (x - m_over.min) / (m_over.max - m_over.min), v = (y - m_shown.min) / (m_shown.max - m_shown.min);
        return QPointF(drawn.left() + u * drawn.width(), drawn.bottom() - v * drawn.height());
    };
    QPainterPath path(place(m_over.min, points.front().y));
    for (const auto& [x, y] : points) path.lineTo(place(x, y));
    path.lineTo(place(m_over.max, points.back().y));
    painter.setPen(QPen(colour(), 1.6));
    painter.drawPath(path);
    painter.setPen(QPen(palette().color(QPalette::Text), 1, Qt::DashLine));
    for (const double x : m_use.marked) painter.drawLine(place(x, m_shown.min), place(x, m_shown.max));
}

void CCurveEditor::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_folded) return paintStrip(painter);
    painter.fillRect(plot(), palette().brush(QPalette::Base));
    painter.setClipRect(plot());
    if (!m_use.branches.empty()) paintUse(painter);
    painter.setClipping(false);
    paintGrid(painter);
    painter.setClipRect(plot().adjusted(-7, -7, 7, 7));
    paintCurve(painter);
}

} // namespace stromar
