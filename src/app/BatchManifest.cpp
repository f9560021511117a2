#include "BatchManifest.h"
#include "ContentHash.h"
#include "stromar/util/Error.h"
#include "stromar/util/FileSet.h"
#include "stromar/util/Text.h"
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

namespace stromar {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {
constexpr const char* kStart = "manifest.";
constexpr const char* kEnd = ".jsonl";

std::string nameIn(const BatchPlan& plan, const BatchFile& file) { return file.output.lexically_proximate(outputFolder(plan)).generic_string(); }

Json entryOf(const BatchPlan& plan, const BatchFile& file) {
    Json entry{{"file", nameIn(plan, file)}, {"tree", file.tree.filename().string()}};
    entry["seed"] = file.seed ? Json(*file.seed) : Json();
    entry["age"] = file.age;
    entry["month"] = file.month ? Json(*file.month) : Json();
    entry["lod"] = file.lod;
    entry["bytes"] = fs::file_size(file.output);
    entry["hash"] = nameOfHash(hashOfFile(file.output));
    return entry;
}

/// By their file's name, all that parts have told of.
std::multimap<std::string, Json> entriesIn(const fs::path& folder) {
    std::multimap<std::string, Json> entries;
    std::error_code problem;
    std::vector<fs::path> parts;
    for (const auto& file : fs::directory_iterator(folder, problem))
        if (const std::string name = file.path().filename().string(); name.starts_with(kStart) && name.ends_with(kEnd)) parts.push_back(file.path());
    for (const fs::path& part : parts) {
        std::istringstream lines(readFile(part));
        for (std::string line; std::getline(lines, line);) {
            const Json entry = Json::parse(line, nullptr, false); // a line that was cut when its run was killed is none
            if (entry.is_object() && entry.contains("file") && entry["file"].is_string()) entries.emplace(entry["file"].get<std::string>(), entry);
        }
    }
    return entries;
}
} // namespace

CBatchManifest::CBatchManifest(const BatchPlan& plan, int part, int parts) : m_plan(plan) {
    const fs::path folder = outputFolder(plan), file = folder / (kStart + std::to_string(part) + "-of-" + std::to_string(parts) + kEnd);
    std::error_code problem;
    fs::create_directories(folder, problem);
    const bool cut = fs::is_regular_file(file, problem) && !readFile(file).ends_with('\n'); // the run before was killed while it wrote
    m_out.open(file, std::ios::app);
    if (cut) m_out << '\n';
    if (!m_out) throw CError("cannot write " + file.string());
}

void CBatchManifest::add(const BatchFile& file, double seconds) {
    Json entry = entryOf(m_plan, file);
    entry["seconds"] = seconds;
    const std::lock_guard lock(m_mutex);
    m_out << entry.dump() << std::endl; // on the disk before the next begins
    if (!m_out) throw CError("cannot write the manifest of the batch");
}

BatchManifest mergeManifests(const BatchPlan& plan) {
    const fs::path folder = outputFolder(plan);
    const auto entries = entriesIn(folder);
    BatchManifest result{folder / "manifest.json", 0, {}};
    Json all = Json::array();
    for (const BatchFile& file : filesOf(plan)) {
        std::error_code problem;
        const bool there = fs::is_regular_file(file.output, problem) && entries.contains(nameIn(plan, file));
        const Json own = there ? entryOf(plan, file) : Json();
        bool told = false;
        for (auto [entry, end] = entries.equal_range(nameIn(plan, file)); there && entry != end; ++entry)
            told = told || entry->second.value("hash", "") == own["hash"].get<std::string>();
        if (told)
            all.push_back(own);
        else
            result.missing.push_back(file.output.string());
    }
    result.models = all.size();
    std::error_code problem; // writing says it better
    fs::create_directories(folder, problem);
    writeFile(result.file, all.dump(1) + "\n");
    return result;
}

} // namespace stromar
