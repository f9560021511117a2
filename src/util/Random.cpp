#include "stromar/util/Random.h"

namespace stromar {

double CRandom::draw(std::uint64_t id, std::uint32_t purpose, std::uint64_t place) const {
    return unitOf(hashCombine(hashCombine(hashCombine(m_seed, id), purpose), place));
}

} // namespace stromar
