#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace stromar {

/// Light of an sRGB value, and back; all 0..1 (IEC 61966-2-1).
inline float linearOf(float v) { return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f); }
inline float encodedOf(float v) { return v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f; }

/// Light of an sRGB byte.
inline float linearOfByte(std::uint8_t v) {
    static const std::array<float, 256> all = [] {
        std::array<float, 256> light{};
        for (std::size_t i = 0; i < light.size(); ++i) light[i] = linearOf(float(i) / 255);
        return light;
    }();
    return all[v];
}

/// Of 0..1; what lies beyond is cut off.
inline std::uint8_t byteOf(float value) { return static_cast<std::uint8_t>(std::clamp(value * 255 + 0.5f, 0.0f, 255.0f)); }

} // namespace stromar
