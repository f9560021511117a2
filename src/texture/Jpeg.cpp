#include "stromar/texture/TextureMaps.h"
#include "stromar/util/Error.h"
#include "stromar/util/FileSet.h"
#include <memory>
#include <turbojpeg.h>

namespace stromar {

namespace {
constexpr int kQuality = 90; // of 100: blocks are not seen
}

void writeJpeg(const std::vector<std::array<std::uint8_t, 4>>& pixels, int width, int height, const std::filesystem::path& path, CFileSet& files) {
    const std::unique_ptr<void, int (*)(void*)> jpeg(tjInitCompress(), tjDestroy);
    if (!jpeg) throw CError("cannot write a JPEG picture: no memory");
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    const int failed = tjCompress2(jpeg.get(), pixels.front().data(), width, 0, height, TJPF_RGBX, &bytes, &size, TJSAMP_444, kQuality, TJFLAG_ACCURATEDCT);
    const std::unique_ptr<unsigned char, void (*)(unsigned char*)> kept(bytes, tjFree);
    if (failed) throw CError(path.string() + ": " + tjGetErrorStr2(jpeg.get()));
    files.create(path).write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
}

} // namespace stromar
