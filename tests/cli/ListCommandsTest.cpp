// The lists of parameters and formats.
#include "Checkout.h"
#include "cli/Cli.h"
#include "stromar/app/Formats.h"
#include "stromar/params/ParamText.h"
#include "stromar/params/ParamTable.h"
#include "stromar/util/FileSet.h"
#include <algorithm>
#include "stromar/app/Methods.h"
#include <gtest/gtest.h>
#include <map>

namespace stromar::test {

TEST(ParamsCommand, MarkdownIsThePageOfTheManual) {
    for (const TreeMethod& method : treeMethods()) {
        const bool isFirst = &method == &treeMethods().front();
        const std::string name(method.block->method), page = isFirst ? "parameters" : "parameters-" + name;
        const ProcessResult run = cli({"params", "--method", name, "--markdown"});
        EXPECT_EQ(run.status, 0);
        EXPECT_EQ(run.err, "");
        EXPECT_EQ(run.out, readFile(inSource("docs/" + page + ".md")))
            << "write it anew with: stromar-cli params --method " << name << " --markdown";
    }
}

/// A build without OpenSceneGraph has fewer rows.
TEST(FormatsCommand, MarkdownIsThePageOfTheManual) {
    const std::string page = readFile(inSource("docs/formats.md"));
    const ProcessResult run = cli({"formats", "--markdown"});
    EXPECT_EQ(run.status, 0);
    std::istringstream lines(run.out);
    std::size_t rows = 0;
    for (std::string line; std::getline(lines, line); ++rows)
        EXPECT_NE(page.find(line + "\n"), std::string::npos) << line << ": write the page anew";
    EXPECT_GE(rows, formatTable().size());
}

TEST(ImportsCommand, MarkdownIsThePageOfTheManual) {
    const ProcessResult run = cli({"imports", "--markdown"});
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.out, readFile(inSource("docs/import.md"))) << "write it anew with: stromar-cli imports --markdown";
}

TEST(ImportCommand, WritesATreeAndTellsWhatChanged) {
    const CTemporaryFolder folder;
    writeFile(folder / "a.py", "{'g_scale': 17,\n 'gadget': 1}");
    const ProcessResult run = cli({"import", (folder / "a.py").string(), "-o", (folder / "a.tree").string()});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.err.find("a.py:2:2: warning: 'gadget' is not known"), std::string::npos) << run.err;
    EXPECT_NE(readFile(folder / "a.tree").find("\nScale = 17\n"), std::string::npos);
    writeFile(folder / "b.py", "import os");
    const ProcessResult broken = cli({"import", (folder / "b.py").string(), "-o", (folder / "a.tree").string()});
    EXPECT_EQ(broken.status, 1);
    EXPECT_NE(broken.err.find("b.py:1:8: error: "), std::string::npos) << broken.err;
    EXPECT_NE(readFile(folder / "a.tree").find("\nScale = 17\n"), std::string::npos) << "the file is as it was";
}

TEST(ParamsCommand, MarkdownTablesAreWhole) {
    std::istringstream page(cli({"params", "--markdown"}).out);
    std::size_t rows = 0;
    bool isPictureRow = false; // in a table of two columns
    for (std::string line; std::getline(page, line);) {
        if (!line.starts_with('|')) isPictureRow = false;
        if (line == "| | |") isPictureRow = true;
        if (!line.starts_with('|')) continue;
        EXPECT_EQ(std::ranges::count(line, '|'), isPictureRow ? 3 : 7) << line;
        ++rows;
    }
    EXPECT_GT(rows, rowsOf(weberPennBlock()).size());
}

TEST(ParamsCommand, JsonListsEveryParameter) {
    const Json rows = Json::parse(cli({"params", "--json"}).out);
    std::map<std::string, Json> byKey;
    for (const Json& row : rows) EXPECT_TRUE(byKey.emplace(row.at("key"), row).second) << row.at("key");
    EXPECT_EQ(byKey.size(), allParams().size());
    for (const ParamRef& ref : numberParams()) {
        ASSERT_TRUE(byKey.contains(ref.key())) << ref.key();
        const Json& row = byKey[ref.key()];
        EXPECT_EQ(row.at("min"), ref.info->range.min) << ref.key();
        EXPECT_EQ(row.at("max"), ref.info->range.max) << ref.key();
        EXPECT_EQ(row.at("default"), std::get<double>(defaultOf(ref, weberPennBlock()))) << ref.key();
        EXPECT_EQ(row.at("type"), std::string(kindName(*ref.info))) << ref.key();
        EXPECT_EQ(row.contains("words"), !ref.info->words.empty()) << ref.key();
    }
    for (const ParamRef& ref : allParams()) EXPECT_TRUE(byKey.contains(ref.key())) << ref.key();
}

TEST(ParamsCommand, TextNamesEveryRow) {
    const ProcessResult run = cli({"params"});
    EXPECT_EQ(run.status, 0);
    for (const ParamInfo* info : rowsOf(weberPennBlock()))
        EXPECT_NE(run.out.find(info->key), std::string::npos) << info->key;
}

TEST(FormatsCommand, ListsEveryFormat) {
    const ProcessResult run = cli({"formats", "--json"});
    EXPECT_EQ(run.status, 0);
    const Json rows = Json::parse(run.out);
    ASSERT_EQ(rows.size(), formatTable().size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i].at("ending"), formatTable()[i].ending);
        EXPECT_EQ(rows[i].at("name"), formatTable()[i].name);
        EXPECT_FALSE(rows[i].at("loses").get<std::string>().empty());
    }
    const std::string text = cli({"formats"}).out;
    EXPECT_EQ(std::ranges::count(text, '\n'), static_cast<std::ptrdiff_t>(formatTable().size()));
    for (const Format& format : formatTable()) EXPECT_NE(text.find(format.ending), std::string::npos) << format.ending;
}

} // namespace stromar::test
