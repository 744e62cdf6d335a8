import { Vector3 } from 'three';
import { number, vector } from './data.js';

/**
 * The search for the depth of a pair that overlaps: the surface at each step, and each step in words. Numbers are in
 * world units and in A's frame, those of the surface are of the cores, without their margins.
 */
export class DepthModel {
  constructor(json, { unit, marginA, marginB }) {
    Object.assign(this, json);
    this.unit = unit;
    this.marginA = marginA;
    this.marginB = marginB;
    this.points = json.vertices.map((v) => this.drawn(v));
  }

  get margins() {
    return this.marginA + this.marginB;
  }

  /** The depth, or null where only bounds are known. */
  get value() {
    return this.result.status === 'Overlapping' ? Math.max(-this.result.distance, 0) : null;
  }

  /** How B moves to leave A by the shortest way, as it is drawn, or null where none is known. */
  get wayOut() {
    return this.value > 0 ? this.drawn(this.result.normal).multiplyScalar(this.value) : null;
  }

  get deepestOnA() {
    return this.drawn(this.result.pointA);
  }

  get deepestOnB() {
    return this.deepestOnA.sub(this.wayOut);
  }

  drawn([x, y, z]) {
    return new Vector3(x * this.unit, y * this.unit, z * this.unit);
  }

  point(index) {
    return this.points[index];
  }

  name(index) {
    return `p${index + 1}`;
  }

  /** Whether a search ends with this step. Another one may begin after it. */
  ends(at) {
    return this.steps[at].outcome !== 'Grows';
  }

  /** The corners of each face by its number. A step has only what is new; one without a surface shows the last one. */
  surface(at) {
    const faces = new Map();
    for (let i = 0; i <= at; i++) {
      for (const face of this.steps[i].removed ?? []) faces.delete(face);
      for (const [face, ...corners] of this.steps[i].added ?? []) faces.set(face, corners);
    }
    return faces;
  }

  /** Describes a step in paragraphs of [kind, text]. */
  story(at) {
    const step = this.steps[at];
    const told =
      step.lowest === undefined
        ? [['text', this.ending(at)]]
        : [
            ['text', this.surfaceText(at)],
            ['text', this.searchText(step)],
            ['text', this.ending(at)],
          ];
    return at === this.steps.length - 1 ? [...told, ['answer', this.answer()]] : told;
  }

  surfaceText(at) {
    const { count, lowest, below } = this.steps[at];
    const corners = this.surface(at)
      .get(lowest)
      .map((i) => this.name(i))
      .join(' ');
    const first =
      at === 0 || this.ends(at - 1) ? 'Four support points of A − B are the corners of the first surface. ' : '';
    const bound =
      below > 0
        ? `${number(below)} from the origin. A ball of this radius fits inside, so no way out is shorter`
        : 'nearest the origin, which is still outside or on it: it proves nothing yet, and grows towards the origin';
    return `Surface: ${first}Of its ${count} triangles the lowest, ${corners}, is ${bound}.`;
  }

  searchText(step) {
    const { normal, idA, idB, onA, onB, above, vertex } = step;
    const name = (id) => (id < 0 ? '' : `vertex ${id}, `);
    const cost = new Vector3(...normal).dot(new Vector3(...this.vertices[vertex]));
    const known = above < cost ? `; ${number(above)} is known already` : '';
    return [
      `Search: beyond it, along its normal n = ${vector(normal)}, A’s furthest point is ${name(idA)}${vector(onA)}, `,
      `B’s furthest against n ${name(idB)}${vector(onB)}; their difference is ${this.name(vertex)}. `,
      `${this.margins > 0 ? 'The cores part' : 'B leaves A'} along n after ${number(cost)}${known}. `,
      this.between(step),
    ].join('');
  }

  between({ below, above }) {
    if (above < 0) return '';
    const of = this.margins > 0 ? 'The depth of the cores' : 'The depth';
    return `${of} is between ${number(Math.max(below, 0))} and ${number(above)}.`;
  }

  ending(at) {
    const step = this.steps[at];
    switch (step.outcome) {
      case 'Grows':
        return this.growth(at);
      case 'BoundsMet':
        return (
          'End: nothing of A − B lies further along n than the triangle does, as far as rounding and the tolerance ' +
          'of curved shapes can tell. The two bounds have met.'
        );
      case 'Flat':
        return (
          'End: A − B is flat and has no inside, so there is no surface to grow; ' +
          'across it, the way out of the cores has no length.'
        );
      case 'Apart':
        return 'End: this plane separates the cores.';
      case 'OutOfRoom':
        return (
          `End: ${step.room} points are all that there is room for. ${this.between(step)}` +
          (at + 1 < this.steps.length ? ' The search begins anew from the lowest triangle, with more room.' : '')
        );
      default:
        return 'End: this point contradicts one that the same shape gave before; no convex shape does that.';
    }
  }

  growth(at) {
    const { vertex, lowest } = this.steps[at],
      next = this.steps[at + 1];
    const p = this.name(vertex),
      n = new Vector3(...this.steps[at].normal),
      w = new Vector3(...this.vertices[vertex]);
    const above = number(n.dot(w.sub(new Vector3(...this.vertices[this.surface(at).get(lowest)[0]]))));
    if (next?.lowest === undefined) return `Growth: ${p} lies ${above} above the triangle.`;
    const joined = [...this.surface(at + 1).values()].filter((corners) => corners.includes(vertex)).length;
    const gone = this.steps[at].count + joined - next.count;
    const which = gone === 1 ? 'The triangle goes' : `The ${gone} triangles that ${p} lies above go`;
    return `Growth: ${p} lies ${above} above the triangle. ${which}, and ${joined} new ones join their rim to ${p}.`;
  }

  /** The answer in few words. */
  summary() {
    const { status, distance, lowerBound } = this.result;
    if (status === 'IterationLimit') return `depth between ${number(-distance)} and ${number(-lowerBound)}`;
    return this.value === null ? status : `depth ${number(this.value)}`;
  }

  answer() {
    const { status, distance, lowerBound, normal, iterations } = this.result;
    if (status === 'IterationLimit') {
      const between = `${number(-distance)} and ${number(-lowerBound)}`;
      return `Answer: the depth is between ${between}; there was no room to know it better.`;
    }
    if (this.value === null) return `Answer: ${status}.`;
    if (this.value === 0) return 'Answer: depth 0: the shapes only touch, as far as rounding can tell.';
    const margins = `${number(this.marginA)} and ${number(this.marginB)}`;
    const of = this.margins > 0 ? `, the margins ${margins} included` : '';
    // The query answers two boxes without asking for a support.
    const axes =
      iterations === 0 && this.steps.length
        ? ' The query itself answers two boxes by their 15 separating axes; ' +
          'the surface is grown for this page and shows the same depth.'
        : '';
    const way = `B moves by it along ${vector(normal)}, and only touches A`;
    return `Answer: depth ${number(this.value)}${of}. The shortest way out: ${way}.${axes}`;
  }
}
