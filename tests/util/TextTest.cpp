#include "stromar/util/Text.h"
#include "stromar/util/Error.h"
#include "stromar/util/FileSet.h"
#include "util/TemporaryFolder.h"
#include <bit>
#include <clocale>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <locale>
#include <random>
#include <vector>

namespace stromar {
namespace {

TEST(Text, NumbersAreWrittenShort) {
    const std::pair<double, const char*> cases[] = {
        {0, "0"},       {1, "1"},     {-2.5, "-2.5"},    {0.1, "0.1"},
        {0.17, "0.17"}, {100, "100"}, {1e300, "1e+300"}, {2147483647, "2147483647"}};
    for (const auto& [value, text] : cases) EXPECT_EQ(numberText(value), text);
}

TEST(Text, EveryNumberReadsBackExactly) {
    std::mt19937_64 bits(1);
    for (int i = 0; i < 20000; ++i) {
        const auto value = std::bit_cast<double>(bits());
        if (!std::isfinite(value)) continue;
        const auto back = parseNumber(numberText(value));
        ASSERT_TRUE(back) << numberText(value);
        ASSERT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(value));
    }
}

TEST(Text, NumbersAreRead) {
    const std::pair<const char*, double> cases[] = {{"5", 5},    {"+5", 5}, {"-5", -5},    {"0.25", 0.25},
                                                    {".5", 0.5}, {"5.", 5}, {"1e3", 1000}, {"1.5E-2", 0.015},
                                                    {"-0", 0},   {"007", 7}};
    for (const auto& [text, value] : cases) EXPECT_EQ(parseNumber(text), std::optional(value)) << text;
}

TEST(Text, WhatIsNoNumberIsRefused) {
    for (const char* text : {"",     " ",   "x",    "1x",  "1 2", " 1",       "1 ", "1,5",   "1.2.3",
                             "0x10", "inf", "-inf", "nan", "NaN", "infinity", "1e", "1e999", "-1e999",
                             "+-5",  "++5", "--5",  "+",   "-",   ".",        "e5", "1_000", "٣"})
        EXPECT_FALSE(parseNumber(text)) << "'" << text << "'";
}

/// Numbers with a decimal comma and points between thousands.
struct GermanNumbers : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

/// The program's locale becomes a German one: the C++ one always, C's where the system has it.
class CGermanLocale {
public:
    CGermanLocale()
        : m_cpp(std::locale::global(std::locale(std::locale::classic(), new GermanNumbers))),
          m_c(std::setlocale(LC_NUMERIC, nullptr)) {
        for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "cs_CZ.UTF-8", "cs_CZ.utf8"})
            if (std::setlocale(LC_NUMERIC, name)) break;
    }
    ~CGermanLocale() {
        std::locale::global(m_cpp);
        std::setlocale(LC_NUMERIC, m_c.c_str());
    }

private:
    std::locale m_cpp;
    std::string m_c;
};

TEST(Text, TheLocaleDoesNotMatter) {
    const test::CTemporaryFolder folder;
    const CGermanLocale german;
    EXPECT_EQ(numberText(1234567.5), "1234567.5");
    EXPECT_EQ(parseNumber("1234567.5"), std::optional(1234567.5));
    EXPECT_FALSE(parseNumber("0,5"));
    CFileSet files;
    files.create(folder / "numbers") << 1234567 << ' ' << 0.5;
    files.commit();
    EXPECT_EQ(readFile(folder / "numbers"), "1234567 0.5");
}

TEST(Text, TrimmedAndLowerCase) {
    EXPECT_EQ(trimmed("  a b\t\r"), "a b");
    EXPECT_EQ(trimmed(" \t\r "), "");
    EXPECT_EQ(trimmed(""), "");
    EXPECT_EQ(trimmed("x"), "x");
    EXPECT_EQ(lowerCase("DownAngle 1Á"), "downangle 1Á");
}

TEST(Text, FindsTheNearestWord) {
    const std::vector<std::string> keys{"Scale", "ScaleV", "Shape", "1DownAngle", "2DownAngle", "Leaves", "LeafScale"};
    const std::pair<const char*, const char*> near[] = {
        {"Scal", "Scale"},           {"scale", "Scale"},           {"SCALEV", "ScaleV"}, {"Shpae", "Shape"},
        {"1DwnAngel", "1DownAngle"}, {"2downangle", "2DownAngle"}, {"Leafs", "Leaves"},  {"LeafScal", "LeafScale"}};
    for (const auto& [word, meant] : near) {
        EXPECT_EQ(nearestWord(word, keys), std::optional<std::string>(meant)) << word;
        EXPECT_EQ(suggestion(word, keys), ", did you mean '" + std::string(meant) + "'?");
    }
    for (const char* far : {"", "Zebra crossing", "q", "xyzzy", "Method of growing"}) {
        EXPECT_FALSE(nearestWord(far, keys)) << far;
        EXPECT_EQ(suggestion(far, keys), "");
    }
    EXPECT_FALSE(nearestWord("Scale", {}));
}

TEST(Message, NamesThePlace) {
    const Message warning{Severity::Warning, "oak.tree", 12, 9, "text"};
    EXPECT_EQ(warning.toString(), "oak.tree:12:9: warning: text");
    const Message whole{Severity::Error, "oak.tree", 0, 0, "empty"};
    EXPECT_EQ(whole.toString(), "oak.tree: error: empty");
    EXPECT_EQ((Message{Severity::Error, "", 0, 0, "empty"}).toString(), "error: empty");
    EXPECT_STREQ(CInputError({warning, whole}).what(), "oak.tree:12:9: warning: text\noak.tree: error: empty");
}

} // namespace
} // namespace stromar
