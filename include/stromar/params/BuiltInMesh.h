#pragma once
#include "stromar/params/Params.h"
#include <string_view>

namespace stromar {

/// How texts name a mesh that comes with the program, and no file: "mesh:curved".
inline constexpr std::string_view kBuiltInMesh = "mesh:";
inline bool isBuiltInMesh(std::string_view text) { return text.starts_with(kBuiltInMesh); }

/// Whether some leaves have a mesh as wide as LeafScaleX says, or none; files keep their proportions.
inline bool hasLeavesOfAnyWidth(const CParams& params) {
    const auto keeps = [](const std::string& mesh) { return !mesh.empty() && !isBuiltInMesh(mesh); };
    if (!keeps(params.text.leafMesh)) return true;
    for (std::size_t other = 0; other < std::size(kLeafShares); ++other)
        if (params.common.*kLeafShares[other] > 0 && isBuiltInMesh(params.text.*kLeafMeshes[other + 1])) return true;
    return false;
}

} // namespace stromar
