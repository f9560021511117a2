#include "stromar/texture/HalfPicture.h"
#include "stromar/util/Error.h"
#include <ImfRgbaFile.h>
#include <ImfStdIO.h>

namespace stromar {

void writeExr(const std::vector<std::array<float, 4>>& pixels, int width, int height, const std::filesystem::path& path,
              CFileSet& files) {
    std::vector<Imf::Rgba> halves;
    halves.reserve(pixels.size());
    for (const auto& pixel : pixels) halves.emplace_back(pixel[0], pixel[1], pixel[2], pixel[3]);
    Imf::StdOSStream bytes;
    try {
        const Imf::Header header(width, height, 1, Imath::V2f(0, 0), 1, Imf::INCREASING_Y, Imf::ZIP_COMPRESSION);
        Imf::RgbaOutputFile file(bytes, header, Imf::WRITE_RGBA);
        file.setFrameBuffer(halves.data(), 1, static_cast<std::size_t>(width));
        file.writePixels(height);
    } catch (const std::exception& e) {
        throw CError(std::string("cannot make an OpenEXR picture: ") + e.what());
    }
    files.create(path) << bytes.str();
}

} // namespace stromar
