import { AT_REST } from '../engine.js';
import { hull, minus, plus, turned } from './geometry.js';

/** How far A moves in a frame, where a figure moves it. */
const REST = [0, 0];

/** Two convex polygons of the plane z = 0, and the library's answers, which solves them as flat shapes in space. */
export class PlaneModel {
  constructor(engine) {
    this.engine = engine;
  }

  /** Begins with two polygons. */
  load(shapes) {
    this.bodies = shapes.map(({ corners, at }) => ({
      corners: corners.map((corner) => corner.map(Math.fround)), at: at.map(Math.fround), angle: 0,
    }));
    for (const body of this.bodies) body.shape = this.engine.shape(wordsOf(body.corners));
    this.ask();
  }

  move(index, by) {
    const body = this.bodies[index];
    body.at = plus(body.at, by).map(Math.fround);
  }

  turn(index, angle) {
    this.bodies[index].angle += angle;
  }

  /** Asks the library for the distance. */
  ask() {
    this.tell();
    [this.answer] = this.engine.ask('distance', [[0, 1]]);
  }

  tell(way = REST) {
    this.bodies.forEach((body, i) => this.engine.set(i, body.shape, motionOf(body, i === 0 ? way : REST)));
  }

  /** When A first touches B on a way, as a part of it. */
  impact(way) {
    this.tell(way);
    const [result] = this.engine.ask('impact', [[0, 1]]);
    this.tell();
    return result;
  }

  /** The steps of the library's search. */
  explain() {
    const steps = this.engine.explain(0, 1).map((step) => this.inWorld(step));
    steps.forEach((step, i) => {
      step.best = Math.max(...steps.slice(0, i + 1).map(({ lower }) => lower));
      step.before = i > 0 ? steps[i - 1].after ?? steps[i - 1].before : [];
      step.after = step.vertices?.map(({ at, weight }) => ({ step: stepOf(steps, at, i), weight }));
    });
    return steps;
  }

  /** A step's points as the plane has them; the library tells them in A's frame. */
  inWorld({ normal, onA, onB, w, lower, vertices, nearest, upper }) {
    const [a] = this.bodies, rotate = ([x, y]) => turned([x, y], a.angle);
    return {
      normal: rotate(normal), onA: plus(rotate(onA), a.at), onB: plus(rotate(onB), a.at), w: rotate(w), lower, upper,
      nearest: nearest && rotate(nearest), vertices: vertices?.map((v) => ({ at: rotate(v.w), weight: v.weight })),
    };
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
}

/** The last step up to one that found a vertex. */
function stepOf(steps, [x, y], last) {
  for (let i = last; i > 0; i--) {
    const [p, q] = steps[i].w;
    if (p === x && q === y) return i;
  }
  return 0;
}

/** A polygon as words of a record: a triangle or a flat hull. */
function wordsOf(corners) {
  const numbers = corners.map(([x, y]) => `${x} ${y} 0`).join(' ');
  return corners.length === 3 ? `triangle ${numbers}` : `mesh ${corners.length} ${numbers}`;
}

function motionOf({ at, angle }, way) {
  const motion = [...AT_REST];
  [motion[2], motion[3]] = [Math.sin(angle / 2), Math.cos(angle / 2)];
  [motion[4], motion[5]] = at;
  [motion[7], motion[8]] = way;
  return motion;
}
