#pragma once
#include <string>

namespace stromar {

/// What things may be called in USD, XML and the like: letters, digits and underscores, no digit in front.
inline std::string identifier(const std::string& name) {
    std::string plain;
    for (const char c : name) plain += (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ? c : '_';
    return plain.empty() || (plain[0] >= '0' && plain[0] <= '9') ? "_" + plain : plain;
}

} // namespace stromar
