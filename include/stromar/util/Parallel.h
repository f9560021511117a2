#pragma once
#include "stromar/util/Progress.h"
#include <cstddef>
#include <functional>

namespace stromar {

/// Calls `body(first, last)` for consecutive ranges of at most `grain` indices that together cover 0..count, on as many
/// threads as `progress` allows (the caller's is one of them). Ranges start at multiples of `grain`, whatever the
/// number of threads. Rethrows the first exception and starts no further range; throws CCancelled when asked to stop.
void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body,
                 const CProgress& progress);

} // namespace stromar
