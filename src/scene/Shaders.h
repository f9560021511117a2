#pragma once

namespace stromar {

// GLSL 1.20: OpenGL 2.1 and later. All in the world's axes; colours are linear until they are shown.

/// In front of the fragments' shaders: the best looks, or lesser ones where the processor draws.
inline constexpr const char* kBestLooks = "#version 120\n#define BEST 1\n";
inline constexpr const char* kFastLooks = "#version 120\n#define BEST 0\n";

/// What both tree and ground need to know of the light.
inline constexpr const char* kLightFunctions = R"(
uniform vec3 sun, sunlight, zenith, haze, bounce;
uniform float exposure; // times the light
uniform sampler2DShadow shadows;
uniform float shadowTexel; // 0: there are none
uniform vec3 pass; // of several whose mean is shown: shift of the pixel, of the noise
vec3 linear(vec3 c) { return c * (c * (c * 0.305306011 + 0.682171111) + 0.012522878); }
vec3 shown(vec3 c) {
    c = max(mix(vec3(dot(c, vec3(0.25, 0.65, 0.1))), c, 0.86) * (0.82 * exposure), 0.0);
    c = (c * (2.51 * c + 0.03)) / (c * (2.43 * c + 0.59) + 0.14);
    vec3 a = sqrt(clamp(c, 0.0, 1.0)), b = sqrt(a); // sRGB's curve
    return 0.585122381 * a + 0.783140355 * b - 0.368262736 * sqrt(b);
}
float noiseOfPixel() { return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))) + pass.z); }
// The part of the sun that is seen, over a disc of so many texels.
float sunSeen(vec3 place, float radius) {
    if (shadowTexel == 0.0 || place.z > 1.0) return 1.0;
#if BEST
    float turn = 6.2831853 * noiseOfPixel(), seen = 0.0;
    for (int i = 0; i < 8; ++i) {
        float out_ = sqrt((float(i) + 0.5) / 8.0) * radius * shadowTexel, a = turn + 2.3999632 * float(i);
        seen += shadow2D(shadows, vec3(place.xy + out_ * vec2(cos(a), sin(a)), place.z)).r;
    }
    return seen / 8.0;
#else
    return shadow2D(shadows, vec3(place.xy + 1.6 * radius * shadowTexel * pass.xy, place.z)).r;
#endif
}
vec3 skyIn(vec3 ray) {
    vec3 sky = mix(haze, zenith, 0.3 * smoothstep(0.0, 0.08, abs(ray.z)) + 0.7 * smoothstep(0.0, 0.38, abs(ray.z)));
    float glow = max(dot(ray, sun), 0.0);
    glow *= glow;
    glow *= glow;
    glow *= glow; // the eighth power
    float disc = glow * glow * glow;
    disc *= disc;
    disc *= disc;
    return sky + sunlight * (0.10 * glow + 0.25 * disc * disc);
}
)";

/// How pictures with gaps are drawn, as `coverOf` does: one of a few pixels covers a part of each.
inline constexpr const char* kCutOutFunctions = R"(
uniform float alphaCut;
uniform vec2 softening;
float softnessOfPixel() {
    vec2 footprint = max(abs(dFdx(gl_TexCoord[0].st)), abs(dFdy(gl_TexCoord[0].st)));
    return clamp(log2(max(footprint.x, footprint.y) / softening.x) / log2(softening.y / softening.x), 0.0, 1.0);
}
float cutOf(float soft) { return mix(alphaCut, 0.5, soft); }
)";

