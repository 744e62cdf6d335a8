import { point, short } from './lesson.js';

const names = (after) => after.map(({ step }) => `{w${step + 1}}`).join(' ');
const FEATURES = ['', 'the point', 'the edge', 'the triangle'];

/** What happens in the current stage of a search, in words. */
export function story({ current, model, layers }) {
  return current.isReduced ? reduced(current, model.answer, layers) : support(current, model.answer, layers);
}

function support(step, answer, layers) {
  const n = step.number;
  const where = n === 1 ? 'Begin in {d|a first direction}.' : 'Search from {v} {d|towards the origin}.';
  const found = `${where} {A}'s furthest corner that way is {a${n}}, {B}'s furthest the other way is {b${n}}. Their `
    + `difference {w${n}} = ${point(step.w)} is the furthest point of {A − B} that way.`;
  if (!step.after) return `${found} ${ending(step, answer)}`;
  if (!layers.has('line')) return found;
  if (step.lower <= 0)
    return `${found} {line|The line} through {w${n}} does not keep {A − B} from the {origin}: it proves nothing.`;
  const known = step.best > step.lower ? `, and an earlier line proved ${short(step.best)}` : '';
  return `${found} All of {A − B} lies beyond {line|the line} through {w${n}}: the shapes are `
    + `{at least|at least ${short(step.lower)}} apart${known}.`;
}

function ending(step, answer) {
  if (answer.status !== 'Separated') return 'The {origin} is reached: the shapes overlap. The search ends.';
  return `It is no nearer to the {origin} than {v}, so nothing of {A − B} is. The distance is `
    + `{shortest|${short(answer.distance)}}, and the search ends.`;
}

function reduced({ after, before, nearest, upper }, answer, layers) {
  const count = after.length;
  if (count === 3) {
    return `The {origin} lies in {simplex|the triangle} ${names(after)} or on its side: the shapes share a point. The `
      + 'search ends.';
  }
  const kept = `{simplex|${FEATURES[count]}} ${names(after)}`;
  const dropped = before.length > 0 && before.length + 1 > count;
  const region = before.length === 0 || !layers.has('regions') ? ''
    : `The {origin} lies in {region|the hatched region}, that of ${kept}. `;
  const rest = dropped ? `Only ${kept} is kept: the other corners cannot help. ` : '';
  const sum = layers.has('weights')
    ? ` = ${after.map(({ step, weight }) => `${short(weight)} {w${step + 1}}`).join(' + ')}` : '';
  const isReached = upper === 0 && answer.status === 'Overlapping';
  const end = isReached ? ' The {origin} is reached: the shapes touch or overlap.' : '';
  return `${region}${rest}The point of ${kept} nearest to the {origin} is {v}${sum} = ${point(nearest)}; the shapes are `
    + `at most ${short(upper)} apart.${end}`;
}
