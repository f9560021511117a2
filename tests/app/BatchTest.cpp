#include "stromar/app/Batch.h"
#include "stromar/params/TreeFile.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/util/FileSet.h"
#include "util/TemporaryFolder.h"
#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

namespace stromar::test {

namespace {
namespace fs = std::filesystem;

/// A folder with two small trees and a plan for them.
class Batch : public testing::Test {
protected:
    Batch() {
        for (const auto& [name, branches] : {std::pair{"oak", 3}, {"elm", 4}}) {
            CParams params;
            weberPenn(params).levels = 2;
            weberPenn(params).level[1].branches = branches;
            static_cast<void>(CTreeFile().write(m_folder / (std::string(name) + ".tree"), params));
        }
    }
    BatchPlan plan(const std::string& json) { return parsePlan(json, "plan.json", m_folder.path()); }
    BatchResult run(const BatchPlan& plan, bool force = false) {
        m_said.clear();
        return runBatch(plan, {2, force, {}, m_folder / "plan.done", "1"},
                        [&](const BatchFile& file, BatchOutcome outcome, std::size_t) { m_said.emplace(file.output.filename().string(), outcome); }, CProgress(2));
    }
    std::vector<std::string> errorsOf(const std::string& json) {
        try {
            static_cast<void>(plan(json));
        } catch (const CInputError& e) {
            std::vector<std::string> all;
            for (const Message& message : e.messages()) all.push_back(message.toString());
            return all;
        }
        return {};
    }

    CTemporaryFolder m_folder;
    std::multimap<std::string, BatchOutcome> m_said;
};

constexpr const char* kSmall = R"({"trees": "*.tree", "seeds": {"from": 1, "to": 2}, "lods": [0, 3], "formats": ["glb", "obj"],
  "output": "out/{tree}/{seed}_lod{lod}.{format}"})";
} // namespace

TEST_F(Batch, FilesAreTheProductOfItsLists) {
    const std::vector<BatchFile> files = filesOf(plan(kSmall));
    EXPECT_EQ(files.size(), 2u * 2 * 2 * 2);
    std::set<std::string> names;
    for (const BatchFile& file : files) names.insert(file.output.lexically_relative(m_folder.path()).string());
    EXPECT_EQ(names.size(), files.size());
    EXPECT_TRUE(names.contains("out/elm/1_lod0.glb"));
    EXPECT_TRUE(names.contains("out/oak/2_lod3.obj"));
    const auto one = filesOf(plan(R"({"trees": ["oak.tree"], "output": "{tree}_{seed}_{age}_{season}_{lod}.{format}"})"));
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one[0].output.filename(), "oak_own_1_own_0.glb") << "lists that are missing change nothing";
    const auto seasons = filesOf(plan(R"({"trees": "oak.tree", "seasons": ["winter", 6.5], "ages": [0.5], "for": "unity", "output": "{season}_{age}.{format}"})"));
    ASSERT_EQ(seasons.size(), 2u);
    EXPECT_EQ(seasons[0].output.filename(), "winter_0.5.glb");
    EXPECT_EQ(seasons[1].month, 6.5);
}

TEST_F(Batch, EveryErrorHasItsPlace) {
    EXPECT_EQ(errorsOf("{\"trees\": \"ash*.tree\",\n \"sedes\": [1],\n  \"ages\": [2], \"lods\": 9, \"seasons\": \"monsoon\",\n\"formats\": [\"max\"], "
                       "\"choices\": {\"up\": \"down\", \"lods\": \"none\"},\n\"output\": \"{name}.glb\"}"),
              (std::vector<std::string>{"plan.json:1:2: error: there is no file ash*.tree", "plan.json:2:2: error: a plan has no \"sedes\", did you mean 'seeds'?",
                                        "plan.json:3:3: error: \"ages\" wants a number from 0 to 1, not 2",
                                        "plan.json:3:16: error: \"lods\" wants a whole number from 0 to 3, not 9",
                                        "plan.json:3:27: error: there is no season \"monsoon\"",
                                        "plan.json:4:1: error: " + unknownFormat("model.max"),
                                        "plan.json:4:21: error: 'up' is one of format, y, z, not 'down'",
                                        "plan.json:4:21: error: levels of detail are the plan's \"lods\"",
                                        "plan.json:5:1: error: \"output\" knows no {name}"}));
    EXPECT_EQ(errorsOf("{\"trees\": [,]}"), (std::vector<std::string>{"plan.json:1:12: error: this is no JSON"}));
    EXPECT_EQ(errorsOf("[]"), (std::vector<std::string>{"plan.json:1:1: error: a plan is an object: {\"trees\": […], \"output\": …}"}));
    EXPECT_EQ(errorsOf("{}").size(), 2u) << "what it needs";
    EXPECT_TRUE(errorsOf(kSmall).empty());
}

