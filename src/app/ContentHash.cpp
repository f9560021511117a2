#include "ContentHash.h"
#include "stromar/util/FileSet.h"
#include "stromar/util/Random.h"
#include <algorithm>
#include <cstdio>
#include <cstring>

namespace stromar {

namespace fs = std::filesystem;

std::uint64_t hashOfText(std::string_view text) {
    std::uint64_t hash = text.size();
    for (std::size_t at = 0; at < text.size(); at += sizeof hash) {
        std::uint64_t word = 0;
        std::memcpy(&word, text.data() + at, std::min(sizeof word, text.size() - at));
        hash = hashCombine(hash, word);
    }
    return hash;
}

std::uint64_t hashOfFile(const fs::path& path) { return hashOfText(readFile(path)); }

std::string nameOfHash(std::uint64_t hash) {
    char name[17];
    std::snprintf(name, sizeof name, "%016llx", static_cast<unsigned long long>(hash));
    return name;
}

} // namespace stromar
