#include "stromar/app/Batch.h"
#include "BatchManifest.h"
#include "BatchRecord.h"
#include "ContentHash.h"
#include "stromar/app/Export.h"
#include "stromar/app/Render.h"
#include "stromar/params/TreeFile.h"
#include "stromar/util/Parallel.h"
#include "stromar/util/Text.h"
#include <algorithm>
#include <chrono>
#include <cmath>
#include <glob.h>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>

namespace stromar {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {
constexpr double kMaxSeeds = 1e6, kMaxModels = 1e6;

std::vector<fs::path> filesOfPattern(const fs::path& pattern) {
    glob_t found{};
    std::vector<fs::path> files;
    if (::glob(pattern.c_str(), 0, nullptr, &found) == 0)
        for (std::size_t i = 0; i < found.gl_pathc; ++i) files.emplace_back(found.gl_pathv[i]);
    ::globfree(&found);
    return files;
}

/// Reads a plan and gathers what is wrong with it.
class CPlanParser {
public:
    CPlanParser(const std::string& text, std::string name, fs::path folder) : m_text(text), m_name(std::move(name)) { m_plan.folder = std::move(folder); }

    BatchPlan parse() {
        try {
            m_json = Json::parse(m_text, nullptr, true, true);
        } catch (const Json::parse_error& e) {
            failAt(std::min(e.byte > 0 ? e.byte - 1 : 0, m_text.size()), "this is no JSON");
            throw CInputError(std::move(m_errors));
        }
        if (!m_json.is_object()) {
            failAt(0, "a plan is an object: {\"trees\": […], \"output\": …}");
            throw CInputError(std::move(m_errors));
        }
        readKeys();
        if (m_plan.sharesPictures) m_plan.options.textures = static_cast<int>(ExportedTextures::Copy);
        for (const char* needed : {"trees", "output"})
            if (!m_json.contains(needed)) failAt(0, std::string("a plan has \"") + needed + "\"");
        if (!m_errors.empty()) throw CInputError(std::move(m_errors));
        return m_plan;
    }

private:
    using Read = void (CPlanParser::*)(const Json&);
    static const std::map<std::string, Read>& readers() {
        static const std::map<std::string, Read> all{{"trees", &CPlanParser::readTrees},     {"seeds", &CPlanParser::readSeeds},
                                                     {"ages", &CPlanParser::readAges},       {"seasons", &CPlanParser::readSeasons},
                                                     {"lods", &CPlanParser::readLods},       {"formats", &CPlanParser::readFormats},
                                                     {"set", &CPlanParser::readSet},         {"textures", &CPlanParser::readTextures},
                                                     {"for", &CPlanParser::readEngine},      {"choices", &CPlanParser::readChoices},
                                                     {"output", &CPlanParser::readOutput}};
        return all;
    }

    void readKeys() {
        if (m_json.contains("for")) readKey("for"); // the others stand on top of it
        for (const auto& [key, value] : m_json.items())
            if (key != "for") readKey(key);
    }

    void readKey(const std::string& key) {
        m_key = key;
        const auto read = readers().find(key);
        if (read != readers().end()) return (this->*read->second)(m_json[key]);
        std::vector<std::string> known;
        for (const auto& [name, unused] : readers()) known.push_back(name);
        fail("a plan has no \"" + key + "\"" + suggestion(key, known));
    }

    /// Where the key stands that is read now.
    void fail(const std::string& why) { failAt(placeOf(m_key), why); }

    std::size_t placeOf(const std::string& word) const {
        const std::size_t at = m_text.find('"' + word + '"');
        return at == std::string::npos ? 0 : at;
    }

    void failAt(std::size_t byte, const std::string& why) {
        const auto line = static_cast<int>(std::count(m_text.begin(), m_text.begin() + static_cast<std::ptrdiff_t>(byte), '\n')) + 1;
        const std::size_t start = byte == 0 ? std::string::npos : m_text.rfind('\n', byte - 1);
        const int column = static_cast<int>(start == std::string::npos ? byte : byte - start - 1) + 1;
        m_errors.push_back({Severity::Error, m_name, line, column, why});
    }

