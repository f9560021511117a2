#pragma once

namespace stromar {

// GLSL 1.20: OpenGL 2.1 and later. Directions in eye space; the sun stands still in the world.

inline constexpr const char* kTreeVertexShader = R"(#version 120
uniform mat4 osg_ViewMatrix;
uniform vec3 crownMiddle, crownSize;
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
    openness = smoothstep(0.1, 1.0, length(out_) * 0.8 + 0.25 * out_.z);
    // All corners of a leaf share its normal: a number of its own.
    shade = fract(sin(dot(gl_Normal, vec3(127.1, 311.7, 74.7))) * 437.5);
}
)";

inline constexpr const char* kTreeFragmentShader = R"(#version 120
uniform mat4 osg_ViewMatrix;
uniform sampler2D picture;
uniform float leaf;
varying vec3 eyeNormal, eyePosition, sun;
varying float openness, shade;
void main() {
    vec4 colour = texture2D(picture, gl_TexCoord[0].st);
    if (colour.a < 0.4) discard;
    vec3 n = normalize(eyeNormal);
    if (dot(n, eyePosition) > 0.0) n = -n;
    vec3 up = (osg_ViewMatrix * vec4(0.0, 0.0, 1.0, 0.0)).xyz;
    float facing = dot(n, normalize(sun));
    float direct = max(facing, 0.0) + leaf * 0.55 * max(-facing, 0.0);
    vec3 sky = mix(vec3(0.44, 0.43, 0.34), vec3(0.70, 0.78, 0.88), 0.5 + 0.5 * dot(n, up));
    colour.rgb *= mix(vec3(1.0), vec3(0.82 + 0.36 * shade, 0.88 + 0.24 * shade, 0.80 + 0.2 * shade), leaf);
    vec3 light = sky * mix(0.55, 0.95, openness) + vec3(1.05, 0.99, 0.86) * direct * mix(0.5, 1.0, openness);
    gl_FragColor = vec4(colour.rgb * light, 1.0);
}
)";

inline constexpr const char* kBackgroundVertexShader = R"(#version 120
varying vec3 direction;
void main() {
    gl_Position = vec4(gl_Vertex.xy, 0.999, 1.0);
    vec4 near_ = gl_ModelViewProjectionMatrixInverse * vec4(gl_Vertex.xy, -1.0, 1.0);
    vec4 far_ = gl_ModelViewProjectionMatrixInverse * vec4(gl_Vertex.xy, 1.0, 1.0);
    direction = far_.xyz / far_.w - near_.xyz / near_.w;
}
)";

// The ground is the plane z = 0, seen along each ray, with a soft shadow under the crown.
inline constexpr const char* kBackgroundFragmentShader = R"(#version 120
uniform mat4 osg_ViewMatrixInverse;
uniform vec3 crownMiddle, crownSize;
varying vec3 direction;
const vec3 haze = vec3(0.86, 0.89, 0.90);
vec3 ground(vec2 place) {
    float size = max(crownSize.x, max(crownSize.y, crownSize.z));
    vec2 inShadow = (place - crownMiddle.xy - vec2(-0.35, 0.45) * crownMiddle.z) / (crownSize.xy + 0.02 * size);
    float shadow = 0.45 * (1.0 - smoothstep(0.25, 1.15, length(inShadow)));
    float trunk = 0.35 * (1.0 - smoothstep(0.0, 0.25, length(place) / size));
    float away = length(place - crownMiddle.xy) / size;
    return mix(vec3(0.55, 0.60, 0.44) * (1.0 - max(shadow, trunk)), haze, 1.0 - exp(-0.09 * max(away - 1.0, 0.0)));
}
void main() {
    vec3 eye = osg_ViewMatrixInverse[3].xyz;
    vec3 ray = normalize(direction);
    vec3 sky = mix(haze, vec3(0.47, 0.63, 0.81), smoothstep(0.0, 0.45, abs(ray.z)));
    bool down = ray.z < 0.0 && eye.z > 0.0;
    gl_FragColor = vec4(down ? ground(eye.xy - ray.xy * eye.z / ray.z) : sky, 1.0);
}
)";

} // namespace stromar
