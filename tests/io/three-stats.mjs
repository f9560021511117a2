// Reads a model file with a loader of three.js and prints what it found as JSON.
import { readFileSync } from 'fs';
import { dirname, extname, join } from 'path';
import { pathToFileURL } from 'url';

const from = name => pathToFileURL(join(process.cwd(), 'node_modules', 'three', name)).href;
globalThis.self = globalThis.window = globalThis;
globalThis.ProgressEvent ??= class extends Event {};
const asked = [];
// Pictures are there at once; what matters is which are asked for.
globalThis.document = {
  createElementNS: () => {
    const image = { listeners: {}, addEventListener: (kind, call) => { image.listeners[kind] = call; }, removeEventListener: () => {} };
    Object.defineProperty(image, 'src', { set: url => { asked.push(url); setTimeout(() => image.listeners.load.call(image), 0); } });
    return image;
  },
};
const THREE = await import(from('build/three.module.js'));
const file = process.argv[2];
const data = readFileSync(file);
const bytes = data.buffer.slice(data.byteOffset, data.byteOffset + data.byteLength);
const usd = async () => new (await import(from('examples/jsm/loaders/USDLoader.js'))).USDLoader().parse(extname(file) === '.usda' ? data.toString() : bytes, dirname(file) + '/');
const gltf = async () => {
  const { GLTFLoader } = await import(from('examples/jsm/loaders/GLTFLoader.js'));
  const { MeshoptDecoder } = await import(from('examples/jsm/libs/meshopt_decoder.module.js'));
  return (await new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).parseAsync(bytes, dirname(file) + '/')).scene;
};
// A buffer beside the file is taken into it: three.js would fetch it.
const gltfBeside = async () => {
  const { GLTFLoader } = await import(from('examples/jsm/loaders/GLTFLoader.js'));
  const json = JSON.parse(data.toString());
  for (const buffer of json.buffers) buffer.uri = 'data:application/octet-stream;base64,' + readFileSync(join(dirname(file), decodeURIComponent(buffer.uri))).toString('base64');
  return (await new GLTFLoader().parseAsync(JSON.stringify(json), dirname(file) + '/')).scene;
};
const readers = {
  '.glb': gltf,
  '.gltf': gltfBeside,
  '.fbx': async () => new (await import(from('examples/jsm/loaders/FBXLoader.js'))).FBXLoader().parse(bytes, dirname(file) + '/'),
  '.usda': usd,
  '.usdz': usd,
};
const root = await readers[extname(file)]();
root.updateMatrixWorld(true);
const looks = new Set();
const box = new THREE.Box3(); // of the vertices, not of the boxes of instances
const stats = { triangles: 0, opaque: 0, objects: [], attributes: [], materials: {}, groups: 0, scale: 0, colours: 0, uv2: 0, vertices: 0, instances: 0, looks: 0, colour: [0, 0, 0], normal: [0, 0, 0], uv: [0, 0], uv2Range: [Infinity, -Infinity] };
root.traverse(object => {
  stats.scale = Math.max(stats.scale, ...object.scale.toArray());
  if (!object.isMesh) return;
  const { index, attributes, groups } = object.geometry;
  stats.opaque += [object.material].flat().every(material => material.alphaTest === 0 && !material.alphaMap) ? 1 : 0;
  const places = [new THREE.Matrix4()];
  if (object.isInstancedMesh) for (let i = 0; i < object.count; ++i) object.getMatrixAt(i, places[i] = new THREE.Matrix4());
  stats.instances += object.isInstancedMesh ? object.count : 0;
  stats.triangles += places.length * (index ? index.count : attributes.position.count) / 3;
  stats.objects.push(object.name);
  stats.groups += groups.length;
  for (const name of Object.keys(attributes)) if (!stats.attributes.includes(name)) stats.attributes.push(name);
  const colours = object.instanceColor ?? attributes.color;
  stats.colours += colours ? 1 : 0;
  const coloured = object.isInstancedMesh ? attributes.position.count : 1; // vertices by each
  for (let c = 0; colours && c < colours.count; ++c) stats.colour = stats.colour.map((sum, i) => sum + coloured * colours.getComponent(c, i));
  const normal = new THREE.Vector3(), point = new THREE.Vector3(), turn = new THREE.Matrix3();
  for (const place of places) {
    turn.getNormalMatrix(place);
    for (let v = 0; v < attributes.position.count; ++v) {
      box.expandByPoint(point.fromBufferAttribute(attributes.position, v).applyMatrix4(place).applyMatrix4(object.matrixWorld));
      normal.fromBufferAttribute(attributes.normal, v).applyMatrix3(turn).normalize();
      stats.normal = stats.normal.map((sum, i) => sum + Math.abs(normal.getComponent(i)));
      stats.uv = stats.uv.map((sum, i) => sum + attributes.uv.getComponent(v, i));
    }
  }
  stats.vertices += places.length * attributes.position.count;
  stats.uv2 += attributes.uv1 ? 1 : 0;
  for (let v = 0; attributes.uv1 && v < attributes.uv1.count; ++v)
    for (let c = 0; c < 2; ++c) stats.uv2Range = [Math.min(stats.uv2Range[0], attributes.uv1.getComponent(v, c)), Math.max(stats.uv2Range[1], attributes.uv1.getComponent(v, c))];
  for (const material of [object.material].flat()) looks.add(material.uuid);
  for (const material of [object.material].flat()) stats.materials[material.name] = ['map', 'alphaMap', 'normalMap', 'roughnessMap'].filter(map => material[map]);
});
for (const mean of [stats.normal, stats.uv, stats.colour]) mean.forEach((sum, i) => { mean[i] = sum / stats.vertices; });
Object.assign(stats, { min: box.min.toArray(), max: box.max.toArray() });
stats.looks = looks.size;
stats.objects.sort();
stats.pictures = asked;
console.log(JSON.stringify(stats));
