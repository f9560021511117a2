#include "stromar/app/ExportOptions.h"
#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace stromar::test {

TEST(Formats, RowsAreComplete) {
    std::set<std::string_view> endings;
    for (const Format& format : formatTable()) {
        EXPECT_TRUE(format.ending.starts_with('.')) << format.ending;
        EXPECT_TRUE(endings.insert(format.ending).second) << format.ending;
        EXPECT_FALSE(format.name.empty()) << format.ending;
        EXPECT_TRUE(format.upAxis == "y" || format.upAxis == "z") << format.ending;
        EXPECT_FALSE(lossesOf(format).empty()) << format.ending;
        EXPECT_NE(format.write, nullptr) << format.ending;
        EXPECT_GT(format.bytesPerVertex, 0) << format.ending;
    }
    for (const std::string_view own : {".lwo", ".obj", ".pov"}) EXPECT_TRUE(endings.contains(own)) << own;
}

TEST(Formats, SayWhatTheyLose) {
    EXPECT_EQ(lossesOf(*formatOf("a.glb")), "nothing");
    EXPECT_EQ(lossesOf(*formatOf("a.obj")), "leaf tints, ambient occlusion (attribute), tangents");
    const std::string lwo = lossesOf(*formatOf("a.lwo"));
    EXPECT_NE(lwo.find("normals (programs make their own)"), std::string::npos) << lwo;
    EXPECT_EQ(lwo.find("tangents"), std::string::npos) << "without normals it goes without saying";
    const std::string dae = lossesOf(*formatOf("a.dae"));
    EXPECT_NE(dae.find("; Blender and Godot"), std::string::npos) << dae;
}

TEST(ExportChoices, AreCompleteRows) {
    std::set<std::string_view> keys;
    for (const ExportChoice& choice : exportChoices()) {
        EXPECT_TRUE(keys.insert(choice.key).second) << choice.key;
        EXPECT_FALSE(choice.label.empty()) << choice.key;
        EXPECT_FALSE(choice.help.empty()) << choice.key;
        EXPECT_NE(choice.field != nullptr, choice.number != nullptr) << choice.key;
        EXPECT_EQ(choice.words.size(), choice.names.size()) << choice.key;
        EXPECT_NE(choice.words.empty(), choice.range.max <= choice.range.min) << choice.key;
    }
}

TEST(ExportChoices, EveryFormatTakesTheUsualOnes) {
    for (const Format& format : formatTable()) EXPECT_EQ(conflictOf({}, format), "") << format.ending;
}

TEST(Formats, AreFoundByTheEnding) {
    for (const Format& format : formatTable()) {
        std::string upper(format.ending);
        std::ranges::transform(upper, upper.begin(),
                               [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
        EXPECT_EQ(formatOf("/some/folder.x/tree" + std::string(format.ending)), &format);
        EXPECT_EQ(formatOf("TREE" + upper), &format);
    }
    for (const char* other : {"tree", "tree.", "tree.tree", "obj", ".", "", "tree.obj.zip"})
        EXPECT_EQ(formatOf(other), nullptr) << other;
}

TEST(Formats, AnUnknownOneNamesTheNearestAndAll) {
    const std::string text = unknownFormat("oak.obk");
    EXPECT_NE(text.find("'.obk'"), std::string::npos) << text;
    EXPECT_NE(text.find("did you mean '.obj'"), std::string::npos) << text;
    for (const Format& format : formatTable()) EXPECT_NE(text.find(format.ending), std::string::npos) << text;
    EXPECT_EQ(unknownFormat("oak.quite-different").find("did you mean"), std::string::npos);
    EXPECT_NE(unknownFormat("oak").find(".obj"), std::string::npos);
}

} // namespace stromar::test
