#pragma once
#include "stromar/mesh/Detail.h"
#include "stromar/model/ExportModel.h"
#include "stromar/scene/Camera.h"

namespace stromar {

/// Metres from which on a program shows a level of detail of a tree so high (kScreenCoverage); 0 for the finest and for
/// the simple model, which no program switches to.
inline double lodDistance(const Detail& detail, double height, const CCamera& camera) {
    if (detail.model == Model::Simple || detail.lod == 0) return 0;
    const double halfPerMetre = camera.halfHeight() / camera.distance();
    return height / (2 * halfPerMetre * kScreenCoverage[static_cast<std::size_t>(detail.lod) - 1]);
}

} // namespace stromar
