#pragma once
#include "stromar/mesh/Mesh.h"
#include <array>
#include <osg/Geometry>
#include <osg/Group>
#include <osg/Texture2D>
#include <string>
#include <vector>

namespace stromar {

/// A mesh ready to be drawn.
struct ViewPart {
    osg::ref_ptr<osg::Geometry> geometry;
    Surface surface;
};

/// What the viewport shows: the tree, the ground it stands on, the sky. All members: the thread that draws.
class CViewScene {
public:
    CViewScene();

    osg::Group* root() { return m_root; }
    /// Replaces the tree; parts that were shown before stay on the graphics card.
    void show(const std::vector<ViewPart>& parts);
    /// Empty on success, else why the picture cannot be shown; then the surface is plain.
    std::string setTexture(Surface surface, const std::string& file);
    void setWireframe(bool on);
    osg::BoundingBox bounds() const;

private:
    void updateLight();

    osg::ref_ptr<osg::Group> m_root, m_tree;
    std::array<osg::ref_ptr<osg::Group>, 2> m_surfaces;
    osg::ref_ptr<osg::Uniform> m_crownMiddle, m_crownSize;
};

} // namespace stromar
