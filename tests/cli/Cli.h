#pragma once
#include "Checkout.h"
#include "cli/Process.h"
#include <nlohmann/json.hpp>
#include <sstream>

namespace stromar::test {

using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

inline Words cliCommand(const Words& words) {
    Words command = {inBin("stromar-cli")};
    command.insert(command.end(), words.begin(), words.end());
    return command;
}

inline ProcessResult cli(const Words& words, const ProcessSettings& settings = {}) {
    return runProcess(cliCommand(words), settings);
}

inline std::string presetFile(const std::string& name) { return inSource("presets/" + name + ".tree"); }
inline const std::string kAspen = presetFile("quaking_aspen");

/// A tree of a few branches: quickly made.
inline Words smallTree(const std::string& command, const Words& more = {}) {
    Words words = {command, kAspen, "--set", "1Branches=6", "--set", "2Branches=3"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// An export of that tree.
inline Words exportTo(const std::filesystem::path& path, const Words& more = {}) {
    Words words = smallTree("export", {"-o", path.string()});
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

inline std::vector<Json> jsonLines(const std::string& text) {
    std::vector<Json> objects;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) objects.push_back(Json::parse(line));
    return objects;
}

inline std::vector<std::string> keysOf(const Json& object) {
    std::vector<std::string> keys;
    for (const auto& item : object.items()) keys.push_back(item.key());
    return keys;
}

} // namespace stromar::test
