import { bytes, floats, ints } from './data.js';

/** Numbers in an entry: the fraction, the point, the normal. */
const ENTRY = 7;

/**
 * How the objects of a moving scene go over one frame, and when its pairs first touch. At rest there is nothing of it.
 */
export class CastData {
  constructor(json) {
    this.isMoving = json.velocities !== undefined;
    if (!this.isMoving) return;
    this.velocities = floats(json.velocities);
    this.turns = bytes(json.turns);
    this.entries = floats(json.casts);
    this.places = new Map();
    ints(json.castIndices).forEach((index, entry) => this.places.set(index, entry));
  }

  velocity(object) {
    return this.isMoving ? Array.from(this.velocities.subarray(3 * object, 3 * object + 3)) : [0, 0, 0];
  }

  /** Whether two objects move past each other. What turns is not cast. */
  applies(a, b) {
    if (!this.isMoving || this.turns[a] || this.turns[b]) return false;
    const other = this.velocity(b);
    return this.velocity(a).some((v, axis) => v !== other[axis]);
  }

  /** When, where and how a pair first touches, by its place among all answers; null if it does not. */
  entry(index) {
    const place = this.isMoving ? this.places.get(index) : undefined;
    if (place === undefined) return null;
    const [fraction, x, y, z, nx, ny, nz] = this.entries.subarray(ENTRY * place, ENTRY * place + ENTRY);
    return { fraction, isKnown: !Number.isNaN(x), point: [x, y, z], normal: [nx, ny, nz] };
  }
}
