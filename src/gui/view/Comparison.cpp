#include "view/Comparison.h"
#include "view/Viewport.h"

namespace stromar {

CComparison::CComparison(CViewport& viewport, QObject* parent) : QObject(parent), m_viewport(viewport) {}

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
    emit notice(tr("Kept; A shows it in place of what you make of it"));
}

void CComparison::show(bool before) {
    if (before && !m_before.view) {
        emit notice(tr("Nothing was kept yet: Shift+A keeps the tree as it is"));
        emit shownChanged(false);
        return;
    }
    if (before == m_showsBefore) return;
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