TEST_F(Batch, NamesThatCollideAreRefused) {
    EXPECT_THROW(filesOf(plan(R"({"trees": "*.tree", "output": "out/{seed}.{format}"})")), CError);
    EXPECT_THROW(filesOf(plan(R"({"trees": "*.tree", "seeds": {"from": 1, "to": 600000}, "output": "{tree}_{seed}.{format}"})")), CError) << "too many";
    EXPECT_THROW(filesOf(plan(R"({"trees": "oak.tree", "formats": ["glb", "obj"], "output": "{tree}.glb"})")), CError);
    EXPECT_THROW(filesOf(plan(R"({"trees": "oak.tree", "lods": [0, 1], "choices": {"displacement": 0.05}, "output": "{lod}.{format}"})")), CError);
    EXPECT_THROW(filesOf(plan(R"({"trees": "oak.tree", "formats": ["stl"], "choices": {"wind": "bones"}, "output": "{tree}.{format}"})")), CError);
}

TEST_F(Batch, WhatIsDoneAndUnchangedIsSkipped) {
    const BatchPlan small = plan(kSmall);
    BatchResult result = run(small);
    EXPECT_EQ(result.written, 16u);
    EXPECT_TRUE(result.failures.empty());
    for (const BatchFile& file : filesOf(small)) EXPECT_TRUE(fs::exists(file.output)) << file.output;
    result = run(small);
    EXPECT_EQ(result.skipped, 16u);
    writeFile(m_folder / "out/oak/1_lod0.glb", "broken");
    fs::remove(m_folder / "out/elm/2_lod3.obj");
    result = run(small);
    EXPECT_EQ(result.written, 2u) << "what is not as it was";
    CParams other;
    weberPenn(other).levels = 1;
    static_cast<void>(CTreeFile().write(m_folder / "elm.tree", other));
    result = run(small);
    EXPECT_EQ(result.written, 8u) << "another tree";
    EXPECT_EQ(run(small, true).written, 16u) << "by force";
}

TEST_F(Batch, ARunThatWasKilledGoesOn) {
    const BatchPlan small = plan(kSmall);
    run(small);
    const std::string record = readFile(m_folder / "plan.done");
    const std::size_t half = record.find('\n', record.size() / 2);
    writeFile(m_folder / "plan.done", record.substr(0, half + 9)); // in the middle of a line
    const BatchResult result = run(small);
    EXPECT_GT(result.skipped, 4u);
    EXPECT_GT(result.written, 4u);
    EXPECT_EQ(result.written + result.skipped, 16u);
    EXPECT_EQ(run(small).skipped, 16u);
}

TEST_F(Batch, ABrokenTreeDoesNotStopTheOthers) {
    writeFile(m_folder / "broken.tree", "Scale = big\n");
    const BatchResult result = run(plan(kSmall));
    EXPECT_EQ(result.written, 16u);
    ASSERT_EQ(result.failures.size(), 8u);
    EXPECT_NE(result.failures[0].find("broken.tree:1:9"), std::string::npos) << result.failures[0];
}

TEST_F(Batch, ValuesAreSet) {
    const auto heightOf = [&](const char* json) {
        const BatchPlan own = plan(json);
        EXPECT_EQ(run(own).failures, std::vector<std::string>());
        const auto gltf = nlohmann::json::parse(readFile(filesOf(own)[0].output));
        double height = 0;
        for (const auto& accessor : gltf["accessors"])
            if (accessor.contains("max") && accessor["max"].size() == 3) height = std::max(height, accessor["max"][1].get<double>());
        return height;
    };
    const double tall = heightOf(R"({"trees": "oak.tree", "formats": "gltf", "set": {"Scale": 20, "ScaleV": 0}, "output": "a.{format}"})");
    const double small = heightOf(R"({"trees": "oak.tree", "formats": "gltf", "set": {"Scale": 5, "ScaleV": 0}, "output": "b.{format}"})");
    EXPECT_NEAR(tall / small, 4, 0.2);
    EXPECT_EQ(errorsOf(R"({"trees": "oak.tree", "set": {"Scael": 5}, "output": "c.{format}"})"),
              (std::vector<std::string>{"plan.json:1:31: error: there is no parameter \"Scael\""}));
    const BatchResult wrong = run(plan(R"({"trees": "oak.tree", "set": {"Derivations": 3}, "output": "c.{format}"})"));
    ASSERT_EQ(wrong.failures.size(), 1u) << "of another method";
    EXPECT_NE(wrong.failures[0].find("Derivations"), std::string::npos);
    EXPECT_FALSE(fs::exists(m_folder / "c.glb"));
}

