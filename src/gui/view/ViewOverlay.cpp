#include "view/ViewOverlay.h"
#include "window/QtText.h"
#include "window/Settings.h"
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
constexpr std::size_t kManyLines = 500; // that are selected
constexpr double kHandleRadius = 6, kGrip = 11; // pixels
constexpr double kAxisReach = 34, kAxisBall = 8, kAxisMargin = 54.0;
constexpr int kRingPoints = 48;
constexpr double kSteep = 0.94; // of a view that looks down or up: its sine
const QColor kAccent(255, 150, 40);
const QColor kGuide(255, 176, 64);
const QColor kWind(120, 200, 255);
constexpr double kLevel = 0.02; // of a measure that goes neither up nor down, or nowhere else
constexpr double kArrowStart = 0.35, kArrowEnd = 1.15; // of the tree's reach

/// What rows of text take.
QSizeF plateSize(const QFontMetricsF& metrics, const QStringList& rows) {
    double wide = 0;
    for (const QString& row : rows) wide = std::max(wide, metrics.horizontalAdvance(row));
    return {wide + 14, metrics.height() * double(rows.size()) + 8};
}

/// Rows of text on a plate that is readable before a light and a dark ground; moved until it lies in the view.
void drawPlate(QPainter& painter, const QPointF& corner, Qt::Corner which, const QStringList& rows,
               const QColor& ink = Qt::white) {
    const QFontMetricsF metrics(painter.font());
    QRectF plate(corner, plateSize(metrics, rows));
    if (which == Qt::TopRightCorner || which == Qt::BottomRightCorner) plate.moveRight(corner.x());
    if (which == Qt::BottomLeftCorner || which == Qt::BottomRightCorner) plate.moveBottom(corner.y());
    const QRectF view = painter.viewport();
    plate.moveLeft(std::max(view.left(), std::min(plate.left(), view.right() - plate.width())));
    plate.moveTop(std::max(view.top(), std::min(plate.top(), view.bottom() - plate.height())));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(24, 26, 28, 150));
    painter.drawRoundedRect(plate, 4, 4);
    painter.setPen(ink);
    for (qsizetype i = 0; i < rows.size(); ++i)
        painter.drawText(QPointF(plate.left() + 7, plate.top() + 4 + metrics.ascent() + metrics.height() * double(i)),
                         rows[i]);
}
} // namespace

/// One of the six ends of the axis cross.
struct CViewOverlay::AxisEnd {
    QPointF at;
    double depth; ///< larger is nearer
    QColor colour;
    QString name;      ///< empty at the negative end
    double yaw, pitch; ///< the view from there
};

CViewOverlay::CViewOverlay(const CCamera& camera, QWidget* parent) : QWidget(parent), m_camera(camera) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
}

osg::Vec2d CViewOverlay::toView(const QPointF& at) const {
    return {2 * at.x() / std::max(1, width()) - 1, 1 - 2 * at.y() / std::max(1, height())};
}

std::optional<QPointF> CViewOverlay::toWidget(const osg::Vec3d& point) const {
    const osg::Vec3d place = m_camera.project(point, aspect());
    if (place.z() < 0) return {};
    return QPointF((place.x() + 1) / 2 * width(), (1 - place.y()) / 2 * height());
}

glm::dvec2 CViewOverlay::guidePoint(std::size_t handle, const QPointF& at) const {
    const auto [from, direction] = m_camera.rayAt(toView(at), aspect());
    const double height = m_model.guide->handles[handle].place(m_model.params, m_model.scaleTree).y;
    if (std::abs(m_camera.forward().z()) > kSteep) { // the level plane at its height
        const osg::Vec3d point = from - direction * ((from.z() - height) / direction.z());
        return {std::hypot(point.x(), point.y()), height};
    }
    // The upright plane through the trunk's axis that faces the eye.
    osg::Vec3d ahead = m_camera.forward();
    ahead.z() = 0;
    ahead.normalize();
    const osg::Vec3d point = from - direction * ((from * ahead) / (direction * ahead));
    return {std::hypot(point.x(), point.y()), std::max(point.z(), 0.0)};
}

QPointF CViewOverlay::handlePlace(std::size_t handle) const {
    const glm::dvec2 at = m_model.guide->handles[handle].place(m_model.params, m_model.scaleTree);
    osg::Vec3d aside = m_camera.right();
    aside.z() = 0;
    aside.normalize();
    return toWidget(aside * at.x + osg::Vec3d(0, 0, at.y)).value_or(QPointF(-1000, -1000));
}

