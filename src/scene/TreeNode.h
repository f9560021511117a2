#pragma once
#include "stromar/scene/ViewScene.h"
#include <osg/MatrixTransform>

namespace stromar {

constexpr unsigned kInstancesMask = 2; ///< of nodes whose triangles OpenSceneGraph does not know
/// What a scene without a tree is framed by.
inline const osg::BoundingBox kNoTree(-1, -1, 0, 1, 1, 2);

/// Tells the shaders the room of leaves whose shade they compute.
void setCrown(osg::StateSet* state, const osg::BoundingBox& room);

/// One tree of the scene: a group for each surface with its pictures, and the parts that show it. Its uniforms are those of the tree
/// alone, but for the pose of the wind.
class CTreeNode {
public:
    CTreeNode();

    osg::Group* node() { return m_node; }
    void standAt(const osg::Vec3& place);
    /// Without `instancing` leaves get vertices of their own.
    void show(const std::vector<ViewPart>& parts, bool instancing);
    void setSurface(Surface surface, const SurfaceMaps& maps);
    void showLeaves(bool on);
    /// Edges of leaves as soft as the frame buffer's samples allow.
    void smoothEdges(bool on);
    void limitInstances(std::size_t vertices);
    /// Stems thinner than this on the average do not hide others: many faint ones together are dense.
    void seeThrough(double radius);
    /// What the graphics card has a copy of.
    void releaseInstances();

    const std::vector<ViewPart>& parts() const { return m_parts; }
    /// What draws a part: its geometry, or one without instances.
    osg::Geometry& drawn(std::size_t part) { return *m_drawn[part]; }
    const osg::Vec3& place() const { return m_place; }
    /// As it stands in the scene.
    osg::BoundingBox bounds() const;

private:
    osg::StateSet& stateOf(Surface surface) { return *m_surfaces[static_cast<std::size_t>(surface)]->getOrCreateStateSet(); }
    void shareBarks();
    void updateCrown();

    osg::ref_ptr<osg::MatrixTransform> m_node = new osg::MatrixTransform;
    std::array<osg::ref_ptr<osg::Group>, kSurfaces.size()> m_surfaces;
    std::vector<ViewPart> m_parts;
    std::vector<osg::ref_ptr<osg::Geometry>> m_drawn;
    osg::Vec3 m_place;
};

} // namespace stromar
