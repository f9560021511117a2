#pragma once
#include "stromar/app/Engines.h"
#include "stromar/app/Prediction.h"
#include <functional>
#include <optional>

namespace stromar {

/// What a plan says: trees × seeds × ages × seasons × levels of detail × formats. Lists that it does not have hold one value that changes
/// nothing.
struct BatchPlan {
    std::vector<std::filesystem::path> trees;
    std::vector<std::optional<int>> seeds{std::nullopt};
    std::vector<double> ages{1};
    std::vector<std::optional<double>> months{std::nullopt};
    std::vector<int> lods{0};
    std::vector<std::string> endings{".glb"};
    std::vector<std::pair<std::string, std::string>> values; ///< key and value, as a .tree file has them
    ExportOptions options{};
    bool sharesPictures = false;
    std::filesystem::path folder; ///< of the plan: its paths start here
    std::string output;           ///< with {tree} {seed} {age} {season} {lod} {format}
};

/// Reads a plan in JSON; comments are allowed. `name` stands in messages for the file, paths start at `folder`. Throws CInputError: what is
/// no JSON, unknown keys, wrong values, patterns without a file, with file, line and column.
BatchPlan parsePlan(const std::string& text, const std::string& name, const std::filesystem::path& folder);
BatchPlan readPlan(const std::filesystem::path& path);

/// One model to write.
struct BatchFile {
    std::filesystem::path tree, output;
    std::optional<int> seed;
    double age = 1;
    std::optional<double> month;
    int lod = 0;
};
/// In the order of the plan. Throws CError where two have the same name, a format cannot do what was chosen,
/// or there are more than a million.
std::vector<BatchFile> filesOf(const BatchPlan& plan);

struct BatchOptions {
    int jobs = 1;       ///< trees that are made side by side, memory allowing
    bool force = false; ///< writes also what is there and unchanged
    SizeLimits limits{}; ///< of all jobs together
    std::filesystem::path record; ///< of what was done: a file that this run reads and adds to
    std::string version;          ///< of the program: another one writes anew
    int part = 1, parts = 1;      ///< of the trees every so many-th one, from 1 on: parts run side by side on several machines
    bool manifest = false;        ///< adds to manifest.I-of-N.jsonl in outputFolder()
};

struct BatchResult {
    std::size_t written = 0, skipped = 0;
    std::vector<std::string> failures; ///< "out/oak.glb: why"
};

/// What becomes of a file. Any thread, one at a time.
enum class BatchOutcome { Written, Skipped, Failed };
using BatchReport = std::function<void(const BatchFile& file, BatchOutcome outcome, std::size_t done)>;

/// Writes all files of a plan that are not there yet as they should be; a tree that fails does not stop the others. Folders are made. Throws
/// CCancelled; what was written stays, and is known to the next run.
BatchResult runBatch(const BatchPlan& plan, const BatchOptions& options, const BatchReport& report, const CProgress& progress);

/// The deepest folder that all models of a plan have in common.
std::filesystem::path outputFolder(const BatchPlan& plan);

/// What all parts together have made.
struct BatchManifest {
    std::filesystem::path file; ///< manifest.json in outputFolder()
    std::size_t models = 0;
    std::vector<std::string> missing; ///< models of the plan that no part has made, or that are not as it made them
};
/// Writes the models of the plan, in its order, with bytes and hashes, as a list in JSON. The same bytes for any number of parts. Reads all
/// models. Throws CError.
BatchManifest mergeManifests(const BatchPlan& plan);

/// About how many bytes the models take, without pictures, and how many vertices are made for them. Throws CError for a tree that cannot be
/// read.
struct BatchSize {
    double bytes = 0, vertices = 0;
};
BatchSize sizeOf(const BatchPlan& plan, const BatchFile& file, const CProgress& progress);

} // namespace stromar
