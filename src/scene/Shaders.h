#pragma once

namespace stromar {

// GLSL 1.20: OpenGL 2.1 and later. Directions in eye space; the sun stands still in the world.

inline constexpr const char* kTreeVertexShader = R"(#version 120
uniform mat4 osg_ViewMatrix;
uniform vec3 crownMiddle, crownSize;
attribute float openAt;
varying vec3 eyeNormal, eyePosition, sun;
varying float openness, shade;
void main() {
    gl_Position = ftransform();
    gl_TexCoord[0] = gl_MultiTexCoord0;
    eyeNormal = gl_NormalMatrix * gl_Normal;
    eyePosition = (gl_ModelViewMatrix * gl_Vertex).xyz;
    sun = (osg_ViewMatrix * vec4(normalize(vec3(0.45, -0.6, 0.75)), 0.0)).xyz;
    // Inside the crown less of the sky is seen.
    vec3 out_ = (gl_Vertex.xyz - crownMiddle) / crownSize;
    openness = smoothstep(0.1, 1.0, length(out_) * 0.8 + 0.25 * out_.z) * openAt;
    // All corners of a leaf share its normal: a number of its own.
    shade = fract(sin(dot(gl_Normal, vec3(127.1, 311.7, 74.7))) * 437.5);
}
)";

inline constexpr const char* kTreeFragmentShader = R"(#version 120
uniform mat4 osg_ViewMatrix;
uniform sampler2D picture;
uniform float leaf, tinted, generation;
varying vec3 eyeNormal, eyePosition, sun;
varying float openness, shade;
void main() {
    vec4 colour = texture2D(picture, gl_TexCoord[0].st);
    if (colour.a < 0.4) discard;
    // Leaves let one see the stems that are in hand.
    if (leaf > 0.5 && tinted > -0.5 && mod(floor(gl_FragCoord.x) + floor(gl_FragCoord.y), 2.0) > 0.5) discard;
    vec3 n = normalize(eyeNormal);
    if (dot(n, eyePosition) > 0.0) n = -n;
    vec3 up = (osg_ViewMatrix * vec4(0.0, 0.0, 1.0, 0.0)).xyz;
    float facing = dot(n, normalize(sun));
    float direct = max(facing, 0.0) + leaf * 0.55 * max(-facing, 0.0);
    vec3 sky = mix(vec3(0.44, 0.43, 0.34), vec3(0.70, 0.78, 0.88), 0.5 + 0.5 * dot(n, up));
    colour.rgb *= mix(vec3(1.0), vec3(0.82 + 0.36 * shade, 0.88 + 0.24 * shade, 0.80 + 0.2 * shade), leaf);
    vec3 light = sky * mix(0.55, 0.95, openness) + vec3(1.05, 0.99, 0.86) * direct * mix(0.5, 1.0, openness);
    vec3 seen = colour.rgb * light;
    if (abs(tinted - generation) < 0.5)
        seen = mix(seen, vec3(1.0, 0.55, 0.12) * (0.45 + 0.6 * dot(seen, vec3(0.35, 0.5, 0.15))), 0.6);
    gl_FragColor = vec4(seen, 1.0);
}
)";

inline constexpr const char* kPlainVertexShader = R"(#version 120
void main() { gl_Position = ftransform(); }
)";

// Upright and towards the eye, its feet at `place`.
inline constexpr const char* kPersonVertexShader = R"(#version 120
uniform mat4 osg_ViewMatrix;
uniform vec3 place;
void main() {
    vec3 up = (osg_ViewMatrix * vec4(0.0, 0.0, 1.0, 0.0)).xyz;
    vec3 aside = normalize(cross(up, vec3(0.0, 0.0, 1.0)) + vec3(1e-4, 0.0, 0.0));
    vec4 feet = gl_ModelViewMatrix * vec4(place, 1.0);
    gl_Position = gl_ProjectionMatrix * vec4(feet.xyz + aside * gl_Vertex.x + up * gl_Vertex.y, 1.0);
}
)";

inline constexpr const char* kPlainFragmentShader = R"(#version 120
uniform vec4 colour;
void main() { gl_FragColor = colour; }
)";

inline constexpr const char* kBackgroundVertexShader = R"(#version 120
varying vec4 near_, far_;
void main() {
    gl_Position = vec4(gl_Vertex.xy, 0.999, 1.0);
    near_ = gl_ModelViewProjectionMatrixInverse * vec4(gl_Vertex.xy, -1.0, 1.0);
    far_ = gl_ModelViewProjectionMatrixInverse * vec4(gl_Vertex.xy, 1.0, 1.0);
}
)";

// The ground is the plane z = 0, seen along each ray, with a soft shadow under the crown and a grid of metres.
inline constexpr const char* kBackgroundFragmentShader = R"(#version 120
uniform mat4 osg_ViewMatrixInverse;
uniform vec3 crownMiddle, crownSize;
uniform int backdrop;
uniform float grid;
varying vec4 near_, far_;
const vec3 haze = vec3(0.86, 0.89, 0.90);
float size() { return max(crownSize.x, max(crownSize.y, crownSize.z)); }
float shadowAt(vec2 place) {
    vec2 inShadow = (place - crownMiddle.xy - vec2(-0.35, 0.45) * crownMiddle.z) / (crownSize.xy + 0.02 * size());
    float shadow = 0.45 * (1.0 - smoothstep(0.25, 1.15, length(inShadow)));
    return max(shadow, 0.35 * (1.0 - smoothstep(0.0, 0.25, length(place) / size())));
}
float lines(vec2 place, float cell) {
    vec2 at = place / cell, width = fwidth(at);
    vec2 off = abs(fract(at - 0.5) - 0.5) / max(width, vec2(1e-6));
    return (1.0 - min(min(off.x, off.y), 1.0)) * (1.0 - smoothstep(0.1, 0.5, max(width.x, width.y)));
}
void main() {
    vec3 start = near_.xyz / near_.w;
    vec3 ray = normalize(far_.xyz / far_.w - start);
    bool down = ray.z < -1e-5 && osg_ViewMatrixInverse[3].z > 0.0;
    vec2 place = start.xy - ray.xy * start.z / (down ? ray.z : -1.0);
    float line = grid * max(0.35 * lines(place, 1.0), 0.7 * lines(place, 10.0));
    float away = max(length(place - crownMiddle.xy) / size() - 1.0, 0.0);
    float fade = exp(-0.09 * away);
    vec3 colour;
    if (backdrop == 0) {
        vec3 sky = mix(haze, vec3(0.47, 0.63, 0.81), smoothstep(0.0, 0.45, abs(ray.z)));
        vec3 ground = mix(vec3(0.55, 0.60, 0.44) * (1.0 - shadowAt(place)), vec3(0.20, 0.23, 0.16), line);
        colour = down ? mix(haze, ground, fade) : sky;
    } else {
        vec3 plain = backdrop == 1 ? vec3(0.88) : vec3(0.17, 0.18, 0.19);
        vec3 ink = backdrop == 1 ? vec3(0.35) : vec3(0.55);
        vec3 ground = mix(plain * (1.0 - 0.7 * shadowAt(place)), ink, line);
        colour = down ? mix(plain, ground, fade) : plain;
    }
    gl_FragColor = backdrop == 3 ? vec4(0.0) : vec4(colour, 1.0);
}
)";

} // namespace stromar
