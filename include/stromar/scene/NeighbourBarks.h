#pragma once
#include "stromar/mesh/Mesh.h"
#include "stromar/model/TreeModel.h"
#include <array>
#include <osg/StateSet>

namespace stromar {

/// A bark that another gives way to where wood is thicker, or thinner, than the stems of its own level are.
struct NeighbourBark {
    Surface surface = Surface::Bark;
    float from = 0; ///< VertexLook::thinness over 255 where it begins
    float rate = 0; ///< by which its share grows with that; below 0 towards thick wood; 0: there is none
};
/// The one before and the one after, by level.
using NeighbourBarks = std::array<NeighbourBark, 2>;

/// Of one of kBarks: between the mean radius of the stems that show it and that of its neighbours' the two are mixed.
/// Linear in the stems.
NeighbourBarks neighbourBarksOf(const TreeModel& model, Surface bark);

/// Tells the shader.
void setNeighbours(osg::StateSet& state, const NeighbourBarks& barks);
/// Names the units of the neighbours' pictures.
void nameNeighbourPictures(osg::StateSet& state);
/// Lets the shader see the pictures that showSurface() gave to a neighbour, 0 or 1.
void shareSurface(osg::StateSet& state, std::size_t neighbour, const osg::StateSet& shown);

} // namespace stromar