/// In front of the vertices' shaders: a vertex of wood, or of one of many blades that stand in their places, where the wind has it.
inline constexpr const char* kPlaceFunctions = R"(#version 120
uniform float instanced;
uniform vec3 roundingCentre;
uniform vec2 rounding; // how far normals look out of the crown; cosine to the blade's own, at least
attribute vec4 instancePlace, instanceTurn; // foot and length; quaternion
attribute float instanceWidth;
uniform float growth; // of blades that stand for more than themselves
uniform float swaying; // 0: the air is still
uniform vec2 swayTime; // seconds; after how many all repeats, 0: never
uniform vec2 swaySize; // of the table's pictures: nodes in a line, lines
uniform sampler2D swayRows, swayStill; // two texels a node: point and strength, quaternion; one: its point in still air
attribute vec4 swayPlace; // node, part of the way to the next; of an instance also phase and frequency
vec3 turned(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

vec4 swayTurn;
vec3 swayFrom, swayTo;
float swayAngle; // of the blade about its stalk
vec2 texelOf(float node) { // the middle of a texel of swayStill
    float line = floor((node + 0.5) / swaySize.x);
    return (vec2(node - line * swaySize.x, line) + 0.5) / swaySize;
}
float rhythm(float hertz) {
    return swayTime.y > 0.0 ? max(1.0, floor(hertz * swayTime.y + 0.5)) / swayTime.y : hertz;
}
void findSway() {
    swayTurn = vec4(0.0, 0.0, 0.0, 1.0);
    swayFrom = swayTo = vec3(0.0);
    swayAngle = 0.0;
    if (swaying < 0.5) return;
    vec2 low = texelOf(swayPlace.x), high = texelOf(swayPlace.x + 1.0), half_ = vec2(0.25 / swaySize.x, 0.0);
    vec4 point = mix(texture2DLod(swayRows, low - half_, 0.0), texture2DLod(swayRows, high - half_, 0.0), swayPlace.y);
    vec4 a = texture2DLod(swayRows, low + half_, 0.0), b = texture2DLod(swayRows, high + half_, 0.0);
    swayTurn = normalize(mix(a, dot(a, b) < 0.0 ? -b : b, swayPlace.y));
    swayFrom = mix(texture2DLod(swayStill, low, 0.0).xyz, texture2DLod(swayStill, high, 0.0).xyz, swayPlace.y);
    swayTo = point.xyz;
    if (instanced < 0.5) return;
    float slow = rhythm(swayPlace.w), fast = rhythm(1.618 * swayPlace.w);
    float wave = 0.6 * sin(6.2831853 * fract(slow * swayTime.x) + swayPlace.z) +
                 0.4 * sin(6.2831853 * fract(fast * swayTime.x) + 2.4 * swayPlace.z);
    float blade = clamp(4.0 * instanceWidth / max(instancePlace.w, 1e-9), 0.1, 1.0);
    swayAngle = min(1.04719755, 0.43633231 * point.w) * blade * wave;
}
vec3 flutter(vec3 v) {
    float c = cos(swayAngle), s = sin(swayAngle);
    return vec3(c * v.x + s * v.z, v.y, c * v.z - s * v.x);
}
vec3 stillPlace() {
    if (instanced < 0.5) return gl_Vertex.xyz;
    return instancePlace.xyz + turned(instanceTurn, flutter(gl_Vertex.xyz * growth * vec3(instanceWidth, instancePlace.w, instanceWidth)));
}
vec3 swayedPlace(vec3 place) { return swaying < 0.5 ? place : swayTo + turned(swayTurn, place - swayFrom); }
vec3 placeOfVertex() {
    findSway();
    return swayedPlace(stillPlace());
}
vec3 rounded(vec3 n, vec3 place) {
    vec3 away = place - roundingCentre;
    float apart = length(away);
    if (rounding.x <= 0.0 || apart < 1e-9) return n;
    vec3 sum = (1.0 - rounding.x) * n + rounding.x / apart * away;
    float size = length(sum), front = dot(sum, n);
    if (size > 1e-9 && front >= rounding.y * size) return sum / size;
    vec3 across = sum - front * n;
    float side = length(across);
    return side < 1e-9 ? n : rounding.y * n + sqrt(1.0 - rounding.y * rounding.y) / side * across;
}
vec3 stillNormal(vec3 place) {
    if (instanced < 0.5) return gl_Normal;
    vec3 size = vec3(instanceWidth, instancePlace.w, instanceWidth);
    return rounded(turned(instanceTurn, flutter(normalize(gl_Normal / size))), place);
}

uniform float trunkRadius; // metres, 0: not of wood
uniform float halvings; // of its radius over the range of thinness
uniform float thinnestWood; // a radius, metres at a distance of one
attribute vec2 look; // part of the sky that is seen, thinness of the wood
// Wood too thin to be seen as a line becomes one; the part of that which it covers.
float widen(vec3 front) {
    float own = trunkRadius * exp2(-halvings * look.y), least = thinnestWood * gl_Position.w;
    if (trunkRadius <= 0.0 || own >= least) return 1.0;
    gl_Position += gl_ModelViewProjectionMatrix * vec4((least - own) * front, 0.0);
    return own / least;
}
)";

