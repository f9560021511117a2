#pragma once
#include "stromar/tree/Tree.h"
#include "stromar/util/Progress.h"
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec4.hpp>

namespace stromar {

/// The wind over a tree. Where it comes from and how strong it is are the same everywhere, but for gusts.
struct Wind {
    glm::dvec3 direction{1, 0, 0}; ///< unit; where it blows to
    double strength = 0;           ///< 0 still; 1 a strong gale, 22 m/s
    double gusts = 0.3;            ///< how much of the strength comes and goes, 0..1
    double loop = 0;               ///< seconds after which every motion repeats; 0: never

    bool operator==(const Wind&) const = default;
};
constexpr double kMaxWindStrength = 3;

/// A horizontal direction: degrees from x, counter-clockwise seen from above.
glm::dvec3 windDirection(double degrees);

/// How often a motion repeats in the wind: in a loop, whole times.
struct Rhythm {
    double frequency;    ///< Hz
    std::uint32_t steps; ///< of noise at this frequency, until it repeats; 0: never

    Rhythm(double hertz, double loop);
};

/// A smooth noise in −1..1, one lattice step per unit of `at`; `steps` as in Rhythm. The lattice's values are
/// windLattice().
double windNoise(double at, std::uint32_t seed, std::uint32_t steps);
/// The value of the noise at a whole number, −1..1: a hash that shaders and scripts can repeat (32 bits).
double windLattice(std::uint32_t at, std::uint32_t seed);

/// Where something hangs: between a node and the next one of its path.
struct SwayPlace {
    float node; ///< a whole number
    float part; ///< 0..1 of the way to the next

    std::size_t index() const { return static_cast<std::size_t>(node); }
};

/// What the wind knows of a stem of the still tree.
struct WindStem {
    glm::dvec3 base;
    glm::dvec3 axis; ///< unit, from the base to the tip
    glm::dvec3 x, y; ///< of its frame at its base
    double length;   ///< of the grown stem, metres
    double diameter; ///< of the grown stem at its base, metres
    double flexibility;
    double angularSpeed;            ///< rad/s of its own swaying
    double phase;                   ///< radians of the same
    std::uint32_t seed;             ///< of its noises
    std::int32_t parent;            ///< in the table, −1 for a trunk
    SwayPlace on;                   ///< where it sits on its parent
    std::uint32_t generation, stem; ///< in the tree
    std::uint32_t firstNode;        ///< of path 0
    std::uint32_t segments;         ///< of path 0
    bool forks;                     ///< has other paths

    /// How far it can bend: 1 as far as the most slender stems, 0 not at all.
    double slenderness() const;
};

/// A tree bent by the wind, or fallen. Two rows for each node: its point and the strength of the wind at its stem; the
/// quaternion (x y z w) that has turned the wood there.
struct WindPose {
    std::vector<glm::vec4> rows;
};

/// The axes of a tree as the wind bends them. Nodes are the ends of segments: each path has one more than segments,
/// they lie one after the other. Immutable, any thread.
class CWindTable {
public:
    /// `grown` is the tree at the end of its life, from which stems of the same names take their stiffness.
    CWindTable(std::shared_ptr<const CTree> tree, const CTree& grown, double flexibility, int seed);

    const CTree& tree() const { return *m_tree; }
    const std::vector<WindStem>& stems() const { return m_stems; } ///< by generation, then as in the tree
    const WindStem& stem(std::size_t generation, std::size_t stem) const {
        return m_stems[m_firstStem[generation] + stem];
    }
    std::size_t nodeCount() const { return m_still.size(); }
    /// The nodes of the still tree.
    const std::vector<glm::vec3>& still() const { return m_still; }
    /// The node at the base of a segment of a generation.
    std::uint32_t nodeOf(std::size_t generation, std::uint32_t segment) const { return m_nodeOf[generation][segment]; }
    /// The place on a stem that is nearest to a point. Linear in the stem's segments.
    SwayPlace nearestOn(std::size_t generation, std::size_t stem, const glm::dvec3& point) const;

    /// The pose at a time, as many rows as nodes times two. Each stem turns about φ⃗·z/l at z metres from its base, in
    /// the frame of its parent there; its pieces keep their lengths. Same result for any number of threads; 0.1 µs a
    /// node.
    void pose(const Wind& wind, double seconds, WindPose& pose, const CProgress& progress) const;
    /// The rotation vector of a stem in its parent's frame, and the strength of the wind where it stands.
    struct Push {
        glm::dvec3 turn; ///< radians, at most 60°
        double strength;
        double before; ///< radians before they were limited
    };
    Push pushOn(const WindStem& stem, const Wind& wind, double seconds) const;

    /// Poses one stem whose parent, if any, is posed: it is pushed, and hangs at `on` of its parent's axis; a trunk
    /// stands where it is.
    void poseStem(const WindStem& own, const Push& push, const SwayPlace& on, std::vector<glm::vec4>& rows) const;
    /// Poses consecutive pieces from a node on: it lies at `at`, `start` metres above where the wood is turned by
    /// `carried`, and turns further by so much per metre.
    void posePath(std::uint32_t first, std::uint32_t segments, double start, glm::dvec3 at, const glm::dquat& carried,
                  const glm::dvec3& perMetre, float strength, std::vector<glm::vec4>& rows) const;

private:
    void addStems(std::size_t generation, const CTree& grown, double flexibility, int seed);
    void poseClones(const WindStem& own, const Push& push, const glm::dquat& carried,
                    std::vector<glm::vec4>& rows) const;

    std::shared_ptr<const CTree> m_tree;
    std::vector<WindStem> m_stems;
    std::vector<std::size_t> m_firstStem;             ///< by generation
    std::vector<std::vector<std::uint32_t>> m_nodeOf; ///< by generation and segment
    std::vector<glm::vec3> m_still;
    std::vector<glm::vec4> m_pieces; ///< by node: unit vector to the next one, and how far it is, metres
};

/// What hangs at a place, as a pose moves it: its turn, and where a point of the still tree goes.
struct Swayed {
    glm::quat turn;
    glm::vec3 from, to; ///< the place on the axis, still and in the pose
    float strength;     ///< of the wind

    Swayed(const std::vector<glm::vec3>& still, const WindPose& pose, const SwayPlace& place);
    glm::vec3 point(const glm::vec3& p) const { return to + turn * (p - from); }
    glm::vec3 direction(const glm::vec3& v) const { return turn * v; }
    /// Where a point of the pose comes from.
    glm::vec3 stillPoint(const glm::vec3& p) const { return from + glm::conjugate(turn) * (p - to); }
};

/// A leaf's own motion about its stalk: radians.
struct Flutter {
    float phase;  ///< radians
    float hertz;  ///< 2..6
    float amount; ///< 1 for blades, less for needles

    /// For the leaf with a name, so wide for its length.
    Flutter(std::uint64_t id, float widthOverLength);
    float angle(float strength, double seconds, double loop) const;
};

} // namespace stromar
