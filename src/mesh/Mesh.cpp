#include "stromar/mesh/Mesh.h"
#include <glm/common.hpp>

namespace stromar {

Bounds CMesh::bounds() const {
    Bounds box{positions.front(), positions.front()};
    for (const glm::vec3& p : positions) box = {glm::min(box.min, p), glm::max(box.max, p)};
    return box;
}

} // namespace stromar
