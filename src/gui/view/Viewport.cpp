#include "view/Viewport.h"
#include "window/Display.h"
#include "document/Gesture.h"
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <cmath>
#include <utility>

namespace stromar {

namespace {
constexpr std::chrono::milliseconds kSettle{200}, kLongestSettle{1500}, kMoving{1000};
constexpr double kClickPixels = 4; // a drag is longer
constexpr std::size_t kMovingVertices = 4'000'000, kMovingVerticesInSoftware = 160'000; // of all leaves
constexpr std::size_t kFewestVertices = 60'000;
constexpr qint64 kSlowNs = 90'000'000,
                 kSmoothNs = 50'000'000; // a moving picture that wants fewer leaves, or may have more
constexpr qint64 kQuickNs = 12'000'000; // a picture with its shadows
constexpr int kShadowEvery = 6;         // poses, where it is slower
constexpr double kAir = 1.12; // about a tree that fills the view
constexpr double kDegreesPerPixel = 0.35;
constexpr double kZoomPerPixel = 0.006, kZoomPerNotch = 0.14;
std::size_t mostVertices() { return display::bestSamples() > 0 ? kMovingVertices : kMovingVerticesInSoftware; }
} // namespace

CViewport::CViewport(QWidget* parent)
    : QOpenGLWidget(parent), m_renderer(m_scene), m_overlay(new CViewOverlay(m_camera, this)),
      m_rest([this](const ViewPass& pass) { return restPass(pass); }, this),
      m_navigation(&navigationTable().front()) {
    setFormat(display::surfaceFormat(display::bestSamples()));
    m_camera.lookFrom(0, 5);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    m_organVertices = mostVertices();
    setMinimumSize(160, 160);
    setAccessibleName(tr("Picture of the tree"));
    connect(&m_rest, &CRestPicture::refined, this, [this] { m_overlay->showBelow(m_rest.image()); });
    connect(this, &QOpenGLWidget::frameSwapped, this, &CViewport::adaptToHand); // software rasterises after paintGL()
    m_settle.setSingleShot(true);
    connect(&m_settle, &QTimer::timeout, this, [this] {
        m_scene.renewShadows();
        redraw();
    });
}

CViewport::~CViewport() {
    disconnect(m_contextDies); // else ~QOpenGLWidget calls into what is already destroyed
    release();
}

void CViewport::release() {
    if (!m_renderer.attached()) return;
    makeCurrent();
    m_restBuffer.reset();
    m_renderer.detach();
    doneCurrent();
}

void CViewport::initializeGL() {
    m_lost = false;
    m_renderer.attach(display::bestSamples());
    disconnect(m_contextDies);
    m_contextDies = connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { release(); });
}

void CViewport::resizeGL(int, int) {
    m_overlay->setGeometry(rect());
    redraw();
}

void CViewport::paintGL() {
    if (!context()->isValid()) {
        if (!std::exchange(m_lost, true)) emit contextLost();
        return;
    }
    m_sincePaint.start();
    const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
    ViewPass plain;
    plain.organVertices = hurries() ? m_organVertices : mostVertices(); // the passes of a view that rests have all
    plain.standIn = drawsStandIn() && m_scene.look().wireframe == Wireframe::Off; // who looks at edges wants the tree's own
    m_renderer.draw(defaultFramebufferObject(), pixels.width(), pixels.height(), m_camera, plain);
    m_frameNs = m_sincePaint.nsecsElapsed();
    ++m_frames;
    emit drawn();
}

bool CViewport::hurries() const { return moves() || m_settle.isActive(); }

bool CViewport::moves() const { return m_sinceMoved.isValid() && m_sinceMoved.elapsed() < kMoving.count(); }