    /// Every value of a list, or one alone.
    template <typename Take>
    void each(const Json& value, Take&& take) {
        if (!value.is_array()) return take(value);
        if (value.empty()) fail("\"" + m_key + "\" is empty");
        for (const Json& one : value) take(one);
    }

    std::optional<double> numberIn(const Json& value, double min, double max, bool whole) {
        const std::string range = (whole ? "a whole number from " : "a number from ") + numberText(min) + " to " + numberText(max);
        if (value.is_number() && value.get<double>() >= min && value.get<double>() <= max && (!whole || value.get<double>() == std::floor(value.get<double>())))
            return value.get<double>();
        fail("\"" + m_key + "\" wants " + range + ", not " + value.dump());
        return {};
    }

    std::optional<std::string> textIn(const Json& value) {
        if (value.is_string()) return value.get<std::string>();
        fail("\"" + m_key + "\" wants a text, not " + value.dump());
        return {};
    }

    void readTrees(const Json& value) {
        std::set<fs::path> known;
        each(value, [&](const Json& one) {
            const auto pattern = textIn(one);
            if (!pattern) return;
            const auto found = filesOfPattern(m_plan.folder / *pattern);
            if (found.empty()) fail("there is no file " + *pattern);
            for (const fs::path& file : found)
                if (known.insert(file.lexically_normal()).second) m_plan.trees.push_back(file);
        });
    }

    void readSeeds(const Json& value) {
        m_plan.seeds.clear();
        const auto add = [&](const Json& one) {
            if (const auto seed = numberIn(one, 0, 1e9, true)) m_plan.seeds.emplace_back(static_cast<int>(*seed));
        };
        if (!value.is_object()) return each(value, add);
        for (const auto& [key, unused] : value.items())
            if (key != "from" && key != "to") fail("seeds are a list, or {\"from\": N, \"to\": N}");
        const auto from = numberIn(value.value("from", Json()), 0, 1e9, true), to = numberIn(value.value("to", Json()), 0, 1e9, true);
        if (!from || !to) return;
        if (*to < *from || *to - *from >= kMaxSeeds) return fail("seeds go from a number to one that is no smaller, a million at most");
        for (double seed = *from; seed <= *to; ++seed) m_plan.seeds.emplace_back(static_cast<int>(seed));
    }

    void readAges(const Json& value) {
        m_plan.ages.clear();
        each(value, [&](const Json& one) {
            if (const auto age = numberIn(one, 0, 1, false)) m_plan.ages.push_back(*age);
        });
    }

    void readSeasons(const Json& value) {
        m_plan.months.clear();
        each(value, [&](const Json& one) {
            const auto named = one.is_string() ? std::ranges::find(seasonNames(), one.get<std::string>(), &SeasonName::name) : seasonNames().end();
            if (named != seasonNames().end())
                m_plan.months.emplace_back(named->month);
            else if (one.is_string())
                fail("there is no season \"" + one.get<std::string>() + "\"");
            else if (const auto month = numberIn(one, 1, 13, false))
                m_plan.months.emplace_back(*month);
        });
    }

    void readLods(const Json& value) {
        m_plan.lods.clear();
        each(value, [&](const Json& one) {
            if (const auto lod = numberIn(one, 0, kMaxLod, true)) m_plan.lods.push_back(static_cast<int>(*lod));
        });
    }

    void readFormats(const Json& value) {
        m_plan.endings.clear();
        each(value, [&](const Json& one) {
            const auto name = textIn(one);
            if (!name) return;
            const std::string ending = (name->starts_with('.') ? "" : ".") + *name;
            if (formatOf("model" + ending))
                m_plan.endings.push_back(ending);
            else
                fail(unknownFormat("model" + ending));
        });
    }

