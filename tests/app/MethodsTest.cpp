// A way to grow that no file of the program names: a class, a table and a row (tests/methods/Pole.cpp).
#include "Checkout.h"
#include "app/SameModel.h"
#include "methods/Pole.h"
#include "stromar/app/Demonstration.h"
#include "stromar/app/Export.h"
#include "stromar/app/Randomise.h"
#include "stromar/mesh/check/MeshCheck.h"
#include "stromar/model/MeshValues.h"
#include "stromar/params/ParamText.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/params/TreeFile.h"
#include "stromar/util/FileSet.h"
#include "util/TemporaryFolder.h"
#include <fstream>
#include <gtest/gtest.h>

namespace stromar::test {

namespace {
const ParamBlock& block() { return *poleMethod().block; }
ParamRef row(const char* key) { return *findParam(key, block()); }

const std::string kFile = "Format = 2\n"
                          "Method = pole  # ours\n"
                          "\n"
                          "# Pole\n"
                          "PoleHeight = 4 # metres\n"
                          "PoleThickness = 0:0.2, 3:0.1,   8:0.02 # by the piece\n"
                          "PolePlan = \"\"\"\n"
                          "LL # no comment: text\n"
                          "  L = x\n"
                          "\"\"\" # the plan\n"
                          "Species = Pole\n";

CTreeFile parsed(const std::string& text = kFile) {
    static_cast<void>(block());
    return CTreeFile::parse(text, "pole.tree");
}

Messages fileErrorsOf(const std::string& text) {
    try {
        parsed(text);
    } catch (const CInputError& error) {
        return error.messages();
    }
    return {};
}

void expectErrorAt(const std::string& text, int line, int column, const std::string& says) {
    const Messages errors = fileErrorsOf(text);
    ASSERT_EQ(errors.size(), 1u) << text;
    EXPECT_EQ(errors[0].line, line) << errors[0].toString();
    EXPECT_EQ(errors[0].column, column) << errors[0].toString();
    EXPECT_NE(errors[0].text.find(says), std::string::npos) << errors[0].toString();
}
} // namespace

TEST(Methods, WeberAndPennIsTheFirst) {
    EXPECT_EQ(treeMethods().front().block, &weberPennBlock());
    EXPECT_EQ(&methodOf(CParams()), &treeMethods().front());
}

TEST(Methods, OneMoreHasItsOwnValuesAndTheCommonOnes) {
    const CParams params(block());
    EXPECT_EQ(params.as<PoleParams>().height, 6);
    EXPECT_EQ(params.common.flare, 0) << "the method's own default of a common value";
    EXPECT_EQ(CParams().common.flare, 0.5);
    EXPECT_EQ(params.common.seed, CParams().common.seed);
    EXPECT_FALSE(params == CParams());
    std::size_t own = 0;
    for (const ParamRef& ref : allParams(block())) own += ref.key().starts_with("Pole");
    EXPECT_EQ(own, 7u);
    EXPECT_TRUE(findParam("LeafScale", block()));
    EXPECT_FALSE(findParam("1Branches", block())) << "the keys of another method are unknown";
}

TEST(Methods, EveryKindGoesThroughAFileByteForByte) {
    const CTreeFile file = parsed();
    EXPECT_TRUE(file.warnings().empty());
    const PoleParams& values = file.params().as<PoleParams>();
    EXPECT_EQ(values.height, 4);
    EXPECT_EQ(values.thickness, CCurve({{0, 0.2}, {3, 0.1}, {8, 0.02}}));
    EXPECT_EQ(values.plan, "LL # no comment: text\n  L = x");
    EXPECT_EQ(file.text(file.params()), kFile);

    CParams params = file.params();
    params.as<PoleParams>().thickness = CCurve({{0, 0.25}});
    params.as<PoleParams>().plan = "L\n\nL\n";
    const std::string saved = file.text(params);
    EXPECT_NE(saved.find("PoleThickness = 0:0.25 # by the piece\n"), std::string::npos) << saved;
    EXPECT_NE(saved.find("PolePlan = \"\"\"\nL\n\nL\n\n\"\"\" # the plan\n"), std::string::npos) << saved;
    EXPECT_EQ(parsed(saved).params(), params);
    EXPECT_EQ(parsed(CTreeFile(block()).text(params)).params(), params) << "a new file";
    EXPECT_TRUE(CTreeFile(block()).text(params).starts_with("Format = 2\nMethod = pole\n"));
}

TEST(Methods, LineEndingsStayAsTheyAre) {
    std::string windows;
    for (const char c : kFile) windows += c == '\n' ? "\r\n" : std::string(1, c);
    const CTreeFile file = parsed(windows);
    EXPECT_EQ(file.params(), parsed().params());
    EXPECT_EQ(file.text(file.params()), windows);
    CParams params = file.params();
    params.as<PoleParams>().plan = "L\nL";
    EXPECT_NE(file.text(params).find("PolePlan = \"\"\"\r\nL\r\nL\r\n\"\"\""), std::string::npos);
}

TEST(Methods, ErrorsNameThePoint) {
    const std::string head = "Format = 2\nMethod = pole\n";
    expectErrorAt(head + "PoleThickness = 0:1, 3:x\n", 3, 22, "point 2 ('3:x')");
    expectErrorAt(head + "PoleThickness = 0:1, 3\n", 3, 22, "not x:y");
    expectErrorAt(head + "PoleThickness = 3:1, 2:1\n", 3, 22, "to the right");
    expectErrorAt(head + "PoleThickness = 0:1,, 2:1\n", 3, 21, "empty");
    expectErrorAt(head + "PoleThickness =\n", 3, 16, "empty");
    const Messages warnings = parsed(head + "PoleThickness = 0:1, 3:7\n").warnings();
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].column, 22);
    EXPECT_NE(warnings[0].text.find("point 2"), std::string::npos) << warnings[0].text;
    expectErrorAt(head + "PolePlan = \"\"\"\nL\nL\n", 3, 12, "not closed");
}