std::optional<std::size_t> CViewOverlay::handleAt(const QPointF& at) const {
    for (std::size_t i = 0; m_model.guide && i < m_model.guide->handles.size(); ++i)
        if (QLineF(handlePlace(i), at).length() < kGrip) return i;
    return {};
}

/// From the foot of the tree to beyond its edge, on the ground.
std::optional<std::pair<QPointF, QPointF>> CViewOverlay::windArrow() const {
    if (!m_model.wind) return {};
    const double angle = *m_model.wind * osg::PI / 180;
    const osg::Vec3d along(std::cos(angle), std::sin(angle), 0);
    const auto from = toWidget(along * (kArrowStart * m_model.reach)), to = toWidget(along * (kArrowEnd * m_model.reach));
    if (!from || !to) return {};
    return std::pair(*from, *to);
}

bool CViewOverlay::isOnWindArrow(const QPointF& at) const {
    const auto arrow = windArrow();
    return arrow && QLineF(arrow->second, at).length() < 1.5 * kGrip;
}

std::optional<double> CViewOverlay::windDirectionAt(const QPointF& at) const {
    const auto [from, direction] = m_camera.rayAt(toView(at), aspect());
    if (std::abs(direction.z()) < 1e-6 || from.z() / direction.z() > 0) return {};
    const osg::Vec3d point = from - direction * (from.z() / direction.z());
    return std::atan2(point.y(), point.x()) * 180 / osg::PI;
}

void CViewOverlay::showBelow(const QImage& picture) {
    if (picture.isNull() && m_below.isNull()) return;
    m_below = picture;
    update();
}

void CViewOverlay::setWipe(std::optional<double> share) {
    m_wipe = share ? std::optional(std::clamp(*share, 0.02, 0.98)) : std::nullopt;
    update();
}

void CViewOverlay::showBefore(const QImage& picture) {
    m_before = picture;
    update();
}

bool CViewOverlay::isOnWipe(const QPointF& at) const { return m_wipe && std::abs(at.x() - *m_wipe * width()) < kGrip; }

void CViewOverlay::paintWipe(QPainter& painter) const {
    const double line = *m_wipe * width();
    if (!m_before.isNull()) {
        painter.save();
        painter.setClipRect(QRectF(0, 0, line, height()));
        painter.drawImage(rect(), m_before);
        painter.restore();
    }
    painter.setPen(QPen(QColor(0, 0, 0, 120), 4));
    painter.drawLine(QPointF(line, 0), QPointF(line, height()));
    painter.setPen(QPen(Qt::white, 2));
    painter.drawLine(QPointF(line, 0), QPointF(line, height()));
    painter.setBrush(Qt::white);
    painter.drawEllipse(QPointF(line, height() / 2.0), kHandleRadius, kHandleRadius);
    const double foot = height() - 12.0;
    drawPlate(painter, {line - 10, foot}, Qt::BottomRightCorner, {m_before.isNull() ? tr("Before …") : tr("Before")});
    drawPlate(painter, {line + 10, foot}, Qt::BottomLeftCorner, {tr("Now")});
}

void CViewOverlay::setHotHandle(std::optional<std::size_t> handle) {
    if (handle == m_hot) return;
    m_hot = handle;
    update();
}

/// Where neither the person nor the statistics stand.
QPointF CViewOverlay::axesMiddle() const { return {width() - kAxisMargin, kAxisMargin}; }

std::vector<CViewOverlay::AxisEnd> CViewOverlay::axisEnds() const {
    const QPointF middle = axesMiddle();
    const osg::Vec3d axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const QColor colours[] = {QColor(214, 76, 76), QColor(104, 168, 60), QColor(74, 128, 216)};
    const char* names[] = {"X", "Y", "Z"};
    const std::pair<double, double> views[][2] = {{{90, 0}, {-90, 0}}, {{180, 0}, {0, 0}}, {{0, 90}, {0, -90}}};
    std::vector<AxisEnd> ends;
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, 1}) {
            const osg::Vec3d to = axes[axis] * (side == 0 ? 1 : -1);
            ends.push_back({middle + kAxisReach * QPointF(to * m_camera.right(), -(to * m_camera.up())),
                            -(to * m_camera.forward()), colours[axis],
                            side == 0 ? QString::fromLatin1(names[axis]) : QString(), views[axis][side].first,
                            views[axis][side].second});
        }
    std::ranges::sort(ends, {}, &AxisEnd::depth);
    return ends;
}

std::optional<std::pair<double, double>> CViewOverlay::axisAt(const QPointF& at) const {
    const std::vector<AxisEnd> ends = axisEnds();
    const auto found = std::find_if(ends.rbegin(), ends.rend(), // the nearest is drawn last
                                    [&](const AxisEnd& e) { return QLineF(e.at, at).length() <= kAxisBall + 1; });
    if (found == ends.rend()) return {};
    return std::pair(found->yaw, found->pitch);
}

