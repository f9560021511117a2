#include "motion/SwayMoment.h"

namespace stromar {

std::shared_ptr<const WindPose> SwayMoment::pose() const {
    auto rows = std::make_shared<WindPose>();
    sway->table->pose(wind, seconds, *rows, CProgress());
    return rows;
}

} // namespace stromar
