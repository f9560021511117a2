#pragma once
#include "stromar/util/Error.h"
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>
#include <zlib.h>

namespace stromar {

static_assert(std::endian::native == std::endian::little, "FBX's numbers are little-endian");

/// An array of an FBX file. `fill` gets a function that takes the numbers one by one; they are compressed at once.
template <typename Number, typename Fill>
struct FbxArray {
    std::size_t count;
    Fill fill;
};
template <typename Fill>
FbxArray<double, Fill> fbxDoubles(std::size_t count, Fill fill) {
    return {count, std::move(fill)};
}
template <typename Fill>
FbxArray<std::int32_t, Fill> fbxIntegers(std::size_t count, Fill fill) {
    return {count, std::move(fill)};
}

/// Bytes that are no text.
struct FbxBytes {
    std::string_view bytes;
};

/// A binary FBX file of version 7.4 in the making: records with properties and nested records. Nothing of it is kept in memory; the
/// lengths, which stand in front, are filled in afterwards. At most 4 GiB.
class CFbxOut {
public:
    explicit CFbxOut(std::ostream& out) : m_out(out) {
        text(std::string_view("Kaydara FBX Binary  \0\x1a\0", 23));
        number(kVersion);
    }

    /// A record without others in it.
    template <typename... Properties>
    void leaf(std::string_view name, const Properties&... properties) {
        const Head head = begin(name, sizeof...(properties));
        (put(properties), ...);
        endProperties(head);
        if (sizeof...(properties) == 0) endNested();
        end(head);
    }

    /// One whose nested records `fill` writes.
    template <typename Fill, typename... Properties>
    void node(std::string_view name, Fill&& fill, const Properties&... properties) {
        const Head head = begin(name, sizeof...(properties));
        (put(properties), ...);
        endProperties(head);
        fill();
        endNested();
        end(head);
    }

    /// What every file ends with.
    void finish() {
        constexpr std::string_view kMark("\xfa\xbc\xab\x09\xd0\xc8\xd4\x66\xb1\x76\xfb\x83\x1c\xf7\x26\x7e", 16);
        constexpr std::string_view kEnd("\xf8\x5a\x8c\x6a\xde\xf5\xd9\x7e\xec\xe9\x0c\xe3\x75\x8f\x29\x0b", 16);
        constexpr std::uint64_t kAlignment = 16, kEmpty = 120;
        endNested();
        text(kMark);
        zeros(4);
        zeros(kAlignment - place() % kAlignment);
        number(kVersion);
        zeros(kEmpty);
        text(kEnd);
    }

private:
    static constexpr std::uint32_t kVersion = 7400;
    static constexpr std::uint64_t kMost = 0xffffffff;
    static constexpr const char* kTooLarge = "an FBX file holds at most 4 GiB; choose a lower level of detail";

    struct Head {
        std::uint64_t place, properties;
    };

    Head begin(std::string_view name, std::size_t properties) {
        Head head{place(), 0};
        number(std::uint32_t{0}); // where the record ends, filled in by end()
        number(static_cast<std::uint32_t>(properties));
        number(std::uint32_t{0}); // the length of the properties
        number(static_cast<std::uint8_t>(name.size()));
        text(name);
        head.properties = place();
        return head;
    }
    void endProperties(const Head& head) { patch(head.place + 8, place() - head.properties); }
    void end(const Head& head) { patch(head.place, place()); }
    void endNested() { zeros(13); }

    void put(bool value) { typed('C', static_cast<std::uint8_t>(value)); }
    void put(std::int32_t value) { typed('I', value); }
    void put(std::int64_t value) { typed('L', value); }
    void put(double value) { typed('D', value); }
    void put(std::string_view value) { sized('S', value); }
    void put(const std::string& value) { sized('S', value); }
    void put(const char* value) { sized('S', value); }
    void put(const FbxBytes& value) { sized('R', value.bytes); }
    template <typename Number, typename Fill>
    void put(const FbxArray<Number, Fill>& array) {
        text(std::is_same_v<Number, double> ? "d" : "i");
        if (array.count > kMost / sizeof(Number)) throw CError(kTooLarge);
        number(static_cast<std::uint32_t>(array.count));
        number(std::uint32_t{1}); // compressed
        const std::uint64_t length = place();
        number(std::uint32_t{0});
        compress<Number>(array.fill);
        patch(length, place() - length - 4);
    }

    template <typename Number, typename Fill>
    void compress(const Fill& fill) {
        constexpr std::size_t kAtOnce = 8192;
        z_stream stream{};
        if (deflateInit(&stream, Z_BEST_SPEED) != Z_OK) throw CError("zlib cannot start");
        const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&stream, deflateEnd);
        std::vector<Number> numbers;
        numbers.reserve(kAtOnce);
        const auto hand = [&](int flush) {
            stream.next_in = reinterpret_cast<Bytef*>(numbers.data());
            stream.avail_in = static_cast<uInt>(numbers.size() * sizeof(Number));
            drain(stream, flush);
            numbers.clear();
        };
        fill([&](Number value) {
            numbers.push_back(value);
            if (numbers.size() == kAtOnce) hand(Z_NO_FLUSH);
        });
        hand(Z_FINISH);
    }
    void drain(z_stream& stream, int flush) {
        do {
            stream.next_out = reinterpret_cast<Bytef*>(m_buffer.data());
            stream.avail_out = static_cast<uInt>(m_buffer.size());
            deflate(&stream, flush);
            text({m_buffer.data(), m_buffer.size() - stream.avail_out});
        } while (stream.avail_out == 0);
    }

    template <typename Number>
    void typed(char type, Number value) {
        text({&type, 1});
        number(value);
    }
    void sized(char type, std::string_view value) {
        typed(type, static_cast<std::uint32_t>(value.size()));
        text(value);
    }
    template <typename Number>
    void number(Number value) {
        text({reinterpret_cast<const char*>(&value), sizeof value});
    }
    void zeros(std::size_t count) {
        for (; count > 0; --count) m_out.put('\0');
    }
    void text(std::string_view bytes) { m_out.write(bytes.data(), static_cast<std::streamsize>(bytes.size())); }
    std::uint64_t place() { return static_cast<std::uint64_t>(m_out.tellp()); }
    void patch(std::uint64_t at, std::uint64_t value) {
        if (value > kMost) throw CError(kTooLarge);
        const std::uint64_t here = place();
        m_out.seekp(static_cast<std::streamoff>(at));
        number(static_cast<std::uint32_t>(value));
        m_out.seekp(static_cast<std::streamoff>(here));
    }

    std::ostream& m_out;
    std::array<char, 1 << 16> m_buffer{};
};

} // namespace stromar
