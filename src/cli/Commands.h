#pragma once
#include "stromar/app/ExportOptions.h"
#include "stromar/app/Motion.h"
#include "stromar/app/Prediction.h"
#include "stromar/app/Render.h"
#include "stromar/mesh/Detail.h"
#include "stromar/util/Progress.h"
#include <ostream>
#include <string>
#include <vector>

namespace stromar {

/// The user asked for something that does not exist: exit status 2.
class CUsageError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What the commands on a tree have in common.
struct CommonOptions {
    std::string file;
    std::vector<std::string> others{}; ///< files of trees beside it
    std::vector<std::string> settings; ///< KEY=VALUE
    bool varied = true;
    bool quiet = false;
    int threads = 0;
    double age = 1; ///< 0..1 of the tree's life
    SizeLimits limits;
};

struct ModelOptions {
    bool simple = false;
    int lod = 0;
    const Detail& detail() const { return detailOf(simple ? Model::Simple : Model::Full, lod); }
};

enum class ListStyle { Text, Markdown, Json };

// Each writes its data to `out` and messages to standard error, and throws when it cannot do its work.
void printInfo(const CommonOptions& common, const ModelOptions& model, std::ostream& out, const CProgress& progress);
/// A line for each stem; with `segments` one for each of its segments behind it.
void printStructure(const CommonOptions& common, bool segments, std::ostream& out, const CProgress& progress);
/// Prints a table of the faults of the meshes, or of the one solid that is exported; false when there are any.
bool checkMeshes(const CommonOptions& common, const ModelOptions& model, const ExportOptions& exported, std::ostream& out,
                 const CProgress& progress);
void exportTree(const CommonOptions& common, const ExportOptions& options, const Motion& motion, bool timeSamples, const std::string& path,
                const CProgress& progress);
/// Draws a recipe, "bark:birch" or "leaf:oak" and KEY=VALUE, and writes its pictures.
void writeTexture(const std::vector<std::string>& recipe, int size, const std::string& path, const CProgress& progress);
/// Draws the tree and writes the picture, or those of its motion.
void renderTree(const CommonOptions& common, const ModelOptions& model, const RenderOptions& options, const Motion& motion,
                const std::string& path, const CProgress& progress);
void printParams(const std::string& method, ListStyle style, std::ostream& out);
void printMethods(ListStyle style, std::ostream& out);
void printFormats(ListStyle style, std::ostream& out);

/// Reads a tree of another program and writes it as a .tree file; what changed on the way goes to `messages`. Throws CError.
void importForeign(const std::string& foreign, const std::string& output, bool quiet, std::ostream& messages);
void printImports(ListStyle style, std::ostream& out);

} // namespace stromar
