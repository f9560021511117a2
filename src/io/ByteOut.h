#pragma once
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace stromar {

/// Bytes of a binary file in the making, most or least significant first.
template <std::endian order>
class CByteOut {
public:
    void u8(std::uint8_t v) { m_bytes += static_cast<char>(v); }
    void u16(std::uint16_t v) { put(v, 2); }
    void u32(std::uint32_t v) { put(v, 4); }
    void f32(float v) { u32(std::bit_cast<std::uint32_t>(v)); }
    void text(std::string_view t) { m_bytes += t; }
    /// With a zero behind it.
    void zeroText(std::string_view t) {
        m_bytes += t;
        m_bytes += '\0';
    }
    /// Overwrites an earlier u16 or u32.
    void patch16(std::size_t place, std::uint16_t v) { patch(place, v, 2); }
    void patch32(std::size_t place, std::uint32_t v) { patch(place, v, 4); }
    std::size_t size() const { return m_bytes.size(); }
    const std::string& bytes() const { return m_bytes; }

private:
    void put(std::uint32_t v, int count) {
        for (int i = 0; i < count; ++i) m_bytes += byteOf(v, i, count);
    }
    void patch(std::size_t place, std::uint32_t v, int count) {
        for (int i = 0; i < count; ++i) m_bytes[place + static_cast<std::size_t>(i)] = byteOf(v, i, count);
    }
    static char byteOf(std::uint32_t v, int i, int count) {
        return static_cast<char>(v >> (8 * (order == std::endian::big ? count - 1 - i : i)) & 0xff);
    }
    std::string m_bytes;
};

} // namespace stromar
