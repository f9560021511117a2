#include "stromar/util/FileSet.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <fstream>
#include <streambuf>
#include <sys/stat.h>
#include <unistd.h>

namespace stromar {

namespace fs = std::filesystem;

namespace {
/// `what` names the file by %1.
[[noreturn]] void fail(std::string_view what, const fs::path& path, int error) {
    throw CError(translated(what, path.string()) + ": " + std::strerror(error));
}

/// The place a path really names, so that a symbolic link is written through instead of replaced.
fs::path resolved(fs::path path) {
    constexpr int kMaxLinks = 40;
    std::error_code problem;
    for (int links = 0; links < kMaxLinks && fs::is_symlink(path, problem); ++links)
        path = path.parent_path() / fs::read_symlink(path, problem);
    return path;
}

/// An unbuffered-by-the-system output that counts, reports and polls. Throws instead of returning eof.
class CCountingBuffer : public std::streambuf {
public:
    CCountingBuffer(int file, fs::path path, const CProgress& progress, std::uint64_t& total, std::uint64_t expected)
        : m_file(file), m_path(std::move(path)), m_progress(progress), m_total(total), m_expected(expected) {
        setp(m_buffer.data(), m_buffer.data() + m_buffer.size());
    }
    std::uint64_t size() const { return m_size; }
    void flushAll() {
        drain();
        if (m_failure) std::rethrow_exception(m_failure); // a library may have swallowed it
    }

protected:
    int_type overflow(int_type c) override {
        drain();
        if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
        return traits_type::not_eof(c);
    }
    int sync() override {
        drain();
        return 0;
    }
    std::streamsize xsputn(const char* data, std::streamsize size) override {
        if (size < epptr() - pptr()) return std::streambuf::xsputn(data, size);
        drain();
        put(data, static_cast<std::size_t>(size));
        return size;
    }
    /// Writers of chunked formats go back to fill in a length.
    pos_type seekoff(off_type off, std::ios_base::seekdir way, std::ios_base::openmode which) override {
        const auto here = static_cast<off_type>(m_position) + (pptr() - pbase());
        if (way == std::ios_base::cur && off == 0) return here;
        const off_type end = std::max(static_cast<off_type>(m_size), here);
        const off_type from = way == std::ios_base::beg ? 0 : way == std::ios_base::cur ? here : end;
        return seekpos(from + off, which);
    }
    pos_type seekpos(pos_type place, std::ios_base::openmode) override {
        drain();
        if (::lseek(m_file, off_type(place), SEEK_SET) < 0) fail(NC_("stromar", "cannot write %1"), m_path, errno);
        m_position = static_cast<std::uint64_t>(off_type(place));
        return place;
    }

private:
    void drain() {
        const auto size = static_cast<std::size_t>(pptr() - pbase());
        setp(m_buffer.data(), m_buffer.data() + m_buffer.size());
        put(m_buffer.data(), size);
    }
    void put(const char* data, std::size_t size) {
        try {
            write(data, size);
        } catch (...) {
            m_failure = std::current_exception();
            throw;
        }
    }
    void write(const char* data, std::size_t size) {
        m_progress.poll();
        while (size > 0) {
            const ssize_t n = ::write(m_file, data, std::min<std::size_t>(size, 1 << 20));
            if (n < 0 && errno == EINTR) continue;
            if (n < 0) fail(NC_("stromar", "cannot write %1"), m_path, errno);
            data += n;
            size -= static_cast<std::size_t>(n);
            m_position += static_cast<std::uint64_t>(n);
            m_size = std::max(m_size, m_position);
            m_total += static_cast<std::uint64_t>(n);
            if (m_expected > 0) m_progress.report(std::min(1.0, double(m_total) / double(m_expected)));
            m_progress.poll();
        }
    }

