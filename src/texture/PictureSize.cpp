#include "stromar/texture/PictureSize.h"
#include "stromar/util/Error.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iomanip>
#include <optional>
#include <sstream>
#include <string>

namespace stromar {

namespace {
/// As the head of a file has it.
struct PictureHead {
    double width, height;
    int bytesPerPixel; ///< unpacked
};

/// Of the next bytes, the highest first; 0 beyond the end.
std::uint32_t number(std::istream& in, int bytes) {
    std::uint32_t value = 0;
    for (int i = 0; i < bytes; ++i) {
        const int next = in.get();
        value = value << 8 | static_cast<std::uint32_t>(next < 0 ? 0 : next);
    }
    return value;
}

/// Signature, length and name of the first chunk, then width, height and bits of a channel.
std::optional<PictureHead> readPngHead(std::istream& in) {
    in.seekg(16);
    const double width = number(in, 4), height = number(in, 4);
    return PictureHead{width, height, number(in, 1) == 16 ? 8 : 4};
}

/// The first start of a frame behind any other segments.
std::optional<PictureHead> readJpegHead(std::istream& in) {
    in.seekg(2);
    while (in.good() && number(in, 1) == 0xFF) {
        std::uint32_t marker = number(in, 1);
        while (marker == 0xFF) marker = number(in, 1); // filling
        const std::uint32_t length = number(in, 2);
        const bool frame = marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
        if (!frame) {
            if (length < 2) return {};
            in.seekg(length - 2, std::ios::cur);
            continue;
        }
        number(in, 1); // bits
        const double height = number(in, 2), width = number(in, 2);
        return PictureHead{width, height, 4};
    }
    return {};
}

/// Lines of text, an empty one, then "-Y 512 +X 1024".
std::optional<PictureHead> readHdrHead(std::istream& in) {
    std::string line;
    while (std::getline(in, line) && !line.empty()) continue;
    std::getline(in, line);
    std::istringstream words(line);
    std::string first, second;
    double height = 0, width = 0;
    if (!(words >> first >> height >> second >> width)) return {};
    return PictureHead{width, height, 12};
}

std::optional<PictureHead> readHead(std::istream& in) {
    std::array<char, 4> magic{};
    in.read(magic.data(), magic.size());
    const std::string_view start(magic.data(), magic.size());
    if (start == "\x89PNG") return readPngHead(in);
    if (start.starts_with("\xFF\xD8")) return readJpegHead(in);
    if (start.starts_with("#?")) return readHdrHead(in);
    return {};
}
} // namespace

int longerSideOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    const auto head = readHead(in);
    return head ? static_cast<int>(std::min(1e9, std::max(head->width, head->height))) : 0;
}

void refuseHugePicture(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    const auto head = readHead(in);
    if (!head || head->width * head->height * head->bytesPerPixel <= kMaxPictureBytes) return;
    const double bytes = head->width * head->height * head->bytesPerPixel;
    std::ostringstream why;
    why << std::setprecision(10) << file.string() << ": a picture of " << head->width << " x " << head->height
        << " pixels is too large; it would take " << std::ceil(bytes / 1e6) << " MB, " << kMaxPictureBytes / 1e6 << " are allowed";
    throw CError(why.str());
}

} // namespace stromar
