#pragma once
#include "stromar/util/Error.h"
#include <array>
#include <cstdint>
#include <ostream>
#include <streambuf>
#include <string>
#include <vector>
#include <zlib.h>

namespace stromar {

/// Hands on what is written, and counts and sums it up.
class CSummingBuffer : public std::streambuf {
public:
    explicit CSummingBuffer(std::ostream& out) : m_out(out) {}
    std::uint32_t sum() const { return m_sum; } ///< CRC-32
    std::uint64_t size() const { return m_size; }

protected:
    int_type overflow(int_type c) override {
        const char byte = traits_type::to_char_type(c);
        xsputn(&byte, 1);
        return traits_type::not_eof(c);
    }
    std::streamsize xsputn(const char* bytes, std::streamsize size) override {
        m_out.write(bytes, size);
        m_sum = static_cast<std::uint32_t>(crc32_z(m_sum, reinterpret_cast<const Bytef*>(bytes), static_cast<z_size_t>(size)));
        m_size += static_cast<std::uint64_t>(size);
        return size;
    }

private:
    std::ostream& m_out;
    std::uint32_t m_sum = 0;
    std::uint64_t m_size = 0;
};

/// A zip archive whose files are stored as they are, each at a multiple of 64 bytes, as .usdz packages have to be. At most 4 GiB.
class CZipOut {
public:
    explicit CZipOut(std::ostream& out) : m_out(out) {}

    /// A file that `fill` writes into a stream.
    template <typename Fill>
    void add(const std::string& name, Fill&& fill) {
        const std::uint64_t head = place();
        const std::uint64_t bare = head + kLocalHead + name.size() + kExtraHead;
        const auto padding = static_cast<std::uint16_t>((kAlignment - bare % kAlignment) % kAlignment);
        Entry entry{name, head, 0, 0};
        putLocalHead(entry, padding);
        CSummingBuffer buffer(m_out);
        std::ostream stream(&buffer);
        stream.exceptions(std::ios::badbit | std::ios::failbit);
        fill(stream);
        entry.sum = buffer.sum();
        entry.size = buffer.size();
        const std::uint64_t end = place();
        if (end > kMost) throw CError("a .usdz package holds at most 4 GiB; choose a lower level of detail");
        m_out.seekp(static_cast<std::streamoff>(head));
        putLocalHead(entry, padding);
        m_out.seekp(static_cast<std::streamoff>(end));
        m_entries.push_back(entry);
    }

    void finish() {
        const std::uint64_t start = place();
        for (const Entry& entry : m_entries) putCentralHead(entry);
        const std::uint64_t size = place() - start;
        u32(0x06054b50);
        for (int i = 0; i < 2; ++i) u16(0); // one disk
        for (int i = 0; i < 2; ++i) u16(m_entries.size());
        u32(size);
        u32(start);
        u16(0);
    }

private:
    static constexpr std::uint64_t kAlignment = 64, kLocalHead = 30, kExtraHead = 4, kMost = 0xffffffff;
    static constexpr std::uint64_t kVersion = 10, kDay = 0x21; // 1980-01-01: the same model gives the same bytes at any time
    static constexpr std::uint64_t kPadding = 0x1986;          // an extra field that means nothing

    struct Entry {
        std::string name;
        std::uint64_t head;
        std::uint32_t sum;
        std::uint64_t size;
    };

    /// Version, flags, method, time, date, sum, sizes, length of the name.
    void putCommon(const Entry& entry) {
        for (const std::uint64_t value : {kVersion, std::uint64_t{0}, std::uint64_t{0}, std::uint64_t{0}, kDay}) u16(value);
        u32(entry.sum);
        for (int i = 0; i < 2; ++i) u32(entry.size);
        u16(entry.name.size());
    }
    void putLocalHead(const Entry& entry, std::uint16_t padding) {
        u32(0x04034b50);
        putCommon(entry);
        u16(kExtraHead + padding);
        text(entry.name);
        u16(kPadding);
        u16(padding);
        text(std::string(padding, '\0'));
    }
    void putCentralHead(const Entry& entry) {
        u32(0x02014b50);
        u16(kVersion);
        putCommon(entry);
        for (int i = 0; i < 4; ++i) u16(0); // extra field, comment, disk, attributes
        u32(0);
        u32(entry.head);
        text(entry.name);
    }

    void u16(std::uint64_t value) { put(value, 2); }
    void u32(std::uint64_t value) { put(value, 4); }
    void put(std::uint64_t value, int bytes) {
        for (int i = 0; i < bytes; ++i) m_out.put(static_cast<char>(value >> (8 * i) & 0xff));
    }
    void text(const std::string& bytes) { m_out.write(bytes.data(), static_cast<std::streamsize>(bytes.size())); }
    std::uint64_t place() { return static_cast<std::uint64_t>(m_out.tellp()); }

    std::ostream& m_out;
    std::vector<Entry> m_entries;
};

} // namespace stromar
