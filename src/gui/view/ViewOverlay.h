#pragma once
#include "stromar/app/Methods.h"
#include "stromar/scene/Camera.h"
#include "stromar/tree/Wind.h"
#include <QImage>
#include <QStringList>
#include <QWidget>
#include <optional>

namespace stromar {

/// Lines, handles and words above the picture of the tree: antialiased, never part of what is exported. It takes no
/// mouse events; the viewport asks it what lies under the mouse.
class CViewOverlay : public QWidget {
    Q_OBJECT
public:
    /// A point on a segment of a tree in still air.
    struct TreePoint {
        osg::Vec3d at;
        std::uint32_t generation, segment;
        float part; ///< of the way along the segment, 0..1
    };
    /// Lines on a tree.
    struct Selection {
        std::shared_ptr<const CTree> tree;
        std::vector<std::vector<TreePoint>> lines;
    };
    /// Everything it draws.
    struct Model {
        CParams params;
        double scaleTree = 10; ///< metres
        const Guide* guide = nullptr; ///< null: none
        Selection selection; ///< lines to emphasise
        QString selectionText;
        QStringList statistics;
        std::optional<osg::Vec3d> person; ///< top of the head
        QString personText;
        std::optional<double> wind; ///< degrees: where it blows to
        double reach = 1;           ///< metres from the trunk to the tree's edge
        std::optional<std::pair<osg::Vec3d, osg::Vec3d>> measured; ///< the ends of the ruler
        std::vector<std::pair<osg::Vec3d, QString>> labels;        ///< words above places
        QString badge;                                             ///< what is shown in place of the tree; empty: the tree
    };

    explicit CViewOverlay(const CCamera& camera, QWidget* parent);

    Model& model() { return m_model; }
    /// The selection follows a pose of its tree; null: still air.
    void setPose(const std::shared_ptr<const CWindTable>& table, const std::shared_ptr<const WindPose>& pose);
    /// The handle under a place of the widget.
    std::optional<std::size_t> handleAt(const QPointF& at) const;
    /// Where a handle is drawn.
    QPointF handlePlace(std::size_t handle) const;
    /// Where a handle is dragged to: distance from the trunk's axis and height, metres. From above or below the height
    /// stays.
    glm::dvec2 guidePoint(std::size_t handle, const QPointF& at) const;
    /// Whether the tip of the wind's arrow lies under a place, and where it would point from there; nothing where the ground is not seen.
    bool isOnWindArrow(const QPointF& at) const;
    std::optional<double> windDirectionAt(const QPointF& at) const;
    /// A picture in place of what the viewport draws below; null: none.
    void showBelow(const QImage& picture);
    void setHotHandle(std::optional<std::size_t> handle);
    /// A line between before, at its left, and now: at a part of the width, 0..1; nothing: there is none.
    void setWipe(std::optional<double> share);
    const std::optional<double>& wipe() const { return m_wipe; }
    /// What is at the left of the line; null: it is still to come.
    void showBefore(const QImage& picture);
    bool hasBefore() const { return !m_before.isNull(); }
    bool isOnWipe(const QPointF& at) const;
    /// Yaw and pitch of the axis under a place of the widget.
    std::optional<std::pair<double, double>> axisAt(const QPointF& at) const;

    /// −1 … 1, y up.
    osg::Vec2d toView(const QPointF& at) const;
    /// Nothing behind the eye.
    std::optional<QPointF> toWidget(const osg::Vec3d& point) const;
    double aspect() const { return double(width()) / std::max(1, height()); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct AxisEnd;
    QPointF axesMiddle() const;
    std::vector<AxisEnd> axisEnds() const;
    void paintGuide(QPainter& painter) const;
    void paintHandles(QPainter& painter) const;
    void paintSelection(QPainter& painter) const;
    void paintAxes(QPainter& painter) const;
    void paintWind(QPainter& painter) const;
    std::optional<std::pair<QPointF, QPointF>> windArrow() const;
    void paintRuler(QPainter& painter) const;
    void paintWords(QPainter& painter) const;
    void drawLabels(QPainter& painter) const;
    void paintWipe(QPainter& painter) const;
    void drawLine(QPainter& painter, const std::vector<osg::Vec3d>& points) const;
    std::vector<std::vector<osg::Vec3d>> selectedLines() const;

    const CCamera& m_camera;
    Model m_model;
    std::shared_ptr<const CWindTable> m_table;
    std::shared_ptr<const WindPose> m_pose;
    std::optional<std::size_t> m_hot;
    QImage m_below, m_before;
    std::optional<double> m_wipe;
};

} // namespace stromar
