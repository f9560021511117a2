#pragma once
#include "stromar/mesh/Detail.h"
#include "stromar/mesh/Mesh.h"
#include "stromar/mesh/MeshParams.h"
#include "stromar/tree/Tree.h"
#include "stromar/util/Progress.h"
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace stromar {

struct MeshPlan;

/// The form of all leaves of a tree: points of a blade of length and width 1, its foot at the origin, its axis along y.
struct LeafBlade {
    struct Point {
        glm::dvec3 place;  ///< x across (times the width), y along (times the length), z up (times the width)
        glm::dvec3 normal; ///< unit, in the same axes
        glm::vec2 texCoord;
    };
    std::vector<Point> points;
    std::vector<std::uint32_t> indices; ///< three per triangle, counter-clockwise seen from above
    std::shared_ptr<const LeafBlade> far{}; ///< what stands for a mesh at the last level of detail; null: itself
};

/// What an organ is drawn as; leaves by kind.
LeafBlade bladeOf(const MeshParams& params, Organ organ, const Detail& detail, std::size_t kind = 0);

/// Where leaves look when they are shaded as a round crown, and by how much.
struct Rounding {
    glm::dvec3 centre{0};
    double share = 0;
    double minCosine = 0; ///< to a leaf's own normal, so that its folded halves are not seen from behind

    /// A normal turned outwards, but never to the back of its leaf.
    glm::dvec3 turned(const glm::dvec3& normal, const glm::dvec3& place) const;
};

/// How much larger a leaf is that grew in the shade of its crown: an ellipsoid, as the window shades it. Leaves in the sun are smaller,
/// so that all have the same area together.
struct CrownShade {
    glm::dvec3 centre{0}, half{1}; ///< of the stems that bear leaves
    double most = 0;               ///< what is added to the size in the deepest shade
    double sunlit = 1;             ///< size in the full sun

    double sizeAt(const glm::dvec3& place) const;
};

/// One of many places where a blade stands, as graphics cards want it.
struct InstancePlace {
    glm::vec3 position; ///< of the blade's foot
    float length, width;
    glm::vec4 turn; ///< unit quaternion x y z w: from the blade's axes to the world's
};

/// The organs of one kind as they are drawn: instances of one blade. Immutable.
class COrganMesh {
public:
    /// Those of `organs` that `shown` lists, `growth` times as large as they are grown.
    COrganMesh(Organ organ, std::size_t kind, LeafBlade blade, std::shared_ptr<const COrgans> organs, std::vector<std::uint32_t> shown,
               double growth, const Rounding& rounding, const CrownShade& shade = {});

    Organ organ() const { return m_organ; }
    std::size_t kind() const { return m_kind; } ///< of a leaf, else 0
    std::string name() const;
    Surface surface() const;
    /// The same in another size.
    std::shared_ptr<const COrganMesh> resized(double factor) const;
    const LeafBlade& blade() const { return m_blade; }
    const Rounding& rounding() const { return m_rounding; }
    std::size_t count() const { return m_count; }
    std::size_t vertexCount() const { return count() * m_blade.points.size(); }
    std::size_t triangleCount() const { return count() * m_blade.indices.size() / 3; }
    std::size_t bytes() const { return CMesh::bytesOf(vertexCount(), 3 * triangleCount()); } ///< when it is expanded
    const CLeaf& leaf(std::size_t i) const { return m_organs->grown[m_shown.empty() ? i : m_shown[i]]; }
    InstancePlace place(std::size_t i) const;
    /// Of all vertices; there are some.
    Bounds bounds(const CProgress& progress) const;
    /// The instance whose triangles a ray meets first, and how far along it, in lengths of `direction`; −1: none.
    /// Linear in the instances.
    struct Hit {
        std::int64_t instance = -1;
        double distance = 0;
    };
    Hit meet(const glm::dvec3& from, const glm::dvec3& direction) const;
    /// With vertices of its own for every instance. Same result for any number of threads. Throws CCancelled.
    std::shared_ptr<const CMesh> expanded(const CProgress& progress) const;

private:
    double sizeOf(const CLeaf& leaf) const { return m_growth * m_shade.sizeAt(leaf.position); }

    Organ m_organ;
    std::size_t m_kind;
    LeafBlade m_blade;
    std::shared_ptr<const COrgans> m_organs;
    std::size_t m_count;
    std::vector<std::uint32_t> m_shown; ///< empty where all are
    double m_growth;
    Rounding m_rounding;
    CrownShade m_shade;
};

using OrganMeshes = std::vector<std::shared_ptr<const COrganMesh>>;

/// Which organs of a kind a level of detail shows on the stems that `plans`, by generation, chose: at most its share or
/// kFewOrgans. Not those on stems that cards show.
OrganDemand demandOf(const Detail& detail, std::span<const MeshPlan* const> plans, const StemSet& asCards = {});

/// How many leaves a season left on a tree.
struct LeafCount {
    double onStems, onTwigs; ///< those that cards show
};
/// What the last level of detail draws of its leaves, and if those are not enough of its cards, 0.4 to 1, so that with `wood` triangles the tree has no
/// more than 5,000 or a twentieth of those at LOD 0, of which wood has `fullWood`.
LeafShare leafShareOf(const MeshParams& params, const Detail& detail, double fullWood, double wood, const LeafCount& leaves);

/// The grown leaves of a tree by their form, seen from above; blossoms as cards, fruits as ellipsoids. As many and as
/// large as the season has them, on stems that `plans` chose, enlarged to keep the area of all as far as
/// Detail::maxLeafGrowth allows. Leaves by kind, kLeafKinds of them; some may be empty. Throws CCancelled.
OrganMeshes meshOfOrgans(const CTree& tree, Organ organ, std::span<const MeshPlan* const> plans,
                                               const MeshParams& params, const Detail& detail,
                                               const CProgress& progress, const StemSet& asCards = {});

} // namespace stromar
