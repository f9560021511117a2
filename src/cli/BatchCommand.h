#pragma once
#include "stromar/app/Prediction.h"
#include "stromar/util/Progress.h"
#include <ostream>
#include <string>

namespace stromar {

struct BatchFlags {
    std::string plan;
    int jobs = 1;
    int part = 1, parts = 1;
    bool force = false, dryRun = false, quiet = false, merge = false;
    SizeLimits limits{};
};

/// Writes the models of a plan, or of a part of it, or with merge the manifest of all parts, or with dryRun lists them to `out` with their sizes. False when some could not be written; they are
/// listed at the end, on standard error.
bool runBatchCommand(const BatchFlags& flags, std::ostream& out, const CProgress& progress);

} // namespace stromar
