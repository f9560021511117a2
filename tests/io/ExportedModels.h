#pragma once
#include "stromar/app/ExportOptions.h"
#include "stromar/app/TreeCreator.h"
#include "util/TemporaryFolder.h"
#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace stromar::test {

/// Which programs other than ours read back which formats: a format without one fails a test.
struct ForeignReader {
    const char* program;
    std::vector<std::string> endings;
};
extern const ForeignReader kAssimp, kOsg, kPovRay, kThree;

/// A file of a format, to be read.
struct ReadCase {
    std::string ending, sample;
};
void PrintTo(const ReadCase& readCase, std::ostream* out);
std::vector<ReadCase> readCases(const ForeignReader& reader, const std::vector<std::string>& samples);
std::string labelOf(const testing::TestParamInfo<ReadCase>& info);

struct SampleModel {
    std::string name;
    std::shared_ptr<const TreeModel> model;
};
/// A few branches; a preset; a preset of more than 200,000 triangles.
const std::vector<SampleModel>& sampleModels();
const TreeModel& sampleModel(const std::string& name);

/// Options by their keys and words.
ExportOptions chosen(std::initializer_list<std::pair<const char*, const char*>> words);

/// How a format's axes follow from ours (z up): x, y, z of the file.
using Axes = glm::vec3 (*)(const glm::vec3&);
inline glm::vec3 zUp(const glm::vec3& p) { return p; }
inline glm::vec3 yUp(const glm::vec3& p) { return {p.x, p.z, -p.y}; }
inline glm::vec3 yUpLeftHanded(const glm::vec3& p) { return {p.x, p.z, p.y}; }

struct Corner {
    glm::vec3 position, normal;
    glm::vec2 texCoord;
};
/// The corners of all triangles in their order.
std::vector<Corner> cornersOf(const TreeModel& model, Axes axes);

Bounds boundsOf(const TreeModel& model, Axes axes);
/// What the bark encloses.
double barkVolume(const TreeModel& model);

void expectNear(const Bounds& box, const Bounds& wanted);

/// A folder with the model in it as tree.ending, and its pictures.
class CExported {
public:
    CExported(const TreeModel& model, const std::string& ending, const std::string& stem = "tree");
    std::string path() const { return m_path; }
    std::string folder() const { return m_folder.path().string(); }
    const CTemporaryFolder& temporary() const { return m_folder; }

private:
    CTemporaryFolder m_folder;
    std::string m_path;
};

} // namespace stromar::test
