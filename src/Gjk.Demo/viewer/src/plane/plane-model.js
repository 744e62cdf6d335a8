import { AT_REST } from '../engine.js';
import { hull, minus, plus, turned } from './geometry.js';
import { PRESETS } from './presets.js';

/**
 * Two convex polygons of the plane z = 0, the answer of the library, and the steps of its search. The library solves
 * them as flat shapes in space.
 */
export class PlaneModel {
  constructor(engine) {
    this.engine = engine;
    this.load('triangles');
  }

  /** Begins with a figure. */
  load(preset) {
    const { a, b } = PRESETS[preset];
    this.preset = preset;
    this.bodies = [a, b].map(({ corners, at }) => ({
      corners: corners.map((corner) => corner.map(Math.fround)), at: at.map(Math.fround), angle: 0,
    }));
    for (const body of this.bodies) body.shape = this.engine.shape(wordsOf(body.corners));
    this.ask();
    this.stage = this.stages.length - 1;
  }

  move(index, by) {
    const body = this.bodies[index];
    body.at = plus(body.at, by).map(Math.fround);
  }

  turn(index, angle) {
    this.bodies[index].angle += angle;
  }

  /** Asks the library. The walk stays at its step, and at its end where it was there. */
  ask() {
    const { engine } = this, wasAtEnd = this.stage === undefined || this.stage >= this.stages.length - 1;
    this.bodies.forEach((body, i) => engine.set(i, body.shape, motionOf(body)));
    this.answer = engine.ask('distance', [[0, 1]])[0];
    this.steps = engine.explain(0, 1).map((step) => this.inWorld(step));
    this.steps.forEach((step, i) => {
      step.best = Math.max(...this.steps.slice(0, i + 1).map(({ lower }) => lower));
      step.before = i > 0 ? this.steps[i - 1].after ?? this.steps[i - 1].before : [];
      step.after = step.vertices?.map(({ at, weight }) => ({ step: this.stepOf(at, i), weight }));
    });
    // Each step is told in two stages: the support, and what remains of the simplex.
    this.stages = this.steps.flatMap((step, i) => (
      step.after ? [{ step: i, isReduced: false }, { step: i, isReduced: true }] : [{ step: i, isReduced: false }]));
    this.stage = wasAtEnd ? this.stages.length - 1 : Math.min(this.stage, this.stages.length - 1);
  }

  get current() {
    const { step, isReduced } = this.stages[this.stage];
    return { ...this.steps[step], number: step + 1, isReduced };
  }

  /** A step's points as the plane has them; the library tells them in A's frame. */
  inWorld({ normal, onA, onB, w, lower, vertices, nearest, upper }) {
    const [a] = this.bodies, rotate = ([x, y]) => turned([x, y], a.angle);
    return {
      normal: rotate(normal), onA: plus(rotate(onA), a.at), onB: plus(rotate(onB), a.at), w: rotate(w), lower, upper,
      nearest: nearest && rotate(nearest), vertices: vertices?.map((v) => ({ at: rotate(v.w), weight: v.weight })),
    };
  }

  /** The last step up to one that found a vertex. */
  stepOf([x, y], last) {
    for (let i = last; i > 0; i--) {
      const [p, q] = this.steps[i].w;
      if (p === x && q === y) return i;
    }
    return 0;
  }

  /** A body's corners in the plane. */
  outline(index) {
    const { corners, at, angle } = this.bodies[index];
    return hull(corners.map((corner) => plus(turned(corner, angle), at)));
  }

  /** The corners of A - B. */
  difference() {
    const [a, b] = [this.outline(0), this.outline(1)];
    return hull(a.flatMap((p) => b.map((q) => minus(p, q))));
  }

  /** A sum of the steps' points with the weights of a simplex. */
  weighted(after, name) {
    return after.reduce((sum, { step, weight }) => sum.map((x, i) => x + weight * this.steps[step][name][i]), [0, 0]);
  }
}

/** A polygon as words of a record: a point, a segment, a triangle or a flat hull. */
function wordsOf(corners) {
  const numbers = corners.map(([x, y]) => `${x} ${y} 0`).join(' ');
  if (corners.length === 1) return 'point 0';
  return corners.length === 3 ? `triangle ${numbers}` : `mesh ${corners.length} ${numbers}`;
}

function motionOf({ at, angle }) {
  const motion = [...AT_REST];
  [motion[2], motion[3]] = [Math.sin(angle / 2), Math.cos(angle / 2)];
  [motion[4], motion[5]] = at;
  return motion;
}
