#include "cli/Cli.h"
#include "stromar/app/TreeCreator.h"
#include "stromar/params/TreeFile.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace stromar::test {

namespace {
Json info(const Words& more = {}) { return Json::parse(cli(smallTree("info", more)).out); }
std::vector<Json> structure(const Words& more = {}) { return jsonLines(cli(smallTree("structure", more)).out); }

/// Without what may differ between two runs.
Json lasting(Json object) {
    object.erase("milliseconds");
    return object;
}

bool isVector(const Json& value) {
    return value.is_array() && value.size() == 3 && value[0].is_number() && value[1].is_number() &&
           value[2].is_number();
}

const std::vector<std::string> kInfoKeys = {"species",        "seed",   "method", "age",       "scale_tree", "generations", "predicted",
                                            "leaves",         "model",  "lod",          "vertices",   "triangles",
                                            "leaf_area_kept", "bounds", "milliseconds", "mesh_bytes"};
const std::vector<std::string> kGenerationKeys = {"generation", "stems",      "clones",
                                                  "segments",   "length_sum", "radius_sum"};
const std::vector<std::string> kStemKeys = {"generation", "index",  "parent", "path", "segment",
                                            "offset",     "length", "radius", "base", "direction",
                                            "segments",   "clones", "leaves"};
} // namespace

TEST(Info, HasExactlyTheAgreedFields) {
    const Json object = info();
    EXPECT_EQ(keysOf(object), kInfoKeys);
    for (const Json& generation : object.at("generations")) EXPECT_EQ(keysOf(generation), kGenerationKeys);
    EXPECT_EQ(keysOf(object.at("bounds")), (Words{"min", "max"}));
    EXPECT_EQ(keysOf(object.at("milliseconds")), (Words{"structure", "smooth", "mesh", "total"}));
}

TEST(Info, FieldsHaveTheRightTypes) {
    const Json object = info();
    for (const char* key : {"species", "method", "model"}) EXPECT_TRUE(object.at(key).is_string()) << key;
    for (const char* key : {"seed", "leaves", "lod", "vertices", "triangles", "mesh_bytes"})
        EXPECT_TRUE(object.at(key).is_number_integer()) << key;
    EXPECT_TRUE(object.at("scale_tree").is_number());
    for (const Json& generation : object.at("generations"))
        for (const std::string& key : kGenerationKeys)
            EXPECT_TRUE(key.ends_with("_sum") ? generation.at(key).is_number() : generation.at(key).is_number_integer())
                << key;
    for (const char* key : {"min", "max"}) EXPECT_TRUE(isVector(object.at("bounds").at(key))) << key;
    for (const auto& time : object.at("milliseconds")) EXPECT_GE(time.get<double>(), 0);
}

TEST(Info, SaysWhatTheLibraryMakes) {
    const CParams params = CTreeFile::read(kAspen).params();
    for (const Detail& detail : detailTable()) {
        const bool simple = detail.model == Model::Simple;
        const Words flags = simple ? Words{"--model", "simple"} : Words{"--lod", std::to_string(detail.lod)};
        Words words = {"info", kAspen};
        words.insert(words.end(), flags.begin(), flags.end());
        const Json object = Json::parse(cli(words).out);
        const auto model = CTreeCreator().create(params, detail, CProgress(2));
        EXPECT_EQ(object.at("vertices"), model->vertexCount()) << detail.name;
        EXPECT_EQ(object.at("triangles"), model->triangleCount()) << detail.name;
        EXPECT_EQ(object.at("leaves"), model->tree->organs(Organ::Leaf)->total);
        EXPECT_EQ(object.at("model"), simple ? "simple" : "full");
        EXPECT_EQ(object.at("lod"), detail.lod);
        EXPECT_EQ(object.at("seed"), params.common.seed);
        EXPECT_EQ(object.at("species"), params.text.species);
        EXPECT_NEAR(object.at("scale_tree"), model->tree->height(), 1e-9);
        EXPECT_EQ(object.at("generations").size(), 3u);
        EXPECT_GE(object.at("mesh_bytes").get<std::size_t>(), 32 * model->vertexCount());
    }
}

TEST(Info, TheFullModelOfLevelZeroIsTheDefault) {
    EXPECT_EQ(lasting(info()), lasting(info({"--model", "full", "--lod", "0"})));
    EXPECT_NE(lasting(info()), lasting(info({"--lod", "1"})));
}

TEST(Info, IsTheSameForEveryRunAndNumberOfThreads) {
    EXPECT_EQ(lasting(info()), lasting(info()));
    EXPECT_EQ(lasting(info({"--threads", "1"})), lasting(info({"--threads", "2"})));
    EXPECT_EQ(cli(smallTree("structure", {"--threads", "1"})).out, cli(smallTree("structure", {"--threads", "2"})).out);
}

TEST(Info, SeedIsShortForASetting) {
    EXPECT_EQ(lasting(info({"--seed", "77"})), lasting(info({"--set", "Seed=77"})));
    EXPECT_EQ(info({"--seed", "77"}).at("seed"), 77);
    EXPECT_EQ(info({"--seed", "-5"}).at("seed"), -5);
    EXPECT_NE(info({"--seed", "77"}).at("bounds"), info().at("bounds"));
    EXPECT_EQ(structure({"--seed", "77"}), structure({"--set", "Seed=77"}));
}

TEST(Info, WithoutVariationTheSeedDoesNotMatter) {
    EXPECT_EQ(structure({"--variation", "off", "--seed", "1"}), structure({"--variation", "off", "--seed", "2"}));
    EXPECT_EQ(structure({"--variation", "on"}), structure());
    EXPECT_NE(structure({"--variation", "off"}), structure());
}

