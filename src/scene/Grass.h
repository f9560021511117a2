#pragma once
#include <osg/Geometry>
#include <osg/BoundingBox>

namespace stromar {

/// Tufts on the ground about the foot of the tree, the denser the nearer.
class CGrass {
public:
    CGrass();

    osg::Node* node() { return m_node; }
    /// It stays below the tree's box, whose room it shares; small trees stand in small grass.
    void setTree(const osg::BoundingBox& tree);
    /// With the functions of the light in front of the fragments' shader.
    void setLooks(const char* looks);

private:
    osg::ref_ptr<osg::Geometry> m_node;
    osg::ref_ptr<osg::Uniform> m_size; ///< metres to the farthest tuft; blades times this
};

} // namespace stromar
