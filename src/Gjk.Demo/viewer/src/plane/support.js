import { across, dot, minus, plus, times } from './geometry.js';
import { Lesson, point } from './lesson.js';

/** Where the direction is turned, and how large it is there. */
const DIAL = [0.1, -1.15], SIZE = 0.65, FIRST = 0.5;

const furthest = (corners, d) => corners.reduce((most, p) => (dot(p, d) > dot(most, d) ? p : most));

/** A direction to turn, and the furthest points of A, of B and of A - B along it. */
export class Support extends Lesson {
  angle = FIRST;

  found = [];

  help = 'Drag the tip of the arrow d.';

  get direction() {
    return [Math.cos(this.angle), Math.sin(this.angle)];
  }

  changed() {
    this.found = [];
  }

  handles() {
    return [{
      at: plus(DIAL, times(this.direction, SIZE)),
      move: (to) => { this.angle = Math.atan2(...minus(to, DIAL).reverse()); },
    }];
  }

  /** The furthest points. */
  points() {
    const d = this.direction, a = furthest(this.model.outline(0), d);
    const b = furthest(this.model.outline(1), times(d, -1)), w = minus(a, b);
    if (!this.found.some((p) => Math.hypot(...minus(p, w)) < 1e-9)) this.found.push(w);
    return { a, b, w };
  }

  headline() {
    return '';
  }

  told() {
    const { a, b, w } = this.points();
    return `Furthest along {d}: {a} = ${point(a)} of {A}. Furthest against it: {b} = ${point(b)} of {B}. So {w|w = a − b} `
      + `= ${point(w)} is the furthest of {A − B}: all of it lies behind {line|the line}. Turn {d} all the way round, and `
      + `{w} visits every corner: ${this.found.length} of ${this.model.difference().length} so far.`;
  }

  drawWorld(picture, active) {
    const { a, b } = this.points(), d = this.direction;
    this.beginWorld(picture);
    for (const at of [a, b]) this.line(picture, at);
    this.bodies(picture, active);
    for (const [name, at] of [['a', a], ['b', b]]) {
      picture.square(at, 'support', name);
      picture.text(at, name);
    }
    const tip = plus(DIAL, times(d, SIZE));
    picture.arrow(DIAL, tip, 'search', 'd');
    picture.handle(tip, 'd');
    picture.text(tip, 'd');
    picture.end();
  }

  drawDifference(picture) {
    const { w } = this.points();
    this.beginDifference(picture);
    this.line(picture, w);
    this.outline(picture);
    for (const at of this.found) picture.dot(at, 'simplex', '', 4);
    picture.square(w, 'support', 'w', 6);
    picture.text(w, 'w');
    this.origin(picture);
    picture.end();
  }

  /** The line across the direction, beyond which nothing of a shape lies. */
  line(picture, at) {
    const along = times(across(this.direction), picture.wide + picture.tall);
    picture.line(minus(at, along), plus(at, along), 'plane', 'line');
  }
}
