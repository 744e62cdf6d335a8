// Writes the scenes of the playground's tests. One has every kind of shape, plain and decorated, some far from the
// origin, some touching or parallel to the last bit, and some that turn. The other is a small OBJ file.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';

const folder = process.argv[2];

// A small generator with a fixed seed, so that every run has the same scene.
let state = 20261;
const random = () => (state = (state * 1103515245 + 12345) % 2147483648) / 2147483648;
const within = (low, high) => low + (high - low) * random();
const vector = (low, high) => [within(low, high), within(low, high), within(low, high)];

function rotation() {
  const q = [within(-1, 1), within(-1, 1), within(-1, 1), within(-1, 1)];
  const length = Math.hypot(...q);
  return q.map((x) => x / length);
}

const kinds = [
  () => ({ type: 'point' }),
  () => ({ type: 'segment', a: vector(-1, 1), b: vector(-1, 1) }),
  () => ({ type: 'triangle', a: vector(-1, 1), b: vector(-1, 1), c: vector(-1, 1) }),
  () => ({ type: 'sphere', radius: within(0.2, 1) }),
  () => ({ type: 'capsule', radius: within(0.2, 0.6), halfHeight: within(0.2, 1) }),
  () => ({ type: 'box', halfExtents: vector(0.2, 1) }),
  () => ({ type: 'cylinder', radius: within(0.2, 0.8), halfHeight: within(0.2, 1) }),
  () => ({ type: 'cone', radius: within(0.2, 0.8), halfHeight: within(0.2, 1) }),
  () => ({ type: 'ellipsoid', radii: vector(0.2, 1) }),
  () => ({ type: 'mesh', mesh: 'gem' }),
  () => ({ type: 'mesh', mesh: 'cloud' }),
];

const motion = (i) => ({
  velocity: i % 3 ? vector(-6, 6) : [0, 0, 0], angularVelocity: i % 7 === 2 ? vector(-1, 1) : [0, 0, 0],
});
const objects = kinds.flatMap((shape, k) => Array.from({ length: 4 }, (_, i) => ({
  name: `${shape().type} ${k}.${i}`,
  shape: {
    ...shape(),
    ...(i === 1 ? { rounding: within(0.05, 0.3) } : {}),
    ...(i === 2 ? { position: vector(-1, 1), rotation: rotation() } : {}),
  },
  position: vector(-2.2, 2.2),
  rotation: rotation(),
  ...(i === 3 ? { scale: [within(0.5, 2), -within(0.5, 2), within(0.5, 2)] } : {}),
  ...motion(4 * k + i),
})));

const unit = { type: 'box', halfExtents: [0.5, 0.5, 0.5] };
const far = [1e4, -2e4, 3e5];
for (const [name, shape, position] of [
  ['stacked low', unit, [0, -5, 0]], ['stacked high', unit, [0.25, -4, 0.25]],
  ['parallel', unit, [0, -2.9999998, 0]], ['ball on box', { type: 'sphere', radius: 0.5 }, [0, -2, 0]],
  ['flush', { type: 'triangle', a: [0, 0, 0], b: [1, 0, 0], c: [0, 0, 1] }, [0, -4.5, 0]],
  ['rod', { type: 'segment', a: [-1, 0, 0], b: [1, 0, 0] }, [0, -3.5, 0.5]],
  ['far box', unit, far], ['far touching', unit, [far[0] + 1, far[1], far[2]]],
  ['far cone', { type: 'cone', radius: 0.5, halfHeight: 0.5 }, [far[0] - 1.25, far[1], far[2]]],
  ['tiny', { type: 'box', halfExtents: [1e-9, 1e-9, 1e-9] }, [1, -4, 0]],
]) objects.push({ name, shape, position, velocity: [0.5, -1, 0] });

const gem = [[1, 0, 0.1], [-1, 0.1, 0], [0.1, 1, 0], [0, -1, 0.2], [0.3, 0.1, 1], [0, 0.2, -1], [0.7, 0.7, 0.5]];
const cloud = Array.from({ length: 120 }, () => {
  const v = vector(-1, 1);
  return v.map((x) => x / Math.hypot(...v));
});
const shapes = { version: 1, name: 'shapes', meshes: { gem, cloud }, objects };
writeFileSync(join(folder, 'shapes.json'), JSON.stringify(shapes));

const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1, (i >> 1) & 1, (i >> 2) & 1]);
const part = (name, dx) => [`o ${name}`, ...corners.map(([x, y, z]) => `v ${x + dx} ${y} ${z}`)];
const faces = (from) => ['1 3 4 2', '5 6 8 7', '1 2 6 5', '3 7 8 4', '1 5 7 3', '2 4 8 6']
  .map((face) => `f ${face.split(' ').map((i) => Number(i) + from).join(' ')}`);
writeFileSync(join(folder, 'parts.obj'),
  [...part('left part', -2), ...faces(0), ...part('right part', 0.5), ...faces(8), ''].join('\n'));
