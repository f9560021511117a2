#pragma once
#include <charconv>
#include <ostream>
#include <string>
#include <string_view>

namespace stromar {

/// Collects text in a buffer: numbers in the shortest form that reads back exactly, always with a decimal point.
class CTextOut {
public:
    explicit CTextOut(std::ostream& out) : m_out(out) { m_text.reserve(kFlushAt + 256); }
    CTextOut(const CTextOut&) = delete;
    CTextOut& operator=(const CTextOut&) = delete;

    CTextOut& operator<<(std::string_view text) {
        m_text += text;
        return *this;
    }
    CTextOut& operator<<(float value) { return number(value); }
    CTextOut& operator<<(std::size_t value) { return number(value); }

    /// Hands everything over. Must be called at the end.
    void flush() {
        m_out.write(m_text.data(), static_cast<std::streamsize>(m_text.size()));
        m_text.clear();
    }
    /// Call now and then, between two records.
    void endRecord() {
        if (m_text.size() >= kFlushAt) flush();
    }

private:
    static constexpr std::size_t kFlushAt = 1 << 16;

    template <typename T>
    CTextOut& number(T value) {
        char buffer[40];
        m_text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
        return *this;
    }

    std::ostream& m_out;
    std::string m_text;
};

} // namespace stromar