inline constexpr const char* kTreeVertexShader = R"(
uniform vec3 crownMiddle, crownSize, sun, standsAt; // the crown in the tree's own place
uniform mat4 shadowMatrix;
uniform float shadowOffset; // metres
uniform vec2 neighbourFrom, neighbourRate; // of the barks of thicker and of thinner wood
varying vec3 place, normal, inShadow;
varying float skyVisibility, shade, ground, woodCover;
varying vec2 neighbours; // shares
void main() {
    swayAngle = 0.0;
    vec3 own = stillPlace(), front = stillNormal(own);
    findSway();
    if (swayAngle != 0.0) {
        own = stillPlace();
        front = stillNormal(own);
    }
    vec3 there = swayedPlace(own);
    place = there + standsAt;
    ground = swaying < 0.5 ? -1e9 : min(own.z, 0.0) - 1e-3;
    normal = swaying < 0.5 ? front : turned(swayTurn, front);
    gl_Position = gl_ModelViewProjectionMatrix * vec4(there, 1.0);
    woodCover = widen(normal);
    gl_TexCoord[0] = gl_MultiTexCoord0;
    inShadow = (shadowMatrix * vec4(place + shadowOffset * (sun + normal * sign(dot(normal, sun))), 1.0)).xyz;
    // Inside the crown less of the sky is seen.
    vec3 out_ = (own - crownMiddle) / crownSize;
    skyVisibility = (0.35 + 0.65 * smoothstep(0.05, 1.0, length(out_) * 0.8 + 0.25 * out_.z)) * look.x;
    neighbours = clamp((look.y - neighbourFrom) * neighbourRate, 0.0, 1.0);
    // What all corners of a leaf share gives it a number of its own.
    vec3 facing = instanced < 0.5 ? gl_Normal : turned(instanceTurn, vec3(0.0, 0.0, 1.0));
    shade = fract(sin(dot(facing, vec3(127.1, 311.7, 74.7))) * 437.5);
}
)";

