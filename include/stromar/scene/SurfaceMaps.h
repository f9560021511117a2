#pragma once
#include "stromar/model/Material.h"
#include <memory>
#include <osg/Image>
#include <osg/StateSet>
#include <osg/ref_ptr>
#include <string>

namespace stromar {

/// The pictures of a surface as the graphics card wants them. Immutable.
struct SurfaceMaps {
    osg::ref_ptr<osg::Image> albedo, relief, gloss; ///< gloss: red roughness, green what goes through
    osg::ref_ptr<osg::Image> under;                 ///< albedo of the under side; null: like the upper one
    bool bumpy = false;                             ///< the relief is a picture
    std::string problem;                            ///< why its picture cannot be shown; then it is plain
};

/// Reads a picture, and its maps where mapBeside() names some; without a file the surface is plain. Any thread; some
/// hundredths of a second.
std::shared_ptr<const SurfaceMaps> readSurface(Surface surface, const std::string& file);

/// Puts them on the texture units, and sets the uniforms `reliefDepth` and `underSide`.
void showSurface(osg::StateSet& state, const SurfaceMaps& maps);

/// Texture units, for those who use more.
constexpr unsigned kAlbedoUnit = 0, kReliefUnit = 1, kGlossUnit = 2, kShadowUnit = 3, kUnderUnit = 4, kSwayRowsUnit = 5, kSwayStillUnit = 6, kBackdropUnit = 13; // 7 to 12: NeighbourBarks

} // namespace stromar
