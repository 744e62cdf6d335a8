import { number } from '../data.js';
import { across, clip, dot, features, length, minus, plus, region, times } from './geometry.js';
import { Picture, shape } from './svg.js';

/** The half width and height of both shapes' picture, and steps for those of A - B, so that they seldom change. */
const WORLD = [3.6, 2.4], HALVES = [2.5, 3.5, 4.5, 6, 8, 12, 20, 40];

/** The lengths of arrows that only show a direction, in units of the plane. */
const DIRECTION = 0.9;

const middle = (points) => times(points.reduce(plus), 1 / points.length);
const unit = (v) => (length(v) > 0 ? times(v, 1 / length(v)) : [0, 0]);

/** Both shapes: the support points of a step and the closest points. */
export class WorldFigure extends Picture {
  constructor(model) {
    super('both shapes');
    this.model = model;
  }

  draw(active) {
    const { model } = this, { current, answer } = model;
    this.begin(...WORLD);
    [0, 1].forEach((i) => {
      const outline = model.outline(i), { at, angle } = model.bodies[i];
      this.polygon(outline, `body ${'ab'[i]}${i === active ? ' active' : ''}`);
      if (outline.length === 1) this.dot(outline[0], `body ${'ab'[i]}`, 6);
      this.text(middle(outline), 'AB'[i], 'name', -4, 5);
      if (outline.length === 1) return;
      const handle = this.handle(i);
      this.line(at, handle, 'handle');
      this.dot(handle, 'handle', 8);
    });
    const towards = times(unit(current.normal), DIRECTION);
    if (!current.isReduced) {
      this.arrow(current.onA, minus(current.onA, towards), 'search');
      this.arrow(current.onB, plus(current.onB, towards), 'search');
    }
    this.square(current.onA, 'support');
    this.square(current.onB, 'support');
    this.text(current.onA, `a${current.number}`, '', -22, 18);
    this.text(current.onB, `b${current.number}`, '', 9, 18);
    if (current.isReduced) {
      const [p, q] = ['onA', 'onB'].map((name) => model.weighted(current.after, name));
      this.line(p, q, 'nearest');
      for (const point of [p, q]) this.dot(point, 'nearest');
    }
    if (model.stage === model.stages.length - 1 && answer.distance > 0) {
      const ends = [answer.pointA.slice(0, 2), answer.pointB.slice(0, 2)];
      this.line(...ends, 'nearest');
      this.text(middle(ends), number(answer.distance), 'strong');
    }
    this.end();
  }

  /** Where a body is taken hold of to turn it. */
  handle(index) {
    const { at, angle, corners } = this.model.bodies[index];
    const reach = Math.max(...corners.map(length)) + 0.45;
    return plus(at, [-Math.sin(angle) * reach, Math.cos(angle) * reach]);
  }
}

/** A - B and the origin: the simplex, the support line, and the region in which the origin lies. */
export class DifferenceFigure extends Picture {
  constructor(model) {
    super('A − B and the origin');
    this.model = model;
  }

  draw() {
    const { model } = this, { current } = model, difference = model.difference();
    const [wide, tall] = [0, 1].map((axis) => {
      const most = 1.15 * Math.max(...difference.map((p) => Math.abs(p[axis])));
      return HALVES.find((half) => half >= most) ?? most;
    });
    this.begin(wide, tall);
    this.add(shape('defs', {}, this.hatch()));
    const [w, t] = [this.wide, this.tall];
    this.line([-w, 0], [w, 0], 'axis');
    this.line([0, -t], [0, t], 'axis');
    if (current.isReduced) this.regions();
    this.polygon(difference, 'difference');
    if (current.isReduced) this.reduced();
    else this.support();
    this.dot([0, 0], 'origin', 6);
    this.text([0, 0], 'origin', 'strong', 10, 16);
    this.end();
  }

  hatch() {
    const size = 9 * this.unit;
    return shape('pattern', {
      id: 'hatch', width: size, height: size, patternUnits: 'userSpaceOnUse', patternTransform: 'rotate(45)',
    }, shape('line', { x1: 0, y1: 0, x2: 0, y2: size, class: 'hatch', 'stroke-width': 2 * this.unit }));
  }

  /** The regions of the simplex with the new point in it; the one with the origin is hatched. */
  regions() {
    const { steps, current: { before, after, number: last } } = this.model;
    const simplex = [...new Set([...before.map(({ step }) => step), last - 1])];
    const points = simplex.map((step) => steps[step].w);
    if (points.length < 2 || points.length > 3) return;
    const chosen = after.map(({ step }) => simplex.indexOf(step)).sort().join();
    for (const feature of features(points.length)) {
      const part = clip(this.window(), region(points, feature));
      const isChosen = [...feature].sort().join() === chosen;
      if (part.length > 2) this.polygon(part, isChosen ? 'region chosen' : 'region');
    }
  }

  /** The old simplex, and the furthest point towards the origin with the line that it proves. */
  support() {
    const { steps, current } = this.model, { w, normal } = current;
    this.simplex(current.before.map(({ step }) => step), 'old');
    const along = times(unit(across(normal)), this.wide + this.tall);
    this.line(minus(w, along), plus(w, along), 'plane');
    const nearest = current.before.length ? steps[current.number - 2].nearest : null;
    if (nearest && length(nearest) > 0) {
      const towards = times(unit(nearest), Math.min(DIRECTION, length(nearest)));
      this.arrow(nearest, minus(nearest, towards), 'search');
    }
    if (nearest) this.distance(nearest, current.after ? 'nearest faint' : 'nearest');
    if (current.lower > 0) {
      const foot = times(unit(normal), dot(w, unit(normal)));
      this.line([0, 0], foot, 'proved');
    }
    this.square(w, 'support', 6);
    this.text(w, `w${current.number} = a${current.number} − b${current.number}`);
  }

  reduced() {
    const { current } = this.model;
    this.simplex(current.after.map(({ step }) => step), '');
    for (const { step, weight } of current.after) {
      const share = current.after.length > 1 ? `${number(Number(weight.toPrecision(3)))} · ` : '';
      this.text(this.model.steps[step].w, `${share}w${step + 1}`);
    }
    this.distance(current.nearest, 'nearest');
  }

  /** The nearest point of a simplex, and the way to it. */
  distance(nearest, className) {
    if (length(nearest) > 0) this.line([0, 0], nearest, className);
    this.dot(nearest, className);
    this.text(nearest, 'v', '', -18, 14);
  }

  simplex(indices, className) {
    const points = indices.map((step) => this.model.steps[step].w);
    if (points.length > 1) this.polygon(points, `simplex ${className}`);
    for (const point of points) this.dot(point, `simplex ${className}`);
  }
}