void CViewOverlay::drawLine(QPainter& painter, const std::vector<osg::Vec3d>& points) const {
    QPolygonF line;
    for (const osg::Vec3d& point : points)
        if (const auto at = toWidget(point)) line << *at;
    painter.drawPolyline(line);
}

/// Two meridians square to the view, and rings.
void CViewOverlay::paintGuide(QPainter& painter) const {
    if (!m_model.guide) return;
    const std::vector<glm::dvec2> profile = m_model.guide->profile(m_model.params, m_model.scaleTree);
    if (profile.empty()) return;
    const double yaw = std::atan2(m_camera.right().y(), m_camera.right().x());
    const auto at = [](const glm::dvec2& p, double angle) {
        return osg::Vec3d(p.x * std::cos(angle), p.x * std::sin(angle), p.y);
    };
    painter.setPen(QPen(kGuide, 1.8));
    for (const double angle : {yaw, yaw + osg::PI}) {
        std::vector<osg::Vec3d> meridian;
        for (const glm::dvec2& p : profile) meridian.push_back(at(p, angle));
        drawLine(painter, meridian);
    }
    painter.setPen(QPen(QColor(kGuide.red(), kGuide.green(), kGuide.blue(), 110), 1.2));
    for (std::size_t i = 8; i < profile.size(); i += 8) {
        std::vector<osg::Vec3d> ring;
        for (int k = 0; k <= kRingPoints; ++k) ring.push_back(at(profile[i], 2 * osg::PI * k / kRingPoints));
        drawLine(painter, ring);
    }
}

void CViewOverlay::paintHandles(QPainter& painter) const {
    for (std::size_t i = 0; m_model.guide && i < m_model.guide->handles.size(); ++i) {
        const QPointF at = handlePlace(i);
        const bool hot = m_hot == i;
        painter.setPen(QPen(QColor(40, 30, 10), 1.4));
        painter.setBrush(hot ? QColor(Qt::white) : kGuide);
        painter.drawEllipse(at, kHandleRadius + (hot ? 1.5 : 0), kHandleRadius + (hot ? 1.5 : 0));
        if (hot) drawPlate(painter, at + QPointF(14, -10), Qt::TopLeftCorner, {trText(m_model.guide->handles[i].text)});
    }
}

void CViewOverlay::setPose(const std::shared_ptr<const CWindTable>& table,
                           const std::shared_ptr<const WindPose>& pose) {
    m_table = table;
    m_pose = pose;
    if (!m_model.selection.lines.empty()) update();
}

/// Where they are seen.
std::vector<std::vector<osg::Vec3d>> CViewOverlay::selectedLines() const {
    const bool sways = m_pose && &m_table->tree() == m_model.selection.tree.get();
    std::vector<std::vector<osg::Vec3d>> lines;
    for (const auto& line : m_model.selection.lines) {
        std::vector<osg::Vec3d>& seen = lines.emplace_back();
        for (const TreePoint& point : line) {
            seen.push_back(point.at);
            if (!sways) continue;
            const SwayPlace place{static_cast<float>(m_table->nodeOf(point.generation, point.segment)), point.part};
            const glm::vec3 moved = Swayed(m_table->still(), *m_pose, place)
                                        .point({float(point.at.x()), float(point.at.y()), float(point.at.z())});
            seen.back() = osg::Vec3d(moved.x, moved.y, moved.z);
        }
    }
    return lines;
}

