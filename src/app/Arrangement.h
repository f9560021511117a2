#pragma once
#include <glm/vec3.hpp>

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

} // namespace stromar
