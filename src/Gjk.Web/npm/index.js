// Gjk.Core in a page or in Node.js: shapes, queries of two of them, and scenes.
import { dotnet } from './runtime/dotnet.js';
import { Engine } from './runtime/engine.js';

const STILL = [0, 0, 0];

const motion = ({ rotation = [0, 0, 0, 1], position = STILL } = {}, velocity = STILL) =>
  [...rotation, ...position, ...velocity, ...STILL];

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

  point = () => this.#shape('point 0');
  sphere = (radius) => this.#shape(`point ${radius}`);
  capsule = (radius, halfHeight) => this.#shape(`segment 0 ${halfHeight} 0 0 ${-halfHeight} 0 ${radius}`);
  box = (halfExtents) => this.#shape(`box ${halfExtents.join(' ')}`);
  cylinder = (radius, halfHeight) => this.#shape(`cylinder ${radius} ${halfHeight} 0`);
  cone = (radius, halfHeight) => this.#shape(`cone ${radius} ${halfHeight} 0`);
  ellipsoid = (radii) => this.#shape(`ellipsoid ${radii.join(' ')}`);
  mesh = (points) => this.#shape(`mesh ${points.length} ${points.flat().map(Math.fround).join(' ')}`);

  #ask(question, a, motionA, b, motionB) {
    this.#engine.reserve(2, 1);
    this.#engine.set(0, a.id, motionA);
    this.#engine.set(1, b.id, motionB);
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
    return this.#bodies.push([shape.id, motion(pose)]) - 1;
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