/// CCardLight lights the cards of twigs as it does.
inline constexpr const char* kTreeFragmentShader = R"(
uniform mat4 osg_ViewMatrixInverse;
uniform sampler2D picture, relief, gloss, under; // albedo; normals; roughness and what goes through; albedo from below
uniform float leaf, colourVariation, sunAndShade, tinted, generation, reliefDepth, underSide;
uniform float edgeSamples; // of a pixel, which edges cover in part; 0: all or nothing
uniform sampler2D olderPicture, olderRelief, olderGloss, youngerPicture, youngerRelief, youngerGloss;
uniform vec2 neighbourRate;
uniform int view; // 0 lit, 1 material, 2 occlusion, 3 normals
varying vec3 place, normal, inShadow;
varying float skyVisibility, shade, ground, woodCover;
varying vec2 neighbours; // shares
// Pictures with gaps are multiplied by their opacity.
vec3 ofCutOut(vec4 colour) { return min(colour.rgb / max(colour.a, 0.004), 1.0); }
vec3 withRelief(vec3 n, vec3 bump) {
    vec3 along = dFdx(place), up = dFdy(place);
    vec2 du = dFdx(gl_TexCoord[0].st), dv = dFdy(gl_TexCoord[0].st);
    vec3 across = cross(up, n), ahead = cross(n, along);
    vec3 t = across * du.x + ahead * dv.x, b = across * du.y + ahead * dv.y;
    return normalize(mat3(t * inversesqrt(max(dot(t, t), 1e-30)), b * inversesqrt(max(dot(b, b), 1e-30)), n) * bump);
}
void main() {
    vec4 colour = texture2D(picture, gl_TexCoord[0].st);
    if (leaf > 0.5) colour.rgb = ofCutOut(colour);
    float cover = woodCover;
    if (leaf > 0.5) {
        // What lies behind one another in a pixel covers other parts of it.
        float soft = softnessOfPixel(), cut = cutOf(soft), chance = fract(noiseOfPixel() + 7.31 * shade) - 0.5;
        if (edgeSamples > 0.5) {
            cover = clamp((colour.a - cut) / max(max(fwidth(colour.a), soft), 1e-4) + 0.5, 0.0, 1.0);
            cover = mix(cover, cover > chance + 0.5 ? 1.0 : 0.0, soft); // as much in the mean
            cover = floor(cover * edgeSamples + fract(17.3 * chance + 0.5)) / edgeSamples;
            if (cover <= 0.0) discard;
        } else if (colour.a < cut + soft * chance) discard;
        // Leaves let one see the stems that are in hand.
        if (tinted > -0.5 && mod(floor(gl_FragCoord.x) + floor(gl_FragCoord.y), 2.0) > 0.5) discard;
    }
    vec3 eye = osg_ViewMatrixInverse[3].xyz, toEye = normalize(eye - place);
    if (place.z < ground && eye.z > 0.0) discard; // what a fallen tree presses into the ground
    vec3 n = normalize(normal);
    bool back = leaf > 0.5 && dot(n, toEye) < 0.0;
    if (back) n = -n;
    vec3 bump = vec3(0.0, 0.0, 1.0);
    if (reliefDepth > 0.0) bump = texture2D(relief, gl_TexCoord[0].st).xyz * 2.0 - 1.0;
    vec2 shares = vec2(0.0);
    // Another bark shows first in the furrows.
    if (neighbourRate != vec2(0.0)) shares = smoothstep(0.25, 0.75, neighbours + 0.4 * (0.5 - dot(colour.rgb, vec3(0.333))));
    if (neighbourRate.x != 0.0) {
        colour = mix(colour, texture2D(olderPicture, gl_TexCoord[0].st), shares.x);
        bump = mix(bump, texture2D(olderRelief, gl_TexCoord[0].st).xyz * 2.0 - 1.0, shares.x);
    }
    if (neighbourRate.y != 0.0) {
        colour = mix(colour, texture2D(youngerPicture, gl_TexCoord[0].st), shares.y);
        bump = mix(bump, texture2D(youngerRelief, gl_TexCoord[0].st).xyz * 2.0 - 1.0, shares.y);
    }
    if (bump.z < 1.0) n = withRelief(n, bump);
#if BEST
    bool fromBelow = back && underSide > 0.5;
    if (fromBelow) colour.rgb = ofCutOut(texture2D(under, gl_TexCoord[0].st));
#else
    bool fromBelow = false;
#endif
    vec3 albedo = linear(colour.rgb);
    float hue = fract(17.3 * shade);
    vec3 own = vec3(0.97, 0.99, 0.9) +
               colourVariation * ((shade - 0.5) * vec3(1.0, 0.76, 0.8) + (hue - 0.5) * vec3(0.45, 0.0, -0.3));
    float lit = clamp((skyVisibility - 0.35) / 0.65, 0.0, 1.0);
    own *= mix(vec3(1.0), mix(vec3(0.68, 0.8, 0.76), vec3(1.06, 1.03, 0.96), lit), sunAndShade);
    albedo *= mix(vec3(1.0), own, leaf);
    if (back && !fromBelow) albedo = mix(albedo, vec3(dot(albedo, vec3(0.3, 0.6, 0.1))), 0.25) * 1.15;
#if BEST
    vec2 skin = texture2D(gloss, gl_TexCoord[0].st).rg;
    if (neighbourRate.x != 0.0) skin = mix(skin, texture2D(olderGloss, gl_TexCoord[0].st).rg, shares.x);
    if (neighbourRate.y != 0.0) skin = mix(skin, texture2D(youngerGloss, gl_TexCoord[0].st).rg, shares.y);
#else
    vec2 skin = vec2(0.8, 0.6);
#endif
    float rough = clamp(back ? skin.x + 0.2 : skin.x, 0.15, 1.0), through = leaf * skin.y;

    float facing = dot(n, sun);
    float seen = sunSeen(inShadow, leaf > 0.5 ? 2.5 : 2.0);
    vec3 direct = sunlight * seen;
    vec3 above = mix(haze, zenith, 0.35) * 1.05;
    vec3 around = mix(bounce, above, 0.5 + 0.5 * n.z) * skyVisibility;
    vec3 light = albedo * (around + direct * max(facing, 0.0));
    // Light that went through a blade is warmer and greener than what it throws back.
    vec3 passed = albedo * vec3(1.3, 1.25, 0.6);
    light += through * passed * (direct * max(-facing, 0.0) + 0.35 * mix(above, bounce, 0.5 + 0.5 * n.z) * skyVisibility);
#if BEST
    vec3 half_ = normalize(sun + toEye);
    float sharp = 2.0 / (rough * rough * rough * rough) - 2.0 + 1e-3;
    float mirror = 0.04 + 0.96 * pow(1.0 - max(dot(toEye, half_), 0.0), 5.0);
    light += direct * max(facing, 0.0) * mirror * (sharp + 8.0) / 25.0 * pow(max(dot(n, half_), 0.0), sharp);
    float rim = 0.04 + 0.5 * pow(1.0 - max(dot(n, toEye), 0.0), 5.0);
    light += rim * (1.0 - rough) * skyVisibility * skyIn(reflect(-toEye, n)) * step(0.0, reflect(-toEye, n).z);
#endif

    vec3 result = shown(light);
    if (view == 1) result = colour.rgb;
    if (view == 2) result = vec3(skyVisibility);
    if (view == 3) result = n * 0.5 + 0.5;
    if (abs(tinted - generation) < 0.5)
        result = mix(result, vec3(1.0, 0.55, 0.12) * (0.45 + 0.6 * dot(result, vec3(0.35, 0.5, 0.15))), 0.6);
    gl_FragColor = vec4(result, cover);
}
)";

