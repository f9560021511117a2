#include "stromar/params/ParamText.h"
#include "params/Support.h"
#include "stromar/util/Text.h"
#include <gtest/gtest.h>

namespace stromar {
namespace {

using test::otherValue;
using test::param;
using test::valueOf;

struct Answer {
    SetResult result;
    double value;
    std::string problem;
};

Answer set(const char* key, std::string_view text) {
    CParams params;
    SetProblem problem;
    const SetResult result = setFromText(params, findParam(key).value(), text, problem);
    return {result, valueOf(params, key), problem.text};
}

TEST(ParamText, EveryValueGoesThroughText) {
    for (const ParamRef& ref : numberParams())
        for (const double value :
             {ref.info->range.min, ref.info->range.max, otherValue(*ref.info, ref.get(CParams()))}) {
            CParams params, back;
            ASSERT_TRUE(ref.set(params, value));
            SetProblem problem;
            EXPECT_EQ(setFromText(back, ref, valueText(params, ref), problem), SetResult::Done) << ref.key() << problem.text;
            EXPECT_TRUE(back == params) << ref.key();
        }
}

TEST(ParamText, OutOfRangeIsClampedAndSaid) {
    for (const ParamRef& ref : numberParams())
        for (const auto& [beyond, bound] : {std::pair(ref.info->range.min - 1, ref.info->range.min),
                                            std::pair(ref.info->range.max + 1, ref.info->range.max)}) {
            CParams params;
            SetProblem problem;
            EXPECT_EQ(setFromText(params, ref, numberText(beyond), problem), SetResult::Clamped) << ref.key();
            EXPECT_EQ(ref.get(params), bound) << ref.key();
            EXPECT_NE(problem.text.find(ref.key()), std::string::npos) << problem.text;
        }
}

TEST(ParamText, EveryWordOfAnEnumIsItsNumber) {
    int words = 0;
    for (const ParamRef& ref : numberParams())
        for (std::size_t i = 0; i < ref.info->words.size(); ++i) {
            ++words;
            CParams params;
            SetProblem problem;
            EXPECT_EQ(setFromText(params, ref, ref.info->words[i], problem), SetResult::Done) << problem.text;
            EXPECT_EQ(ref.get(params), double(i)) << ref.info->words[i];
            EXPECT_EQ(valueText(params, ref), std::to_string(i)) << "files have numbers";
        }
    EXPECT_EQ(words, 9 + 13 + 2 + 2 + 2 + 2); // crown shapes, leaf shapes, leaf forms, two switches
}

TEST(ParamText, WordsIgnoreCase) {
    EXPECT_EQ(set("Shape", "FLAME").value, 5);
    EXPECT_EQ(set("Shape", "Tend-Flame").value, 7);
    EXPECT_EQ(set("CloneHalving", "Off").value, 0);
    EXPECT_EQ(set("LeafShape", "needles").value, 7);
}

TEST(ParamText, BadValuesLeaveTheParamsAlone) {
    for (const ParamRef& ref : numberParams())
        for (const char* bad : {"", "x", "nan", "inf", "-inf", "1e999", "1,5", "0x1", "1 2", "flam3"}) {
            CParams params;
            SetProblem problem;
            EXPECT_EQ(setFromText(params, ref, bad, problem), SetResult::BadValue) << ref.key() << " = " << bad;
            EXPECT_NE(problem.text.find(ref.key()), std::string::npos) << problem.text;
            EXPECT_TRUE(params == CParams()) << ref.key() << " = " << bad;
        }
}

TEST(ParamText, IntegersRefuseFractions) {
    for (const ParamRef& ref : numberParams()) {
        CParams params;
        SetProblem problem;
        const SetResult result = setFromText(params, ref, "3.5", problem);
        if (ref.info->integer()) {
            EXPECT_EQ(result, SetResult::BadValue) << ref.key();
            EXPECT_TRUE(params == CParams());
        } else {
            EXPECT_NE(result, SetResult::BadValue) << ref.key();
        }
    }
    EXPECT_EQ(set("Levels", "3.0").value, 3);
    EXPECT_EQ(set("Levels", "+4").value, 4);
    EXPECT_EQ(set("Seed", "1e300").result, SetResult::Clamped);
}

TEST(ParamText, AnUnknownWordGetsASuggestion) {
    const Answer answer = set("Shape", "flamme");
    EXPECT_EQ(answer.result, SetResult::BadValue);
    EXPECT_NE(answer.problem.find("did you mean 'flame'"), std::string::npos) << answer.problem;
    EXPECT_EQ(set("Shape", "zigzag garden").problem.find("did you mean"), std::string::npos);
}

TEST(ParamText, MethodsAreSuggested) {
    EXPECT_NE(methodSuggestion("weber-pen").find("did you mean 'weber-penn'"), std::string::npos);
    EXPECT_NE(methodSuggestion("quite another").find("known: weber-penn"), std::string::npos);
}

TEST(ParamText, NearKeysAreSuggested) {
    EXPECT_EQ(keySuggestion("1DownAngel"), ", did you mean '1DownAngle'?");
    EXPECT_EQ(keySuggestion("LeafBemd"), ", did you mean 'LeafBend'?");
    EXPECT_EQ(keySuggestion("Speceis"), ", did you mean 'Species'?");
    EXPECT_EQ(keySuggestion("Quite something else"), "");
}

TEST(ParamText, ThePagesNameEveryRow) {
    const std::string markdown = paramsAsMarkdown(), text = paramsAsText();
    for (const ParamInfo* row : rowsOf(weberPennBlock())) {
        const ParamInfo& info = *row;
        const std::string key = (info.perLevel() ? "n" : "") + std::string(info.key);
        EXPECT_NE(markdown.find("| `" + key + "` |"), std::string::npos) << key;
        EXPECT_NE(markdown.find(info.help), std::string::npos) << key;
        EXPECT_NE(text.find("  " + key + " "), std::string::npos) << key;
        EXPECT_NE(text.find(info.help), std::string::npos) << key;
    }
}

TEST(ParamText, EveryRowOfTheMarkdownHasSixCells) {
    const std::string page = paramsAsMarkdown();
    std::size_t rows = 0;
    for (std::size_t at = 0; at < page.size();) {
        const std::size_t end = page.find('\n', at);
        const std::string line = page.substr(at, end - at);
        if (line.starts_with("| `")) {
            ++rows;
            EXPECT_EQ(std::count(line.begin(), line.end(), '|'), 7) << line;
        }
        at = end == std::string::npos ? page.size() : end + 1;
    }
    EXPECT_EQ(rows, rowsOf(weberPennBlock()).size());
}

} // namespace
} // namespace stromar