TEST_F(Batch, SharedPicturesLieThereOnce) {
    const BatchPlan shared = plan(R"({"trees": "*.tree", "formats": ["glb", "obj"], "textures": "shared", "output": "out/{tree}/{tree}.{format}"})");
    EXPECT_EQ(run(shared).failures, std::vector<std::string>());
    std::size_t pictures = 0;
    for (const auto& entry : fs::recursive_directory_iterator(m_folder / "out"))
        if (entry.path().extension() == ".png") {
            ++pictures;
            EXPECT_EQ(entry.path().parent_path(), m_folder / "out/textures");
        }
    EXPECT_EQ(pictures, 1u) << "the bark, for both trees and formats";
    const std::string library = readFile(m_folder / "out/oak/oak.mtl");
    const std::size_t at = library.find("map_Kd ") + 7;
    const std::string named = library.substr(at, library.find('\n', at) - at);
    EXPECT_TRUE(fs::exists(m_folder / "out/oak" / named)) << named;
}

TEST_F(Batch, PartsMakeTheSameAsOneRun) {
    const BatchPlan small = plan(kSmall);
    const auto runPart = [&](int part, int parts) {
        return runBatch(small, {1, false, {}, m_folder / ("plan." + std::to_string(part)), "1", part, parts, true}, [](const BatchFile&, BatchOutcome, std::size_t) {}, CProgress(1));
    };
    EXPECT_EQ(outputFolder(small), m_folder / "out");
    std::size_t written = 0;
    for (int part = 1; part <= 3; ++part) {
        EXPECT_EQ(mergeManifests(small).missing.size(), 16u - written);
        written += runPart(part, 3).written;
        EXPECT_TRUE(fs::exists(m_folder / "out" / ("manifest." + std::to_string(part) + "-of-3.jsonl")));
    }
    EXPECT_EQ(written, 16u);
    EXPECT_EQ(mergeManifests(small).models, 16u);
    const std::string merged = readFile(m_folder / "out/manifest.json");
    fs::remove_all(m_folder / "out");
    EXPECT_EQ(runPart(1, 1).written, 16u);
    EXPECT_TRUE(mergeManifests(small).missing.empty());
    EXPECT_EQ(readFile(m_folder / "out/manifest.json"), merged) << "byte for byte";
    const auto list = nlohmann::json::parse(merged);
    ASSERT_EQ(list.size(), 16u);
    EXPECT_EQ(list[0]["file"], "elm/1_lod0.glb");
    EXPECT_EQ(list[0]["bytes"], fs::file_size(m_folder / "out/elm/1_lod0.glb"));
    EXPECT_FALSE(list[0].contains("seconds"));
    writeFile(m_folder / "out/elm/1_lod0.glb", "broken");
    EXPECT_EQ(mergeManifests(small).missing, std::vector<std::string>{(m_folder / "out/elm/1_lod0.glb").string()});
}

TEST_F(Batch, APartThatWasKilledGoesOnAndTellsOfEachModel) {
    const BatchPlan small = plan(kSmall);
    const BatchOptions options{1, false, {}, m_folder / "plan.done", "1", 1, 2, true};
    const auto go = [&] { return runBatch(small, options, [](const BatchFile&, BatchOutcome, std::size_t) {}, CProgress(1)); };
    EXPECT_EQ(go().written, 8u);
    const fs::path lines = m_folder / "out/manifest.1-of-2.jsonl";
    const std::string text = readFile(lines);
    writeFile(lines, text.substr(0, text.size() / 2));
    EXPECT_EQ(go().skipped, 8u);
    EXPECT_EQ(mergeManifests(small).models, 8u);
}

} // namespace stromar::test
