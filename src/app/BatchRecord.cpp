#include "BatchRecord.h"
#include "stromar/util/Error.h"
#include "stromar/util/FileSet.h"
#include "stromar/util/Random.h"
#include <cstring>
#include <sstream>

namespace stromar {

namespace fs = std::filesystem;

std::uint64_t hashOfText(std::string_view text) {
    std::uint64_t hash = text.size();
    for (std::size_t at = 0; at < text.size(); at += sizeof hash) {
        std::uint64_t word = 0;
        std::memcpy(&word, text.data() + at, std::min(sizeof word, text.size() - at));
        hash = hashCombine(hash, word);
    }
    return hash;
}

std::uint64_t hashOfFile(const fs::path& path) { return hashOfText(readFile(path)); }

CBatchRecord::CBatchRecord(const fs::path& file) : m_folder(file.parent_path()) {
    if (file.empty()) return;
    bool cut = false;
    if (std::error_code problem; fs::is_regular_file(file, problem)) {
        const std::string text = readFile(file);
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            Entry entry{};
            std::string model;
            if (words >> std::hex >> entry.wanted >> entry.content && words.get() == ' ' && std::getline(words, model)) m_entries[model] = entry;
        }
        cut = !text.empty() && text.back() != '\n'; // the run before was killed while it wrote
    }
    m_out.open(file, std::ios::app);
    if (cut) m_out << '\n';
    if (!m_out) throw CError("cannot write " + file.string());
}

bool CBatchRecord::has(const fs::path& model, std::uint64_t wanted) const {
    Entry entry{};
    {
        const std::lock_guard lock(m_mutex);
        const auto found = m_entries.find(model.lexically_proximate(m_folder).string());
        if (found == m_entries.end() || found->second.wanted != wanted) return false;
        entry = found->second;
    }
    std::error_code problem;
    return fs::is_regular_file(model, problem) && hashOfFile(model) == entry.content;
}

void CBatchRecord::add(const fs::path& model, std::uint64_t wanted) {
    const Entry entry{wanted, hashOfFile(model)};
    const std::string name = model.lexically_proximate(m_folder).string();
    const std::lock_guard lock(m_mutex);
    m_entries[name] = entry;
    if (!m_out.is_open()) return;
    m_out << std::hex << entry.wanted << ' ' << entry.content << ' ' << name << std::endl; // on the disk before the next begins
    if (!m_out) throw CError("cannot write the record of the batch");
}

} // namespace stromar
