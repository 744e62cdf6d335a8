import { number } from '../data.js';
import { length, minus, plus, times } from './geometry.js';

/** The least half width and height of both shapes' picture; for A - B steps of both, so that they seldom change. */
const WORLD = [3, 1.9], HALVES = [1.8, 2.5, 3.5, 4.5, 6, 8, 12, 20, 40];

/** The length of an arrow that only shows a direction, and how far from a body it is turned, in units of the plane. */
export const DIRECTION = 0.9, HANDLE = 0.45;

/** Room around a body and what turns with it, in units of the plane: a handle needs some to be seen whole. */
export const ROOM = 0.28;

export const middle = (points) => times(points.reduce(plus), 1 / points.length);
export const unit = (v) => (length(v) > 0 ? times(v, 1 / length(v)) : [0, 0]);

/** A number as a figure writes it. */
export const short = (x) => number(Number(x.toPrecision(4)));
export const point = ([x, y]) => `(${short(x)}, ${short(y)})`;

/**
 * A figure of two polygons: what is drawn of them, what is told, and what can be taken hold of. This one shows A - B,
 * the origin, and the shortest way between the shapes. In what is told, {w1} or {w1|the corner} is a word whose part of
 * the picture lights up.
 */
export class Lesson {
  constructor(model, { turns = false } = {}) {
    this.model = model;
    this.turns = turns;
    this.step = 0;
  }

  /** How many steps there are to walk; 1 where there is nothing to walk, and no end to some walks. */
  count = 1;

  /** What a step is called, and how long it is shown. */
  steps = 'step';

  pace = 1800;

  help = 'Drag a shape.';

  /** Called when the shapes have changed, after the library was asked. */
  changed() {}

  /** What the figure has besides the shapes to take hold of: {at, move(to)}. */
  handles() {
    return [];
  }

  drawWorld(picture, active) {
    this.beginWorld(picture);
    this.bodies(picture, active);
    this.shortest(picture);
    picture.end();
  }

  drawDifference(picture) {
    this.beginDifference(picture);
    this.outline(picture);
    const { distance, pointA, pointB } = this.model.answer;
    if (distance > 0) picture.line([0, 0], minus(pointA, pointB).slice(0, 2), 'nearest', 'shortest');
    this.origin(picture);
    picture.end();
  }

  headline() {
    const { status, distance } = this.model.answer;
    return status === 'Separated' ? `apart by ${short(distance)}` : 'touching or overlapping';
  }

  told() {
    const { distance } = this.model.answer;
    if (distance > 0) {
      return `The {origin} is outside {A − B}, and as far from it as {A} is from {B}: {shortest|the shortest arrow} is `
        + `${short(distance)} long in both pictures.`;
    }
    return 'The {origin} is in {A − B}, or on its edge: some point of {A} is a point of {B}, too.';
  }

  /** How far a body reaches with everything that turns with it. */
  reach(index) {
    return Math.max(...this.model.bodies[index].corners.map(length)) + (this.turns ? HANDLE : 0);
  }

  beginWorld(picture) {
    const most = [0, 1].map((axis) => Math.max(WORLD[axis], ...this.model.bodies.map(({ at }, i) => (
      Math.abs(at[axis]) + this.reach(i) + ROOM))));
    picture.begin(...most);
  }

  bodies(picture, active) {
    const { model } = this;
    for (const i of [0, 1]) {
      const outline = model.outline(i), name = 'AB'[i];
      picture.polygon(outline, `body ${'ab'[i]}${i === active ? ' active' : ''}`, name);
      picture.text(middle(outline), name, 'name');
      if (!this.turns) continue;
      picture.line(model.bodies[i].at, this.turnedBy(i), 'handle');
      picture.dot(this.turnedBy(i), 'handle', '', 8);
    }
  }

  /** Where a body is taken hold of to turn it. */
  turnedBy(index) {
    const { at, angle } = this.model.bodies[index], reach = this.reach(index);
    return plus(at, [-Math.sin(angle) * reach, Math.cos(angle) * reach]);
  }

  /** The shortest line between the shapes. */
  shortest(picture) {
    const { distance, pointA, pointB } = this.model.answer;
    if (!(distance > 0)) return;
    const ends = [pointA.slice(0, 2), pointB.slice(0, 2)];
    picture.line(...ends, 'nearest', 'shortest');
    picture.text(middle(ends), short(distance), 'strong', 'shortest');
  }

  beginDifference(picture) {
    const corners = this.model.difference();
    const [wide, tall] = [0, 1].map((axis) => {
      const most = 1.15 * Math.max(...corners.map((p) => Math.abs(p[axis])));
      return HALVES.find((half) => half >= most) ?? most;
    });
    picture.begin(wide, tall);
    picture.line([-picture.wide, 0], [picture.wide, 0], 'axis');
    picture.line([0, -picture.tall], [0, picture.tall], 'axis');
  }

  outline(picture) {
    picture.polygon(this.model.difference(), 'difference', 'A − B');
  }

  origin(picture) {
    picture.dot([0, 0], 'origin', 'origin', 6);
    picture.text([0, 0], 'origin', 'strong');
  }
}
