#pragma once
#include "document/Document.h"
#include "work/TreeCreatorThread.h"
#include "view/Viewport.h"
#include "stromar/app/Methods.h"
#include <QObject>
#include <QTimer>

namespace stromar {

class CParamPanel;

/// What one sees of what one edits: brings viewport, panel and document together. Tints for a moment the generation of the value in
/// hand, draws the guides of crown and envelope, tells about the stem or leaf that was clicked.
class CViewController : public QObject {
    Q_OBJECT
public:
    CViewController(CViewport& viewport, CParamPanel& panel, CDocument& document, QObject* parent = nullptr);

    /// After the viewport got the model.
    void show(const std::shared_ptr<const ViewModel>& view);
    /// After a change of the values or of the unit.
    void updateOverlay();
    /// Switches of the look.
    void setLook(const std::function<void(ViewLook&)>& change);
    void setStatistics(bool on);
    /// As far away as the level of detail that is shown begins.
    void goToLod();
    /// Whether the level that is edited stays tinted; else it flashes when it is first touched.
    void setTintKept(bool on);
    /// The generation whose value has the focus, else ViewPart::kNone.
    int touched() const { return m_touched; }
    void clearSelection();
    bool hasSelection() const { return m_selected.has_value(); }
    /// Whether a handle is held.
    bool held() const { return m_dragging; }
    /// Asks for a picture behind the tree. False, perhaps with a message, when there is none to show.
    bool chooseBackdrop(QWidget* parent);
    /// Asks for a picture of a real tree and its height, which stands behind the tree; likewise.
    bool chooseReference(QWidget* parent);
    /// Asks for size and file, and writes a picture or the frames of a turntable.
    void savePicture(QWidget* parent);

signals:
    void released();
    void notice(const QString& text);

private:
    /// A stem or a leaf, by what stays the same when the tree grows anew.
    struct Selected {
        int generation;   ///< ViewPart::kLeaves for a leaf
        std::uint64_t id; ///< of the stem or the leaf
        std::uint32_t segment = 0; ///< of the stem
    };
    /// The branches that a point of a curve touches.
    struct HeldRange {
        ParamRef curve;
        double low, high; ///< not included
    };

    void onTouched(const std::optional<ParamRef>& ref);
    void endFlash();
    void onPicked(const std::optional<ViewHit>& hit);
    void onLineTouched(const ParamRef& ref, int line);
    void onRangeHeld(const ParamRef& curve, double low, double high);
    void onPanelReleased();
    const CTree* treeOfDocument() const;
    void selectSegments(const std::vector<std::vector<std::uint32_t>>& segments);
    void selectHeldRange();
    void showCurveUse();
    std::optional<SegmentPlace> selectedSegment() const;
    QStringList quantitiesAt(const SegmentPlace& place) const;
    void showWriterOf(std::size_t generation, std::size_t stem);
    void onDragged(std::size_t handle, const glm::dvec2& to, int gesture);
    void describeStem(std::size_t generation, const CStem& stem, std::size_t number);
    void describeLeaf(const CLeaf& leaf);
    void updateSelection();
    std::shared_ptr<const BackdropPicture> askForPicture(QWidget* parent, const QString& title, const QString& kinds);
    double shownLodDistance() const;
    QStringList statistics() const;
    int generationOf(const ParamRef& ref) const;
    const Guide* guideOf(const ParamRef& ref) const;

    CViewport& m_viewport;
    CParamPanel& m_panel;
    CDocument& m_document;
    std::shared_ptr<const ViewModel> m_view;
    std::optional<Selected> m_selected;
    std::optional<HeldRange> m_range;
    const Guide* m_guide = nullptr;
    bool m_statistics = false, m_dragging = false, m_tintKept = false;
    int m_touched = ViewPart::kNone; ///< the level whose value has the focus
    QTimer m_flash;
};

} // namespace stromar
