#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace stromar {

// Names for what is kept by its content. Not for the safety of anything.

std::uint64_t hashOfText(std::string_view text);
/// Of the content. Throws CError.
std::uint64_t hashOfFile(const std::filesystem::path& path);
/// Sixteen digits.
std::string nameOfHash(std::uint64_t hash);

} // namespace stromar