    int m_file;
    fs::path m_path;
    const CProgress& m_progress;
    std::uint64_t& m_total;
    std::uint64_t m_expected;
    std::uint64_t m_position = 0, m_size = 0;
    std::exception_ptr m_failure;
    std::array<char, 1 << 16> m_buffer{};
};
} // namespace

class CFileSet::CFile {
public:
    CFile(const fs::path& path, const CProgress& progress, std::uint64_t& total, std::uint64_t expected)
        : m_path(resolved(path)), m_temporary(temporaryBeside(m_path)), m_file(open()),
          m_buffer(m_file, path, progress, total, expected), m_stream(&m_buffer) {
        m_stream.imbue(std::locale::classic());
        m_stream.exceptions(std::ios::badbit | std::ios::failbit);
    }
    ~CFile() {
        if (m_file >= 0) ::close(m_file);
        if (!m_temporary.empty()) ::unlink(m_temporary.c_str());
    }
    CFile(const CFile&) = delete;
    CFile& operator=(const CFile&) = delete;

    std::ostream& stream() { return m_stream; }

    void finish() {
        m_buffer.flushAll();
        if (::fsync(m_file) != 0 && errno != EINVAL) fail(NC_("stromar", "cannot write %1"), m_path, errno);
        const int result = ::close(m_file);
        m_file = -1;
        if (result != 0) fail(NC_("stromar", "cannot write %1"), m_path, errno);
        std::error_code problem;
        if (fs::file_size(m_temporary, problem) != m_buffer.size() || problem)
            throw CError(translated(NC_("stromar", "cannot write %1: the file on the disk is incomplete"), m_path.string()));
    }
    void moveIntoPlace() {
        if (fs::is_directory(m_path)) fail(NC_("stromar", "cannot write %1"), m_path, EISDIR);
        if (::rename(m_temporary.c_str(), m_path.c_str()) != 0) fail(NC_("stromar", "cannot write %1"), m_path, errno);
        m_temporary.clear();
    }
    bool placeIsFolder() const { return fs::is_directory(m_path); }
    const fs::path& path() const { return m_path; }

private:
    /// Another for every file, so that threads that write the same one do not meet.
    static fs::path temporaryBeside(const fs::path& path) {
        static std::atomic<unsigned> number = 0;
        return path.parent_path() /
               ("." + path.filename().string() + ".part" + std::to_string(::getpid()) + "-" + std::to_string(++number));
    }
    int open() const {
        struct ::stat old {};
        const bool exists = ::stat(m_path.c_str(), &old) == 0;
        const int file = ::open(m_temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
        if (file < 0) fail(NC_("stromar", "cannot write %1"), m_path, errno);
        if (exists) (void)::fchmod(file, old.st_mode & 0777);
        return file;
    }

    fs::path m_path, m_temporary;
    int m_file;
    CCountingBuffer m_buffer;
    std::ostream m_stream;
};

CFileSet::CFileSet(CProgress progress, std::uint64_t expectedBytes)
    : m_progress(std::move(progress)), m_expected(expectedBytes) {}

CFileSet::~CFileSet() = default;

std::ostream& CFileSet::create(const fs::path& path) {
    m_files.push_back(std::make_unique<CFile>(path, m_progress, m_bytes, m_expected));
    return m_files.back()->stream();
}

void CFileSet::copy(const fs::path& source, const fs::path& path) {
    std::error_code problem;
    if (fs::equivalent(source, path, problem)) return;
    const std::string content = readFile(source);
    create(path).write(content.data(), static_cast<std::streamsize>(content.size()));
}

void CFileSet::commit() {
    for (const auto& file : m_files) {
        if (file->placeIsFolder()) fail(NC_("stromar", "cannot write %1"), file->path(), EISDIR);
        file->finish();
    }
    m_progress.poll();
    for (const auto& file : m_files) file->moveIntoPlace();
    m_files.clear();
}

std::uint64_t CFileSet::bytes() const { return m_bytes; }

void writeFile(const fs::path& path, std::string_view content) {
    CFileSet files;
    files.create(path).write(content.data(), static_cast<std::streamsize>(content.size()));
    files.commit();
}

std::string readFile(const fs::path& path) {
    if (fs::is_directory(path)) fail(NC_("stromar", "cannot read %1"), path, EISDIR);
    errno = 0;
    std::ifstream in(path, std::ios::binary);
    if (!in) fail(NC_("stromar", "cannot read %1"), path, errno);
    std::string content((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    if (in.bad()) fail(NC_("stromar", "cannot read %1"), path, errno);
    return content;
}

} // namespace stromar