TEST(Structure, HasExactlyTheAgreedFields) {
    const auto stems = structure();
    ASSERT_FALSE(stems.empty());
    for (const Json& stem : stems) {
        ASSERT_EQ(keysOf(stem), kStemKeys);
        for (const char* key : {"generation", "index", "parent", "path", "segment", "segments", "clones", "leaves"})
            ASSERT_TRUE(stem.at(key).is_number_integer()) << key;
        for (const char* key : {"offset", "length", "radius"}) ASSERT_TRUE(stem.at(key).is_number()) << key;
        for (const char* key : {"base", "direction"}) ASSERT_TRUE(isVector(stem.at(key))) << key;
        double square = 0;
        for (const Json& part : stem.at("direction")) square += std::pow(part.get<double>(), 2);
        ASSERT_NEAR(square, 1, 1e-5);
    }
}

TEST(Structure, AgreesWithInfo) {
    for (const char* name : {"quaking_aspen", "ca_black_oak", "weeping_willow"}) {
        const Words small = {presetFile(name), "--set", "1Branches=12", "--set", "2Branches=6", "--set", "3Branches=4"};
        Words words = {"info"};
        words.insert(words.end(), small.begin(), small.end());
        const Json object = Json::parse(cli(words).out);
        words.front() = "structure";
        const auto stems = jsonLines(cli(words).out);
        std::int64_t leaves = 0;
        for (const Json& generation : object.at("generations")) {
            std::int64_t count = 0, clones = 0, segments = 0;
            double length = 0, radius = 0;
            for (const Json& stem : stems) {
                if (stem.at("generation") != generation.at("generation")) continue;
                EXPECT_EQ(stem.at("index"), count++) << name;
                clones += stem.at("clones").get<std::int64_t>();
                segments += stem.at("segments").get<std::int64_t>();
                leaves += stem.at("leaves").get<std::int64_t>();
                length += stem.at("length").get<double>();
                radius += stem.at("radius").get<double>();
            }
            EXPECT_EQ(generation.at("stems"), count) << name;
            EXPECT_EQ(generation.at("clones"), clones) << name;
            EXPECT_EQ(generation.at("segments"), segments) << name;
            EXPECT_NEAR(generation.at("length_sum"), length, 1e-4 * length) << name;
            EXPECT_NEAR(generation.at("radius_sum"), radius, 1e-4 * radius) << name;
        }
        EXPECT_EQ(object.at("leaves"), leaves) << name;
    }
}

TEST(Structure, ParentsAreValid) {
    const auto stems = jsonLines(cli({"structure", presetFile("ca_black_oak"), "--set", "2Branches=10"}).out);
    std::vector<std::vector<Json>> generations;
    for (const Json& stem : stems) {
        const auto g = stem.at("generation").get<std::size_t>();
        ASSERT_TRUE(g == generations.size() || g + 1 == generations.size()) << "generation by generation";
        if (g == generations.size()) generations.emplace_back();
        generations[g].push_back(stem);
        if (g == 0) {
            EXPECT_EQ(stem.at("parent"), -1);
            continue;
        }
        const auto parent = stem.at("parent").get<std::size_t>();
        ASSERT_LT(parent, generations[g - 1].size());
        const Json& below = generations[g - 1][parent];
        EXPECT_LE(stem.at("path").get<int>(), below.at("clones").get<int>());
        EXPECT_GE(stem.at("path").get<int>(), 0);
        EXPECT_LT(stem.at("segment").get<int>(), below.at("segments").get<int>());
        EXPECT_GE(stem.at("offset").get<double>(), 0);
        EXPECT_LE(stem.at("offset").get<double>(), below.at("length").get<double>() * (1 + 1e-9));
        EXPECT_LE(stem.at("radius").get<double>(), below.at("radius").get<double>() * 2);
    }
    EXPECT_EQ(generations.size(), 3u);
}

TEST(Structure, StaysOutOfTheLargestModelsWay) {
    const ProcessResult run = cli({"structure", presetFile("weeping_willow"), "--threads", "2"});
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_GT(std::ranges::count(run.out, '\n'), 50'000);
}

TEST(Info, TellsOfTreesAtAnAge) {
    for (const char* name : {"quaking_aspen", "rowan", "strand_bonsai"}) {
        SCOPED_TRACE(name);
        const auto at = [&](const char* age) { return Json::parse(cli({"info", presetFile(name), "--age", age}).out); };
        const Json young = at("0.4"), grown = at("1"), none = at("0");
        EXPECT_EQ(young.at("age"), 0.4);
        EXPECT_LT(young.at("scale_tree"), grown.at("scale_tree"));
        EXPECT_LT(young.at("vertices"), grown.at("vertices"));
        EXPECT_GT(young.at("vertices"), 0);
        EXPECT_EQ(none.at("vertices"), 0);
        EXPECT_TRUE(none.at("generations").empty());
        EXPECT_TRUE(none.at("bounds").is_null());
        Json today = Json::parse(cli({"info", presetFile(name)}).out), same = grown;
        for (Json* info : {&today, &same}) info->erase("milliseconds");
        EXPECT_EQ(today, same) << "1 is what there is without an age";
        for (const char* age : {"0.05", "0.5", "0.93"}) EXPECT_EQ(cli({"check", presetFile(name), "--age", age}).status, 0) << age;
    }
    const ProcessResult clamped = cli({"info", presetFile("rowan"), "--age", "7"});
    EXPECT_EQ(clamped.status, 0);
    EXPECT_NE(clamped.err.find("from 0 to 1"), std::string::npos) << clamped.err;
    for (const char* wrong : {"nan", "old", ""}) EXPECT_EQ(cli({"info", presetFile("rowan"), "--age", wrong}).status == 0, *wrong == 0) << wrong;
}

} // namespace stromar::test
