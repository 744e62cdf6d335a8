import { number, vector } from './data.js';
import { Walk } from './walk.js';

/** Ratio. The textbook's distance is called right if it is no further than this from the exact one. */
const AGREES = 1e-5;

/** The textbook's GJK on the same pair, and each of its steps in words. */
export class TextbookModel extends Walk {
  constructor(json, exact) {
    super(json.steps, exact.unit);
    this.json = json;
    this.exact = exact;
    this.steps.forEach((step, i) => {
      step.same = this.steps.findIndex((other) => other.w.every((x, axis) => x === step.w[axis]));
      step.rises = i > 0 && step.after?.length < 4 && step.upper > this.steps[i - 1].upper;
    });
  }

  /** Whether the textbook gives the exact answer, as far as float can. */
  get isRight() {
    const { distance } = this.json,
      truth = this.exact.result;
    if (truth.status === 'Overlapping') return this.isHit;
    const isApart = this.hasAnswer && !this.isHit && truth.status === 'Separated';
    return isApart && Math.abs(distance - truth.distance) <= AGREES * truth.distance;
  }

  get hasAnswer() {
    return ['NoNearer', 'Encloses', 'Touches'].includes(this.json.ending);
  }

  /** Whether the textbook finds an intersection, of the cores or of their margins. */
  get isHit() {
    return this.hasAnswer && this.json.distance === 0;
  }

  /** The textbook on this pair, in a word. */
  get mark() {
    return this.isRight ? 'right here' : this.hasAnswer ? 'wrong here' : 'fails here';
  }

  story(at) {
    const step = this.steps[at];
    const told = [this.search(at), this.test(at), ...(step.after ? [this.reduction(at)] : [])];
    return [...told.map((text) => ['text', text]), ...(this.isLast(at) ? [['answer', this.answer()]] : [])];
  }

  search(at) {
    const { before, normal, same } = this.steps[at];
    const from = before.length
      ? `d points from the ${this.feature(before)} towards the origin`
      : 'd points from A’s centre to B’s';
    const again = same < at ? ` It is ${this.vertexName(same)} again.` : '';
    const d = vector(normal.map((x) => -x));
    return `Search: ${from}: d = ${d}. The support point is ${this.vertexName(at)}.${again}`;
  }

  test(at) {
    const { after, before, same } = this.steps[at],
      name = this.vertexName(at);
    if (!before.length) return `Test: ${name} is the first vertex.`;
    if (!after) return `Test: ${name} is no further along d than v, so nothing of A − B is.`;
    const why = before.includes(same) ? ' It is a corner of the simplex, so this is rounding alone.' : '';
    return `Test: in float, ${name} is further along d than v. The loop goes on.${why}`;
  }

  reduction(at) {
    const { before, after, upper, rises } = this.steps[at];
    if (after.length === 4) return `Region: behind each face of the ${this.feature(after)}, it seems.`;
    const joined = [...before, at],
      dropped = this.names(joined.filter((i) => !after.includes(i)));
    const rest = dropped.length ? `, without ${dropped.join(' and ')}` : '';
    const more = rises ? ' That is more than before: the loop has gone back.' : '';
    const length = upper === null ? '|v| has left the range of float' : `|v| = ${number(upper)}`;
    return `Region: the simplex is now the ${this.feature(after)}${rest}. ${length}.${more}`;
  }

  answer() {
    return `Answer: ${this.ending()} ${this.verdict()}`;
  }

  ending() {
    const { ending, distance, repeatOf, stepCap } = this.json;
    const last = this.steps.length;
    switch (ending) {
      case 'NoNearer':
        return this.isHit && this.exact.margins > 0
          ? 'the shapes intersect, by their margins.'
          : `distance ${number(distance)}.`;
      case 'Encloses':
        return 'the shapes intersect.';
      case 'Touches':
        return 'the shapes touch.';
      case 'NotFinite':
        return 'none, a number has left the range of float.';
      case 'Repeats':
        return (
          `none. The simplex is that of step ${repeatOf + 1} again. The loop keeps nothing else, ` +
          `so it does steps ${repeatOf + 2} to ${last} for ever.`
        );
      default:
        return `none after ${stepCap} steps. This page stops here; the textbook has no limit.`;
    }
  }

  verdict() {
    const { status, distance } = this.exact.result;
    if (this.isRight) return 'The exact query says the same.';
    const truth =
      status === 'Overlapping' ? 'they intersect' : distance === null ? status : `distance ${number(distance)}`;
    return `Exact: ${truth}.${this.json.ending === 'Encloses' ? this.flatness() : ''}`;
  }

  /** Why a tetrahedron seemed to hold the origin. */
  flatness() {
    const corners = this.steps.at(-1).after.map((i) => this.steps[i].same);
    if (new Set(corners).size === 4) return ' The tetrahedron is so flat that rounding decides on which side it is.';
    return ' Corners of the tetrahedron are one point: it has no inside, and the signs of its face tests are rounding.';
  }
}
