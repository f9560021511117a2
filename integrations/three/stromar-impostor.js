// An impostor of Stromar in three.js: one quad that shows 8 × 8 views of a tree.
//
//   import { loadImpostor } from './stromar-impostor.js';
//   const tree = await loadImpostor('oak_impostor.json');
//   tree.material.uniforms.sunDirection.value.set(1, 2, 1).normalize(); // in the tree's own axes
//   lod.addLevel(tree, 80);
//
// Light is that of a DirectionalLight and a HemisphereLight of three.js on a Lambert material. Files with y up (glTF) only.
import * as THREE from 'three';
import { DDSLoader } from 'three/addons/loaders/DDSLoader.js';

// Positions and directions in the tree's axes (z up), lengths in radii, the origin in the middle of the tree.
const common = /* glsl */ `
vec3 toTree(vec3 v) { return vec3(v.x, -v.z, v.y); }
vec3 fromTree(vec3 v) { return vec3(v.x, v.z, -v.y); }

void basis(vec3 towards, out vec3 right, out vec3 up) {
    vec3 across = vec3(-towards.y, towards.x, 0.0);
    right = dot(across, across) < 1e-12 ? vec3(1.0, 0.0, 0.0) : normalize(across);
    up = cross(towards, right);
}`;

const vertexShader = /* glsl */ `
uniform vec3 centre;
uniform float radius;
varying vec3 vOrigin, vPlace;
flat varying vec3 vTowards;
${common}
void main() {
    mat4 toObject = inverse(modelViewMatrix);
    vec3 eye = toTree(toObject[3].xyz - centre) / radius;
    vTowards = isOrthographic ? normalize(toTree(toObject[2].xyz)) : normalize(eye);
    vec3 right, up;
    basis(vTowards, right, up);
    float distance = length(eye);
    float size = isOrthographic ? 1.0 : distance / sqrt(max(0.04, distance * distance - 1.0)); // all of the ball, seen in perspective
    vPlace = size * (position.x * right + position.y * up);
    vOrigin = isOrthographic ? vPlace + 4.0 * vTowards : eye;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(centre + radius * fromTree(vPlace), 1.0);
}`;

