#include "params/Support.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/util/FileSet.h"
#include "util/TemporaryFolder.h"
#include <gtest/gtest.h>

namespace stromar {
namespace {

using test::CTemporaryFolder;
using test::otherValue;
using test::parsed;

/// A file with all that a hand may write.
const std::string kByHand = "# An oak\r\n"
                            "Format = 1\r\n"
                            "\r\n"
                            "  Scale\t=  12.50   # metres\r\n"
                            "Ratio=0.02\r\n"
                            "Species = \"Oak # 7\"   # quoted\r\n"
                            "Shape = Flame\r\n"
                            "Fruit = acorn # unknown here\r\n"
                            "Bend = .5\r\n"
                            "1Curve = -0040\r\n"
                            "\t\r\n"
                            "# the end";

TEST(TreeFileWrite, AnUnchangedDocumentKeepsItsBytes) {
    const std::string newline = [] {
        std::string text = kByHand;
        std::erase(text, '\r');
        return text;
    }();
    for (const std::string& text :
         {kByHand, newline, "\xEF\xBB\xBF" + kByHand, kByHand + "\r\n\r\n", newline + "\n", std::string("Scale = 12"),
          std::string("Scale = 12\n\n\n"), std::string("Scale = 99999\n"), std::string("Scale=12\r\nRatio = .1\n")}) {
        const CTreeFile file = parsed(text);
        EXPECT_EQ(file.text(file.params()), text);
    }
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return text.replace(at, old.size(), by);
}

TEST(TreeFileWrite, OnlyTheChangedValueChanges) {
    const CTreeFile file = parsed(kByHand);
    CParams params = file.params();
    weberPenn(params).scale = 20;
    EXPECT_EQ(file.text(params), replaced(kByHand, "12.50", "20"));
    params.text.species = "Elm # 8";
    EXPECT_EQ(file.text(params), replaced(replaced(kByHand, "12.50", "20"), "Oak # 7", "Elm # 8"));
    params = file.params();
    params.common.leafBend = 0.75;
    EXPECT_EQ(file.text(params), replaced(kByHand, "Bend = .5", "Bend = 0.75"));
    params = file.params();
    weberPenn(params).level[1].curve = 30;
    weberPenn(params).shape = 0;
    EXPECT_EQ(file.text(params), replaced(replaced(kByHand, "-0040", "30"), "Flame", "0"));
}

TEST(TreeFileWrite, BlanksAroundAChangedValueStay) {
    const CTreeFile file = parsed("Format = 1\nScale=12\nRatio   =0.02\n");
    CParams params = file.params();
    weberPenn(params).scale = 20;
    weberPenn(params).ratio = 0.25;
    EXPECT_EQ(file.text(params), "Format = 1\nScale=20\nRatio   =0.25\n");
}

TEST(TreeFileWrite, AStrayCarriageReturnInFrontOfAValueStays) {
    const CTreeFile file = parsed("Format = 1\nScale =\r12\nLeafTexture =\r\"a b.png\"\n");
    CParams params = file.params();
    EXPECT_EQ(weberPenn(params).scale, 12);
    EXPECT_EQ(params.text.leafTexture, "a b.png");
    weberPenn(params).scale = 20;
    params.text.leafTexture = "c.png";
    EXPECT_EQ(file.text(params), "Format = 1\nScale =\r20\nLeafTexture =\rc.png\n");
}

TEST(TreeFileWrite, EveryChangeOfAPresetTouchesOneLine) {
    for (const auto& path : test::presetFiles()) {
        const CTreeFile file = CTreeFile::read(path);
        const std::string before = readFile(path);
        for (const ParamRef& ref : numberParams(file.params().block())) {
            const bool absent = before.find("\n" + ref.key() + " =") == std::string::npos; // has its default
            CParams params = file.params();
            ref.set(params, otherValue(*ref.info, ref.get(params)));
            const std::string after = file.text(params);
            EXPECT_TRUE(parsed(after).params() == params) << ref.key();
            EXPECT_EQ(std::count(after.begin(), after.end(), '\n'),
                      std::count(before.begin(), before.end(), '\n') + (absent ? 1 : 0))
                << ref.key();
            if (absent) {
                const std::size_t added = after.find("\n" + ref.key() + " =") + 1, behind = after.find('\n', added) + 1;
                EXPECT_EQ(after.substr(0, added) + after.substr(behind), before) << ref.key();
                continue;
            }
            const std::size_t line = before.find("\n" + ref.key() + " =") + 1, next = before.find('\n', line);
            EXPECT_EQ(after.substr(0, line), before.substr(0, line)) << ref.key();
            EXPECT_TRUE(after.ends_with(before.substr(next))) << ref.key();
        }
    }
}

TEST(TreeFileWrite, AddedKeysStandAtTheEndOfTheirGroup) {
    const std::string text =
        "Format = 1\n# Tree\nScale = 12 # metres\nLevels = 2\n\n# First\n1Curve = 5\n1Length = 0.4\n\n# Second\n"
        "2Curve = 6\n# end\n";
    const CTreeFile file = parsed(text);
    CParams params = file.params();
    weberPenn(params).ratio = 0.25;
    weberPenn(params).level[1].curveV = 7;
    weberPenn(params).level[2].curveV = 8;
    const std::string expected =
        "Format = 1\n# Tree\nScale = 12 # metres\nLevels = 2\nRatio = 0.25\n\n# First\n1Curve = 5\n"
        "1Length = 0.4\n1CurveV = 7\n\n# Second\n2Curve = 6\n2CurveV = 8\n# end\n";
    EXPECT_EQ(file.text(params), expected);
}

TEST(TreeFileWrite, EveryMissingKeyCanBeAdded) {
    for (const std::string& text : {std::string("Format = 1"), std::string("Format = 1\r\n# x\r\n"), kByHand})
        for (const ParamRef& ref : numberParams()) {
            const CTreeFile file = parsed(text);
            CParams params = file.params();
            ref.set(params, otherValue(*ref.info, ref.get(params)));
            const std::string saved = file.text(params);
            EXPECT_TRUE(parsed(saved).params() == params) << ref.key() << "\n" << saved;
            const auto returns = std::count(saved.begin(), saved.end(), '\r');
            if (text.find('\r') != std::string::npos) {
                EXPECT_EQ(returns, std::count(saved.begin(), saved.end(), '\n')) << ref.key() << ": mixed line ends";
            } else {
                EXPECT_EQ(returns, 0);
            }
        }
}

TEST(TreeFileWrite, SavingTwiceIsStable) {
    const CTemporaryFolder folder;
    CTreeFile file = parsed(kByHand);
    CParams params = file.params();
    params.common.flare = 0.75;
    file = file.write(folder / "oak.tree", params);
    const std::string once = readFile(folder / "oak.tree");
    EXPECT_TRUE(file.params() == params);
    file.write(folder / "oak.tree", params);
    EXPECT_EQ(readFile(folder / "oak.tree"), once);
    params.common.flare = 0.5;
    file.write(folder / "oak.tree", params);
    EXPECT_EQ(readFile(folder / "oak.tree"), replaced(once, "Flare = 0.75", "Flare = 0.5"));
    EXPECT_EQ(folder.names(), std::set<std::string>{"oak.tree"});
}

TEST(TreeFileWrite, TextsOfAllKindsReadBack) {
    for (const std::string text : {"",    " ",   "#",     "# x",       "x#y",    "x #y",       "\"",        "\"\"",
                                   "\"x", "x\"", "\"x\"", "a \"b\" c", " x ",    "x = y",      "=",         "Dub letní",
                                   "\t",  "x\t", "12",    "\"#\"",     "a\"\"b", "weber-penn", "Format = 2"})
        for (const ParamRef& ref : allParams()) {
            if (ref.info->kind() != ParamKind::Text) continue;
            CParams params;
            ref.setValue(params, text);
            EXPECT_TRUE(parsed(CTreeFile().text(params)).params() == params) << ref.key() << " = '" << text << "'";
            for (const std::string before : {"Oak", "\"Oak # 1\"", "Oak # comment", "", "\"\" # comment"}) {
                const std::string line = ref.key() + " = " + before + "\n";
                const CTreeFile file = parsed("Format = 1\n" + line);
                CParams changed = file.params();
                ref.setValue(changed, text);
                EXPECT_TRUE(parsed(file.text(changed)).params() == changed) << line << "set to '" << text << "'";
            }
        }
}

TEST(TreeFileWrite, ACommentBehindAnEmptyTextStaysAComment) {
    const CTreeFile file = parsed("Format = 1\nSpecies = # not yet named\n");
    CParams params = file.params();
    params.text.species = "Oak";
    const std::string saved = file.text(params);
    EXPECT_EQ(parsed(saved).params().text.species, "Oak") << saved;
    EXPECT_TRUE(saved.ends_with(" # not yet named\n")) << saved;
}

/// An importer or a pasted text may hold anything; what is saved has to be a file that can be read.
TEST(TreeFileWrite, WhatIsSavedCanBeRead) {
    for (const std::string text :
         {"two\nlines", "a\r\nb", "Scale = 5\nScale = 6", "bell\a", "\xFF\xFE", "cut \xC5", "\nScale"})
        for (const CTreeFile& file : {CTreeFile(), parsed("Format = 1\nDescription = x\n")}) {
            CParams params = file.params();
            params.text.description = text;
            try {
                const CParams back = parsed(file.text(params)).params();
                EXPECT_TRUE(back.common == params.common && weberPenn(back) == weberPenn(params)) << text;
            } catch (const CInputError& error) {
                ADD_FAILURE() << error.what() << "\nafter the description became\n" << text;
            }
        }
}

TEST(TreeFileWrite, AFailedWriteLeavesTheOldFile) {
    const CTemporaryFolder folder;
    const CTreeFile file = parsed("Format = 1\nScale = 12\n");
    std::filesystem::create_directory(folder / "oak.tree");
    EXPECT_THROW(file.write(folder / "oak.tree", file.params()), CError);
    EXPECT_THROW(file.write(folder / "nowhere/oak.tree", file.params()), CError);
    EXPECT_EQ(folder.names(), std::set<std::string>{"oak.tree"});
    EXPECT_TRUE(std::filesystem::is_empty(folder / "oak.tree"));
}

} // namespace
} // namespace stromar
