#pragma once
#include "motion/SwayMoment.h"
#include "work/LatestTask.h"
#include <QElapsedTimer>
#include <QTimer>

namespace stromar {

class CGrowthController;
class CViewport;
class CWindPanel;
struct ViewModel;

/// Lets the tree in the viewport sway while the wind blows. Nothing is drawn when the air is still.
class CWindController : public QObject {
    Q_OBJECT
public:
    static constexpr double kLoop = 64; ///< seconds: motions repeat, so that the card never sees large times

    CWindController(CViewport& viewport, CWindPanel& panel, CGrowthController& growth, QObject* parent = nullptr);

    /// After the viewport got a model.
    void show(const std::shared_ptr<const ViewModel>& view);
    /// While something else moves the tree.
    void setPaused(bool paused);
    bool blowing() const { return m_timer.isActive(); }

private:
    void follow();
    void tick();
    void onPosed(const SwayMoment& moment, const std::shared_ptr<const WindPose>& pose);
    SwayMoment now() const;

    CViewport& m_viewport;
    CWindPanel& m_panel;
    CGrowthController& m_growth;
    std::shared_ptr<const ModelSway> m_sway; ///< of the model that is shown; null until one that sways has come
    QTimer m_timer;
    QElapsedTimer m_clock;
    bool m_paused = false;
    bool m_waiting = false; ///< for a pose
    std::optional<std::pair<SwayMoment, std::shared_ptr<const WindPose>>>
        m_ready;         ///< it is worked out while a picture is drawn
    CLatestTask m_poses; ///< last: it stops before anything it reports to is gone
};

} // namespace stromar
