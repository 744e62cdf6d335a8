// Gjk.Core in a page or in Node.js: shapes, queries of two of them, and scenes.
import { dotnet } from './runtime/dotnet.js';
import { Engine } from './runtime/engine.js';

const STILL = [0, 0, 0];

function numbers(name, count, values) {
  const list = Array.from(values ?? []);
  if (list.length === count && list.every(Number.isFinite)) return list;
  throw new TypeError(`${name} must be ${count} finite numbers, but is ${values}`);
}

function number(name, value) {
  if (Number.isFinite(value)) return value;
  throw new TypeError(`${name} must be a finite number, but is ${value}`);
}

const motion = ({ rotation = [0, 0, 0, 1], position = STILL } = {}, velocity = STILL) => [
  ...numbers('rotation', 4, rotation), ...numbers('position', 3, position), ...numbers('velocity', 3, velocity),
  ...STILL,
];

function idOf(name, shape) {
  if (shape?.id !== undefined) return shape.id;
  throw new TypeError(`${name} must be a shape, such as box([1, 1, 1]), but is ${shape}`);
}

let loading;

/** Starts the runtime, once. */
export function load() {
  loading ??= start().then((engine) => new Gjk(engine));
  return loading;
}

async function start() {
  const assembly = __ASSEMBLIES__.map((name) => ({ virtualPath: name, name }));
  return Engine.over(dotnet, {
    assembly,
    jsModuleNative: [{ name: 'dotnet.native.js' }],
    jsModuleRuntime: [{ name: 'dotnet.runtime.js' }],
    wasmNative: [{ name: 'dotnet.native.wasm' }],
  });
}

class Gjk {
  #engine;

  constructor(engine) {
    this.#engine = engine;
  }

  #shape = (words) => Object.freeze({ words, id: this.#engine.shape(words) });

  #standing = (type, radius, halfHeight) =>
    this.#shape(`${type} ${number('radius', radius)} ${number('halfHeight', halfHeight)} 0`);

  point = () => this.#shape('point 0');
  sphere = (radius) => this.#shape(`point ${number('radius', radius)}`);

  capsule(radius, halfHeight) {
    const half = number('halfHeight', halfHeight);
    return this.#shape(`segment 0 ${half} 0 0 ${-half} 0 ${number('radius', radius)}`);
  }

  box = (halfExtents) => this.#shape(`box ${numbers('halfExtents', 3, halfExtents).join(' ')}`);
  cylinder = (radius, halfHeight) => this.#standing('cylinder', radius, halfHeight);
  cone = (radius, halfHeight) => this.#standing('cone', radius, halfHeight);
  ellipsoid = (radii) => this.#shape(`ellipsoid ${numbers('radii', 3, radii).join(' ')}`);

  mesh(points) {
    const corners = points.flatMap((point, i) => numbers(`points[${i}]`, 3, point)).map(Math.fround);
    return this.#shape(`mesh ${points.length} ${corners.join(' ')}`);
  }

  #ask(question, a, motionA, b, motionB) {
    if (this.#engine.bodies !== 2) this.#engine.reserve(2, 1);
    this.#engine.set(0, idOf('a', a), motionA);
    this.#engine.set(1, idOf('b', b), motionB);
    return this.#engine.ask(question, [[0, 1]])[0];
  }

  distance = (a, poseA, b, poseB) => this.#ask('distance', a, motion(poseA), b, motion(poseB));

  depth = (a, poseA, b, poseB) => this.#ask('signed', a, motion(poseA), b, motion(poseB));

  cast = (a, poseA, velocityA, b, poseB, velocityB) =>
    this.#ask('impact', a, motion(poseA, velocityA), b, motion(poseB, velocityB));

  contacts(a, poseA, b, poseB, maxGap = 0) {
    this.depth(a, poseA, b, poseB);
    const { normal, points } = this.#engine.contacts(0, 1, maxGap);
    return { normal: [...normal], points: points.map(({ point, gap }) => ({ point: [...point], gap })) };
  }

  scene = () => new Scene(this.#engine);
}

class Scene {
  #engine;
  #bodies = [];

  constructor(engine) {
    this.#engine = engine;
  }

  add(shape, pose) {
    return this.#bodies.push([idOf('shape', shape), motion(pose)]) - 1;
  }

  setPose(body, pose) {
    this.#bodies[body][1] = motion(pose);
  }

  pairsWithin(distance) {
    this.#engine.reserve(this.#bodies.length, 1);
    this.#bodies.forEach(([shape, at], i) => this.#engine.set(i, shape, at));
    return this.#engine.pairsWithin(this.#bodies.length, distance);
  }
}