inline constexpr const char* kPlainVertexShader = R"(
void main() { gl_Position = gl_ModelViewProjectionMatrix * vec4(placeOfVertex(), 1.0); }
)";

// Depth alone, cut out by the pictures.
inline constexpr const char* kShadowVertexShader = R"(
varying float woodCover;
void main() {
    gl_Position = gl_ModelViewProjectionMatrix * vec4(placeOfVertex(), 1.0);
    woodCover = widen(swaying < 0.5 ? gl_Normal : turned(swayTurn, gl_Normal));
    gl_TexCoord[0] = gl_MultiTexCoord0;
}
)";
inline constexpr const char* kShadowFragmentShader = R"(
uniform sampler2D picture;
uniform float leaf;
varying float woodCover;
void main() {
    if (woodCover < 0.3) discard; // too thin for a line of shadow
    if (leaf > 0.5) {
        float soft = softnessOfPixel(), chance = fract(dot(gl_FragCoord.xyz, vec3(0.7548777, 0.5698403, 4096.0))) - 0.5;
        if (texture2D(picture, gl_TexCoord[0].st).a < cutOf(soft) + soft * chance) discard;
    }
    gl_FragColor = vec4(1.0);
}
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

inline constexpr const char* kReferenceVertexShader = R"(#version 120
uniform mat4 osg_ViewMatrix;
uniform vec2 size;
varying vec2 at;
void main() {
    vec3 up = (osg_ViewMatrix * vec4(0.0, 0.0, 1.0, 0.0)).xyz;
    vec3 aside = normalize(cross(up, vec3(0.0, 0.0, 1.0)) + vec3(1e-4, 0.0, 0.0));
    vec4 foot = gl_ModelViewMatrix * vec4(0.0, 0.0, 0.0, 1.0);
    gl_Position = gl_ProjectionMatrix * vec4(foot.xyz + aside * size.x * gl_Vertex.x + up * size.y * gl_Vertex.y, 1.0);
    gl_Position.z = 0.0; // neither too near nor too far
    at = vec2(0.5 + gl_Vertex.x, gl_Vertex.y);
}
)";

