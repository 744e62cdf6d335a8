// The library itself: .NET's runtime for browsers with Gjk.Core, which the page carries. Bodies and answers are
// exchanged in the runtime's own memory.

/** Numbers of a body's motion: rotation (x y z w), position, velocity, angular velocity. */
export const MOTION = 13;

/** Numbers of an answer: status, distance or fraction, lower bound, two points, normal, iterations. */
const ANSWER = 13;

export const QUESTIONS = { distance: 0, signed: 1, impact: 2 };

export const AT_REST = [0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0];

/** In the order of the library's GjkStatus and CastStatus. */
const STATUS = [
  'None', 'Separated', 'Overlapping', 'BeyondMaxDistance', 'IterationLimit', 'InvalidInput', 'InvalidShape',
];
const CAST_STATUS = ['None', 'Hit', 'Miss', 'OverlappingAtStart', 'IterationLimit', 'InvalidInput', 'InvalidShape'];

/**
 * The runtime compiles traces of hot code. In 10.0.14 some of them are wrong: after some 5,000 queries a quaternion
 * was made of its first number three times. So all code stays interpreted, at some 50 microseconds for a query.
 */
const OPTIONS = ['--no-jiterpreter-traces-enabled'];

/** A record whose first body has a shape: what the library reads shapes from. */
export const recordOf = (words) => `gjk1 ${words} @ 0 0 0 1 0 0 0 point 0 @ 0 0 0 1 0 0 0`;

/** The words of the first body's shape in a record. */
export const wordsOf = (record) => record.slice('gjk1 '.length, record.indexOf(' @'));

export class Engine {
  /** Starts the runtime. It takes about half a second. */
  static async start() {
    const { loader, native, runtime } = globalThis.gjkRuntime;
    const files = Object.entries(JSON.parse(document.getElementById('runtime').textContent));
    const unpack = async ([name, text]) => [name, await unpacked(text)];
    const bytes = Object.fromEntries(await Promise.all(files.map(unpack)));
    const assembly = files.filter(([name]) => name.endsWith('.dll'))
      .map(([name]) => ({ virtualPath: name, name, resolvedUrl: `x:${name}`, buffer: bytes[name] }));
    const wasm = 'dotnet.native.wasm';
    const response = new Response(bytes[wasm], { headers: { 'Content-Type': 'application/wasm' } });
    return Engine.over(loader.dotnet, {
      assembly,
      jsModuleNative: [{ name: 'dotnet.native.js', resolvedUrl: 'x', moduleExports: native }],
      jsModuleRuntime: [{ name: 'dotnet.runtime.js', resolvedUrl: 'x', moduleExports: runtime }],
      wasmNative: [{
        name: wasm, resolvedUrl: 'x', pendingDownload: { name: wasm, url: 'x', response: Promise.resolve(response) },
      }],
    });
  }

  /** Starts the runtime of a loader, with what its files are. */
  static async over(dotnet, resources) {
    const api = await dotnet.withRuntimeOptions(OPTIONS).withConfig({
      mainAssemblyName: 'Gjk.Web', globalizationMode: 'invariant', resources,
    }).create();
    const exports = await api.getAssemblyExports('Gjk.Web.dll');
    return new Engine(api, exports.Gjk.Web.Exports);
  }

  constructor(api, calls) {
    this.api = api;
    this.calls = calls;
    this.shapes = new Map();
    this.reserve(2, 1);
  }

  /** Makes room for bodies and for pairs to ask about. The ones before are gone. */
  reserve(bodies, pairs) {
    this.bodies = bodies;
    this.addresses = this.calls.Reserve(bodies, pairs).map((address) => address / 4);
  }

  /**
   * The index of a shape, given as words of a record.
   * @throws {Error} They describe no shape.
   */
  shape(words) {
    let shape = this.shapes.get(words);
    if (shape === undefined) this.shapes.set(words, shape = this.calls.AddShape(recordOf(words)));
    return shape;
  }

