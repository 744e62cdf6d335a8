// Gjk.Core in a page or in Node.js: shapes, queries of two of them, and scenes.
import { dotnet } from './runtime/dotnet.js';
import { Engine } from './runtime/engine.js';

const STILL = [0, 0, 0];

/** How far from 1 the length of a quaternion may be, as in the library. */
const MOST_OFF_UNIT = 0.001;

// The library counts in floats, whose range is smaller than that of JavaScript's numbers.
const isFloat = (value) => Number.isFinite(value) && Number.isFinite(Math.fround(value));

function numbers(name, count, values) {
  const list = Array.from(values ?? []);
  if (list.length === count && list.every(isFloat)) return list.map(Math.fround);
  throw new TypeError(`${name} must be ${count} finite numbers, but is ${values}`);
}

function number(name, value) {
  if (isFloat(value)) return Math.fround(value);
  throw new TypeError(`${name} must be a finite number, but is ${value}`);
}

function notNegative(name, value) {
  for (const one of [value].flat()) if (one < 0) throw new RangeError(`${name} must not be negative, but is ${value}`);
  return value;
}

const vector = (name, values) => numbers(name, 3, values).join(' ');
const size = (name, value) => notNegative(name, number(name, value));
const sizes = (name, values) => notNegative(name, numbers(name, 3, values)).join(' ');

function unit(name, quaternion) {
  const list = numbers(name, 4, quaternion);
  if (Math.abs(Math.hypot(...list) - 1) <= MOST_OFF_UNIT) return list;
  throw new RangeError(`${name} must have length 1, but is ${quaternion}`);
}

const motion = ({ rotation = [0, 0, 0, 1], position = STILL } = {}, velocity = STILL) => [
  ...unit('rotation', rotation), ...numbers('position', 3, position), ...numbers('velocity', 3, velocity),
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

  #shape(words) {
    try {
      return Object.freeze({ words, id: this.#engine.shape(words) });
    } catch (error) {
      // The words are made here: the caller knows the argument that the message names, not the place of a word.
      throw new RangeError(error.message.replace(/^Before word \d+: /, ''));
    }
  }

  #standing = (type, radius, halfHeight) =>
    this.#shape(`${type} ${size('radius', radius)} ${size('halfHeight', halfHeight)} 0`);

  point = () => this.#shape('point 0');
  sphere = (radius) => this.#shape(`point ${size('radius', radius)}`);

  capsule(radius, halfHeight) {
    const half = size('halfHeight', halfHeight);
    return this.#shape(`segment 0 ${half} 0 0 ${-half} 0 ${size('radius', radius)}`);
  }

  segment = (a, b) => this.#shape(`segment ${vector('a', a)} ${vector('b', b)} 0`);
  triangle = (a, b, c) => this.#shape(`triangle ${vector('a', a)} ${vector('b', b)} ${vector('c', c)}`);

  taperedCapsule(topRadius, bottomRadius, halfHeight) {
    const radii = `${size('topRadius', topRadius)} ${size('bottomRadius', bottomRadius)}`;
    return this.#shape(`taperedcapsule ${radii} ${size('halfHeight', halfHeight)}`);
  }

  halfSpace(normal, offset) {
    const outward = numbers('normal', 3, normal);
    if (outward.every((x) => x === 0)) throw new RangeError(`normal must not be zero, but is ${normal}`);
    return this.#shape(`halfspace ${outward.join(' ')} ${number('offset', offset)} 0 0 0 0 0`);
  }

  rounded(shape, radius) {
    idOf('shape', shape);
    return this.#shape(`${shape.words} + ${size('radius', radius)}`);
  }

  box = (halfExtents) => this.#shape(`box ${sizes('halfExtents', halfExtents)}`);
  cylinder = (radius, halfHeight) => this.#standing('cylinder', radius, halfHeight);
  cone = (radius, halfHeight) => this.#standing('cone', radius, halfHeight);
  ellipsoid = (radii) => this.#shape(`ellipsoid ${sizes('radii', radii)}`);

  mesh(points) {
    if (!Array.isArray(points) || points.length === 0)
      throw new TypeError(`points must be an array of at least one point, but is ${points}`);
    const corners = points.flatMap((point, i) => numbers(`points[${i}]`, 3, point));
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
    const { normal, points } = this.#engine.contacts(0, 1, number('maxGap', maxGap));
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
    if (!this.#bodies[body]) throw new RangeError(`body must be a number that add returned, but is ${body}`);
    this.#bodies[body][1] = motion(pose);
  }

  pairsWithin(distance) {
    if (!(distance >= 0)) throw new RangeError(`distance must be at least 0, but is ${distance}`);
    this.#engine.reserve(this.#bodies.length, 1);
    this.#bodies.forEach(([shape, at], i) => this.#engine.set(i, shape, at));
    return this.#engine.pairsWithin(this.#bodies.length, distance);
  }
}