TEST(Methods, MethodsThatAreNotKnownAreRefusedWithTheKnownOnes) {
    expectErrorAt("Format = 2\nMethod = pol\n", 2, 10, "did you mean 'pole'");
    expectErrorAt("Format = 2\nMethod = strudel\nX = 1\n", 2, 10, "weber-penn, l-system, strands, pole");
}

TEST(Methods, TheFormatKeepsOlderReadersAway) {
    const Messages warnings = parsed("Format = 1\nMethod = pole\n").warnings();
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].text.find("Format = 2"), std::string::npos);
    EXPECT_TRUE(parsed("Format = 2\nMethod = pole\n").warnings().empty());
    EXPECT_TRUE(parsed("Format = 1\nMethod = weber-penn\n").warnings().empty());
}

TEST(Methods, AKeyOfAnotherMethodIsKeptWithItsLines) {
    const std::string text = "Format = 1\nScale = 12\nPolePlan = \"\"\"\nScale = 7\n\"\"\"\nLevels = 2\n";
    const CTreeFile file = parsed(text);
    ASSERT_EQ(file.warnings().size(), 1u);
    EXPECT_EQ(file.warnings()[0].line, 3);
    EXPECT_EQ(file.text(file.params()), text);
}

TEST(Methods, ACopiedRowIsLinesOfAFile) {
    const CParams params = parsed().params();
    const std::string lines = CTreeFile::lines(params, {row("PoleThickness"), row("PolePlan")});
    const ParamValues given = parsed("Method = pole\n" + lines).givenValues();
    ASSERT_EQ(given.size(), 2u);
    EXPECT_EQ(given[0].second, row("PoleThickness").value(params));
    EXPECT_EQ(given[1].second, row("PolePlan").value(params));
}

TEST(Methods, GrowsMeshesAndExports) {
    const CTemporaryFolder folder;
    const CParams params = parsed().params();
    for (const Detail& detail : detailTable()) {
        const auto model = CTreeCreator().create(params, detail, CProgress(2));
        EXPECT_EQ(model->tree->stemCount(), 1u);
        EXPECT_EQ(model->tree->leaves().size(), 3u);
        const auto stems = meshAllStems(*model->tree, meshParamsOf(params), detail, CProgress(2));
        EXPECT_TRUE(checkStems(*model->tree, 0, stems[0], {}).sound()) << detail.name;
        const Prediction size = predictSize(params, detail);
        EXPECT_GE(size.vertices, double(model->vertexCount())) << detail.name;
    }
    exportModel(*CTreeCreator().create(params, detailOf(Model::Full), CProgress(2)), {}, folder / "pole.obj", CProgress(2));
    EXPECT_TRUE(std::filesystem::exists(folder / "pole.obj"));
}

TEST(Methods, ACreatorTakesTreesOfBothInTurn) {
    CTreeCreator creator;
    const CParams pole = parsed().params();
    const auto first = creator.create(pole, detailOf(Model::Simple), CProgress(2));
    EXPECT_GT(creator.create(CParams(), detailOf(Model::Simple), CProgress(2))->tree->stemCount(), 1u);
    EXPECT_EQ(modelDifference(*creator.create(pole, detailOf(Model::Simple), CProgress(2)), *first), "");
}

TEST(Methods, AChangeRedoesWhatItsRowSays) {
    const CParams before(block());
    CParams after = before;
    after.as<PoleParams>().thickness = CCurve({{0, 0.1}});
    EXPECT_EQ(invalidationOf(before, after), (Invalidation{Stage::Structure, 0}));
    after = before;
    after.common.minRadius = 0.01;
    EXPECT_EQ(invalidationOf(before, after), (Invalidation{Stage::Mesh, 0}));
}

TEST(Methods, ChanceMovesNumbersAndCurvesButNoTexts) {
    const CParams params(block());
    const ParamValues moved = randomised(params, allParams(block()), 0.5, 3);
    const auto has = [&](const char* key) {
        return std::ranges::any_of(moved, [&](const auto& v) { return v.first == row(key); });
    };
    EXPECT_TRUE(has("PoleHeight") && has("PoleThickness"));
    EXPECT_FALSE(has("PolePlan") || has("PoleTop") || has("PoleBent"));
    // By key: another table in front of a row does not move its numbers.
    const ParamRef ratio = *findParam("LeafScale");
    const auto valueIn = [&](const ParamValues& values) {
        return std::ranges::find(values, ratio, [](const auto& v) { return v.first; })->second;
    };
    CParams leafy;
    weberPenn(leafy).leaves = 5;
    EXPECT_EQ(valueIn(randomised(leafy, allParams(), 0.5, 3)), valueIn(moved));
}

TEST(Methods, TheListsShowIt) {
    const std::string page = paramsAsMarkdown(block());
    for (const char* key : {"PoleHeight", "PoleThickness", "PolePlan", "LeafScale"})
        EXPECT_NE(page.find("| `" + std::string(key) + "` |"), std::string::npos) << key;
    EXPECT_NE(page.find("0:0.3, 5:0.05"), std::string::npos);
    EXPECT_EQ(demonstrationsOf(row("PoleHeight")).size(), 3u);
}

TEST(Methods, NoFileOfTheProgramNamesIt) {
    for (const char* folder : {"src", "include"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(inSource(folder)))
            if (entry.is_regular_file()) {
                EXPECT_EQ(readFile(entry.path()).find("PoleHeight"), std::string::npos) << entry.path();
            }
}

} // namespace stromar::test
