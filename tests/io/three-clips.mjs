// Plays the clips of a glTF file with bones in three.js and prints, for each, where its vertices are at the start, in the middle and at the end.
import { readFileSync } from 'fs';
import { pathToFileURL } from 'url';
import { join } from 'path';

const from = name => pathToFileURL(join(process.cwd(), 'node_modules', 'three', name)).href;
globalThis.self = globalThis;
// Pictures are of no interest: they are there at once.
globalThis.document = {
  createElementNS: () => {
    const image = { listeners: {}, addEventListener: (kind, call) => { image.listeners[kind] = call; }, removeEventListener: () => {} };
    Object.defineProperty(image, 'src', { set: () => setTimeout(() => image.listeners.load.call(image), 0) });
    return image;
  },
};
const THREE = await import(from('build/three.module.js'));
const { GLTFLoader } = await import(from('examples/jsm/loaders/GLTFLoader.js'));
const data = readFileSync(process.argv[2]);
const file = data.buffer.slice(data.byteOffset, data.byteOffset + data.byteLength);
const gltf = await new GLTFLoader().parseAsync(file, '');

const meshes = [];
gltf.scene.traverse(object => { if (object.isSkinnedMesh) meshes.push(object); });
function points() {
  gltf.scene.updateMatrixWorld(true);
  const all = [];
  for (const mesh of meshes) {
    mesh.skeleton.update();
    const count = mesh.geometry.attributes.position.count, step = Math.max(1, Math.floor(count / 500));
    for (let i = 0; i < count; i += step) {
      const point = new THREE.Vector3().fromBufferAttribute(mesh.geometry.attributes.position, i);
      all.push(mesh.applyBoneTransform(i, point).applyMatrix4(mesh.matrixWorld));
    }
  }
  return all;
}
const farthest = (a, b) => Math.max(...a.map((p, i) => p.distanceTo(b[i])));
const still = points();
const clips = {};
for (const clip of gltf.animations) {
  const mixer = new THREE.AnimationMixer(gltf.scene);
  const action = mixer.clipAction(clip);
  action.setLoop(THREE.LoopOnce).clampWhenFinished = true;
  action.play();
  const at = [0, 0.5, 1].map(part => { mixer.setTime(part * clip.duration); return points(); });
  clips[clip.name] = {
    seconds: clip.duration, moves: farthest(at[0], at[1]), closes: farthest(at[0], at[2]), ends: farthest(at[2], still),
    height: Math.max(...at[0].map(p => p.y)), top: Math.max(...at[2].map(p => p.y)),
    unmoved: at[2].filter((p, i) => p.distanceTo(still[i]) < 1e-4).length,
  };
  mixer.stopAllAction();
}
console.log(JSON.stringify({ skinned: meshes.length, bones: meshes[0].skeleton.bones.length, height: Math.max(...still.map(p => p.y)), clips }));
