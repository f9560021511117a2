#pragma once
#include "stromar/model/ModelSway.h"
#include <memory>

namespace stromar {

/// A tree in the wind at a moment.
struct SwayMoment {
    std::shared_ptr<const ModelSway> sway;
    Wind wind;
    double seconds = 0;

    std::shared_ptr<const WindPose> pose() const;
};

} // namespace stromar
