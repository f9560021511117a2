#include "stromar/util/Random.h"

namespace stromar {

namespace {
/// The finaliser of SplitMix64 (Steele, Lea, Flood 2014).
std::uint64_t finalize(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
}
} // namespace

std::uint64_t hashCombine(std::uint64_t hash, std::uint64_t word) {
    return finalize(finalize(hash + 0x9e3779b97f4a7c15ULL) ^ (word * 0xd6e8feb86659fd93ULL + 0x2545f4914f6cdd1dULL));
}

double CRandom::draw(std::uint64_t id, std::uint32_t purpose, std::uint64_t place) const {
    return unitOf(hashCombine(hashCombine(hashCombine(m_seed, id), purpose), place));
}

} // namespace stromar
