#pragma once
#include "Arrangement.h"
#include "stromar/app/ExportOptions.h"
#include "stromar/model/ExportModel.h"

namespace stromar {

class CTree;

/// Adds what things bump into as meshes named as the engine looks for them, one convex hull each, and writes the same capsules as JSON.
void addCollision(ExportModel& model, const CTree& tree, const ExportOptions& options, const Format& format, const Arrangement& to,
                  const std::filesystem::path& path, CFileSet& files);

} // namespace stromar
