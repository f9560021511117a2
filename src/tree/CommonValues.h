#pragma once
#include "stromar/params/Params.h"
#include "stromar/tree/Frame.h"
#include "stromar/tree/Organs.h"
#include "stromar/tree/StemForm.h"

namespace stromar {

// What every builder takes from the values that all trees have.

BaseForm baseFormOf(const CommonParams& params);

/// How large an organ is, and how it turns away from where its stem would put it.
struct OrganPose {
    double length, width; ///< metres
    double bend;          ///< to the light, 0..1
    double rise;          ///< −1 hangs down, 0 stands off its stem, 1 stands upright

    Frame applied(const Frame& frame, const glm::dvec3& position) const;
};
/// By the values that all trees have. The density of leaves keeps their area.
OrganPose poseOf(const CommonParams& params, Organ organ);

} // namespace stromar