inline constexpr const char* kReferenceFragmentShader = R"(#version 120
uniform sampler2D picture;
varying vec2 at;
void main() { gl_FragColor = vec4(texture2D(picture, at).rgb, 1.0); }
)";

inline constexpr const char* kPlainFragmentShader = R"(#version 120
uniform vec4 colour;
void main() { gl_FragColor = colour; }
)";

inline constexpr const char* kBackgroundVertexShader = R"(#version 120
varying vec4 near_, far_;
varying vec3 window; // place, and its width over its height
void main() {
    gl_Position = vec4(gl_Vertex.xy, 0.999, 1.0);
    window = vec3(gl_Vertex.xy, gl_ProjectionMatrix[1][1] / gl_ProjectionMatrix[0][0]);
    near_ = gl_ModelViewProjectionMatrixInverse * vec4(gl_Vertex.xy, -1.0, 1.0);
    far_ = gl_ModelViewProjectionMatrixInverse * vec4(gl_Vertex.xy, 1.0, 1.0);
}
)";

/// What is known of the ground below the tree.
inline constexpr const char* kGroundFunctions = R"(
uniform vec3 crownMiddle, crownSize;
float size() { return max(crownSize.x, max(crownSize.y, crownSize.z)); }
// Less of the sky is seen below the crown and at the trunk.
float skyVisibility(vec2 place) {
    vec2 below = (place - crownMiddle.xy) / (crownSize.xy + 0.02 * size());
    float crown = 0.35 * (1.0 - smoothstep(0.0, 1.3, length(below)));
    return 1.0 - max(crown, 0.5 * (1.0 - smoothstep(0.0, 0.12, length(place) / size())));
}
)";

// Blades of grass: where a tuft stands in the unit circle and its shade, and a corner's way from there.
inline constexpr const char* kGrassVertexShader = R"(#version 120
uniform mat4 osg_ViewMatrixInverse;
uniform vec2 grassSize;
uniform mat4 shadowMatrix;
varying vec3 place, inShadow;
varying float up, shade;
void main() {
    vec3 offset = gl_MultiTexCoord0.xyz * grassSize.y;
    place = vec3(gl_Vertex.xy * grassSize.x, 0.0) + offset;
    // Nothing of it is seen through the ground.
    gl_Position = osg_ViewMatrixInverse[3].z < 0.0 ? vec4(2.0, 2.0, 2.0, 1.0) : gl_ModelViewProjectionMatrix * vec4(place, 1.0);
    inShadow = (shadowMatrix * vec4(place + vec3(0.0, 0.0, 0.02), 1.0)).xyz;
    up = offset.z > 0.0 ? 1.0 : 0.0;
    shade = gl_Vertex.z;
}
)";
inline constexpr const char* kGrassFragmentShader = R"(
uniform mat4 osg_ViewMatrixInverse;
uniform vec2 grassSize;
varying vec3 place, inShadow;
varying float up, shade;
void main() {
    // From afar they are the meadow.
    float near = clamp(40.0 * grassSize.y / length(osg_ViewMatrixInverse[3].xyz - place), 0.2, 1.0);
    vec3 tip = mix(vec3(0.11, 0.17, 0.035), vec3(0.2, 0.2, 0.07), shade * shade);
    vec3 albedo = mix(vec3(0.09, 0.112, 0.044), mix(vec3(0.045, 0.07, 0.02), tip, up), near);
    vec3 light = mix(haze, zenith, 0.35) * skyVisibility(place.xy) + sunlight * max(sun.z, 0.0) * sunSeen(inShadow, 4.0);
    gl_FragColor = vec4(shown(albedo * light), 1.0);
}
)";

