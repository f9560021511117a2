#pragma once
#include "ExportParts.h"
#include <optional>

namespace stromar {

/// What an export adds to a model that is shown from far: a last level of detail, or pictures beside it.
struct ImpostorLevel {
    std::shared_ptr<const CMesh> mesh;
    Material look;
};

/// Draws what the options want of the finest model's meshes. A grid of views is written beside the model; a cross comes back. Throws
/// CError and CCancelled.
std::optional<ImpostorLevel> impostorOf(const TreeModel& finest, const Meshes& meshes, const ExportOptions& options, const Format& format,
                                        const std::filesystem::path& treeFolder, const Output& to, CFileSet& files, const CProgress& progress);

} // namespace stromar
