import { Quaternion, Vector3 } from 'three';
import { CastData } from './cast-data.js';
import { ContactData } from './contact-data.js';
import { bytes, exact, floats, ints, number, point, shape, shorts } from './data.js';

/** The statuses in the order of the library's GjkStatus. */
const STATUS = ['Separated', 'Overlapping', 'BeyondMaxDistance', 'IterationLimit', 'InvalidInput', 'InvalidShape'];

const OVERLAPPING = STATUS.indexOf('Overlapping'),
  ITERATION_LIMIT = STATUS.indexOf('IterationLimit');

const POSE = 7;

/** The distance from the middle of a scene to its end as it is drawn, in units. */
const DRAWN_RADIUS = 10;

/**
 * The demo's results, by frame. World coordinates are doubles. Drawn coordinates are centred and scaled, so that any
 * scene fits into a float.
 */
export class SceneModel {
  constructor(json) {
    this.name = json.name;
    this.frames = json.frames;
    this.objects = json.objects;
    this.pairs = json.pairs;
    this.allPairs = json.allPairs;
    this.names = json.names.map((name, i) => name ?? `#${i}`);
    this.shapes = json.shapes.map(shape);
    this.shapeOf = ints(json.shapeOf);
    this.a = ints(json.a);
    this.b = ints(json.b);
    this.poses = floats(json.poses);
    this.status = bytes(json.status);
    this.iterations = shorts(json.iterations);
    this.distances = floats(json.distance);
    this.pointsA = floats(json.pointA);
    this.pointsB = floats(json.pointB);
    this.normals = floats(json.normal);
    this.parts = json.partA === undefined ? null : [ints(json.partA), ints(json.partB)];
    this.overlapping = ints(json.overlapping);
    this.contactData = new ContactData(json, this.overlapping);
    this.castData = new CastData(json);
    this.frame = 0;
    this.measure();
  }

  /** The middle and the unit of the first frame. */
  measure() {
    const low = [Infinity, Infinity, Infinity],
      high = [-Infinity, -Infinity, -Infinity];
    this.radii = this.shapes.map((s) => {
      let most = 0;
      for (let i = 0; i < s.vertices.length; i += 3)
        most = Math.max(most, Math.hypot(s.vertices[i], s.vertices[i + 1], s.vertices[i + 2]));
      return most;
    });
    for (let i = 0; i < this.objects; i++) {
      const r = this.radii[this.shapeOf[i]];
      for (let axis = 0; axis < 3; axis++) {
        const x = this.poses[POSE * i + 4 + axis];
        low[axis] = Math.min(low[axis], x - r);
        high[axis] = Math.max(high[axis], x + r);
      }
    }
    [this.low, this.high] = this.objects
      ? [low, high]
      : [
          [0, 0, 0],
          [0, 0, 0],
        ];
    this.center = this.objects ? low.map((x, axis) => (x + high[axis]) / 2) : [0, 0, 0];
    const size = this.objects ? Math.hypot(...low.map((x, axis) => (high[axis] - x) / 2)) : 0;
    this.unit = size > 0 ? DRAWN_RADIUS / size : 1;
  }

  drawn(x, y, z) {
    return new Vector3(
      (x - this.center[0]) * this.unit,
      (y - this.center[1]) * this.unit,
      (z - this.center[2]) * this.unit,
    );
  }

  position(object) {
    const at = POSE * (this.frame * this.objects + object) + 4;
    return this.drawn(this.poses[at], this.poses[at + 1], this.poses[at + 2]);
  }

  /** The radius of an object as it is drawn. */
  radius(object) {
    return this.radii[this.shapeOf[object]] * this.unit;
  }

  rotation(object) {
    const at = POSE * (this.frame * this.objects + object);
    return new Quaternion(this.poses[at], this.poses[at + 1], this.poses[at + 2], this.poses[at + 3]).normalize();
  }

  index(pair) {
    return this.frame * this.pairs + pair;
  }

  distance(pair) {
    return this.distances[this.index(pair)];
  }

  /** Whether a pair intersects. With the iteration limit it is at least as deep as its distance says. */
  overlaps(pair) {
    const status = this.status[this.index(pair)];
    return status === OVERLAPPING || (status === ITERATION_LIMIT && this.distance(pair) <= 0);
  }

  /** Whether a pair has one depth: two convex shapes have, and a point inside a solid. */
  hasDepth(pair) {
    const isConvex = [this.a[pair], this.b[pair]].every((object) => !this.shapes[this.shapeOf[object]].partStarts);
    return isConvex || this.distance(pair) < 0;
  }

  /** The triangles or parts that a pair's answer is about: [object, part] each. Convex shapes have none. */
  partsOf(pair) {
    const objects = [this.a[pair], this.b[pair]];
    const both = objects.map((object, side) => [object, this.parts?.[side][this.index(pair)] ?? -1]);
    return both.filter(([, part]) => part >= 0);
  }

  /** How an intersecting pair intersects, for a reader. */
  overlapText(pair) {
    return this.hasDepth(pair) ? `depth ${this.depth(pair)}` : 'intersecting';
  }

