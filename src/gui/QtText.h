#pragma once
#include <QString>
#include <filesystem>
#include <string_view>

namespace stromar {

// Between Qt's texts and the layers below. UTF-8 there.

inline QString toQString(std::string_view text) { return QString::fromUtf8(text.data(), qsizetype(text.size())); }
inline std::filesystem::path toPath(const QString& path) { return std::filesystem::path(path.toStdU16String()); }
inline QString fromPath(const std::filesystem::path& path) { return QString::fromStdU16String(path.u16string()); }

} // namespace stromar