const fragmentShader = /* glsl */ `
uniform sampler2D albedo, normalDepth;
uniform float frames, framePixels, alphaCutoff;
uniform bool whole;
uniform vec3 sunDirection, sunColor, skyColor, groundColor;
varying vec3 vOrigin, vPlace;
flat varying vec3 vTowards;
${common}
vec2 signs(vec2 v) { return vec2(v.x < 0.0 ? -1.0 : 1.0, v.y < 0.0 ? -1.0 : 1.0); }

// Where a direction lies on the unfolded octahedron, -1 to 1, and back.
vec2 placeOf(vec3 d) {
    if (!whole) d.z = max(0.0, d.z);
    vec2 flat_ = d.xy / (abs(d.x) + abs(d.y) + abs(d.z));
    if (!whole) return vec2(flat_.x + flat_.y, flat_.x - flat_.y);
    return d.z < 0.0 ? (1.0 - abs(flat_.yx)) * signs(flat_) : flat_;
}
vec3 directionOf(vec2 frame) {
    vec2 place = frame * 2.0 / (frames - 1.0) - 1.0;
    vec2 flat_ = whole ? place : vec2(place.x + place.y, place.x - place.y) / 2.0;
    float z = 1.0 - abs(flat_.x) - abs(flat_.y);
    if (z < 0.0) flat_ = (1.0 - abs(flat_.yx)) * signs(flat_);
    return normalize(vec3(flat_, z));
}

// What one view shows where the ray meets the tree: its depth says how far before or behind the middle that is.
void addView(vec2 frame, float weight, vec3 ray, vec2 dx, vec2 dy, inout vec4 colour, inout vec3 normal) {
    vec3 towards = directionOf(frame), right, up;
    basis(towards, right, up);
    float slope = min(-0.05, dot(ray, towards)), depth = 0.0;
    vec2 inFrame, uv;
    for (int i = 0; i < 4; ++i) {
        vec3 place = vOrigin + ray * (depth - dot(vOrigin, towards)) / slope;
        inFrame = 0.5 + 0.5 * vec2(dot(place, right), -dot(place, up));
        uv = (frame + clamp(inFrame, 0.5 / framePixels, 1.0 - 0.5 / framePixels)) / frames;
        if (i < 3) depth = mix(depth, 2.0 * textureGrad(normalDepth, uv, dx, dy).a - 1.0, i > 0 ? 0.7 : 1.0);
    }
    if (clamp(inFrame, 0.0, 1.0) != inFrame) return;
    vec4 seen = textureGrad(albedo, uv, dx, dy);
    colour += weight * seen.a * vec4(seen.rgb, 1.0);
    normal += weight * seen.a * (2.0 * textureGrad(normalDepth, uv, dx, dy).rgb - 1.0);
}

void main() {
    vec2 place = (placeOf(vTowards) + 1.0) * (frames - 1.0) / 2.0;
    vec2 first = clamp(floor(place), 0.0, frames - 2.0), part = clamp(place - first, 0.0, 1.0);
    vec2 step = vec2(1.0), middle = first - (frames - 2.0) / 2.0;
    if (whole && middle.x * middle.y > 0.0) { // the cell's diagonal along the octahedron's edge
        first.x += 1.0;
        step.x = -1.0;
        part.x = 1.0 - part.x;
    }
    vec2 between = step * (part.x > part.y ? vec2(1.0, 0.0) : vec2(0.0, 1.0));
    float most = max(part.x, part.y), least = min(part.x, part.y);

    vec3 right, up;
    basis(vTowards, right, up);
    vec2 flat_ = vec2(dot(vPlace, right), dot(vPlace, up)) / (2.0 * frames), dx = dFdx(flat_), dy = dFdy(flat_);
    vec3 ray = normalize(vPlace - vOrigin), normal = vec3(0.0);
    vec4 colour = vec4(0.0);
    addView(first, 1.0 - most, ray, dx, dy, colour, normal);
    addView(first + between, most - least, ray, dx, dy, colour, normal);
    addView(first + step, least, ray, dx, dy, colour, normal);
    if (colour.a < alphaCutoff) discard;

    normal /= colour.a;
    float same = clamp(length(normal), 0.001, 1.0); // how much leaves look one way; those that look everywhere catch a quarter of the sun
    vec3 light = sunColor * mix(0.25, max(0.0, dot(normal, sunDirection)) / same, same) + mix(groundColor, skyColor, 0.5 + 0.5 * normal.y);
    gl_FragColor = vec4(colour.rgb / colour.a * light / 3.14159265, 1.0);
    #include <tonemapping_fragment>
    #include <colorspace_fragment>
}`;

/** A mesh that stands where the tree stands. `url` is that of NAME_impostor.json; its pictures lie beside it. */
export async function loadImpostor(url) {
    const beside = name => new URL(name, new URL(url, globalThis.location?.href)).href;
    const json = await (await fetch(url)).json();
    if (json.up !== 'y') throw new Error(`${url}: y has to be up, as in glTF`);
    const [albedo, normalDepth] = await Promise.all([
        new DDSLoader().loadAsync(beside(json.albedo_with_mips)),
        new THREE.TextureLoader().loadAsync(beside(json.normal_depth)),
    ]);
    albedo.colorSpace = THREE.SRGBColorSpace;
    normalDepth.flipY = false; // rows from the top, as in the other
    const material = new THREE.ShaderMaterial({
        vertexShader, fragmentShader,
        uniforms: {
            albedo: { value: albedo }, normalDepth: { value: normalDepth },
            centre: { value: new THREE.Vector3(...json.centre) }, radius: { value: json.radius },
            frames: { value: json.frames }, framePixels: { value: json.frame_pixels }, alphaCutoff: { value: json.alpha_cutoff },
            whole: { value: json.layout === 'octahedral' },
            sunDirection: { value: new THREE.Vector3(1, 2, 1).normalize() }, sunColor: { value: new THREE.Color(3, 3, 3) },
            skyColor: { value: new THREE.Color(1, 1, 1) }, groundColor: { value: new THREE.Color(0.4, 0.4, 0.3) },
        },
    });
    const mesh = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material);
    mesh.geometry.boundingSphere = new THREE.Sphere(material.uniforms.centre.value, json.radius); // the quad turns
    return mesh;
}
