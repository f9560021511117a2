#pragma once
#include "stromar/mesh/MeshBuilder.h"
#include "stromar/model/MeshValues.h"
#include "stromar/params/ParamTable.h"
#include "stromar/tree/weberpenn/WeberPennBuilder.h"
#include <cstdint>
#include <string>
#include <vector>

namespace stromar::test {

struct Sample {
    std::string name; ///< for messages
    CParams params;
};

/// The trees that come with the program.
const std::vector<Sample>& presets();
/// The names of all but some.
std::vector<std::string> presetsWithout(const std::vector<std::string>& names);
/// Those by Weber and Penn's method.
const std::vector<Sample>& weberPennPresets();
/// One of them, by the name of its file without the ending.
CParams preset(const std::string& name);

/// How wild random parameters may be.
struct Caps {
    std::array<int, kParamLevels> branches; ///< by level
    double segSplits;
    int curveRes, leaves, levels;
};
constexpr Caps kMeshCaps{{0, 10, 5, 3}, 0.4, 7, 20, 4};

/// Values from the table's useful ranges, often exactly at their ends or the default. The same number, the same values.
CParams randomParams(std::uint64_t number, const Caps& caps = kMeshCaps);
/// The same without what no plant does: stems thicker than their bends, chains of spheres, knots.
CParams gentleParams(std::uint64_t number, const Caps& caps = kMeshCaps);

/// A trunk alone: straight, round, of even thickness, without flare.
CParams plainTrunk();

std::shared_ptr<const CTree> grow(const CParams& params, int threads = 2);

/// The organs that a level of detail shows of a tree that grow() grew.
std::shared_ptr<const CMesh> organsOf(const CTree& tree, const CParams& params, Organ organ,
                                      const std::vector<StemMesh>& stems, const Detail& detail);

/// The meshes of a tree: stems by generation, then the leaves. Empty ones too.
std::vector<std::shared_ptr<const CMesh>> meshesOf(const CTree& tree, const CParams& params, const Detail& detail,
                                                   int threads = 2);

} // namespace stromar::test