  /** The depth of an intersecting pair, for a reader. */
  depth(pair) {
    const limited = this.status[this.index(pair)] === ITERATION_LIMIT;
    return `${limited ? '≥ ' : ''}${number(-this.distance(pair))}`;
  }

  statusName(pair) {
    return STATUS[this.status[this.index(pair)]];
  }

  normal(pair) {
    const at = 3 * this.index(pair);
    return Array.from(this.normals.subarray(at, at + 3));
  }

  /** The closest points as they are drawn, A's and then B's. Null if there are none. */
  line(pair) {
    return this.distance(pair) > 0 ? this.points(pair) : null;
  }

  /**
   * The way out of an intersecting pair as it is drawn, from B's deepest point to A's: by so much B leaves A. Null for
   * a pair that is apart or only touches, and where only bounds of the depth are known.
   */
  wayOut(pair) {
    const isKnown = this.status[this.index(pair)] === OVERLAPPING && this.distance(pair) < 0;
    return isKnown ? this.points(pair)?.reverse() : null;
  }

  /** The points of a pair for a reader, [on A, on B]; null if there are none. */
  pointTexts(pair) {
    const at = 3 * this.index(pair);
    const both = [this.pointsA, this.pointsB].map((points) => Array.from(points.subarray(at, at + 3)));
    return both.flat().every(Number.isFinite) ? both.map(point) : null;
  }

  /** A pair's answer to copy, in numbers that read back as the same floats. */
  copyText(pair) {
    const at = 3 * this.index(pair);
    const line = (name, points) => `${name} ${Array.from(points.subarray(at, at + 3), exact).join(', ')}`;
    return [
      `${this.names[this.a[pair]]} – ${this.names[this.b[pair]]}`,
      `distance ${exact(this.distance(pair))}`,
      line('point on A', this.pointsA),
      line('point on B', this.pointsB),
      line('normal', this.normals),
    ].join('\n');
  }

  points(pair) {
    const at = 3 * this.index(pair);
    const d = this.distance(pair);
    if (!Number.isFinite(d)) return null;
    const [x, y, z] = this.pointsA.subarray(at, at + 3),
      [nx, ny, nz] = this.normals.subarray(at, at + 3);
    return [this.drawn(x, y, z), this.drawn(x + nx * d, y + ny * d, z + nz * d)];
  }

  /** The contact points of an intersecting pair: each one's gap, and its ends on A and on B as they are drawn. */
  contacts(pair) {
    const [nx, ny, nz] = this.normal(pair);
    return this.contactData.of(pair).map(([x, y, z, gap]) => {
      return { gap, ends: [this.drawn(x, y, z), this.drawn(x + nx * gap, y + ny * gap, z + nz * gap)] };
    });
  }

  /** When a pair first touches over the frame that follows; null if it does not. */
  impact(pair) {
    return this.castData.entry(this.index(pair));
  }

  /** The impact for a reader: a fraction of the frame, or why there is none; empty where nothing moves or one turns. */
  impactText(pair, text = number) {
    if (!this.castData.applies(this.a[pair], this.b[pair])) return '';
    if (this.overlaps(pair)) return 'at start';
    const impact = this.impact(pair);
    return impact ? `${impact.isKnown ? '' : '≥ '}${text(impact.fraction)}` : 'miss';
  }

  /** How far an object goes over a part of the frame, as it is drawn. */
  moved(object, fraction) {
    return new Vector3(...this.castData.velocity(object)).multiplyScalar(fraction * this.unit);
  }

  /** The pair in which each object is the first time in another's way, or -1. */
  firstImpacts() {
    const first = new Int32Array(this.objects).fill(-1);
    for (let pair = 0; pair < this.pairs && this.castData.isMoving; pair++) {
      const impact = this.impact(pair);
      if (!impact?.isKnown) continue;
      for (const object of [this.a[pair], this.b[pair]]) {
        if (first[object] < 0 || impact.fraction < this.impact(first[object]).fraction) first[object] = pair;
      }
    }
    return first;
  }

  /** Goes to a frame. Finds the objects that overlap another, and the pair of each object with its nearest partner. */
  show(frame) {
    this.frame = frame;
    this.hit = new Uint8Array(this.objects);
    this.nearest = new Int32Array(this.objects).fill(-1);
    this.contactData.begin(frame, this.pairs);
    for (let pair = 0; pair < this.pairs; pair++) {
      const a = this.a[pair],
        b = this.b[pair];
      if (this.overlaps(pair)) {
        this.hit[a] = this.hit[b] = 1;
        this.contactData.next(pair);
        continue;
      }
      const d = this.distance(pair);
      if (!Number.isFinite(d)) continue;
      for (const object of [a, b]) {
        if (this.nearest[object] < 0 || d < this.distance(this.nearest[object])) this.nearest[object] = pair;
      }
    }
  }

  /** The pairs in which an object intersects another. */
  hitsOf(object) {
    const result = [];
    for (let pair = 0; pair < this.pairs; pair++) {
      if (this.overlaps(pair) && (this.a[pair] === object || this.b[pair] === object)) result.push(pair);
    }
    return result;
  }

  partner(pair, object) {
    return this.a[pair] === object ? this.b[pair] : this.a[pair];
  }
}
