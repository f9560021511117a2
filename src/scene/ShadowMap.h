#pragma once
#include <osg/BoundingBox>
#include <osg/BoundingSphere>
#include <osg/Camera>
#include <osg/Texture2D>
#include <osg/Uniform>

namespace stromar {

/// How far the sun reaches: a picture of depths seen from it. Drawn anew only when it is stale; other frames keep it.
class CShadowMap {
public:
    /// `casters` are what throws shadows; they stay where they are in the scene.
    explicit CShadowMap(osg::Group* casters);

    /// To be put into the scene: draws the map before everything else.
    osg::Camera* camera() { return m_camera; }
    /// What shaders need is added to this state. The map takes this texture unit.
    void addTo(osg::StateSet* state, unsigned unit) const;
    void aim(const osg::BoundingBox& box, const osg::Vec3& sun);
    const osg::BoundingBox& aimedAt() const { return m_box; }
    /// Whether all of a box lies where it is aimed at.
    bool covers(const osg::BoundingBox& box) const;
    /// Pixels of a side; 0 for no shadows.
    void setSize(int size);
    /// Wood thinner than a texel throws a line of shadow or none, instead of dots; not for means of several maps.
    void setLines(bool on);
    void setStale();
    bool stale() const { return m_camera->getNodeMask() != 0; }
    /// After a frame: the map is there now.
    void setDrawn();

private:
    void resize();
    void lift(); ///< what depends on the size of a texel

    osg::ref_ptr<osg::Camera> m_camera;
    osg::ref_ptr<osg::Texture2D> m_depth;
    osg::ref_ptr<osg::Uniform> m_texel, m_matrix, m_offset, m_thinnest;
    osg::BoundingBox m_box;
    osg::BoundingSphered m_aimed; ///< about the box
    int m_size = 2048;
    bool m_lines = true;
};

} // namespace stromar
