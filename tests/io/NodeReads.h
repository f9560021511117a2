#pragma once
#include "Checkout.h"
#include "cli/Process.h"
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace stromar::test {

/// The JSON that a program prints, started where Node finds its modules.
inline nlohmann::json jsonBy(const std::vector<std::string>& command, const std::string& folder = inBin("..")) {
    const ProcessResult run = runProcess(command, {.folder = folder});
    EXPECT_EQ(run.status, 0) << run.err;
    return nlohmann::json::parse(run.out.substr(std::min(run.out.size(), run.out.find('{'))));
}

/// What three.js says of a file.
inline nlohmann::json readByThree(const std::filesystem::path& file) {
    return jsonBy({"node", inSource("tests/io/three-stats.mjs"), file.string()});
}

/// What the validator says of a glTF file.
inline nlohmann::json validatedGltf(const std::filesystem::path& file) {
    return jsonBy({"node", inSource("tests/io/validate-gltf.js"), file.string()});
}

} // namespace stromar::test
