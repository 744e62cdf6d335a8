// Writes the scenes that the built-in ones do not cover. One moves and has every kind of shape, one has
// objects that meet, miss, overlap and turn over a frame, one has shapes deep in
// each other, and one has many objects.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';

const folder = process.argv[2];

const moving = {
  version: 1,
  name: 'moving',
  frames: 9,
  objects: [
    { name: 'still box', shape: { type: 'box', halfExtents: [1, 1, 1] } },
    { name: 'coming sphere', shape: { type: 'sphere', radius: 0.5 }, position: [5.5, 0, 0], velocity: [-0.5, 0, 0] },
    {
      name: 'turning capsule',
      shape: { type: 'capsule', radius: 0.4, halfHeight: 1 },
      position: [0, 4, 0],
      angularVelocity: [0, 0, 0.2],
    },
    { name: 'cylinder', shape: { type: 'cylinder', radius: 0.5, halfHeight: 0.8 }, position: [-4, 0, 0] },
    { name: 'cone', shape: { type: 'cone', radius: 0.7, halfHeight: 0.8 }, position: [-4, 3, 0] },
    { name: 'ellipsoid', shape: { type: 'ellipsoid', radii: [0.9, 0.4, 0.5] }, position: [4, 3, 0] },
    { name: 'point', shape: { type: 'point' }, position: [-4, -3, 0] },
    { name: 'segment', shape: { type: 'segment', a: [-0.5, 0, 0], b: [0.5, 0.5, 0] }, position: [0, -3, 0] },
    {
      name: 'triangle',
      shape: { type: 'triangle', a: [0, 0, 0], b: [1.5, 0, 0], c: [0, 1.5, 0] },
      position: [4, -3, 0],
    },
  ],
};
writeFileSync(join(folder, 'moving.json'), JSON.stringify(moving));

const sweep = {
  version: 1,
  name: 'sweep',
  objects: [
    { name: 'crate', shape: { type: 'box', halfExtents: [1, 1, 1] } },
    { name: 'ball', shape: { type: 'sphere', radius: 0.5 }, position: [-5.5, 0, 0], velocity: [8, 0, 0] },
    { name: 'passer', shape: { type: 'box', halfExtents: [0.5, 0.5, 0.5] }, position: [-4, 3, 0], velocity: [8, 0, 0] },
    { name: 'inside', shape: { type: 'sphere', radius: 0.5 }, position: [0, -1.2, 0], velocity: [0, -1, 0] },
    {
      name: 'turner',
      shape: { type: 'box', halfExtents: [0.5, 0.5, 0.5] },
      position: [4, -3, 0],
      velocity: [-1, 0, 0],
      angularVelocity: [0, 0, 1],
    },
  ],
};
writeFileSync(join(folder, 'sweep.json'), JSON.stringify(sweep));

const empty = { version: 1, name: 'empty', objects: [] };
writeFileSync(join(folder, 'empty.json'), JSON.stringify(empty));

const ball = { type: 'sphere', radius: 0.5 };
const two = { version: 1, name: 'two', objects: [{ shape: ball }, { shape: ball, position: [2, 0, 0] }] };
writeFileSync(join(folder, 'two.json'), JSON.stringify(two));

const huge = {
  version: 1,
  name: 'huge',
  objects: [
    { name: 'box', shape: { type: 'box', halfExtents: [1e25, 1e25, 1e25] } },
    { name: 'ball', shape: { type: 'sphere', radius: 1e24 }, position: [4e25, 1e25, 0] },
  ],
};
writeFileSync(join(folder, 'huge.json'), JSON.stringify(huge));

const gem = [
  [1, 0, 0.1],
  [-1, 0.1, 0],
  [0.1, 1, 0],
  [0, -1, 0.2],
  [0.3, 0.1, 1],
  [0, 0.2, -1],
  [0.7, 0.7, 0.5],
];
const deep = {
  version: 1,
  name: 'deep',
  meshes: { gem },
  objects: [
    { name: 'gem', shape: { type: 'mesh', mesh: 'gem' } },
    {
      name: 'capsule',
      shape: { type: 'capsule', radius: 0.4, halfHeight: 0.7 },
      position: [0.5, 0.3, 0.2],
      rotation: [0.6, 0, 0, 0.8],
    },
    { name: 'sphere', shape: { type: 'sphere', radius: 0.8 }, position: [1.1, 0.7, 0.3] },
  ],
};
writeFileSync(join(folder, 'deep.json'), JSON.stringify(deep));

// A small generator with a fixed seed, so that every run has the same scene.
let state = 12345;
const random = () => (state = (state * 1103515245 + 12345) % 2147483648) / 2147483648;
const place = () => [random() * 24, random() * 24, random() * 24];
const shapes = [
  { type: 'sphere', radius: 0.5 },
  { type: 'box', halfExtents: [0.4, 0.5, 0.3] },
  { type: 'capsule', radius: 0.3, halfHeight: 0.4 },
];
const objects = Array.from({ length: 2000 }, (_, i) => ({ shape: shapes[i % shapes.length], position: place() }));
const many = { version: 1, name: 'many', objects };
writeFileSync(join(folder, 'many.json'), JSON.stringify(many));
