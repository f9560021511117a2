#pragma once
#include <osg/StateSet>
#include <osg/Vec4>
#include <string>

namespace stromar {

/// The pictures of one surface on the graphics card: albedo on unit 0, normals on 1, roughness and what goes through on
/// 2, the under side on 4, and the uniforms `reliefDepth` and `underSide`, 0 where there are none. The maps are looked
/// for beside the albedo, as `mapFiles()` names them. Empty on success, else why the picture cannot be shown; then the
/// surface has the plain colour.
std::string showSurface(osg::StateSet* state, const std::string& file, const osg::Vec4& plain, bool cutOut);

/// Texture units, for those who use more.
constexpr unsigned kAlbedoUnit = 0, kReliefUnit = 1, kGlossUnit = 2, kShadowUnit = 3, kUnderUnit = 4;

} // namespace stromar
