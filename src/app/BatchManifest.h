#pragma once
#include "stromar/app/Batch.h"
#include <fstream>
#include <mutex>

namespace stromar {

/// What the parts of a batch have made: a file of JSON lines for each part, which it adds to as models are done. All members: any thread.
class CBatchManifest {
public:
    /// In the folder that all models have in common, which is made. Throws CError when it cannot be written.
    CBatchManifest(const BatchPlan& plan, int part, int parts);
    void add(const BatchFile& file, double seconds);

private:
    const BatchPlan& m_plan;
    std::ofstream m_out;
    std::mutex m_mutex;
};

} // namespace stromar
