#pragma once
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <string>

namespace stromar {

/// Which models were written, and what for: a text file with a line for each, added as it is done, so that a run that was killed goes on. All
/// members: any thread.
class CBatchRecord {
public:
    /// Reads the file, if there is one; lines that are none are left out. An empty path keeps nothing. Throws CError when it cannot be written.
    explicit CBatchRecord(const std::filesystem::path& file);

    /// Whether a model was written for this, and still is as it was.
    bool has(const std::filesystem::path& model, std::uint64_t wanted) const;
    void add(const std::filesystem::path& model, std::uint64_t wanted);

private:
    struct Entry {
        std::uint64_t wanted, content;
    };
    std::filesystem::path m_folder; ///< paths of models are relative to it
    std::ofstream m_out;
    mutable std::mutex m_mutex;
    std::map<std::string, Entry> m_entries;
};

} // namespace stromar