// The ground is the plane z = 0, seen along each ray, with the tree's shadow and a grid of metres.
inline constexpr const char* kBackgroundFragmentShader = R"(
uniform mat4 osg_ViewMatrixInverse, shadowMatrix;
uniform sampler2D backdropPicture;
uniform float backdropAspect, backdropScale; // width over height, 0: all around
varying vec3 window;
uniform int backdrop;
uniform float grid;
varying vec4 near_, far_;
float random(vec2 p) {
    vec3 q = fract(p.xyx * 0.1031);
    q += dot(q, q.yzx + 33.33);
    return fract((q.x + q.y) * q.z);
}
float noise(vec2 p) {
    vec2 i = floor(p), f = fract(p);
    f *= f * (3.0 - 2.0 * f);
    return mix(mix(random(i), random(i + vec2(1.0, 0.0)), f.x),
               mix(random(i + vec2(0.0, 1.0)), random(i + 1.0), f.x), f.y);
}
float lines(vec2 place, float cell) {
    vec2 at = place / cell, width = fwidth(at);
    vec2 off = abs(fract(at - 0.5) - 0.5) / max(width, vec2(1e-6));
    return (1.0 - min(min(off.x, off.y), 1.0)) * (1.0 - smoothstep(0.1, 0.5, max(width.x, width.y)));
}
vec3 meadow(vec2 place, float away) {
    float near = exp(-0.6 * away);
#if BEST
    float patches = noise(place * 0.35) * 0.6 + noise(place * 1.3 + 7.0) * 0.4;
    float blades = mix(0.5, 0.65 * noise(place * 9.0) + 0.35 * noise(place * 37.0), near);
#else
    float patches = noise(place * 0.7), blades = mix(0.5, noise(place * 11.0), near);
#endif
    return mix(vec3(0.055, 0.085, 0.028), vec3(0.125, 0.14, 0.06), 0.55 * patches + 0.45 * blades);
}
// A picture as large as fills the window, or a panorama.
vec3 pictured(vec3 ray) {
    if (backdropAspect == 0.0) {
        vec2 turn = vec2(atan(ray.x, ray.y) / 6.2831853 + 0.5, asin(clamp(ray.z, -1.0, 1.0)) / 3.1415927 + 0.5);
        return shown(backdropScale * texture2D(backdropPicture, turn).rgb);
    }
    vec2 part = backdropAspect > window.z ? vec2(window.z / backdropAspect, 1.0) : vec2(1.0, backdropAspect / window.z);
    return texture2D(backdropPicture, 0.5 + 0.5 * window.xy * part).rgb;
}
void main() {
    vec3 start = near_.xyz / near_.w;
    vec3 ray = normalize(far_.xyz / far_.w - start);
    bool down = ray.z < -1e-5 && osg_ViewMatrixInverse[3].z > 0.0;
    vec2 place = start.xy - ray.xy * start.z / (down ? ray.z : -1.0);
    float line = grid * max(0.35 * lines(place, 1.0), 0.7 * lines(place, 10.0));
    float away = max(length(place - crownMiddle.xy) / size() - 1.0, 0.0);
    vec3 at = (shadowMatrix * vec4(place, 0.0, 1.0)).xyz;
    bool inMap = all(greaterThan(at.xy, vec2(0.0))) && all(lessThan(at.xy, vec2(1.0)));
    float seen = inMap ? sunSeen(at, 6.0) : 1.0, open = skyVisibility(place);
    vec3 colour;
    if (backdrop == 0) {
        vec3 light = mix(haze, zenith, 0.35) * open + sunlight * max(sun.z, 0.0) * seen;
        vec3 ground = mix(meadow(place, away) * light, vec3(0.03, 0.04, 0.02), line);
        colour = shown(down ? mix(haze, ground, exp(-0.025 * away)) : skyIn(ray));
    } else {
        vec3 plain = backdrop == 1 ? vec3(0.88) : vec3(0.17, 0.18, 0.19);
        vec3 ink = backdrop == 1 ? vec3(0.35) : vec3(0.55);
        vec3 ground = mix(plain * open * mix(0.72, 1.0, seen), ink, line);
        colour = down ? mix(plain, ground, exp(-0.09 * away)) : plain;
    }
    if (backdrop == 4) colour = mix(pictured(ray), vec3(0.04), line) * (down ? mix(0.45, 1.0, seen) * mix(0.6, 1.0, open) : 1.0);
    gl_FragColor = backdrop == 3 ? vec4(0.0) : vec4(colour, 1.0);
}
)";

} // namespace stromar