    void readSet(const Json& value) {
        if (!value.is_object()) return fail("\"set\" is an object: {\"LeafScale\": 0.2}");
        for (const auto& item : value.items()) {
            const std::string& key = item.key();
            const Json& one = item.value();
            const auto knows = [&](const ParamBlock* block) { return findParam(key, *block).has_value(); };
            if (std::ranges::none_of(paramBlocks(), knows)) failAt(placeOf(key), "there is no parameter \"" + key + "\"");
            m_plan.values.emplace_back(key, one.is_string() ? one.get<std::string>() : one.dump());
        }
    }

    void readTextures(const Json& value) {
        const auto word = textIn(value);
        m_plan.sharesPictures = word == "shared";
        if (word && !m_plan.sharesPictures) choose("textures", *word);
    }

    void readEngine(const Json& value) {
        const auto key = textIn(value);
        if (!key) return;
        const Engine* engine = engineNamed(*key);
        if (!engine) return fail("there is no engine \"" + *key + "\"");
        const ExportSettings settings = settingsFor(*engine);
        m_plan.options = settings.options;
        m_plan.options.lods = static_cast<int>(ExportedLods::None); // the plan has a list of its own
        m_plan.endings = {settings.ending};
    }

    void readChoices(const Json& value) {
        if (!value.is_object()) return fail("\"choices\" is an object: {\"scale\": 100}");
        for (const auto& [key, one] : value.items()) choose(key, one.is_string() ? one.get<std::string>() : one.dump());
    }

    void choose(const std::string& key, const std::string& value) {
        if (key == "lod" || key == "lods") return fail("levels of detail are the plan's \"lods\"");
        try {
            setChoice(m_plan.options, key, value);
        } catch (const CError& e) {
            fail(e.what());
        }
    }

    void readOutput(const Json& value) {
        const auto pattern = textIn(value);
        if (!pattern) return;
        m_plan.output = *pattern;
        for (std::size_t at = 0; (at = pattern->find('{', at)) != std::string::npos; ++at) {
            const std::string word = pattern->substr(at + 1, pattern->find('}', at) - at - 1);
            constexpr std::string_view kKnown[] = {"tree", "seed", "age", "season", "lod", "format"};
            if (std::ranges::find(kKnown, word) == std::end(kKnown)) fail("\"output\" knows no {" + word + "}");
        }
        if (pattern->empty()) fail("\"output\" is empty");
    }

    const std::string& m_text;
    std::string m_name, m_key;
    Json m_json;
    BatchPlan m_plan;
    Messages m_errors;
};

void replaceAll(std::string& text, const std::string& word, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += by.size()) text.replace(at, word.size(), by);
}

std::string nameOfMonth(double month) {
    const auto named = std::ranges::find(seasonNames(), month, &SeasonName::month);
    return named == seasonNames().end() ? numberText(month) : std::string(named->name);
}

fs::path outputOf(const BatchPlan& plan, const BatchFile& file, const std::string& ending) {
    std::string name = plan.output;
    const std::pair<const char*, std::string> words[] = {{"{tree}", file.tree.stem().string()},
                                                         {"{seed}", file.seed ? std::to_string(*file.seed) : "own"},
                                                         {"{age}", numberText(file.age)},
                                                         {"{season}", file.month ? nameOfMonth(*file.month) : "own"},
                                                         {"{lod}", std::to_string(file.lod)},
                                                         {"{format}", ending.substr(1)}};
    for (const auto& [word, by] : words) replaceAll(name, word, by);
    return (plan.folder / name).lexically_normal();
}


ExportOptions optionsOf(const BatchPlan& plan, const BatchFile& file) {
    ExportOptions options = plan.options;
    options.lod = file.lod;
    if (plan.sharesPictures) options.sharedPictures = outputFolder(plan) / "textures";
    return options;
}

/// The tree of a file with what the plan changes. Throws CError.
CParams paramsOf(const BatchPlan& plan, const BatchFile& file) {
    CParams params = CTreeFile::read(file.tree).params();
    std::string lines = "Format = " + std::to_string(CTreeFile::kFormat) + "\nMethod = " + std::string(params.block().method) + "\n";
    for (const auto& [key, value] : plan.values) {
        const auto ref = findParam(key, params.block());
        const bool quoted = ref && ref->info->kind() == ParamKind::Text && !value.starts_with('"');
        lines += key + " = " + (quoted ? '"' + value + '"' : value) + "\n";
    }
    const CTreeFile set = CTreeFile::parse(lines, "set");
    for (const Message& warning : set.warnings()) throw CError(warning.toString()); // an unknown key is one
    for (const auto& [ref, value] : set.givenValues()) ref.setValue(params, value);
    if (file.seed) params.common.seed = *file.seed;
    if (file.month) params.common.season = *file.month;
    return params;
}

/// One tree as it grows: files that show it at levels of detail, in formats.
using FilesOfTree = std::vector<const BatchFile*>;

std::vector<FilesOfTree> groupsOf(const std::vector<BatchFile>& files) {
    std::vector<FilesOfTree> groups;
    const auto sameTree = [](const BatchFile& a, const BatchFile& b) {
        return a.tree == b.tree && a.seed == b.seed && a.age == b.age && a.month == b.month;
    };
    for (const BatchFile& file : files) {
        if (groups.empty() || !sameTree(*groups.back().front(), file)) groups.emplace_back();
        groups.back().push_back(&file);
    }
    return groups;
}

/// Writes one group after the other on each thread that calls.
class CBatchRun {
public:
    CBatchRun(const BatchPlan& plan, const BatchOptions& options, const BatchReport& report)
        : m_plan(plan), m_options(options), m_report(report), m_record(options.record) {
        if (options.manifest) m_manifest.emplace(plan, options.part, options.parts);
    }