  /** Sets a body: its shape's index, and where it is and how it moves. */
  set(body, shape, motion) {
    this.api.localHeapViewI32()[this.addresses[0] + body] = shape;
    this.api.localHeapViewF32().set(motion, this.addresses[1] + MOTION * body);
  }

  /** Answers pairs of bodies. */
  ask(question, pairs) {
    const [, , pairsAt, answersAt] = this.addresses;
    this.api.localHeapViewI32().set(pairs.flat(), pairsAt);
    this.calls.Answer(QUESTIONS[question], pairs.length);
    const heap = this.api.localHeapViewF32();
    return pairs.map((_, i) => answer(question, heap.slice(answersAt + ANSWER * i, answersAt + ANSWER * (i + 1))));
  }

  /** The pairs of the first bodies that are this near each other. */
  pairsWithin(bodies, distance) {
    const numbers = this.calls.PairsWithin(bodies, distance), pairs = [];
    for (let i = 0; i < numbers.length; i += 2 + ANSWER) {
      const [a, b] = numbers.slice(i, i + 2);
      pairs.push({ a, b, ...answer('distance', Float32Array.from(numbers.slice(i + 2, i + 2 + ANSWER))) });
    }
    return pairs;
  }

  record(a, b) {
    return this.calls.Record(a, b);
  }

  /** A record in its usual form. Throws where the text is none. */
  checked(record) {
    return this.calls.Checked(record);
  }

  /** The normal and the contact points of a pair, each with its gap. */
  contacts(a, b, maxGap) {
    const numbers = this.calls.Contacts(a, b, maxGap), points = [];
    for (let i = 3; i < numbers.length; i += 4) points.push({ point: numbers.slice(i, i + 3), gap: numbers[i + 3] });
    return { normal: numbers.slice(0, 3), points };
  }

  /** The steps of a distance query. */
  explain(a, b) {
    return steps(this.calls.Explain(a, b));
  }

  /** A shape's surface in its own frame, in the form that geometry.js draws. */
  surface(shape) {
    return this.mesh(this.calls.ShapeSurface(shape));
  }

  /** The surface of A - B, turned with A, as if both were in the same place. */
  difference(a, b, isCoarse) {
    return this.mesh(this.calls.DifferenceSurface(a, b, isCoarse));
  }

  mesh([dimension, smooth, count, ...indices]) {
    return {
      dimension, smooth: smooth === 1, vertices: this.calls.SurfaceVertices(),
      triangles: Int32Array.from(indices.slice(0, count)), edges: Int32Array.from(indices.slice(count)),
    };
  }
}

function answer(question, n) {
  const [pointA, pointB, normal] = [3, 6, 9].map((at) => Array.from(n.subarray(at, at + 3)));
  const iterations = n[12];
  if (question === 'impact') return { status: CAST_STATUS[n[0]], fraction: n[1], point: pointA, normal, iterations };
  return { status: STATUS[n[0]], distance: n[1], lowerBound: n[2], pointA, pointB, normal, iterations };
}

/** The numbers of a trace as steps: each is a support and, unless it ended the query, the reduced simplex. */
function steps(numbers) {
  const result = [];
  let at = 0;
  const take = (count) => numbers.slice(at, (at += count));
  while (at < numbers.length) {
    const [kind] = take(1);
    if (kind === 1) {
      const [normal, onA, onB] = [take(3), take(3), take(3)], [idA, idB, lower, extended] = take(4);
      const w = onA.map((x, axis) => x - onB[axis]);
      result.push({ normal, onA, onB, w, idA, idB, lower, extended: extended === 1 });
    } else {
      const [count] = take(1);
      const vertices = Array.from({ length: count }, () => ({ w: take(3), weight: take(1)[0] }));
      Object.assign(result.at(-1), { vertices, nearest: take(3), upper: take(1)[0] });
    }
  }
  return result;
}

async function unpacked(text) {
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) bytes[i] = raw.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream).arrayBuffer();
}
