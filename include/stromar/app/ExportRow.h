#pragma once
#include "stromar/app/ExportOptions.h"
#include "stromar/app/Prediction.h"
#include <filesystem>
#include <span>

namespace stromar {

struct Detail;

/// One of several trees that stand in a row: of other seeds, ages, seasons, or at other levels of detail.
struct RowTree {
    CParams params;
    double age = 1;
    const Detail* detail = nullptr; ///< null: what the options want
    double place = 0;               ///< of its foot along x, in metres
    std::string name;               ///< in front of the names of its meshes; letters that every format takes, all different
};

/// Why no row can be written so, marked with N_: levels of detail that lie in one file, wind and collision are of a single tree.
std::string_view rowConflictOf(const ExportOptions& options, const Format& format);

/// Writes all of a row as one model: each tree with its own meshes, pictures that are the same once. Levels of detail may have a file
/// each. They grow one after another, with all threads; together they keep to the limits. Throws CError and CCancelled.
void exportRow(std::span<const RowTree> trees, const ExportOptions& options, const SizeLimits& limits,
               const std::filesystem::path& treeFolder, const std::filesystem::path& path, const CProgress& progress);

} // namespace stromar