/// A view that moves too slowly gets a simpler model of the tree, then fewer leaves, larger ones; a quick one more
/// leaves.
void CViewport::adaptToHand() {
    if (!hurries() || !m_sincePaint.isValid()) return;
    const qint64 took = m_sincePaint.nsecsElapsed();
    m_sincePaint.invalidate();
    if (took > kSlowNs && !m_wantsStandIn && m_scene.hasStandIn()) {
        m_wantsStandIn = true;
        return;
    }
    if (took > kSlowNs) m_organVertices = std::max(kFewestVertices, m_organVertices / 2);
    if (took < kSmoothNs) m_organVertices = std::min(mostVertices(), 2 * m_organVertices);
}

/// Where the view has changed; paintGL() is called for a window that was covered, too.
void CViewport::redraw() {
    m_rest.restart();
    m_overlay->showBelow({});
    update();
}

void CViewport::changed() {
    emit viewChanged();
    m_overlay->update();
    redraw();
}

void CViewport::show(const std::vector<ViewPart>& parts) {
    m_scene.setStandIn({});
    m_scene.show(parts, m_settle.isActive() ? CViewScene::Shadows::Kept : CViewScene::Shadows::New);
    m_overlay->setPose(nullptr, nullptr); // until the next one
    // A tree that grows slower than the hand moves has not come to rest between two steps.
    const std::chrono::milliseconds sinceLast =
        m_sinceShown.isValid() ? std::chrono::milliseconds(m_sinceShown.elapsed()) : kLongestSettle;
    m_settle.start(2 * sinceLast < kLongestSettle ? std::max(2 * sinceLast, kSettle) : kSettle);
    m_sinceShown.start();
    changed();
}

/// The next step of a dragged value is as slow as the last one: it does not have to be seen anew.
void CViewport::setStandIn(const std::vector<ViewPart>& parts, StandIn when) {
    m_scene.setStandIn(parts);
    if (when == StandIn::InMotion || m_standIn != when || !hurries()) m_wantsStandIn = false;
    m_standIn = when;
}

void CViewport::showBeside(const std::vector<TreeBeside>& others) {
    m_scene.showBeside(others);
    m_settle.start(kSettle);
    changed();
}

void CViewport::setPose(const std::shared_ptr<const ModelSway>& sway, const std::shared_ptr<const WindPose>& pose, double seconds,
                        double loop) {
    const bool behind = m_frameNs > kQuickNs && ++m_posesSinceShadows < kShadowEvery;
    if (!behind) m_posesSinceShadows = 0;
    m_scene.setPose(sway, pose, seconds, loop, behind ? CViewScene::Shadows::Kept : CViewScene::Shadows::New);
    m_overlay->setPose(sway->table, pose);
    redraw();
}

void CViewport::endSway() {
    m_scene.endSway();
    m_overlay->setPose(nullptr, nullptr);
    redraw();
}

void CViewport::showWindArrow(std::optional<double> degrees) {
    m_overlay->model().wind = degrees;
    m_overlay->update();
}

void CViewport::setSurface(Surface surface, const SurfaceMaps& maps) {
    m_scene.setSurface(surface, maps);
    redraw();
}

void CViewport::setLook(const ViewLook& look) {
    m_scene.setLook(look);
    changed();
}

void CViewport::tint(int generation) {
    if (generation == m_scene.tinted()) return;
    m_scene.tint(generation);
    redraw();
}

void CViewport::setTrackball(bool on) {
    m_trackball = on;
    if (!on) m_camera.straighten();
    changed();
}

void CViewport::setOrthographic(bool on) {
    m_camera.setOrthographic(on);
    changed();
}

void CViewport::recentre() {
    m_camera.lookFrom(0, 5);
    frame();
}

void CViewport::frame() {
    if (const auto points = m_scene.outline(); !points.empty()) {
        const double free = 1 - double(m_covered) / std::max(1, height());
        m_camera.fit(points, m_overlay->aspect() / free);
        m_camera.zoom(kAir / free);
        m_camera.pan({0, 1 - free}, m_overlay->aspect());
    } else {
        m_camera.frame(osg::BoundingBoxd(-1, -1, 0, 1, 1, 2), m_overlay->aspect());
    }
    changed();
}

