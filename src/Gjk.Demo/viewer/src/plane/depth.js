import { across, dot, minus, plus, times } from './geometry.js';
import { Lesson, point, short, unit } from './lesson.js';

/** Of the depth: a support that is no further than this beyond a side does not move it. */
const NO_FURTHER = 1e-9;

/**
 * How deep two shapes are: a polygon inside A - B grows from the triangle in which the search ended, one corner a step,
 * always beyond its side nearest the origin. It is EPA in the plane, where a side is what a face is in space.
 */
export class Depth extends Lesson {
  pace = 2600;

  changed() {
    const corners = this.model.difference();
    const last = this.model.explain().at(-1), found = last.after ?? [];
    let grown = found.length === 3 ? last.vertices.map(({ at }) => at) : [];
    if (grown.length && turn(grown) < 0) grown.reverse();
    this.walk = [];
    while (grown.length) {
      const side = lowestSide(grown), { normal, height, index } = side;
      const p = corners.reduce((most, c) => (dot(c, normal) > dot(most, normal) ? c : most));
      const atMost = Math.min(dot(p, normal), this.walk.at(-1)?.atMost ?? Infinity);
      const isLast = dot(p, normal) - height <= NO_FURTHER;
      this.walk.push({ grown, normal, height, side: [grown[index], grown[(index + 1) % grown.length]], p, atMost, isLast });
      if (isLast) break;
      grown = [...grown.slice(0, index + 1), p, ...grown.slice(index + 1)];
    }
    this.count = Math.max(1, this.walk.length);
    this.step = Math.min(this.step, this.count - 1);
  }

  /** The depth, and the direction in which B leaves A; null where they only touch or are apart. */
  get answer() {
    const last = this.walk.at(-1);
    return last ? { depth: last.height, normal: last.normal } : null;
  }

  headline() {
    const step = this.walk[this.step];
    if (!step) return super.headline();
    return step.isLast ? `depth ${short(step.height)}` : `depth ${short(step.height)} to ${short(step.atMost)}`;
  }

  told() {
    const step = this.walk[this.step];
    if (!step) return 'The {origin} is in no triangle of {A − B}: the shapes are apart, or touch. Drag them into each other.';
    const { height, p, isLast, normal } = step;
    const first = this.step > 0 ? '' : 'The search has ended in {surface|a triangle} around the {origin}. ';
    const found = `${first}{side|The side} of {surface|the surface} nearest to the {origin} is ${short(height)} away: the `
      + `depth is at least that. The furthest point of {A − B} beyond it is {p} = ${point(p)}`;
    if (isLast) {
      return `${found}, which is no further. So {side|that side} is one of {A − B}, the depth is ${short(height)}, and `
        + `{out|the way out} of {B} is ${point(times(normal, height))}.`;
    }
    return `${found}, ${short(dot(p, normal))} along {n}: the depth is at most that. The surface is pulled out to {p}.`;
  }

  drawWorld(picture, active) {
    const step = this.walk[this.step];
    this.beginWorld(picture);
    if (step?.isLast) {
      const [, b] = this.model.bodies, way = times(step.normal, step.height);
      picture.polygon(this.model.outline(1).map((c) => plus(c, way)), 'ghost b', 'out');
      picture.arrow(b.at, plus(b.at, way), 'out', 'out');
    }
    this.bodies(picture, active);
    this.shortest(picture);
    picture.end();
  }

  drawDifference(picture) {
    const step = this.walk[this.step];
    this.beginDifference(picture);
    this.outline(picture);
    if (step) {
      const { grown, normal, height, side, p, isLast } = step, foot = times(normal, height);
      const along = times(unit(across(normal)), picture.wide + picture.tall);
      picture.polygon(grown, 'simplex', 'surface');
      picture.line(...side, 'lowest', 'side');
      if (!isLast) picture.line(minus(p, along), plus(p, along), 'plane', 'line');
      if (height > 0) picture.line([0, 0], foot, isLast ? 'out' : 'proved', isLast ? 'out' : 'side');
      if (!isLast) {
        picture.arrow(foot, plus(foot, times(normal, 0.5)), 'search', 'n');
        picture.text(plus(foot, times(normal, 0.5)), 'n');
      }
      picture.square(p, 'support', 'p', 6);
      picture.text(p, 'p');
    }
    this.origin(picture);
    picture.end();
  }
}

const turn = ([a, b, c]) => dot(across(minus(b, a)), minus(c, a));

/** The side of a polygon around the origin, counter-clockwise, that is nearest to it. */
function lowestSide(polygon) {
  return polygon.map((from, index) => {
    const [x, y] = minus(polygon[(index + 1) % polygon.length], from), normal = unit([y, -x]);
    return { index, normal, height: dot(from, normal) };
  }).reduce((low, each) => (each.height < low.height ? each : low));
}
