#pragma once
#include "stromar/app/ExportOptions.h"
#include "stromar/app/Motion.h"
#include "stromar/model/ExportModel.h"
#include "stromar/model/ModelSway.h"
#include <span>

namespace stromar {

/// The unit and the axis up that were chosen for a file. Writers turn z to the axis that is usual in the format.
struct Arrangement {
    float scale = 1;
    bool turns = false;
    float side = 1; ///< y up: z becomes y; −1, z up in a writer of y: the way back

    bool isPlain() const { return !turns && scale == 1; }
    glm::vec3 direction(const glm::vec3& v) const { return turns ? glm::vec3(v.x, side * v.z, -side * v.y) : v; }
    glm::vec3 point(const glm::vec3& v) const { return scale * direction(v); }
};

/// Adds what the options ask for, so that a model sways elsewhere. `sways` are of its levels of detail, the finest
/// first, whose meshes it has in the order of TreeModel::visitMeshes().
void addWind(ExportModel& model, std::span<const std::shared_ptr<const ModelSway>> sways, const ExportOptions& options,
             const Motion& motion, const Arrangement& arrangement);

} // namespace stromar
