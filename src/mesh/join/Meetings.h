#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace stromar {

/// What is known of many meetings of an edge with a triangle: a hash table in one array (open addressing), because hundreds of thousands are
/// looked up.
class CMeetings {
public:
    using Index = std::uint32_t;
    static constexpr Index kNone = std::numeric_limits<Index>::max();
    /// Of the edge between two points.
    struct Meeting {
        Index low, high, triangle;
        bool operator==(const Meeting&) const = default;
    };

    std::size_t size() const { return m_count; }

    /// What is known of a meeting, kNone at first, until the next is asked for; and whether this is the first time.
    std::pair<Index&, bool> at(const Meeting& meeting) {
        if (2 * m_count >= m_entries.size()) grow();
        Entry& own = m_entries[placeOf(meeting)];
        const bool isNew = own.meeting != meeting;
        if (isNew) own.meeting = meeting, ++m_count;
        return {own.value, isNew};
    }

private:
    struct Entry {
        Meeting meeting{kNone, kNone, kNone};
        Index value = kNone;
        bool isFree() const { return meeting.triangle == kNone; }
    };

    static std::size_t hashOf(const Meeting& own) {
        std::uint64_t hash = (std::uint64_t{own.low} << 32 | own.high) * 0x9E3779B97F4A7C15u;
        hash = (hash ^ hash >> 32 ^ own.triangle) * 0xC2B2AE3D27D4EB4Fu;
        return static_cast<std::size_t>(hash ^ hash >> 32);
    }

    /// Of the meeting's entry, or the one it would have.
    std::size_t placeOf(const Meeting& meeting) const {
        std::size_t place = hashOf(meeting) & (m_entries.size() - 1);
        while (!m_entries[place].isFree() && m_entries[place].meeting != meeting) place = (place + 1) & (m_entries.size() - 1);
        return place;
    }

    void grow() {
        constexpr std::size_t kFirst = 256;
        std::vector<Entry> before(m_entries.empty() ? kFirst : 2 * m_entries.size());
        before.swap(m_entries);
        for (const Entry& own : before)
            if (!own.isFree()) m_entries[placeOf(own.meeting)] = own;
    }

    std::vector<Entry> m_entries; ///< 2^n, at most half of them in use
    std::size_t m_count = 0;
};

} // namespace stromar
