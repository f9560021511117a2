#pragma once
#include "stromar/tree/Fall.h"
#include <QObject>
#include <memory>
#include <optional>

class QWidget;

namespace stromar {

class CGrowthController;
class CTimeline;
class CViewport;
struct ModelSway;
struct ViewModel;

/// Fells the tree in the viewport: asks where to and where it is cut, shows it falling, and lets the timeline run over
/// the fall. Values may change meanwhile; every new model is felled likewise.
class CFallController : public QObject {
    Q_OBJECT
public:
    CFallController(CViewport& viewport, CTimeline& timeline, CGrowthController& growth, QObject* parent = nullptr);

    /// Asks first. False when the user has thought better of it.
    bool askAndFell(QWidget* parent);
    void fell(const Felling& felling);
    /// It stands again.
    void raise();
    const std::optional<Felling>& felling() const { return m_felling; }
    /// Instead of the viewport's show(): a new model, felled.
    void show(const std::shared_ptr<const ViewModel>& view);

signals:
    /// Whether one is felled now.
    void changed(bool felled);

private:
    void moveTo(double seconds);

    CViewport& m_viewport;
    CTimeline& m_timeline;
    CGrowthController& m_growth;
    std::shared_ptr<const ViewModel> m_view; ///< the last one
    std::optional<Felling> m_felling;
    std::optional<CFall> m_fall;
    std::shared_ptr<const ModelSway> m_cut; ///< of the model that is shown
    bool m_playNext = false;
};

} // namespace stromar
