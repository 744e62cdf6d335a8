import { across, clip, dot, features, length, minus, plus, region, times } from './geometry.js';
import { DIRECTION, Lesson, short, unit } from './lesson.js';
import { shape } from './svg.js';
import { story } from './story.js';

/**
 * The library's search, step by step. What is shown besides the simplex and its nearest point: the 'line' that each
 * support proves, the 'regions' of the simplex, the 'weights' of its corners.
 */
export class Search extends Lesson {
  constructor(model, { layers = [], ...options } = {}) {
    super(model, options);
    this.layers = new Set(layers);
  }

  changed() {
    this.walk = this.model.explain();
    // Each step is told in two stages: the support, and what remains of the simplex.
    this.stages = this.walk.flatMap((step, i) => (
      step.after ? [{ step: i, isReduced: false }, { step: i, isReduced: true }] : [{ step: i, isReduced: false }]));
    this.count = this.stages.length;
    this.step = Math.min(this.step, this.count - 1);
  }

  get current() {
    const { step, isReduced } = this.stages[this.step];
    return { ...this.walk[step], number: step + 1, isReduced };
  }

  told() {
    return story(this);
  }

  headline() {
    return this.step === this.count - 1 ? super.headline() : '';
  }

  drawWorld(picture, active) {
    const { current } = this, k = current.number;
    this.beginWorld(picture);
    this.bodies(picture, active);
    const towards = times(unit(current.normal), DIRECTION);
    if (!current.isReduced) {
      picture.arrow(current.onA, minus(current.onA, towards), 'search', 'd');
      picture.arrow(current.onB, plus(current.onB, towards), 'search', 'd');
    }
    for (const [side, at] of [['a', current.onA], ['b', current.onB]]) {
      picture.square(at, 'support', side + k);
      picture.text(at, side + k);
    }
    if (current.isReduced && this.layers.has('weights')) {
      const ends = ['onA', 'onB'].map((name) => this.weighted(current.after, name));
      picture.line(...ends, 'nearest', 'v');
      for (const end of ends) picture.dot(end, 'nearest', 'v');
    }
    if (this.step === this.count - 1) this.shortest(picture);
    picture.end();
  }

  drawDifference(picture) {
    const { current } = this;
    this.beginDifference(picture);
    if (current.isReduced && this.layers.has('regions')) this.regions(picture);
    this.outline(picture);
    if (current.isReduced) this.reduced(picture);
    else this.support(picture);
    this.origin(picture);
    picture.end();
  }

  /** The regions of the simplex with the new point in it; the one with the origin is hatched. */
  regions(picture) {
    const { walk, current: { before, after, number: last } } = this, size = 9 * picture.unit;
    const line = shape('line', { x1: 0, y1: 0, x2: 0, y2: size, class: 'hatch', 'stroke-width': 2 * picture.unit });
    picture.parts.push(shape('defs', {}, shape('pattern', {
      id: 'hatch', width: size, height: size, patternUnits: 'userSpaceOnUse', patternTransform: 'rotate(45)',
    }, line)));
    const simplex = [...new Set([...before.map(({ step }) => step), last - 1])];
    const points = simplex.map((step) => walk[step].w);
    if (points.length < 2 || points.length > 3) return;
    const chosen = after.map(({ step }) => simplex.indexOf(step)).sort().join();
    for (const feature of features(points.length)) {
      const part = clip(picture.window(), region(points, feature));
      const isChosen = [...feature].sort().join() === chosen;
      if (part.length > 2) picture.polygon(part, isChosen ? 'region chosen' : 'region', isChosen ? 'region' : '');
    }
  }

  /** The old simplex, and the furthest point towards the origin with the line that it proves. */
  support(picture) {
    const { walk, current } = this, { w, normal, number: k } = current;
    this.simplex(picture, current.before.map(({ step }) => step), 'old');
    const nearest = current.before.length ? walk[k - 2].nearest : null;
    if (this.layers.has('line')) {
      const along = times(unit(across(normal)), picture.wide + picture.tall);
      picture.line(minus(w, along), plus(w, along), 'plane', 'line');
      if (current.lower > 0) picture.line([0, 0], times(unit(normal), dot(w, unit(normal))), 'proved', 'at least');
    }
    if (nearest && length(nearest) > 0) {
      const towards = times(unit(nearest), Math.min(DIRECTION, length(nearest)));
      picture.arrow(nearest, minus(nearest, towards), 'search', 'd');
    }
    if (nearest) this.distance(picture, nearest, current.after ? 'nearest faint' : 'nearest');
    picture.square(w, 'support', `w${k}`, 6);
    picture.text(w, `w${k} = a${k} − b${k}`, '', `w${k}`);
  }

  reduced(picture) {
    const { current } = this;
    this.simplex(picture, current.after.map(({ step }) => step), '');
    for (const { step, weight } of current.after) {
      const isShared = current.after.length > 1 && this.layers.has('weights');
      picture.text(this.walk[step].w, `${isShared ? `${short(weight)} · ` : ''}w${step + 1}`, '', `w${step + 1}`);
    }
    this.distance(picture, current.nearest, 'nearest');
  }

  /** The nearest point of a simplex, and the way to it. */
  distance(picture, nearest, className) {
    if (length(nearest) > 0) picture.line([0, 0], nearest, className, 'v');
    picture.dot(nearest, className, 'v');
    picture.text(nearest, 'v');
  }

  simplex(picture, indices, className) {
    const points = indices.map((step) => this.walk[step].w);
    if (points.length > 1) picture.polygon(points, `simplex ${className}`, 'simplex');
    points.forEach((at, i) => picture.dot(at, `simplex ${className}`, `w${indices[i] + 1}`));
  }

  /** A sum of the steps' points with the weights of a simplex. */
  weighted(after, name) {
    return after.reduce((sum, { step, weight }) => sum.map((x, i) => x + weight * this.walk[step][name][i]), [0, 0]);
  }
}
