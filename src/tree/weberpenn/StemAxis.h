#pragma once
#include "stromar/params/methods/weberpenn/TreeParams.h"
#include "stromar/tree/Tree.h"
#include "stromar/util/Random.h"
#include <vector>

namespace stromar {

/// The form of one stem before its length is known: paths and segments in units of the stem's length, base at the
/// origin. The form does not depend on the length, so pruning only scales it.
struct StemAxis {
    struct Segment {
        glm::dvec3 position;
        Frame frame;
        double density;
        bool forks;
    };
    std::vector<CPath> paths; ///< firstSegment counts from this axis's first
    std::vector<double> rotationPhase; ///< by path: start of its children's rotation, radians
    std::vector<Segment> segments;
    int curveRes = 1;

    glm::dvec3 end(const Segment& segment) const { return segment.position + segment.frame[2] / double(curveRes); }
};

/// Grows a stem's axis joint by joint: curvature (Weber & Penn §4.1), splits into clones (§4.2), attraction up (§4.8).
class CAxisGrower {
public:
    CAxisGrower(const CTreeParams& params, const CRandom& random) : m_params(params), m_random(random) {}

    /// `frame` is the stem's own at its base; `key` starts the error diffusion of its splits. Reuses the memory of
    /// `axis`.
    void grow(std::uint64_t id, double key, const Frame& frame, StemAxis& axis);

private:
    struct Growing {
        Frame frame;
        glm::dvec3 position;
        double correction; ///< turned back per segment for the splits so far, radians
        double density;
        bool halved;
    };

    void openPath(const CPath& path, double rotationPhase, const Growing& growing, StemAxis& axis);
    void addSegment(std::size_t path, int k, StemAxis& axis);
    void bend(std::size_t path, int k, const StemAxis& axis);
    void attractUp(Frame& frame) const;
    void split(std::size_t path, int k, StemAxis& axis);
    int cloneCount(const Growing& growing, bool atBase);
    double spreadAngle(bool atBase, int clones, int j, double declination, std::uint64_t pathId, int k) const;

    const CTreeParams& m_params;
    const CRandom& m_random;
    std::uint64_t m_id = 0;
    double m_splitError = 0;
    std::vector<Growing> m_growing;
};

} // namespace stromar