    void write(const FilesOfTree& group, const CProgress& progress) {
        std::unique_ptr<CTreeCreator> creator;
        for (const BatchFile* file : group) {
            progress.poll();
            const auto start = std::chrono::steady_clock::now();
            const auto list = [&] {
                if (m_manifest) m_manifest->add(*file, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
            };
            try {
                const CParams params = paramsOf(m_plan, *file);
                const std::uint64_t wanted = wantedHash(*file, params);
                if (!m_options.force && m_record.has(file->output, wanted)) {
                    list();
                    tell(*file, BatchOutcome::Skipped);
                    continue;
                }
                if (!creator) creator = std::make_unique<CTreeCreator>(true, m_options.limits);
                creator->setAge(file->age);
                fs::create_directories(file->output.parent_path());
                exportTree(*creator, params, optionsOf(m_plan, *file), file->tree.parent_path(), file->output, progress);
                m_record.add(file->output, wanted);
                list();
                tell(*file, BatchOutcome::Written);
            } catch (const CCancelled&) {
                throw;
            } catch (const std::exception& e) {
                tell(*file, BatchOutcome::Failed, e.what());
            }
        }
    }

    BatchResult result() {
        std::ranges::sort(m_result.failures);
        return std::move(m_result);
    }

private:
    /// Everything that makes the file what it is, its pictures included.
    std::uint64_t wantedHash(const BatchFile& file, const CParams& params) const {
        std::string all = m_options.version + '\n' + CTreeFile().text(params) + numberText(file.age) + '\n' + settingsText({{}, {}, optionsOf(m_plan, file)}) +
                          m_plan.output + (m_plan.sharesPictures ? "\nshared" : "");
        for (const ParamRef& ref : allParams(params.block())) { // pictures and meshes of the user's own
            const fs::path own = ref.info->file() && !ref.text(params).empty() ? file.tree.parent_path() / ref.text(params) : fs::path();
            if (std::error_code problem; fs::is_regular_file(own, problem)) all += '\n' + std::to_string(hashOfFile(own));
        }
        return hashOfText(all);
    }

    void tell(const BatchFile& file, BatchOutcome outcome, const std::string& why = {}) {
        const std::lock_guard lock(m_mutex);
        ++m_done;
        if (outcome == BatchOutcome::Written) ++m_result.written;
        if (outcome == BatchOutcome::Skipped) ++m_result.skipped;
        if (outcome == BatchOutcome::Failed) m_result.failures.push_back(file.output.string() + ": " + why);
        m_report(file, outcome, m_done);
    }

    const BatchPlan& m_plan;
    const BatchOptions& m_options;
    const BatchReport& m_report;
    CBatchRecord m_record;
    std::optional<CBatchManifest> m_manifest;
    std::mutex m_mutex; ///< guards what follows
    std::size_t m_done = 0;
    BatchResult m_result;
};
} // namespace

BatchPlan parsePlan(const std::string& text, const std::string& name, const fs::path& folder) { return CPlanParser(text, name, folder).parse(); }

BatchPlan readPlan(const fs::path& path) { return parsePlan(readFile(path), path.string(), path.parent_path()); }

fs::path outputFolder(const BatchPlan& plan) {
    const std::string fixed = plan.output.substr(0, plan.output.find('{'));
    const fs::path folder = (plan.folder / fixed.substr(0, fixed.rfind('/') == std::string::npos ? 0 : fixed.rfind('/'))).lexically_normal();
    return folder.empty() ? fs::path(".") : folder;
}

std::vector<BatchFile> filesOf(const BatchPlan& plan) {
    std::vector<BatchFile> files;
    std::set<fs::path> known;
    for (const std::string& ending : plan.endings)
        for (const int lod : plan.lods) {
            ExportOptions options = plan.options;
            options.lod = lod;
            if (const std::string conflict = conflictText(options, *formatOf("model" + ending)); !conflict.empty()) throw CError(conflict);
        }
    const double count = double(plan.trees.size()) * double(plan.seeds.size()) * double(plan.ages.size()) * double(plan.months.size()) *
                         double(plan.lods.size()) * double(plan.endings.size());
    if (count > kMaxModels) throw CError("a plan has at most a million models, this one " + numberText(count));
    for (const fs::path& tree : plan.trees)
        for (const auto& seed : plan.seeds)
            for (const double age : plan.ages)
                for (const auto& month : plan.months)
                    for (const int lod : plan.lods)
                        for (const std::string& ending : plan.endings) {
                            BatchFile file{tree, {}, seed, age, month, lod};
                            file.output = outputOf(plan, file, ending);
                            if (lowerCase(file.output.extension().string()) != ending)
                                throw CError("the output " + file.output.string() + " does not end in " + ending);
                            if (!known.insert(file.output).second)
                                throw CError("two models have the name " + file.output.string() + ": say more in \"output\"");
                            files.push_back(std::move(file));
                        }
    return files;
}

BatchResult runBatch(const BatchPlan& plan, const BatchOptions& options, const BatchReport& report, const CProgress& progress) {
    const std::vector<BatchFile> files = filesOf(plan);
    std::vector<FilesOfTree> groups;
    int number = 0;
    for (const FilesOfTree& group : groupsOf(files)) // neighbours cost about the same: each part gets some of all
        if (number++ % options.parts == options.part - 1) groups.push_back(group);
    const int jobs = std::clamp(options.jobs, 1, std::max(1, static_cast<int>(groups.size())));
    BatchOptions shared = options;
    shared.limits.bytes /= jobs;
    CBatchRun run(plan, shared, report);
    const CProgress own = progress.piece(std::max(1, progress.threads() / jobs));
    parallelFor(
        groups.size(), 1, [&](std::size_t first, std::size_t) { run.write(groups[first], own); }, progress.piece(jobs));
    return run.result();
}

BatchSize sizeOf(const BatchPlan& plan, const BatchFile& file, const CProgress& progress) {
    const CParams params = paramsOf(plan, file);
    const double full = predictSize(params, detailOf(Model::Full), progress).vertices;
    const ExportOptions options = optionsOf(plan, file);
    return {estimatedBytes(full, options, *formatOf(file.output)), full * detailOf(Model::Full, file.lod).share};
}

} // namespace stromar
