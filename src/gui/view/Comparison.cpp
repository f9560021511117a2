#include "view/Comparison.h"
#include "view/Viewport.h"

namespace stromar {

namespace {
constexpr std::chrono::milliseconds kWipeRest{250}; // without a change, and longer than shadows take to follow
}

CComparison::CComparison(CViewport& viewport, QObject* parent) : QObject(parent), m_viewport(viewport) {
    m_wipeTimer.setSingleShot(true);
    m_wipeTimer.setInterval(kWipeRest);
    connect(&m_wipeTimer, &QTimer::timeout, this, &CComparison::drawWipe);
    connect(&m_viewport, &CViewport::viewChanged, this, &CComparison::renewWipe);
}

void CComparison::setWiping(bool on) {
    if (on && !m_before.view) {
        emit notice(tr("Nothing was kept yet: Shift+A keeps the tree as it is"));
        emit wipingChanged(false);
        return;
    }
    if (on) show(false);
    m_viewport.overlay().setWipe(on ? std::optional(0.5) : std::nullopt);
    renewWipe();
    emit wipingChanged(on);
}

/// The picture is of another view: it goes until there is a new one.
void CComparison::renewWipe() {
    m_viewport.overlay().showBefore({});
    if (m_viewport.overlay().wipe())
        m_wipeTimer.start();
    else
        m_wipeTimer.stop();
}

void CComparison::drawWipe() {
    if (!m_viewport.overlay().wipe() || !m_before.view || !m_now.view) return;
    if (m_viewport.settling()) return m_wipeTimer.start();
    const auto lookOf = [](const State& state, const State& other) {
        CViewport::TreeLook look{&state.view->parts, {}};
        for (const Surface surface : kSurfaces) {
            const auto& maps = state.surfaces[static_cast<std::size_t>(surface)];
            if (maps && maps != other.surfaces[static_cast<std::size_t>(surface)]) look.surfaces.emplace_back(surface, maps.get());
        }
        return look;
    };
    m_viewport.overlay().showBefore(m_viewport.pictureOf(lookOf(m_before, m_now), lookOf(m_now, m_before)));
}

void CComparison::setNow(const std::shared_ptr<const ViewModel>& view) {
    m_now.view = view;
    show(false);
}

void CComparison::setSurface(Surface surface, const std::shared_ptr<const SurfaceMaps>& maps) {
    m_now.surfaces[static_cast<std::size_t>(surface)] = maps;
    if (!m_showsBefore) m_viewport.setSurface(surface, *maps);
}

void CComparison::keep() {
    show(false);
    m_before = m_now;
    renewWipe();
    emit notice(tr("Kept; A shows it in place of what you make of it"));
}

void CComparison::show(bool before) {
    if (before && !m_before.view) {
        emit notice(tr("Nothing was kept yet: Shift+A keeps the tree as it is"));
        emit shownChanged(false);
        return;
    }
    if (before == m_showsBefore) return;
    if (before) setWiping(false);
    m_showsBefore = before;
    if (before) {
        m_viewport.endSway();
        m_viewport.show(m_before.view->parts);
    }
    showSurfaces(before ? m_before : m_now, before ? m_now : m_before);
    m_viewport.overlay().model().badge = before ? tr("Before") : QString();
    m_viewport.overlay().update();
    emit shownChanged(before);
}

void CComparison::showSurfaces(const State& state, const State& instead) {
    for (const Surface surface : kSurfaces) {
        const auto i = static_cast<std::size_t>(surface);
        if (state.surfaces[i] && state.surfaces[i] != instead.surfaces[i]) m_viewport.setSurface(surface, *state.surfaces[i]);
    }
}

} // namespace stromar
