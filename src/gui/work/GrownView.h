#pragma once
#include "work/TreeCreatorThread.h"

namespace stromar {

/// A tree from nothing, with its pictures, ready to be drawn. `folder`: that the paths of pictures start at. Any thread. Throws CError and
/// CCancelled.
std::shared_ptr<const ViewModel> grownView(const CParams& params, const std::filesystem::path& folder, double age, const Detail& detail,
                                           const SizeLimits& limits, const CProgress& progress);

} // namespace stromar
