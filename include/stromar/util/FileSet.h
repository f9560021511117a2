#pragma once
#include "stromar/util/Progress.h"
#include <cstdint>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace stromar {

/// Files that appear together or not at all. Each is written to a temporary file beside its place; commit() moves all
/// of them there. Without commit() nothing changes on the disk: existing files keep their content, temporary ones
/// vanish. Every write may throw CError (disk full, no such folder) or CCancelled.
class CFileSet {
public:
    /// `expectedBytes` scales what is reported to `progress` while writing; 0 reports nothing.
    explicit CFileSet(CProgress progress = CProgress(), std::uint64_t expectedBytes = 0);
    ~CFileSet();
    CFileSet(const CFileSet&) = delete;
    CFileSet& operator=(const CFileSet&) = delete;

    /// A stream that will become `path`. It lives as long as the set and throws on failure.
    std::ostream& create(const std::filesystem::path& path);
    /// Will put a copy of `source` at `path`.
    void copy(const std::filesystem::path& source, const std::filesystem::path& path);
    /// Flushes, checks that each file on the disk has all bytes that were written, and moves all into place.
    void commit();
    /// Bytes written so far.
    std::uint64_t bytes() const;

private:
    class CFile;
    CProgress m_progress;
    std::uint64_t m_expected;
    std::uint64_t m_bytes = 0;
    std::vector<std::unique_ptr<CFile>> m_files;
};

/// Replaces the content of one file, atomically. Throws CError.
void writeFile(const std::filesystem::path& path, std::string_view content);

/// The whole content. Throws CError (missing, a folder, unreadable).
std::string readFile(const std::filesystem::path& path);

} // namespace stromar
