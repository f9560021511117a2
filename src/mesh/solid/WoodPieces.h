#pragma once
#include "stromar/mesh/Mesh.h"
#include "stromar/mesh/MeshParams.h"
#include "stromar/tree/Tree.h"
#include <vector>

namespace stromar {

/// A short straight piece of wood: between two rings, round or with lobes and roots.
struct WoodPiece {
    glm::dvec3 from, to;
    double radiusFrom, radiusTo;
    Frame frame;            ///< angles count from its X
    std::vector<float> out; ///< how far the bark stands out at so many angles, as a part of the radius; none: 1
    bool cut;               ///< flat at a trunk's base; else round
    glm::dvec3 base, up;    ///< of that

    /// How far a point is outside, metres; negative inside. Exact for round ones.
    double distanceTo(const glm::dvec3& point) const;
    double maxRadius() const;
};

/// All wood of a tree, nowhere thinner than `thinnest`, in pieces not longer than `longest`; metres.
std::vector<WoodPiece> woodPiecesOf(const CTree& tree, const MeshParams& params, double thinnest, double longest);

} // namespace stromar
