#pragma once
#include <cstring>
#include <glm/vec3.hpp>
#include <string>

namespace stromar {

template <typename Value>
void put(std::string& bytes, const Value& value) {
    const std::size_t at = bytes.size();
    bytes.resize(at + sizeof(Value));
    std::memcpy(bytes.data() + at, &value, sizeof(Value));
}

/// Axes of a format whose writer has y up.
inline glm::vec3 yUp(const glm::vec3& v) { return {v.x, v.z, -v.y}; }

} // namespace stromar
