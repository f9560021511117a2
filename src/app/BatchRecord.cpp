#include "BatchRecord.h"
#include "ContentHash.h"
#include "stromar/util/Error.h"
#include "stromar/util/FileSet.h"
#include <sstream>

namespace stromar {

namespace fs = std::filesystem;

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
