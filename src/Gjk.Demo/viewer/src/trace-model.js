import { Quaternion } from 'three';
import { count, number, shape, vector } from './data.js';
import { DepthModel } from './depth-model.js';
import { TextbookModel } from './textbook-model.js';
import { Walk } from './walk.js';

/** Ratio. Bounds that are closer than this look the same in six digits. */
const VISIBLE = 1e-6;

/**
 * One query: its steps with the bounds so far, and each step in words. Numbers are in world units and in A's frame.
 */
export class TraceModel extends Walk {
  constructor(json) {
    super(json.steps, json.unit);
    Object.assign(this, json);
    this.shapeA = shape(json.shapeA);
    this.shapeB = shape(json.shapeB);
    this.difference = shape(json.difference);
    this.depth = json.depth ? new DepthModel(json.depth, json) : null;
    this.rotationB = new Quaternion(...json.rotation).normalize();
    this.textbook = new TextbookModel(json.textbook, this);
    let lower = 0,
      upper = Infinity;
    this.steps.forEach((step, i) => {
      if (step.extended && !this.steps[i - 1]?.extended) upper = Infinity;
      step.upperBefore = upper;
      if (step.lower > lower) lower = step.lower;
      if (step.after) upper = step.after.length === 4 ? 0 : step.upper;
      step.best = lower;
      step.bound = upper;
    });
  }

  /** The lines of the pseudo-code that a step runs, by their ids, in their order. */
  lines(at) {
    const step = this.steps[at];
    if (!step) return [];
    const isLast = at === this.steps.length - 1,
      first = at === 0 ? ['start', 'repeat'] : ['repeat'];
    const run = [...first, 'support', 'bound'];
    if (!step.after) return [...run, 'met', isLast ? 'answer' : 'stall'];
    if (step.after.length === 4) return [...run, 'join', 'inside', isLast ? 'answer' : 'stall'];
    run.push('join', 'region', 'next');
    if (!isLast) return this.steps[at + 1].extended && !step.extended ? [...run, 'stall'] : run;
    if (this.result.status === 'Overlapping' && this.margins === 0) return [...run, 'touch', 'answer'];
    return [...run, step.best >= step.upper * (1 - VISIBLE) ? 'met' : 'stall', 'answer'];
  }

  get margins() {
    return this.marginA + this.marginB;
  }

  /** Describes a step in paragraphs of [kind, text]. */
  story(at) {
    if (this.isDepth(at)) return this.depth.story(at - this.steps.length);
    const step = this.steps[at];
    if (!step) return [['text', this.withoutSteps()]];
    const told = [this.search(at), this.proof(step, at), this.reduction(at)].map((text) => ['text', text]);
    if (at === this.steps.length - 1) told.push(['answer', this.answer()]);
    if (this.depth && this.isLast(at)) told.push(['answer', this.depth.answer()]);
    return told;
  }

  search(at) {
    const { before, normal, idA, idB, onA, onB, extended } = this.steps[at];
    const from = before.length
      ? `d points from the ${this.feature(before)} towards the origin`
      : 'd points from A’s centre to B’s, to begin somewhere';
    const name = (id) => (id < 0 ? '' : `vertex ${id}, `);
    const again = extended && !before.length && at;
    return [
      again ? 'Rounding could decide here, so the query begins again in extended precision (106 bits). ' : '',
      `Search: ${from}: d = ${vector(normal.map((x) => -x))}. `,
      `A’s furthest point along d is ${name(idA)}${vector(onA)}, `,
      `B’s furthest against d is ${name(idB)}${vector(onB)}; their difference is w${at + 1}.`,
    ].join('');
  }

  proof({ lower, best }, at) {
    const plane = `the plane through w${at + 1}, across d,`;
    if (lower === null || lower <= 0) return `Bound: ${plane} does not keep the origin out, so it proves nothing yet.`;
    const known = best > lower * (1 + VISIBLE) ? ` (${number(best)} is known already)` : '';
    return `Bound: all of A − B lies beyond ${plane} so the cores are at least ${number(lower)} apart${known}.`;
  }

  reduction(at) {
    const step = this.steps[at],
      isLast = at === this.steps.length - 1;
    if (!step.after) return `Region: ${this.withoutReduction(step, isLast)}`;
    if (step.after.length === 4) {
      const feature = this.feature(step.after);
      return `Region: the origin is inside the ${feature}: A − B holds the origin, so the shapes share a point.`;
    }
    const joined = [...step.before, at];
    const dropped = joined.filter((i) => !step.after.includes(i)).map((i) => `w${i + 1}`);
    const rest = dropped.length ? `; ${dropped.join(' and ')} ${dropped.length > 1 ? 'are' : 'is'} dropped` : '';
    const feature = this.feature(joined);
    const what =
      joined.length === 1
        ? `the simplex is the ${feature}`
        : dropped.length
          ? `of the ${feature}, the origin is nearest the ${this.feature(step.after)}${rest}`
          : `the point of the ${feature} nearest the origin lies inside it; all are kept`;
    return `Region: ${what}. |v| = ${number(step.upper)}.${isLast ? this.ending(step) : ''}`;
  }

  /** Why a step has no new simplex. */
  withoutReduction({ upperBefore }, isLast) {
    if (!isLast) return 'the bounds meet, but the triangle is such a needle that rounding may have tilted it.';
    if (this.result.status === 'InvalidShape') {
      return 'this point lies behind one that the same support gave before; no convex shape does that.';
    }
    return (
      `|v| = ${number(upperBefore)} was known to be reached, and no point is nearer than this plane: ` +
      'the two bounds have met, and the distance is proved.'
    );
  }

  /** Why the query ends after a new simplex. */
  ending(step) {
    if (this.result.status === 'Overlapping') return ' That is no further than rounding can tell from contact.';
    return step.best >= step.upper * (1 - VISIBLE)
      ? ' The plane proves the same: the two bounds have met.'
      : ' It falls no more.';
  }

  answer() {
    const { status, distance, lowerBound, iterations } = this.result;
    const margins = this.marginA + this.marginB,
      both = `${number(this.marginA)} and ${number(this.marginB)}`;
    const after = `after ${count(iterations, 'iteration')}`;
    if (status === 'Overlapping') {
      const bound = this.steps.at(-1)?.bound;
      const why = margins > 0 && bound > 0 ? `, for |v| = ${number(bound)} is no more than the margins ${both}` : '';
      return `Answer: the shapes intersect${why}, ${after}.`;
    }
    if (distance === null) return `Answer: ${status}, ${after}.`;
    const less = margins > 0 ? ` (|v| less the margins ${both})` : '';
    return `Answer: distance ${number(distance)}${less}, at least ${number(lowerBound)}, ${after}.`;
  }

  withoutSteps() {
    return `No steps: ${this.result.status}.`;
  }
}
