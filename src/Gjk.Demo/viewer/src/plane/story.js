import { number } from '../data.js';

const point = ([x, y]) => `(${number(x)}, ${number(y)})`;
const names = (after) => after.map(({ step }) => `w${step + 1}`).join(' ');
const FEATURES = ['', 'the point', 'the edge', 'the triangle'];

/** What happens in the current stage, in words. */
export function story(model) {
  const { current, answer } = model;
  return current.isReduced ? reduced(current, answer) : support(current, answer);
}

function support(step, answer) {
  const n = step.number, direction = step.normal.map((x) => -x / (Math.hypot(...step.normal) || 1));
  const where = n === 1 ? 'Begin in a first direction' : 'Search from v towards the origin';
  const found = `${where}, ${point(direction)}. A's furthest corner that way is a${n}, B's furthest the other way is `
    + `b${n}. Their difference w${n} = ${point(step.w)} is the furthest point of A − B that way.`;
  if (!step.after) return `${found} ${ending(step, answer)}`;
  if (step.lower <= 0)
    return `${found} The line through w${n} does not keep A − B from the origin: it proves nothing.`;
  const known = step.best > step.lower ? `, and an earlier line proved ${number(step.best)}` : '';
  return `${found} All of A − B lies beyond the line through w${n}: the shapes are at least ${number(step.lower)} `
    + `apart${known}.`;
}

function ending(step, answer) {
  if (answer.status !== 'Separated') return 'The origin is reached: the shapes overlap. The search ends.';
  return `It is no nearer to the origin than v: all of A − B lies beyond the line. The distance is `
    + `${number(answer.distance)}, and the search ends.`;
}

function reduced({ after, before, nearest, upper }, answer) {
  const count = after.length;
  if (count === 3)
    return `The origin lies in the triangle ${names(after)} or on its side: the shapes share a point. The search ends.`;
  const dropped = before.length + 1 > count && before.length > 0;
  const region = before.length === 0 ? ''
    : `The origin lies in the hatched region, that of ${FEATURES[count]} ${names(after)}. `
      + (dropped ? 'The other corners are dropped: they cannot help. ' : '');
  const sum = after.map(({ step, weight }) => `${number(Number(weight.toPrecision(3)))} w${step + 1}`).join(' + ');
  const isReached = upper === 0 && answer.status === 'Overlapping';
  const end = isReached ? ' The origin is reached: the shapes touch or overlap.' : '';
  return `${region}Its point nearest to the origin is v = ${sum} = ${point(nearest)}; the distance is at most `
    + `${number(upper)}.${end}`;
}
