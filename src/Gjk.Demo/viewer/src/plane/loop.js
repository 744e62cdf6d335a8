import { exact } from '../data.js';
import { plus } from './geometry.js';
import { Lesson } from './lesson.js';

// The program of the book's third chapter, in float, with the test that most programs use: it ends when the new corner
// is no further towards the origin than v.
const f = Math.fround;
const minus = (p, q) => [f(p[0] - q[0]), f(p[1] - q[1])];
const dot = (p, q) => f(f(p[0] * q[0]) + f(p[1] * q[1]));
const side = (p, q) => f(f(p[0] * q[1]) - f(p[1] * q[0]));
const furthest = (corners, d) => corners.reduce((most, p) => (dot(p, d) > dot(most, d) ? p : most));

function onEdge(p, q) {
  const along = minus(q, p), t = f(-dot(p, along) / dot(along, along));
  if (!(t > 0)) return { v: p, kept: [p] };
  if (t >= 1) return { v: q, kept: [q] };
  return { v: [f(p[0] + f(t * along[0])), f(p[1] + f(t * along[1]))], kept: [p, q] };
}

function nearest(simplex) {
  if (simplex.length < 3) return simplex.length === 1 ? { v: simplex[0], kept: simplex } : onEdge(...simplex);
  const [p, q, w] = simplex, [a, b, c] = [side(p, q), side(q, w), side(w, p)];
  if (a * b > 0 && b * c > 0) return { v: [0, 0], kept: simplex };
  return [onEdge(p, q), onEdge(q, w), onEdge(w, p)]
    .reduce((least, each) => (dot(each.v, each.v) < dot(least.v, least.v) ? each : least));
}

/** No search of ours takes so many steps without a repetition. */
const MOST = 100;

/** The steps of the search in float, up to its end, or to the first simplex that comes again. */
export function searchInFloat(a, b) {
  const names = [], walk = [], seen = new Map();
  const nameOf = (w) => {
    const key = w.join();
    if (!names.includes(key)) names.push(key);
    return `w${names.indexOf(key) + 1}`;
  };
  let simplex = [minus(a[0], b[0])];
  while (walk.length < MOST) {
    const { v, kept } = nearest(simplex), square = dot(v, v), key = kept.join(' ');
    const w = minus(furthest(a, [-v[0], -v[1]]), furthest(b, v));
    const further = f(square - dot(v, w));
    walk.push({ v, kept, names: kept.map(nameOf), w, name: nameOf(w), length: f(Math.sqrt(square)), further });
    if (square === 0 || further <= 0) return { walk, repeats: -1 };
    if (seen.has(key)) return { walk: walk.slice(0, -1), repeats: seen.get(key) };
    seen.set(key, walk.length - 1);
    simplex = [...kept, w];
  }
  return { walk, repeats: -1 };
}

/** A search in float, which may have no end. */
export class Loop extends Lesson {
  pace = 700;

  changed() {
    const corners = [0, 1].map((i) => this.model.bodies[i].corners
      .map((c) => plus(c, this.model.bodies[i].at).map(f)));
    Object.assign(this, searchInFloat(...corners));
    this.count = this.repeats < 0 ? this.walk.length : Infinity;
    this.step = Math.min(this.step, this.count - 1);
  }

  /** A step of the walk, which goes round for ever where a simplex comes again. */
  at(step) {
    const { walk, repeats } = this;
    return walk[step < walk.length ? step : repeats + ((step - repeats) % (walk.length - repeats))];
  }

  headline() {
    if (this.repeats < 0) return this.step === this.count - 1 ? 'it ends here' : '';
    return this.step >= this.walk.length ? 'the same again, for ever' : '';
  }

  told() {
    const { names, name, length, further } = this.at(this.step), { iterations, distance } = this.model.answer;
    const feature = `{simplex|the ${['point', 'edge', 'triangle'][names.length - 1]}} ${names.map((n) => `{${n}}`).join(' ')}`;
    const found = `In float, {v} of ${feature} is ${exact(length)} from the {origin}. `;
    if (length === 0) return `${found}The shapes share a point, and the search ends.`;
    const library = `The library ends after ${iterations} steps, at ${exact(distance)}.`;
    if (further <= 0)
      return `${found}{${name}} is no further towards it, so the search ends. Drag B a little: in some places it never does.`;
    const isOld = names.includes(name);
    const again = this.repeats >= 0 && this.step >= this.walk.length - 1
      ? `The next step is ${this.step >= this.walk.length ? 'the same again' : `step ${this.repeats + 1} again`}. ${library}` : '';
    return `${found}The support {${name}} is further by |v|² − v · w = ${exact(further)}, so the loop goes on. ${isOld
      ? `But {${name}} is a corner of the simplex already: only rounding says that it is further. ` : ''}${again}`;
  }

  drawDifference(picture) {
    const { kept, names, w, name, v } = this.at(this.step);
    this.beginDifference(picture);
    this.outline(picture);
    if (kept.length > 1) picture.polygon(kept, 'simplex', 'simplex');
    kept.forEach((at, i) => { picture.dot(at, 'simplex', names[i]); picture.text(at, names[i]); });
    picture.line([0, 0], v, 'nearest', 'v');
    picture.dot(v, 'nearest', 'v');
    picture.text(v, 'v');
    picture.square(w, 'support', name, 6);
    if (!names.includes(name)) picture.text(w, name);
    this.origin(picture);
    picture.end();
  }

  drawWorld(picture, active) {
    this.beginWorld(picture);
    this.bodies(picture, active);
    picture.end();
  }
}
