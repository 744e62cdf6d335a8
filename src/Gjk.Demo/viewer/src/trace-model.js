import { Quaternion, Vector3 } from 'three';
import { number, shape, vector } from './data.js';
import { DepthModel } from './depth-model.js';

/** Ratio. Bounds that are closer than this look the same in six digits. */
const VISIBLE = 1e-6;

const FEATURES = ['vertex', 'edge', 'triangle', 'tetrahedron'];

/**
 * One query: its steps with the bounds so far, and each step in words. Numbers are in world units and in A's frame.
 * Drawn numbers are multiplied by the unit.
 */
export class TraceModel {
  constructor(json) {
    Object.assign(this, json);
    this.shapeA = shape(json.shapeA);
    this.shapeB = shape(json.shapeB);
    this.difference = shape(json.difference);
    this.depth = json.depth ? new DepthModel(json.depth, json) : null;
    this.rotationB = new Quaternion(...json.rotation).normalize();
    let lower = 0, upper = Infinity;
    this.steps.forEach((step, i) => {
      if (step.extended && !this.steps[i - 1]?.extended) upper = Infinity;
      step.upperBefore = upper;
      if (step.lower > lower) lower = step.lower;
      if (step.after) upper = step.after.length === 4 ? 0 : step.upper;
      step.best = lower;
      step.bound = upper;
    });
  }

  /** How many steps are shown: those of the distance, and then those of the depth. */
  get count() {
    return this.steps.length + (this.depth?.steps.length ?? 0);
  }

  isDepth(at) {
    return Boolean(this.depth) && at >= this.steps.length && at < this.count;
  }

  isLast(at) {
    return at === Math.max(this.count - 1, 0);
  }

  drawn([x, y, z]) {
    return new Vector3(x * this.unit, y * this.unit, z * this.unit);
  }

  /** Names a feature. Each vertex is named after the step that found it. */
  feature(indices) {
    return `${FEATURES[indices.length - 1]} ${indices.map((i) => `w${i + 1}`).sort((a, b) => a.slice(1) - b.slice(1)).join(' ')}`;
  }

  /** The points of both shapes whose difference is the simplex's nearest point. */
  witnesses(step) {
    const mix = (key) => step.after.reduce((sum, i, k) => sum.addScaledVector(this.drawn(this.steps[i][key]), step.weights[k]), new Vector3());
    return [mix('onA'), mix('onB')];
  }

  /** Describes a step in paragraphs of [kind, text]. */
  story(at) {
    if (this.isDepth(at)) return this.depth.story(at - this.steps.length);
    const step = this.steps[at];
    if (!step) return [['text', this.withoutSteps()]];
    const end = this.depth && this.isLast(at) ? [['answer', this.depth.answer()]] : [];
    return [['text', this.search(at)], ['text', this.proof(step)], ['text', this.reduction(at)], ...(at === this.steps.length - 1 ? [['answer', this.answer()], ...end] : [])];
  }

  search(at) {
    const { before, normal, idA, idB, onA, onB, extended } = this.steps[at];
    const from = before.length ? `n points from the origin to the ${this.feature(before)}` : 'n points from B’s centre to A’s, to begin somewhere';
    const name = (id) => (id < 0 ? '' : `vertex ${id}, `);
    const which = extended && !before.length && at ? 'Rounding could decide here, so the query begins again in extended precision (106 bits). ' : '';
    return `${which}Search: ${from}, n = ${vector(normal)}. A’s furthest point against n is ${name(idA)}${vector(onA)}, B’s furthest along n ${name(idB)}${vector(onB)}; `
      + `their difference is w${at + 1}.`;
  }

  proof({ lower, best }) {
    if (lower === null || lower <= 0) return 'Bound: the plane through it, across n, does not keep the origin out, so it proves nothing yet.';
    return `Bound: all of A − B lies beyond the plane through it, across n, so the cores are at least ${number(lower)} apart${best > lower * (1 + VISIBLE) ? ` (${number(best)} is known already)` : ''}.`;
  }

  reduction(at) {
    const step = this.steps[at], isLast = at === this.steps.length - 1;
    if (!step.after) {
      if (!isLast) return 'Region: the bounds meet, but the triangle is such a needle that rounding may have tilted it.';
      if (this.result.status === 'InvalidShape') return 'Region: this point lies behind one that the same support gave before; no convex shape does that.';
      return `Region: |v| = ${number(step.upperBefore)} was known to be reached, and no point is nearer than this plane: the two bounds have met, and the distance is proved.`;
    }
    const joined = [...step.before, at];
    if (step.after.length === 4) return `Region: the origin is inside the ${this.feature(step.after)}: A − B holds the origin, so the shapes share a point.`;
    const dropped = joined.filter((i) => !step.after.includes(i));
    const rest = dropped.length ? `; ${dropped.map((i) => `w${i + 1}`).join(' and ')} ${dropped.length > 1 ? 'are' : 'is'} dropped` : '';
    const what = !dropped.length && joined.length > 1 ? `the point of the ${this.feature(joined)} nearest the origin lies inside it; all are kept` : joined.length > 1 ? `of the ${this.feature(joined)}, the origin is nearest the ${this.feature(step.after)}${rest}` : `the simplex is the ${this.feature(joined)}`;
    const end = !isLast ? '' : this.result.status === 'Overlapping' ? ' That is no further than rounding can tell from contact.' : step.best >= step.upper * (1 - VISIBLE) ? ' The plane proves the same: the two bounds have met.' : ' It falls no more.';
    return `Region: ${what}. |v| = ${number(step.upper)}.${end}`;
  }

  answer() {
    const { status, distance, lowerBound, iterations } = this.result;
    const margins = this.marginA + this.marginB;
    const less = margins > 0 ? ` (|v| less the margins ${number(this.marginA)} and ${number(this.marginB)})` : '';
    const after = `after ${iterations} iterations`;
    if (status === 'Overlapping') {
      const bound = this.steps.at(-1)?.bound;
      return `Answer: the shapes intersect${margins > 0 && bound > 0 ? `, for |v| = ${number(bound)} is no more than the margins ${number(this.marginA)} and ${number(this.marginB)}` : ''}, ${after}.`;
    }
    if (distance === null) return `Answer: ${status}, ${after}.`;
    return `Answer: distance ${number(distance)}${less}, at least ${number(lowerBound)}, ${after}.`;
  }

  withoutSteps() {
    return `No steps: ${this.result.status}.`;
  }
}
