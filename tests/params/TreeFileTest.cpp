#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/params/TreeFile.h"
#include "params/Support.h"
#include "stromar/util/FileSet.h"
#include "stromar/util/Text.h"
#include <gtest/gtest.h>

namespace stromar {
namespace {

using test::otherValue;
using test::parsed;
using test::valueOf;


/// Reads lines behind the one that says the format, and expects no word of complaint.
CParams quietly(const std::string& lines) {
    const CTreeFile file = parsed("Format = 1\n" + lines);
    for (const Message& message : file.warnings()) ADD_FAILURE() << message.toString() << "\nin\n" << lines;
    return file.params();
}

CParams allChanged() {
    CParams params;
    for (const ParamRef& ref : numberParams()) EXPECT_TRUE(ref.set(params, otherValue(*ref.info, ref.get(params))));
    params.text = {"Oak # 1",   "A \"B\" C", "  Žluťoučký kůň  ", "4 17", "bark, old.png",
                   "#leaf.png", "",          "leaf:blossom",       "bark:birch", "", "twig.png",
                   "mesh:wavy", "", "", "leaf:oak", "", "a.obj", ""};
    return params;
}

TEST(TreeFile, EveryValueIsRead) {
    for (const ParamRef& ref : numberParams()) {
        CParams expected;
        ref.set(expected, otherValue(*ref.info, ref.get(expected)));
        EXPECT_TRUE(quietly(ref.key() + " = " + numberText(ref.get(expected)) + "\n") == expected) << ref.key();
    }
}

TEST(TreeFile, MissingKeysHaveTheDefaults) {
    EXPECT_TRUE(quietly("") == CParams());
    EXPECT_TRUE(quietly("# only a comment\n\n") == CParams());
}

TEST(TreeFile, ANewDocumentHasAllValues) {
    for (const CParams& params : {CParams(), allChanged()}) {
        const std::string text = CTreeFile().text(params);
        const CTreeFile back = parsed(text);
        EXPECT_TRUE(back.params() == params);
        EXPECT_TRUE(back.warnings().empty());
        for (const ParamRef& ref : allParams())
            EXPECT_NE(text.find("\n" + ref.key() + " = "), std::string::npos) << ref.key();
        EXPECT_TRUE(text.starts_with("Format = 1\nMethod = weber-penn\n"));
    }
}

TEST(TreeFile, ANewDocumentIsWrittenGroupByGroup) {
    const std::string text = CTreeFile().text(CParams());
    std::size_t last = 0;
    for (const char* inOrder : {"\nScale =", "\n0Length =", "\n1Length =", "\n2Length =", "\n3Length =", "\nLeaves =",
                                "\nPruneRatio =", "\nTextureWrapX ="}) {
        const std::size_t at = text.find(inOrder);
        ASSERT_NE(at, std::string::npos) << inOrder;
        EXPECT_GT(at, last) << inOrder;
        last = at;
    }
}

TEST(TreeFile, BlanksAndOrderAreFree) {
    for (const char* line : {"Scale=12", "Scale =12", "Scale= 12", "  Scale = 12", "\tScale\t=\t12\t", "Scale = 12   ",
                             "Scale = +12", "Scale = 12.0", "Scale = 1.2e1", "Scale = 12\r"})
        EXPECT_EQ(weberPenn(quietly(std::string(line) + "\n")).scale, 12) << line;
    EXPECT_EQ(weberPenn(quietly("Scale = 12")).scale, 12) << "no end of line";
    const CParams one = quietly("Scale = 12\nLevels = 2\n1Curve = 5\n"),
                  two = quietly("1Curve = 5\nLevels = 2\nScale = 12\n");
    EXPECT_TRUE(one == two);
    EXPECT_EQ(weberPenn(parsed("Scale = 12\nFormat = 1\n").params()).scale, 12);
}

TEST(TreeFile, CommentsStartAtALineOrBehindABlank) {
    EXPECT_EQ(weberPenn(quietly("# Scale = 5\n  # Scale = 6\nScale = 12 # metres\n")).scale, 12);
    EXPECT_EQ(weberPenn(quietly("Scale = 12\t# metres = feet\n")).scale, 12);
    EXPECT_EQ(quietly("Species = Oak#2\n").text.species, "Oak#2");
    EXPECT_EQ(quietly("Species = Oak #2\n").text.species, "Oak");
    EXPECT_EQ(quietly("Species = # none\n").text.species, "");
}

TEST(TreeFile, QuotedTextsKeepAll) {
    EXPECT_EQ(quietly("Species = \"Oak # 2\"\n").text.species, "Oak # 2");
    EXPECT_EQ(quietly("Species = \"  Oak  \"  # comment\n").text.species, "  Oak  ");
    EXPECT_EQ(quietly("Species = \"\"\n").text.species, "");
    EXPECT_EQ(quietly("Species = Oak \"old\" tree\n").text.species, "Oak \"old\" tree");
    EXPECT_EQ(quietly("Species = a = b\n").text.species, "a = b");
    EXPECT_EQ(quietly("Species = Dub letní\n").text.species, "Dub letní");
    EXPECT_EQ(quietly("Species =\n").text.species, "");
}

TEST(TreeFile, CrlfAndByteOrderMarkAreRead) {
    const CTreeFile file = parsed("\xEF\xBB\xBF"
                                  "Format = 1\r\nScale = 12\r\nSpecies = Oak\r\n");
    EXPECT_TRUE(file.warnings().empty());
    EXPECT_EQ(weberPenn(file.params()).scale, 12);
    EXPECT_EQ(file.params().text.species, "Oak");
}

TEST(TreeFile, ThesisSpellingsAreRead) {
    const std::tuple<const char*, const char*, double> aliases[] = {
        {"LobesDepth", "LobeDepth", 0.25}, {"BaseSplits", "0BaseSplits", 2}, {"nBaseSplits", "0BaseSplits", 2},
        {"0BaseSplit", "0BaseSplits", 2},  {"0SegSplit", "0SegSplits", 0.5}, {"1SegSplit", "1SegSplits", 0.5},
        {"2SegSplit", "2SegSplits", 0.5},  {"3SegSplit", "3SegSplits", 0.5}, {"0Lenght", "0Length", 0.75},
        {"1Lenght", "1Length", 0.75},      {"2Lenght", "2Length", 0.75},     {"3Lenght", "3Length", 0.75},
        {"0LenghtV", "0LengthV", 0.125},   {"1LenghtV", "1LengthV", 0.125},  {"2LenghtV", "2LengthV", 0.125},
        {"3LenghtV", "3LengthV", 0.125},   {"Bend", "LeafBend", 0.625}};
    for (const auto& [alias, key, value] : aliases) {
        const std::string line = std::string(alias) + " = " + numberText(value) + "\n";
        EXPECT_EQ(valueOf(quietly(line), key), value) << alias;
        const std::string both = "Format = 1\n" + line + key + " = " + numberText(value) + "\n";
        EXPECT_THROW(parsed(both), CInputError) << alias << " beside " << key << " are two values";
    }
}

TEST(TreeFile, WordsAreReadAndNumbersWritten) {
    const CTreeFile file = parsed("Format = 1\nShape = flame\nCloneHalving = off\nLeafShape = square\n");
    EXPECT_EQ(weberPenn(file.params()).shape, 5);
    EXPECT_EQ(weberPenn(file.params()).cloneHalving, 0);
    EXPECT_EQ(file.params().common.leafShape, 6);
    CParams changed = file.params();
    weberPenn(changed).shape = 2;
    EXPECT_EQ(file.text(changed), "Format = 1\nShape = 2\nCloneHalving = off\nLeafShape = square\n");
}

TEST(TreeFile, PresetsAreReadWithoutAWord) {
    const auto files = test::presetFiles();
    EXPECT_GE(files.size(), 4u);
    for (const auto& path : files) {
        const CTreeFile file = CTreeFile::read(path);
        EXPECT_TRUE(file.warnings().empty()) << path;
        EXPECT_EQ(file.text(file.params()), readFile(path)) << path;
        EXPECT_NE(file.params(), CParams(file.params().block())) << path;
    }
}

TEST(TreeFile, ANewDocumentOfAPresetIsTheSameTree) {
    for (const auto& path : test::presetFiles()) {
        const CParams params = CTreeFile::read(path).params();
        EXPECT_TRUE(parsed(CTreeFile(params.block()).text(params)).params() == params) << path;
    }
}

} // namespace
} // namespace stromar
