#pragma once
#include "stromar/tree/Wind.h"
#include <osg/StateSet>
#include <osg/Texture2D>
#include <osg/Uniform>

namespace stromar {

/// A tree's nodes on the graphics card, as the vertices' shaders read them: where they are in still air, and where the
/// wind has them.
class CSwayTables {
public:
    /// What shaders need is added to this state; the tables take these texture units.
    void addTo(osg::StateSet* state, unsigned rowsUnit, unsigned stillUnit);
    /// Another tree: its still pose.
    void setStill(const std::vector<glm::vec3>& nodes);
    /// A pose of the same tree at a time.
    void setPose(const WindPose& pose, double seconds, double loop);
    void setOff();

private:
    osg::ref_ptr<osg::Texture2D> m_rows = new osg::Texture2D, m_still = new osg::Texture2D;
    osg::ref_ptr<osg::Uniform> m_on = new osg::Uniform("swaying", 0.f),
                               m_time = new osg::Uniform("swayTime", osg::Vec2()),
                               m_size = new osg::Uniform("swaySize", osg::Vec2(1, 1));
    std::size_t m_count = 0;
};

} // namespace stromar
