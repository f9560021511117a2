#include "params/Support.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/util/FileSet.h"
#include "util/TemporaryFolder.h"
#include <gtest/gtest.h>

namespace stromar {
namespace {

using test::CTemporaryFolder;

const std::string kMark = "\xEF\xBB\xBF";

/// The errors of a text, none if it is read.
Messages errorsOf(const std::string& text) {
    try {
        (void)CTreeFile::parse(text, "x.tree");
        return {};
    } catch (const CInputError& error) {
        return error.messages();
    }
}

struct BadText {
    std::string text;
    int line, column;
    const char* says; ///< a part of the message
};

void expectError(const BadText& bad) {
    const Messages errors = errorsOf(bad.text);
    ASSERT_EQ(errors.size(), 1u) << bad.text;
    const Message& error = errors.front();
    EXPECT_EQ(error.severity, Severity::Error);
    EXPECT_EQ(error.file, "x.tree");
    EXPECT_EQ(error.line, bad.line) << error.toString() << "\nin\n" << bad.text;
    EXPECT_EQ(error.column, bad.column) << error.toString() << "\nin\n" << bad.text;
    EXPECT_NE(error.text.find(bad.says), std::string::npos) << error.toString();
}

TEST(TreeFileError, ValuesThatAreNoNumbers) {
    const BadText cases[] = {{"Format = 1\nScale = twelve\n", 2, 9, "twelve"},
                             {"Format = 1\n  Scale =    12m # x\n", 2, 14, "12m"},
                             {"Format = 1\nScale = inf\n", 2, 9, "inf"},
                             {"Format = 1\nScale = -nan\n", 2, 9, "nan"},
                             {"Format = 1\nScale = 1e999\n", 2, 9, "1e999"},
                             {"Format = 1\nScale = 1,5\n", 2, 9, "1,5"},
                             {"Format = 1\nScale = 1 2\n", 2, 9, "1 2"},
                             {"Format = 1\nLevels = 3.5\n", 2, 10, "3.5"},
                             {"Format = 1\n\n\n1CurveRes\t=\t2.5", 4, 13, "1CurveRes"},
                             {"Format = 1\nScale =\n", 2, 8, "Scale"},
                             {"Format = 1\nScale = # twelve\n", 2, 9, "Scale"}};
    for (const BadText& bad : cases) expectError(bad);
}

TEST(TreeFileError, WordsThatAreNoChoice) {
    expectError({"Format = 1\nShape = flamme\n", 2, 9, "did you mean 'flame'"});
    expectError({"Format = 1\nCloneHalving = perhaps\n", 2, 16, "perhaps"});
    expectError({"Format = 1\nMethod = strands\n", 2, 10, "strands"});
    expectError({"Format = 1\nScale = flame\n", 2, 9, "flame"});
}

TEST(TreeFileError, TwoValues) {
    expectError({"Format = 1\nScale = 5\nRatio = .1\nScale = 6\n", 4, 1, "Scale"});
    expectError({"Format = 1\nScale = 5\n   Scale = 5\n", 3, 4, "line 2"});
    expectError({"Format = 1\nBend = .5\nLeafBend = .5\n", 3, 1, "LeafBend"});
    expectError({"Format = 1\n1Lenght = .5\n1Length = .5\n", 3, 1, "1Length"});
    expectError({"Format = 1\nBaseSplits = 1\nnBaseSplits = 1\n", 3, 1, "0BaseSplits"});
    expectError({"Format = 1\nSpecies = Oak\nSpecies = Elm\n", 3, 1, "Species"});
    expectError({"Format = 1\nFormat = 1\n", 2, 1, "Format"});
}

TEST(TreeFileError, BrokenLines) {
    expectError({"Format = 1\nScale 12\n", 2, 1, "Key = Value"});
    expectError({"Format = 1\n\t Scale # = 12\n", 2, 3, "Key = Value"});
    expectError({"Format = 1\nScael\n", 2, 1, "did you mean 'Scale'"});
    expectError({"Format = 1\n = 12\n", 2, 2, "key"});
    expectError({"Format = 1\nSpecies = \"Oak\n", 2, 11, "quote"});
    expectError({"Format = 1\nSpecies = \"Oak\" tree\n", 2, 17, "quote"});
    expectError({"<xml>\n", 1, 1, "Key = Value"});
}

TEST(TreeFileError, ColumnsCountCharacters) {
    expectError({"Format = 1\nSpecies = \"Žluťoučký\" kůň\n", 2, 23, "quote"});
    expectError({"Format = 1\nSpecies = Dub \xFF\n", 2, 15, "UTF-8"});
    expectError({"Format = 1\nSpecies = Žlu\xC5\n", 2, 14, "UTF-8"});
    expectError({"Format = 1\n# \xC0\xAF\n", 2, 3, "UTF-8"});
}

TEST(TreeFileError, SurrogatesOverlongAndTooHighCodesAreNoUtf8) {
    expectError({"Format = 1\nScale = 5 # \xED\xA0\x80 half a pair\n", 2, 13, "UTF-8"});
    expectError({"Format = 1\nSpecies = \xE0\x80\x80 too long\n", 2, 11, "UTF-8"});
    expectError({"Format = 1\nSpecies = \xF4\x90\x80\x80 too high\n", 2, 11, "UTF-8"});
}

TEST(TreeFileError, TheByteOrderMarkIsNoColumn) {
    expectError({kMark + "Scale = x\n", 1, 9, "x"});
    expectError({kMark + "Scale\n", 1, 1, "Key = Value"});
    expectError({kMark + "Species = \"Oak\n", 1, 11, "quote"});
    expectError({kMark + "Species = \xFF\n", 1, 11, "UTF-8"});
    expectError({kMark + "Format = 1\r\nScale = x\r\n", 2, 9, "x"});
    EXPECT_EQ(CTreeFile::parse(kMark + "Fruit = acorn\nFormat = 1\n", "x.tree").warnings().at(0).column, 1);
}

TEST(TreeFileError, Formats) {
    expectError({"Format = 3\n", 1, 10, "3"});
    expectError({"Scale = 5\nFormat=99\n", 2, 8, "99"});
    for (const char* bad : {"0", "-1", "1.5", "one", "", "nan"})
        EXPECT_EQ(errorsOf(std::string("Format = ") + bad + "\n").size(), 1u) << bad;
}

TEST(TreeFileError, FilesThatAreNoText) {
    for (const std::string& empty : {std::string(), std::string("\n"), std::string(" \t\r\n\r\n ")})
        expectError({empty, 0, 0, "empty"});
    expectError({std::string("PNG\0\1\2 = 3", 11), 0, 0, "not a text"});
    expectError({std::string("Scale = 5\0", 10), 0, 0, "not a text"});
    expectError({std::string("F\0o\0r\0m\0", 8), 0, 0, ""});
    expectError({std::string("\xFF\xFE"
                             "F\0o\0",
                             6),
                 0, 0, "UTF-16"});
    // Kraut's editor writes its version in four bytes, then its signature.
    const std::string kraut = std::string("\x02\0\0\0<Kraut>\x02\x05\0\0\0", 16);
    expectError({kraut, 0, 0, "Kraut"});
}

TEST(TreeFileError, AByteOrderMarkAloneIsAnEmptyFile) {
    expectError({kMark, 0, 0, "empty"});
    expectError({kMark + "\n", 0, 0, "empty"});
}

TEST(TreeFileError, AllErrorsAreReportedTogether) {
    const Messages errors =
        errorsOf("Format = 1\nScale = x\nGarbage\nRatio = 0.1\nRatio = 0.2\nLevels = 2.5\nShape = flamme\n");
    ASSERT_EQ(errors.size(), 5u);
    const int lines[] = {2, 3, 5, 6, 7};
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(errors[i].line, lines[i]);
    try {
        (void)CTreeFile::parse("Scale = x\nRatio = y\n", "oak.tree");
        FAIL();
    } catch (const CInputError& error) {
        const std::string what = error.what();
        EXPECT_NE(what.find("oak.tree:1:9: error: "), std::string::npos) << what;
        EXPECT_NE(what.find("\noak.tree:2:9: error: "), std::string::npos) << what;
    }
}

TEST(TreeFileError, FoldersAndMissingFiles) {
    const CTemporaryFolder folder;
    try {
        (void)CTreeFile::read(folder.path());
        FAIL() << "a folder was read";
    } catch (const CInputError& error) {
        ASSERT_EQ(error.messages().size(), 1u);
        EXPECT_EQ(error.messages()[0].file, folder.path().string());
        EXPECT_NE(error.messages()[0].text.find("folder"), std::string::npos);
    }
    EXPECT_THROW((void)CTreeFile::read(folder / "missing.tree"), CError);
    writeFile(folder / "bad.tree", "Format = 1\nScale = x\n");
    try {
        (void)CTreeFile::read(folder / "bad.tree");
        FAIL() << "a bad file was read";
    } catch (const CInputError& error) {
        EXPECT_EQ(error.messages().at(0).file, (folder / "bad.tree").string());
    }
}

struct Warned {
    std::string text;
    int line, column;
    const char* says;
};

Message onlyWarning(const std::string& text) {
    const CTreeFile file = CTreeFile::parse(text, "x.tree");
    EXPECT_EQ(file.warnings().size(), 1u) << text;
    return file.warnings().empty() ? Message{} : file.warnings().front();
}

TEST(TreeFileWarning, NamesThePlace) {
    const Warned cases[] = {{"Format = 1\nScale = 99999\n", 2, 9, "1000"},
                            {"Format = 1\n1DownAngle = -181\n", 2, 14, "-180"},
                            {"Format = 1\n  Fruit = acorn\n", 2, 3, "Fruit"},
                            {"Format = 1\n1DownAngel = 5\n", 2, 1, "did you mean '1DownAngle'"},
                            {"Format = 1\nscale = 5\n", 2, 1, "did you mean 'Scale'"},
                            {"Scale = 5\n", 0, 0, "Format"},
                            {"\r\nFruit = acorn\r\nFormat = 1\r\n", 2, 1, "Fruit"}};
    for (const auto& [text, line, column, says] : cases) {
        const Message warning = onlyWarning(text);
        EXPECT_EQ(warning.severity, Severity::Warning);
        EXPECT_EQ(warning.line, line) << warning.toString();
        EXPECT_EQ(warning.column, column) << warning.toString();
        EXPECT_NE(warning.text.find(says), std::string::npos) << warning.toString();
    }
}

TEST(TreeFileWarning, ClampedValuesAndUnknownKeys) {
    EXPECT_EQ(weberPenn(CTreeFile::parse("Format = 1\nScale = 99999\n", "").params()).scale, 1000);
    EXPECT_EQ(weberPenn(CTreeFile::parse("Format = 1\nLevels = 0\n", "").params()).levels, 1);
    const std::string text = "Format = 1\nFruit = acorn # kept\n4Curve = 5\nscale = 5\n";
    const CTreeFile file = CTreeFile::parse(text, "x.tree");
    EXPECT_EQ(file.warnings().size(), 3u);
    EXPECT_EQ(file.params(), CParams());
    EXPECT_EQ(file.text(file.params()), text);
}

} // namespace
} // namespace stromar
