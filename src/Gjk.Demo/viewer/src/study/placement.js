// Puts two shapes so that the library's own signed distance is a wanted gap: the same steps, with the same numbers, as
// Study/Plan/Placement.cs. A stands where both touch when B is at the origin; B moves along a line. Positions near the
// origin have the finest floats, so the gap is usually met to the last bit, and otherwise by the nearest position.

/** Halvings; the search ends earlier, where no float is left between two. */
const MOST_HALVINGS = 200;

const f = Math.fround;

export class Placement {
  /**
   * @param {Engine} engine The library.
   * @param {{a: number, b: number, rotationA: number[], rotationB: number[]}} pair Indices of shapes, and rotations.
   * @param {number[]} line The unit axis along which B moves.
   */
  constructor(engine, pair, line) {
    Object.assign(this, { engine, pair, line, contact: 0 });
    let high = 1;
    while (this.distance(high) <= 0 && high < 1e6) high *= 2;
    const low = this.inside(high);
    this.contact = this.search(0, low, high);
    this.low = f(low - this.contact);
    this.high = f(high - this.contact);
  }

  /** Tells the library where both bodies are when B is at a position on the line. */
  tell(position, shapeB = this.pair.b) {
    const at = (along) => this.line.map((axis) => f(f(along) * axis));
    const rest = [0, 0, 0, 0, 0, 0];
    this.poses = [
      [...this.pair.rotationA, ...at(-this.contact), ...rest], [...this.pair.rotationB, ...at(position), ...rest],
    ];
    this.engine.set(0, this.pair.a, this.poses[0]);
    this.engine.set(1, shapeB, this.poses[1]);
  }

  /** The library's answer for B at a position. */
  distance(position, shapeB = this.pair.b) {
    this.tell(position, shapeB);
    return this.engine.ask('signed', [[0, 1]])[0].distance;
  }

  /** The position at which the library answers the gap, or comes nearest to it. */
  position(gap) {
    if (this.distance(this.low) > gap) throw new Error(`the overlap ${-gap} is deeper than the two shapes can overlap`);
    let high = Math.max(this.high, 1);
    while (this.distance(high) < gap) high *= 2;
    return this.search(f(gap), this.low, high);
  }

  record(position, shapeB = this.pair.b) {
    this.tell(position, shapeB);
    return this.engine.record(0, 1);
  }

  /** The deepest of some positions at which both overlap. */
  inside(high) {
    let best = 0, least = this.distance(0);
    for (let i = -8; i < 8; i++) {
      const at = f((high * i) / 8), distance = this.distance(at);
      if (distance < least) [best, least] = [at, distance];
    }
    if (!(least < 0)) throw new Error('the shapes do not meet on the line');
    return best;
  }

  search(gap, low, high) {
    for (let i = 0; i < MOST_HALVINGS; i++) {
      const middle = f((low + high) / 2);
      if (middle === low || middle === high) break;
      const distance = this.distance(middle);
      if (distance === gap) return middle;
      if (distance < gap) low = middle;
      else high = middle;
    }
    return Math.abs(this.distance(low) - gap) <= Math.abs(this.distance(high) - gap) ? low : high;
  }
}
