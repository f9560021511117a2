#pragma once
#include <osg/StateSet>
#include <osg/Uniform>

namespace stromar {

// What the shaders are told by name.
template <typename Value>
void setUniform(osg::StateSet* state, const char* name, osg::Uniform::Type type, const Value& value) {
    state->getOrCreateUniform(name, type)->set(value);
}
inline void setFloat(osg::StateSet* state, const char* name, double value) {
    setUniform(state, name, osg::Uniform::FLOAT, static_cast<float>(value));
}
inline void setVector(osg::StateSet* state, const char* name, const osg::Vec3& value) {
    setUniform(state, name, osg::Uniform::FLOAT_VEC3, value);
}
inline void setPair(osg::StateSet* state, const char* name, double x, double y) {
    setUniform(state, name, osg::Uniform::FLOAT_VEC2, osg::Vec2(static_cast<float>(x), static_cast<float>(y)));
}
inline void setInteger(osg::StateSet* state, const char* name, int value) { setUniform(state, name, osg::Uniform::INT, value); }

} // namespace stromar
