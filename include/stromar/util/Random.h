#pragma once
#include <cstdint>

namespace stromar {

/// The finaliser of SplitMix64 (Steele, Lea, Flood 2014).
constexpr std::uint64_t splitMix(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
}

/// Mixes a word into a hash. A good avalanche: every input bit reaches every output bit.
constexpr std::uint64_t hashCombine(std::uint64_t hash, std::uint64_t word) {
    return splitMix(splitMix(hash + 0x9e3779b97f4a7c15ULL) ^ (word * 0xd6e8feb86659fd93ULL + 0x2545f4914f6cdd1dULL));
}

/// A hash as a number in [0, 1).
inline double unitOf(std::uint64_t hash) { return static_cast<double>(hash >> 11) * 0x1p-53; }

/// Random numbers without a state: each is a pure function of (seed, id, purpose, place). So numbers can be drawn in
/// any order and on any thread, and one draw more or less never changes another.
class CRandom {
public:
    /// `varied` false gives the neutral source: every uniform number is 0.5 and every phase 0.
    CRandom(std::uint64_t seed, bool varied) : m_seed(seed), m_varied(varied) {}

    /// Uniform in [0, 1). `purpose` says what the number is for, `place` where inside the object `id` it is drawn.
    double uniform(std::uint64_t id, std::uint32_t purpose, std::uint64_t place = 0) const {
        return m_varied ? draw(id, purpose, place) : 0.5;
    }
    /// Uniform in [-v, v).
    double vary(double v, std::uint64_t id, std::uint32_t purpose, std::uint64_t place = 0) const {
        return v == 0 ? 0 : v * (2 * uniform(id, purpose, place) - 1);
    }
    /// Uniform in [0, 1), 0 for the neutral source: the start of a count's error diffusion.
    double phase(std::uint64_t id, std::uint32_t purpose) const { return m_varied ? draw(id, purpose, 0) : 0; }

private:
    double draw(std::uint64_t id, std::uint32_t purpose, std::uint64_t place) const;

    std::uint64_t m_seed;
    bool m_varied;
};

} // namespace stromar
