import { plus, times } from './geometry.js';
import { Lesson, ROOM, short } from './lesson.js';

/** How far A goes in the frame, and in how many steps it is shown. */
const WAY = [2.4, 0.5], FRAMES = 60;

/** A moves, and a slider of time moves it; the library says when it first touches B. */
export class Cast extends Lesson {
  count = FRAMES + 1;

  steps = 'time';

  pace = 50;

  help = 'Move the time, or drag a shape.';

  changed() {
    this.impact = this.model.impact(WAY);
  }

  get time() {
    return this.step / FRAMES;
  }

  get isHit() {
    return this.impact.status === 'Hit';
  }

  headline() {
    if (this.impact.status === 'OverlappingAtStart') return 'overlapping from the start';
    return this.isHit ? `first touch at ${short(this.impact.fraction)}` : 'no touch in this frame';
  }

  told() {
    const { time } = this, { distance } = this.whileMoved(() => { this.model.ask(); return this.model.answer; });
    const where = `At the time ${short(time)} {A} has come {way|this far}. In {A − B}, which stays as it was at the `
      + 'start, {ray|a point} has gone from the {origin} the other way. ';
    if (distance > 0) return `${where}It is ${short(distance)} from {A − B}, and {A} is as far from {B}.`;
    return `${where}It is inside {A − B}, so {A} would be inside {B}. ${this.isHit
      ? `They first touched at ${short(this.impact.fraction)}, where {ray|the ray} enters {A − B}: a cast is a ray cast.` : ''}`;
  }

  /** Does something with A where it is by now. */
  whileMoved(body) {
    const [a] = this.model.bodies, { at } = a;
    a.at = plus(at, times(WAY, this.time)).map(Math.fround);
    const result = body();
    a.at = at;
    this.model.ask();
    return result;
  }

  beginWorld(picture) {
    super.beginWorld(picture);
    const reach = this.reach(0) + ROOM, end = plus(this.model.bodies[0].at, WAY);
    picture.begin(...[0, 1].map((axis) => Math.max(axis ? picture.tall : picture.wide, Math.abs(end[axis]) + reach)));
  }

  drawWorld(picture, active) {
    const { bodies: [a] } = this.model;
    this.beginWorld(picture);
    picture.polygon(this.model.outline(0), 'ghost a', 'way');
    this.whileMoved(() => this.bodies(picture, active));
    picture.arrow(a.at, plus(a.at, WAY), 'motion', 'way');
    if (this.isHit) {
      picture.dot(this.impact.point, 'nearest', 'touch');
      picture.text(this.impact.point, 'first touch', '', 'touch');
    }
    picture.end();
  }

  drawDifference(picture) {
    const by = times(WAY, -this.time);
    this.beginDifference(picture);
    this.outline(picture);
    picture.arrow([0, 0], times(WAY, -1), 'motion', 'ray');
    if (this.isHit) picture.dot(times(WAY, -this.impact.fraction), 'nearest', 'touch');
    this.origin(picture);
    picture.dot(by, 'support', 'ray', 6);
    picture.end();
  }
}
