import { number, vector } from '../data.js';

/** The answer in a few words. */
export function headline({ answer, impact, question }) {
  if (question === 'impact') {
    if (impact.status === 'Hit') return `first touch after ${number(impact.fraction)} of the frame`;
    const text = { Miss: 'no touch in this frame', OverlappingAtStart: 'overlapping at the start' };
    return text[impact.status] ?? impact.status;
  }
  if (answer.status === 'Separated') return `apart by ${number(answer.distance)}`;
  if (answer.status !== 'Overlapping') return answer.status;
  if (question === 'distance') return 'overlapping';
  return answer.distance === 0 ? 'touching' : `overlapping, depth ${number(-answer.distance)}`;
}

const point = (v) => `(${v.map(number).join(', ')})`;

/** The answer as terms with their values. */
export function factsOf({ answer, impact, question, contacts, milliseconds }) {
  const rows = [];
  if (question === 'impact') {
    rows.push(['status', impact.status], ['fraction', number(impact.fraction)]);
    if (impact.status === 'Hit') rows.push(['touch at', point(impact.point)], ['normal', vector(impact.normal)]);
    rows.push(['iterations', String(impact.iterations)]);
  } else {
    const isDeep = answer.status === 'Overlapping' && question === 'signed';
    rows.push(['status', answer.status],
      isDeep ? ['depth', number(-answer.distance)] : ['distance', number(answer.distance)],
      ['proved bound', `≥ ${number(answer.lowerBound)}`],
      [isDeep ? 'deepest of A' : 'point of A', point(answer.pointA)],
      [isDeep ? 'deepest of B' : 'point of B', point(answer.pointB)],
      [isDeep ? 'way out for B' : 'normal', vector(answer.normal)], ['iterations', String(answer.iterations)]);
  }
  if (contacts) rows.push(['contact points', String(contacts.points.length)]);
  return [...rows, ['asked in', `${milliseconds.toFixed(1)} ms`]];
}
