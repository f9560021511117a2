#include "Checkout.h"
#include "stromar/util/FileSet.h"
#include "stromar/util/Text.h"
#include "util/TemporaryFolder.h"
#include <cctype>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

namespace stromar {
namespace {

namespace fs = std::filesystem;

/// What a layer may include: other layers, with all that those may, and the two big libraries.
struct Layer {
    std::vector<std::string> mayInclude;
    bool qt = false, osg = false;
};

const std::map<std::string, Layer>& layers() {
    static const std::map<std::string, Layer> all{
        {"util", {{}}},
        {"texture", {{"util"}}},
        {"params", {{"util"}}},
        {"tree", {{"params"}}},
        {"mesh", {{"tree"}}},
        {"model", {{"mesh"}}},
        {"io", {{"model", "texture"}}},
        {"scene", {{"model", "texture"}, false, true}},
        {"app", {{"io", "scene"}}},
        {"gui", {{"app"}, true, true}},
        {"cli", {{"app"}}},
    };
    return all;
}

std::set<std::string> allowed(const std::string& layer) {
    std::set<std::string> all{layer};
    for (const std::string& lower : layers().at(layer).mayInclude) all.merge(allowed(lower));
    return all;
}

bool isSource(const fs::path& file) {
    static const std::set<std::string> endings{".h", ".hpp", ".cpp", ".cc", ".inl"};
    return endings.contains(file.extension().string());
}

bool isQt(std::string_view include) {
    const bool module = include.size() > 1 && include[0] == 'Q' && std::isalpha(static_cast<unsigned char>(include[1]));
    return module || include.starts_with("ui_") || include == "qglobal.h" || include == "qnamespace.h";
}

bool isOsg(std::string_view include) {
    return (include.starts_with("osg") || include.starts_with("OpenThreads")) &&
           include.find('/') != std::string_view::npos;
}

std::string whyForbidden(const std::string& layer, std::string_view include) {
    constexpr std::string_view kOwn = "stromar/";
    if (include.starts_with(kOwn)) {
        const std::string_view below = include.substr(kOwn.size());
        return allowed(layer).contains(std::string(below.substr(0, below.find('/')))) ? "" : "points up or aside";
    }
    if (isQt(include)) return layers().at(layer).qt ? "" : "Qt in a layer without it";
    if (isOsg(include)) return layers().at(layer).osg ? "" : "OpenSceneGraph in a layer without it";
    // "../mesh/Detail.h" would reach into a layer past the rule above.
    return include.find("..") == std::string_view::npos ? "" : "leaves its folder";
}

/// What a line includes; nothing if it is no such directive.
std::string_view includedBy(std::string_view line) {
    for (const std::string_view word : {"#", "include"}) {
        line = trimmed(line);
        if (!line.starts_with(word)) return {};
        line.remove_prefix(word.size());
    }
    line = trimmed(line);
    if (line.empty() || (line[0] != '<' && line[0] != '"')) return {};
    return line.substr(1, line.find_first_of(">\"", 1) - 1);
}

struct Check {
    std::size_t files = 0, includes = 0;
    std::vector<std::string> problems;
};

void checkFile(const fs::path& file, const std::string& layer, Check& check) {
    ++check.files;
    std::istringstream text(readFile(file));
    for (std::string line; std::getline(text, line);) {
        const std::string_view include = includedBy(line);
        if (include.empty()) continue;
        ++check.includes;
        if (const std::string why = whyForbidden(layer, include); !why.empty())
            check.problems.push_back(file.string() + ": " + std::string(include) + " " + why);
    }
}

/// Checks include/stromar/<layer> and src/<layer> below `root`.
Check checkTree(const fs::path& root) {
    Check check;
    for (const fs::path& top : {root / "include" / "stromar", root / "src"}) {
        if (!fs::exists(top)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(top)) {
            if (!entry.is_regular_file() || !isSource(entry.path())) continue;
            const std::string layer = entry.path().lexically_relative(top).begin()->string();
            if (layers().contains(layer))
                checkFile(entry.path(), layer, check);
            else
                check.problems.push_back(entry.path().string() + " is in no layer");
        }
    }
    return check;
}

TEST(Layers, NoIncludePointsUp) {
    const Check check = checkTree(test::inSource());
    for (const std::string& problem : check.problems) ADD_FAILURE() << problem;
    EXPECT_GT(check.files, 40u);
    EXPECT_GT(check.includes, 200u);
}

TEST(Layers, EveryLayerWasSeen) {
    for (const auto& [layer, rule] : layers()) {
        const fs::path folder = fs::path(test::inSource("src")) / layer;
        if (!fs::exists(folder)) {
            EXPECT_EQ(layer, "gui"); // the only layer whose sources another package may leave out
            continue;
        }
        Check check;
        for (const auto& entry : fs::recursive_directory_iterator(folder))
            if (isSource(entry.path())) checkFile(entry.path(), layer, check);
        EXPECT_GT(check.files, 0u) << layer;
    }
}

std::size_t problemsOf(const std::string& path, const std::string& line) {
    const test::CTemporaryFolder root;
    fs::create_directories((root / path).parent_path());
    writeFile(root / path, "#pragma once\n" + line + "\n");
    const Check check = checkTree(root.path());
    EXPECT_EQ(check.files, 1u);
    EXPECT_EQ(check.includes, 1u);
    return check.problems.size();
}

TEST(Layers, TheCheckFindsPlantedIncludes) {
    const std::pair<const char*, const char*> bad[] = {
        {"src/tree/Tree.cpp", "#include \"stromar/mesh/Mesh.h\""},
        {"src/tree/Tree.cpp", "  #  include <stromar/mesh/Mesh.h>"},
        {"src/tree/deeper/Tree.cpp", "#include \"stromar/app/Export.h\""},
        {"include/stromar/util/Text.h", "#include \"stromar/params/Params.h\""},
        {"src/io/ObjWriter.cpp", "#include \"stromar/scene/ViewScene.h\""},
        {"src/cli/main.cpp", "#include \"stromar/gui/Window.h\""},
        {"src/mesh/Mesh.cpp", "#include <osg/Geometry>"},
        {"src/app/Export.cpp", "#include <osgDB/WriteFile>"},
        {"src/app/Export.cpp", "#include <QString>"},
        {"src/scene/ViewScene.cpp", "#include <QtWidgets/QWidget>"},
        {"src/params/Params.cpp", "#include \"../tree/Draw.h\""}};
    for (const auto& [path, line] : bad) EXPECT_EQ(problemsOf(path, line), 1u) << path << ": " << line;
}

TEST(Layers, TheCheckAcceptsWhatIsAllowed) {
    const std::pair<const char*, const char*> good[] = {
        {"src/mesh/Mesh.cpp", "#include \"stromar/util/Text.h\""},
        {"src/app/Export.cpp", "#include \"stromar/scene/ViewScene.h\""},
        {"src/gui/Window.cpp", "#include <QMainWindow>"},
        {"src/gui/Window.cpp", "#include <osgViewer/Viewer>"},
        {"src/scene/ViewScene.cpp", "#include <osg/Geometry>"},
        {"src/tree/Tree.cpp", "#include \"Draw.h\""},
        {"include/stromar/util/Text.h", "#include <queue>"}};
    for (const auto& [path, line] : good) EXPECT_EQ(problemsOf(path, line), 0u) << path << ": " << line;
}

/// Markdown links and pictures of a page; pictures have a text, without which the help window leaves them out.
TEST(Docs, LinksLeadSomewhereAndPicturesHaveATitle) {
    const std::regex link(R"((!?)\[([^\]]*)\]\(([^)#]+)[^)]*\))");
    int count = 0;
    std::vector<fs::path> pages{test::inSource("README.md")};
    for (const auto& entry : fs::directory_iterator(test::inSource("docs")))
        if (entry.path().extension() == ".md") pages.push_back(entry.path());
    for (const fs::path& page : pages) {
        const std::string text = readFile(page);
        for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at, ++count) {
            const std::string target = (*at)[3];
            if (target.starts_with("http")) continue;
            EXPECT_TRUE(fs::exists(page.parent_path() / target)) << page.filename() << ": " << target;
            if ((*at)[1].length() > 0) {
                EXPECT_GT((*at)[2].length(), 0) << page.filename() << ": " << target;
            }
        }
    }
    EXPECT_GT(count, 60);
}

} // namespace
} // namespace stromar
