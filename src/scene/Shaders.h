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
    vec3 sky = mix(vec3(0.30, 0.30, 0.24), vec3(0.62, 0.70, 0.82), 0.5 + 0.5 * dot(n, up));
    colour.rgb *= mix(vec3(1.0), vec3(0.82 + 0.36 * shade, 0.88 + 0.24 * shade, 0.80 + 0.2 * shade), leaf);
    float open = mix(0.45, 1.0, openness);
    vec3 light = sky * open * 0.75 + vec3(1.15, 1.08, 0.95) * direct * mix(0.55, 1.0, openness);
    gl_FragColor = vec4(colour.rgb * light, 1.0);
}
)";

inline constexpr const char* kSkyVertexShader = R"(#version 120
varying float height;
void main() {
    gl_Position = vec4(gl_Vertex.xy, 0.999, 1.0);
    height = 0.5 + 0.5 * gl_Vertex.y;
}
)";

inline constexpr const char* kSkyFragmentShader = R"(#version 120
varying float height;
void main() {
    gl_FragColor = vec4(mix(vec3(0.83, 0.86, 0.88), vec3(0.56, 0.69, 0.83), height), 1.0);
}
)";

inline constexpr const char* kGroundVertexShader = R"(#version 120
varying vec2 place;
void main() {
    gl_Position = ftransform();
    place = gl_Vertex.xy;
}
)";

inline constexpr const char* kGroundFragmentShader = R"(#version 120
uniform vec3 crownMiddle, crownSize;
varying vec2 place;
void main() {
    float size = max(crownSize.x, max(crownSize.y, crownSize.z));
    float far_ = length(place - crownMiddle.xy) / size;
    vec2 inShadow = (place - crownMiddle.xy - vec2(-0.35, 0.45) * crownMiddle.z) / (crownSize.xy + 0.02 * size);
    float shadow = 0.45 * (1.0 - smoothstep(0.25, 1.15, length(inShadow)));
    float trunk = 0.35 * (1.0 - smoothstep(0.0, 0.25, length(place) / size));
    vec3 grass = vec3(0.50, 0.55, 0.40) * (1.0 - max(shadow, trunk));
    gl_FragColor = vec4(grass, 1.0 - smoothstep(1.2, 5.5, far_));
}
)";

} // namespace stromar
