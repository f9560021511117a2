// Trees of other programs: what becomes of each value, and that no file can do harm.
#include "mesh/SampleTrees.h"
#include "stromar/app/Import.h"
#include "stromar/params/ParamTable.h"
#include "stromar/params/TreeFile.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/util/Text.h"
#include "util/TemporaryFolder.h"
#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <random>

namespace stromar::test {

namespace {
const ImportFormat& formatNamed(std::string_view key) {
    const auto found = std::ranges::find(importTable(), key, &ImportFormat::key);
    EXPECT_NE(found, importTable().end()) << key;
    return *found;
}

/// A tree as Arbaro would write it.
std::string arbaroText(const CParams& params) {
    std::string text = "<?xml version='1.0' ?>\n<arbaro>\n  <species name='some_tree'>\n";
    const auto add = [&](const std::string& name, double value) { text += "    <param name='" + name + "' value='" + numberText(value) + "'/>\n"; };
    for (const ImportRow& row : formatNamed("arbaro").rows) {
        if (row.ours.empty() || row.value) continue;
        if (!row.ours.starts_with('n')) {
            add(std::string(row.foreign), findParam(row.ours)->get(params));
            continue;
        }
        for (int level = 0; level < kParamLevels; ++level)
            if (const auto ref = findParam(std::to_string(level) + std::string(row.ours.substr(1)))) add(std::to_string(level) + std::string(row.foreign.substr(1)), ref->get(params));
    }
    return text + "  </species>\n</arbaro>\n";
}

constexpr const char* kSapling = R"(# a comment
{'levels': 2, 'scale': 13.0, 'shape': '7', 'branches': (0, 50, 30, 10), 'length': (1.0, 0.3, 0.6, 0.45), 'downAngle': (90.0, 110.0, 45.0, 45.0),
 'downAngleV': (0.0, 80.0, 10.0, -5.0), 'useOldDownAngle': False, 'leafDownAngle': 40.0, 'leafRotate': 137.5, 'leaves': 25, 'prune': False,
 'pruneRatio': 1.0, 'ratioPower': 1.1, 'attractUp': (0.0, 0.0, 0.5, 0.5), 'curveRes': (8, 5, 3, 1), 'rootFlare': 1.25, 'handleType': '0',
 'splitBias': 0.4, 'gadget': 3}
)";

constexpr const char* kTreeGen = R"(""" A TREE """
params = {
    'shape': 4, 'g_scale': 13, 'levels': 3, 'base_size': [0.3, 0.02, 0.02, 0.02], # a comment
    'curve_res': [5, 5, 5, 0], 'branches': [2, 50, 30, 1], 'branch_dist': [-0, 2, 0.5, 0],
    'leaf_blos_num': -40, 'leaf_shape': 5, 'blossom_rate': 0.25, 'tropism': [0, 0, 0.5],
}
)";
constexpr const char* kTreeGenJson = R"({"shape": 4, "g_scale": 13, "levels": 3, "base_size": [0.3, 0.02, 0.02, 0.02], "curve_res": [5, 5, 5, 0],
 "branches": [2, 50, 30, 1], "branch_dist": [0, 2, 0.5, 0], "leaf_blos_num": -40, "leaf_shape": 5, "blossom_rate": 0.25, "tropism": [0, 0, 0.5]})";

std::string errorOf(const std::string& text) {
    try {
        static_cast<void>(parseForeign(text, "x.py"));
    } catch (const CInputError& e) {
        return e.what();
    }
    return {};
}
} // namespace

TEST(Import, RowsNameParametersThatAreThere) {
    for (const ImportFormat& format : importTable())
        for (const ImportRow& row : format.rows) {
            const std::string key = row.ours.starts_with('n') ? "1" + std::string(row.ours.substr(1)) : std::string(row.ours);
            EXPECT_TRUE(key.empty() || findParam(key)) << format.key << " " << row.foreign;
        }
}

TEST(Import, ArbarosTreesComeWhole) {
    for (const char* name : {"quaking_aspen", "black_tupelo", "weeping_willow", "ca_black_oak"}) {
        const CParams wanted = preset(name);
        const ImportedTree tree = parseForeign(arbaroText(wanted), "x.xml");
        EXPECT_TRUE(tree.notes.empty()) << tree.notes.front().toString();
        EXPECT_EQ(tree.format->key, "arbaro");
        EXPECT_EQ(tree.params.text.species, "Some tree");
        for (const ImportRow& row : formatNamed("arbaro").rows) {
            if (row.ours.empty()) continue;
            for (int level = 0; level < kParamLevels; ++level) {
                const std::string key = row.ours.starts_with('n') ? std::to_string(level) + std::string(row.ours.substr(1)) : std::string(row.ours);
                if (const auto ref = findParam(key)) {
                    EXPECT_EQ(ref->get(tree.params), ref->get(wanted)) << name << " " << key;
                }
            }
        }
    }
}

TEST(Import, SaplingsFormulasAreConverted) {
    const ImportedTree tree = parseForeign(kSapling, "aspen.py");
    EXPECT_EQ(tree.format->key, "sapling");
    const WeberPennParams& own = weberPenn(tree.params);
    EXPECT_EQ(own.levels, 2);
    EXPECT_EQ(own.shape, 7);
    EXPECT_EQ(own.level[1].branches, 50);
    EXPECT_EQ(own.level[1].length, 0.3);
    EXPECT_EQ(own.level[1].downAngle.value, 60) << "(110, 80) by its formula is the paper's (60, -50)";
    EXPECT_EQ(own.level[1].downAngleV.value, -50);
    EXPECT_EQ(own.level[3].downAngleV.value, 5) << "by chance in both";
    EXPECT_EQ(own.level[2].downAngle.value, 40) << "of the leaves";
    EXPECT_EQ(own.level[2].rotate.value, 137.5);
    EXPECT_EQ(own.pruneRatio, 0) << "it is switched off";
    EXPECT_EQ(tree.params.common.flare, 0.25);
    ASSERT_EQ(tree.notes.size(), 2u);
    EXPECT_EQ(tree.notes[0].toString(), "aspen.py:5:2: warning: 'splitBias' cannot be had: splits are spread evenly");
    EXPECT_EQ(tree.notes[1].toString(), "aspen.py:5:20: warning: 'gadget' is not known and left out");
}

TEST(Import, TreeGensPresetsComeInBothWaysToWriteThem) {
    const ImportedTree tree = parseForeign(kTreeGen, "a/tree.py"), json = parseForeign(kTreeGenJson, "a/tree.json");
    EXPECT_EQ(tree.format->key, "tree-gen");
    EXPECT_EQ(tree.params, json.params);
    const WeberPennParams& own = weberPenn(tree.params);
    EXPECT_EQ(own.scale, 13);
    EXPECT_EQ(own.baseSize, 0.3);
    EXPECT_EQ(own.trunks, 2);
    EXPECT_EQ(own.level[1].whorl, 3) << "2 there is whorls of three";
    EXPECT_EQ(own.level[2].whorl, 1);
    EXPECT_EQ(own.leaves, -30) << "a quarter are blossoms";
    EXPECT_EQ(tree.params.common.blossoms, 10);
    EXPECT_EQ(tree.params.common.leafShape, 11) << "palmate";
    EXPECT_EQ(own.attractionUp, 0.5);
    EXPECT_EQ(own.attractionAxis, static_cast<int>(AttractionAxis::Horizontal));
    ASSERT_EQ(tree.notes.size(), 3u);
    EXPECT_NE(tree.notes[0].toString().find("a/tree.py:4:5: warning: 3CurveRes is 1: 0 is out of its range"), std::string::npos) << tree.notes[0].toString();
    EXPECT_NE(tree.notes[1].text.find("1Whorl = 3"), std::string::npos) << tree.notes[1].toString();
    EXPECT_NE(tree.notes[2].text.find("2Whorl = 1"), std::string::npos) << tree.notes[2].toString();
}

TEST(Import, NothingIsRunAndEveryErrorHasItsPlace) {
    EXPECT_EQ(errorOf("{'g_scale': __import__('os').system('touch x')}"),
              "x.py:1:13: error: '__import__' is no value: only numbers, texts, True, False, None and lists are read");
    EXPECT_EQ(errorOf("params = {\n 'g_scale': 1+1}"), "x.py:2:13: error: '1+1' is no value: only numbers, texts, True, False, None and lists are read");
    EXPECT_EQ(errorOf("{'g_scale': 3}\nimport os"), "x.py:2:1: error: nothing but comments may follow the values");
    EXPECT_EQ(errorOf("{'g_scale': 'a"), "x.py:1:13: error: this text is not closed");
    EXPECT_EQ(errorOf("{'g_scale': [1, 2"), "x.py:1:18: error: ',' or ']' is wanted here");
    EXPECT_EQ(errorOf("{'a': 1}"), "x.py:1:1: error: these are no values of a tree that is known here");
    EXPECT_EQ(errorOf("<arbaro>\n<species>"), "x.py:2:9: error: this is no XML: Start-end tags mismatch");
    EXPECT_NE(errorOf("{'g_scale': " + std::string(100'000, '[')).find("nested too deep"), std::string::npos);
    EXPECT_NE(errorOf("").find("x.py:1:1"), std::string::npos);
}

TEST(Import, CutAndMutatedFilesEndInAnErrorOrATree) {
    std::mt19937 random(7);
    const auto below = [&](std::size_t bound) { return std::uniform_int_distribution<std::size_t>(0, bound - 1)(random); };
    for (const std::string& whole : {arbaroText(preset("quaking_aspen")), std::string(kSapling), std::string(kTreeGen)})
        for (int i = 0; i < 200; ++i) {
            std::string text = whole;
            if (i % 2 == 0)
                text.resize(below(text.size()));
            else
                for (std::size_t changes = 1 + below(6); changes > 0; --changes) {
                    const std::size_t at = below(text.size());
                    if (below(2) == 0)
                        text[at] = static_cast<char>(below(256));
                    else
                        text.insert(at, text.substr(below(text.size()), below(30)));
                }
            try {
                const ImportedTree tree = parseForeign(text, "x");
                for (const Message& note : tree.notes) EXPECT_GE(note.line, 1);
                const CParams opened = CTreeFile::parse(CTreeFile().text(tree.params), "y").params();
                for (const ParamRef& ref : allParams()) EXPECT_FALSE(ref.differs(opened, tree.params)) << ref.key() << " is another one when it is saved and opened";
            } catch (const CInputError& e) {
                for (const Message& message : e.messages()) EXPECT_GE(message.line, 1) << message.toString();
            }
        }
}

TEST(Import, OfAFileOnDisk) {
    const CTemporaryFolder folder;
    std::ofstream(folder / "small.py") << kTreeGen;
    EXPECT_EQ(importTree(folder / "small.py").params.text.species, "Small");
    std::ofstream(folder / "large.py") << std::string(kMaxForeignBytes + 1, ' ');
    EXPECT_THROW(static_cast<void>(importTree(folder / "large.py")), CError);
    EXPECT_THROW(static_cast<void>(importTree(folder / "none.py")), CError);
    for (const char* file : {"a.py", "a.JSON", "a.xml"}) EXPECT_TRUE(mayImport(file)) << file;
    for (const char* file : {"a.tree", "a", "a.p", "a.x"}) EXPECT_FALSE(mayImport(file)) << file;
}

} // namespace stromar::test
