#pragma once
#include "Checkout.h"
#include "stromar/params/ParamText.h"
#include "stromar/params/TreeFile.h"
#include "stromar/params/methods/lsystem/LSystemParams.h"
#include "stromar/params/methods/strands/StrandsParams.h"
#include <cmath>
#include <filesystem>
#include <vector>

namespace stromar::test {

inline std::vector<std::filesystem::path> presetFiles() {
    for (const ParamBlock* block : {&lsystemBlock(), &strandsBlock()}) registerBlock(*block); // no table of methods is there
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(inSource("presets")))
        if (entry.path().extension() == ".tree") files.push_back(entry.path());
    return files;
}

inline CTreeFile parsed(const std::string& text) { return CTreeFile::parse(text, "x.tree"); }

/// Any parameter of the tree by its key.
inline ParamRef param(std::string_view key) { return findParam(key).value(); }

inline double valueOf(const CParams& params, std::string_view key) { return param(key).get(params); }

/// A value that the row allows and that is not `old`; with odd digits where the row has a fraction.
inline double otherValue(const ParamInfo& info, double old) {
    if (info.integer()) return old + 1 <= info.range.max ? old + 1 : old - 1;
    const double step = (info.range.max - info.range.min) * 0.1234567890123;
    const double up = old + step;
    return up <= info.range.max ? up : old - step;
}

} // namespace stromar::test
