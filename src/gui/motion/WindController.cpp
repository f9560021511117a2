#include "motion/WindController.h"
#include "motion/WindPanel.h"
#include "view/Viewport.h"
#include "work/GrowthController.h"
#include <cmath>

namespace stromar {

namespace {
constexpr int kFrameMs = 16;
}

CWindController::CWindController(CViewport& viewport, CWindPanel& panel, CGrowthController& growth, QObject* parent)
    : QObject(parent), m_viewport(viewport), m_panel(panel), m_growth(growth), m_poses(*this) {
    m_timer.setInterval(kFrameMs);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &CWindController::tick);
    connect(&m_panel, &CWindPanel::switched, this, &CWindController::follow);
    connect(&m_panel, &CWindPanel::changed, this, &CWindController::follow);
    connect(&m_viewport, &CViewport::windDragged, &m_panel, &CWindPanel::setDirection);
}

void CWindController::follow() {
    const bool blows = m_panel.blowing() && !m_paused;
    m_viewport.showWindArrow(blows ? std::optional(m_panel.direction()) : std::nullopt);
    if (!m_paused) m_growth.setSwaying(blows);
    if (blows == m_timer.isActive()) return;
    if (blows) {
        if (!m_clock.isValid()) m_clock.start();
        m_timer.start();
    } else {
        m_timer.stop();
        m_ready.reset();
        if (!m_paused) m_viewport.endSway();
    }
}

void CWindController::setPaused(bool paused) {
    m_paused = paused;
    follow();
}

void CWindController::show(const std::shared_ptr<const ViewModel>& view) {
    m_sway = view->sway;
    if (!m_sway || !blowing()) return;
    const SwayMoment moment = now();
    m_viewport.setPose(m_sway, moment.pose(), moment.seconds, kLoop);
}

SwayMoment CWindController::now() const {
    Wind wind = m_panel.wind();
    wind.loop = kLoop;
    return {m_sway, wind, std::fmod(double(m_clock.elapsed()) / 1000, kLoop)};
}

void CWindController::tick() {
    if (!m_sway || !m_viewport.isVisible()) return;
    if (m_ready && m_ready->first.sway == m_sway)
        m_viewport.setPose(m_sway, m_ready->second, m_ready->first.seconds, kLoop);
    m_ready.reset();
    if (m_waiting) return;
    m_waiting = true;
    m_poses.run([this, moment = now()](const CProgress&) -> CLatestTask::Then {
        return [this, moment, pose = moment.pose()] { onPosed(moment, pose); };
    });
}

void CWindController::onPosed(const SwayMoment& moment, const std::shared_ptr<const WindPose>& pose) {
    m_waiting = false;
    m_ready.emplace(moment, pose);
}

} // namespace stromar
