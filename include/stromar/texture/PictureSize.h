#pragma once
#include <filesystem>

namespace stromar {

/// What a picture may take when it is unpacked: one of 11,000 x 11,000 pixels with opacity, or a panorama of 13,000 x 3,300.
constexpr double kMaxPictureBytes = 512e6;

/// Throws CError when a .png, .jpg or .hdr says that it is larger: a small file can hold a picture that takes all memory. Reads its
/// head only; what is no such file, or broken, is left to who reads it.
void refuseHugePicture(const std::filesystem::path& file);

/// Pixels of the longer side of such a file, by its head; 0 where it has none.
int longerSideOf(const std::filesystem::path& file);

} // namespace stromar