/// Thousands of lines are thin and without a rim: a hand waits for them.
void CViewOverlay::paintSelection(QPainter& painter) const {
    const auto lines = selectedLines();
    if (lines.size() > kManyLines) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setPen(QPen(kAccent, 1));
        for (const auto& line : lines) drawLine(painter, line);
        painter.setRenderHint(QPainter::Antialiasing);
        return;
    }
    for (const auto& [colour, wide] : {std::pair(QColor(0, 0, 0, 120), 5.0), {kAccent, 2.6}}) {
        painter.setPen(QPen(colour, wide, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        for (const auto& line : lines) drawLine(painter, line);
    }
}

void CViewOverlay::paintAxes(QPainter& painter) const {
    const QPointF middle = axesMiddle();
    QFont small = font();
    small.setBold(true);
    small.setPixelSize(10);
    painter.setFont(small);
    for (const AxisEnd& end : axisEnds()) {
        const bool positive = !end.name.isEmpty();
        QColor fill = end.colour;
        if (positive) {
            painter.setPen(QPen(end.colour, 2.2));
            painter.drawLine(middle, end.at);
        } else
            fill.setAlpha(90);
        painter.setPen(QPen(end.colour, 1.4));
        painter.setBrush(fill);
        painter.drawEllipse(end.at, kAxisBall, kAxisBall);
        painter.setPen(Qt::white);
        painter.drawText(QRectF(end.at - QPointF(kAxisBall, kAxisBall), QSizeF(2 * kAxisBall, 2 * kAxisBall)),
                         Qt::AlignCenter, end.name);
    }
    painter.setFont(font());
}

void CViewOverlay::paintWind(QPainter& painter) const {
    const auto arrow = windArrow();
    if (!arrow) return;
    const auto& [from, to] = *arrow;
    const QLineF shaft(to, from);
    QPolygonF head{to};
    for (const double turn : {-24.0, 24.0}) {
        QLineF side = QLineF::fromPolar(18, shaft.angle() + turn);
        side.translate(to);
        head << side.p2();
    }
    for (const auto& [colour, wide] : {std::pair(QColor(0, 0, 0, 110), 6.0), {kWind, 3.2}}) {
        painter.setPen(QPen(colour, wide, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawLine(from, to);
        painter.setBrush(colour);
        painter.drawPolygon(head);
    }
}

/// The way, and what of it goes up where it is neither level nor upright.
void CViewOverlay::paintRuler(QPainter& painter) const {
    if (!m_model.measured) return;
    const auto& [from, to] = *m_model.measured;
    const auto start = toWidget(from), end = toWidget(to);
    if (!start || !end) return;
    for (const auto& [colour, wide] : {std::pair(QColor(0, 0, 0, 130), 5.0), {QColor(Qt::white), 2.2}}) {
        painter.setPen(QPen(colour, wide, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(*start, *end);
        for (const QPointF& tip : {*start, *end}) {
            QLineF tick = QLineF::fromPolar(9, QLineF(*start, *end).angle() + 90);
            tick.translate(tip - tick.p2() / 2);
            painter.drawLine(tick);
        }
    }
    const double rise = std::abs(to.z() - from.z()), length = (to - from).length();
    QStringList rows{lengthText(length)};
    if (rise > kLevel * length && rise < (1 - kLevel) * length) rows << tr("Height %1").arg(lengthText(rise));
    drawPlate(painter, *end + QPointF(12, -8), Qt::TopLeftCorner, rows);
}

/// Above their places; those that would lie on each other step up.
void CViewOverlay::drawLabels(QPainter& painter) const {
    std::vector<QRectF> taken;
    for (const auto& [place, text] : m_model.labels) {
        const auto at = toWidget(place);
        if (!at) continue;
        const QStringList rows = text.split(QLatin1Char('\n'));
        QRectF plate(QPointF(), plateSize(fontMetrics(), rows));
        plate.moveCenter({at->x(), 0});
        plate.moveBottom(at->y() - 6);
        for (bool free = false; !free;) {
            const auto other = std::ranges::find_if(taken, [&](const QRectF& known) { return known.intersects(plate); });
            free = other == taken.end() || plate.top() < 0;
            if (!free) plate.moveBottom(other->top() - 2);
        }
        drawPlate(painter, plate.topLeft(), Qt::TopLeftCorner, rows);
        taken.push_back(plate);
    }
}

void CViewOverlay::paintWords(QPainter& painter) const {
    const auto drawCentred = [&](const QPointF& at, const QString& text) {
        const QStringList rows = text.split(QLatin1Char('\n'));
        drawPlate(painter, at - QPointF(plateSize(fontMetrics(), rows).width() / 2, 6), Qt::BottomLeftCorner, rows);
    };
    if (!m_model.statistics.isEmpty()) drawPlate(painter, {8, 8}, Qt::TopLeftCorner, m_model.statistics);
    if (m_model.person)
        if (const auto at = toWidget(*m_model.person)) drawCentred(*at, m_model.personText);
    drawLabels(painter);
    if (!m_model.badge.isEmpty()) drawCentred({width() / 2.0, 46}, m_model.badge);
    if (!m_model.selectionText.isEmpty())
        drawPlate(painter, {width() - 8.0, height() - 8.0}, Qt::BottomRightCorner,
                  m_model.selectionText.split(QLatin1Char('\n')), kAccent.lighter(150));
}

void CViewOverlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (!m_below.isNull()) painter.drawImage(rect(), m_below);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_wipe) paintWipe(painter);
    paintSelection(painter);
    paintGuide(painter);
    paintHandles(painter);
    paintWind(painter);
    paintRuler(painter);
    paintAxes(painter);
    paintWords(painter);
}

} // namespace stromar
