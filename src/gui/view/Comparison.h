#pragma once
#include "work/TreeCreatorThread.h"
#include <QObject>
#include <QTimer>
#include <array>

namespace stromar {

class CViewport;

/// Before and after: keeps a tree as it is shown, to be shown again in place of the newer one. It costs the memory of a second tree.
class CComparison : public QObject {
    Q_OBJECT
public:
    CComparison(CViewport& viewport, QObject* parent);

    /// The tree as it is now. What was kept is no longer shown then.
    void setNow(const std::shared_ptr<const ViewModel>& view);
    void setSurface(Surface surface, const std::shared_ptr<const SurfaceMaps>& maps);
    void keep();
    /// What was kept, or again the tree as it is now: who shows that listens to shownChanged().
    void show(bool before);
    /// Both, with a line between them that can be dragged: before at its left. It is drawn anew when the view rests.
    void setWiping(bool on);

signals:
    void wipingChanged(bool on);
    void shownChanged(bool before);
    void notice(const QString& text);

private:
    struct State {
        std::shared_ptr<const ViewModel> view;
        std::array<std::shared_ptr<const SurfaceMaps>, kSurfaces.size()> surfaces;
    };
    void showSurfaces(const State& state, const State& instead);
    void renewWipe();
    void drawWipe();

    CViewport& m_viewport;
    State m_now, m_before;
    bool m_showsBefore = false;
    QTimer m_wipeTimer; ///< until the view rests
};

} // namespace stromar