void CViewport::setMeasuring(bool on) {
    m_measuring = on;
    setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
    m_overlay->model().measured.reset();
    m_overlay->update();
}

osg::Vec3d CViewport::measuredPoint(const QPointF& at) const {
    const auto [from, direction] = m_camera.rayAt(m_overlay->toView(at), m_overlay->aspect());
    if (const auto hit = m_scene.pick(from, direction)) return hit->point;
    const osg::Vec3d ahead = m_camera.forward();
    return from + direction * (((m_camera.centre() - from) * ahead) / (direction * ahead));
}

void CViewport::measureTo(const QPointF& at) {
    auto& measured = m_overlay->model().measured;
    const osg::Vec3d point = measuredPoint(at);
    measured = std::pair(measured ? measured->first : point, point);
    m_overlay->update();
}

void CViewport::setCamera(const CCamera& camera) {
    m_camera = camera;
    changed();
}

void CViewport::moveTo(double distance) {
    m_camera.zoom(distance / m_camera.distance());
    changed();
}

void CViewport::lookFrom(double yaw, double pitch) {
    m_camera.lookFrom(yaw, pitch);
    frame();
}

std::unique_ptr<QOpenGLFramebufferObject> CViewport::makeBuffer(const QSize& pixels) {
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
    format.setSamples(display::bestSamples());
    return std::make_unique<QOpenGLFramebufferObject>(pixels, format);
}

QImage CViewport::draw(QOpenGLFramebufferObject& buffer, const CCamera& camera, const ViewPass& pass) {
    if (!buffer.isValid()) return {};
    m_renderer.draw(buffer.handle(), buffer.width(), buffer.height(), camera, pass);
    return buffer.toImage();
}

/// Nothing while shadows have to follow or something moves.
QImage CViewport::restPass(const ViewPass& pass) {
    if (!m_renderer.attached() || !isVisible() || m_settle.isActive()) return {};
    makeCurrent();
    const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
    if (!m_restBuffer || m_restBuffer->size() != pixels) m_restBuffer = makeBuffer(pixels);
    const ViewPass shifted{.pixel = pass.pixel, .pattern = pass.pattern, .alone = false}; // the sun's disc would cost shadows of its own
    QImage image = draw(*m_restBuffer, m_camera, shifted);
    doneCurrent();
    return image;
}

QImage CViewport::picture(const QSize& pixels, const ViewLook& look, const CCamera& camera, int passes) {
    if (!m_renderer.attached()) return {};
    makeCurrent();
    m_scene.renewShadows();
    const ViewLook before = m_scene.look();
    const int tinted = m_scene.tinted();
    m_scene.setLook(look);
    m_scene.tint(ViewPart::kNone);
    QImage image;
    {
        const auto buffer = makeBuffer(pixels);
        image = smoothPicture(passes, [&](const ViewPass& pass) { return draw(*buffer, camera, pass); });
    }
    m_scene.setLook(before);
    m_scene.tint(tinted);
    doneCurrent();
    return image;
}

QImage CViewport::pictureOf(const TreeLook& tree, const TreeLook& instead) {
    if (!m_renderer.attached()) return {};
    const auto put = [this](const TreeLook& look, CViewScene::Shadows shadows) {
        m_scene.show(*look.parts, shadows);
        for (const auto& [surface, maps] : look.surfaces) m_scene.setSurface(surface, *maps);
    };
    makeCurrent(); // before anything of the scene goes
    put(tree, CViewScene::Shadows::New);
    const QImage image = picture((QSizeF(size()) * devicePixelRatioF()).toSize(), look(), m_camera, CRestPicture::kFramePasses);
    put(instead, CViewScene::Shadows::New);
    return image;
}

void CViewport::mousePressEvent(QMouseEvent* event) {
    if (m_handle) return; // another button does not let go of it
    const QPointF at = event->position();
    if (event->buttons() == Qt::LeftButton && m_overlay->isOnWipe(at)) {
        m_wipeHeld = true;
        return;
    }
    m_pressed = m_last = at;
    m_click = event->buttons() == Qt::LeftButton;
    m_windHeld = m_click && m_overlay->isOnWindArrow(at);
    m_handle = m_click && !m_windHeld ? m_overlay->handleAt(at) : std::nullopt;
    if (m_click && m_measuring) m_overlay->model().measured.reset();
    if (m_handle) m_gesture = nextGesture();
}

void CViewport::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    if (event->buttons() == Qt::NoButton) {
        m_overlay->setHotHandle(m_overlay->handleAt(at));
        setCursor(m_overlay->isOnWipe(at) ? Qt::SplitHCursor : m_measuring ? Qt::CrossCursor : Qt::ArrowCursor);
        return;
    }
    if (m_wipeHeld) return m_overlay->setWipe(at.x() / std::max(1, width()));
    if (m_windHeld) {
        if (const auto degrees = m_overlay->windDirectionAt(at)) emit windDragged(*degrees);
        return;
    }
    if (m_handle) {
        emit guideDragged(*m_handle, m_overlay->guidePoint(*m_handle, at), m_gesture);
        return;
    }
    if (m_measuring && event->buttons() == Qt::LeftButton) {
        if (m_click) measureTo(m_pressed);
        m_click = false;
        return measureTo(at);
    }
    if (m_click && QLineF(m_pressed, at).length() < kClickPixels) return;
    m_click = false;
    moveView(motionOf(*m_navigation, event->buttons(), event->modifiers()), m_last, at);
    m_last = at;
}

void CViewport::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    if (m_wipeHeld) {
        m_wipeHeld = false;
    } else if (m_windHeld) {
        m_windHeld = false;
    } else if (m_handle) {
        m_handle.reset();
        emit guideReleased();
    } else if (m_click)
        pick(event->position());
    m_click = false;
}

void CViewport::mouseDoubleClickEvent(QMouseEvent* event) { mousePressEvent(event); }

void CViewport::hideEvent(QHideEvent* event) {
    if (std::exchange(m_handle, {})) emit guideReleased();
    QOpenGLWidget::hideEvent(event);
}

void CViewport::leaveEvent(QEvent*) { m_overlay->setHotHandle({}); }

void CViewport::moveView(ViewMotion motion, const QPointF& from, const QPointF& to) {
    const QPointF by = to - from;
    if (motion == ViewMotion::Turn && m_trackball)
        m_camera.roll(m_overlay->toView(from), m_overlay->toView(to));
    else if (motion == ViewMotion::Turn)
        m_camera.turn(-by.x() * kDegreesPerPixel, by.y() * kDegreesPerPixel);
    else if (motion == ViewMotion::Pan)
        m_camera.pan(m_overlay->toView(to) - m_overlay->toView(from), m_overlay->aspect());
    else if (motion == ViewMotion::Zoom)
        m_camera.zoom(std::exp(by.y() * kZoomPerPixel));
    if (motion == ViewMotion::None) return;
    m_sinceMoved.start();
    changed();
}

/// Towards what lies under the mouse.
void CViewport::wheelEvent(QWheelEvent* event) {
    const QPoint turned = event->angleDelta();
    const double notches = (turned.y() != 0 ? turned.y() : turned.x()) / 120.0;
    if (notches == 0) return;
    event->accept();
    const osg::Vec2d place = m_overlay->toView(event->position());
    const double before = m_camera.halfHeight();
    m_camera.zoom(std::exp(-notches * kZoomPerNotch));
    m_camera.pan(place * (m_camera.halfHeight() == 0 ? 0 : 1 - before / m_camera.halfHeight()), m_overlay->aspect());
    changed();
}

void CViewport::pick(const QPointF& at) {
    if (const auto axis = m_overlay->axisAt(at)) return lookFrom(axis->first, axis->second);
    const auto [from, direction] = m_camera.rayAt(m_overlay->toView(at), m_overlay->aspect());
    emit picked(m_scene.pick(from, direction));
}

} // namespace stromar
