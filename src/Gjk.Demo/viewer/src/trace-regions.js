import { Vector3 } from 'three';
import { insideFigure, regionFigure } from './figure.js';

/** The faces of a tetrahedron at its newest corner, as places among its corners. */
const FACES = [
  [0, 1, 2],
  [0, 2, 3],
  [0, 3, 1],
];

/**
 * In which region of the simplex the origin lies: a figure of the plane, the words beside it, and the corners of the
 * walls between the regions. The newest corner comes first.
 */
export function regionsOf(model, at) {
  const step = model.steps[at];
  if (!step?.after) return { words: ['This step has ended the loop before a new simplex.'], corners: [] };
  const joined = [at, ...[...step.before].sort((a, b) => a - b)],
    points = joined.map((i) => new Vector3(...model.steps[i].w));
  const names = joined.map((i) => model.vertexName(i));
  const kept = step.after.map((i) => joined.indexOf(i));
  if (joined.length === 1) return { words: ['One vertex is nearest the origin wherever the origin is.'], corners: [] };
  if (joined.length === 4) return tetrahedron(model, joined, points, names, kept);
  return flat(model, joined, points, names, kept, [0, 1, 2].slice(0, joined.length));
}

/** The regions of an edge or of a triangle, both of which all are regions of a plane. */
function flat(model, joined, points, names, kept, places) {
  const corners = places.map((i) => points[i]);
  const { flatten, foot } = plane(corners);
  const shown = corners.map((p, i) => ({ name: names[places[i]], at: flatten(p) }));
  const here = kept
    .map((i) => places.indexOf(i))
    .sort()
    .join('');
  const skipped = places.length === 2 ? ['1'] : ['1', '2', '12'];
  const old = names.slice(1).filter((name) => shown.some((corner) => corner.name === name));
  const [striped, part] =
    old.length === 2
      ? ['Striped regions', `those of ${old.join(', ')} and the edge ${old.join(' ')}, are`]
      : ['The striped region', `that of ${old[0]}, is`];
  return {
    figure: regionFigure(shown, foot, here, skipped),
    corners: corners.map((p) => p.clone().multiplyScalar(model.unit)),
    words: [
      `The origin lies in the region of the ${model.feature(kept.map((i) => joined[i]))}, which is kept.`,
      `${striped}, ${part} not tested: the nearest part was there before, and ${names[0]} lies ` +
        `beyond it towards the origin. So the part that is nearest now has ${names[0]} as a corner.`,
    ],
  };
}

function tetrahedron(model, joined, points, names, kept) {
  const tests = FACES.map((places) => ({ places, isBeyond: isBeyond(points, places) }));
  const told = tests.map(({ places, isBeyond: is }) => {
    return `${places.map((i) => names[i]).join(' ')}: ${is ? 'the origin is beyond it' : 'behind'}`;
  });
  const lead = `Faces at ${names[0]}: ${told.join('; ')}.`;
  const old = `${names.slice(1).join(' ')} is not tested: the origin was found in front of it.`;
  if (kept.length === 4) {
    const seen = `The figure is what ${names[0]} sees: the origin lies within the three faces, which it sees as edges.`;
    const figure = seenFrom(points, names);
    return { figure, words: [`${lead} So the tetrahedron holds the origin. ${old}`, seen], corners: [] };
  }
  const holds = (places) => kept.every((i) => places.includes(i));
  const face = tests.find((test) => test.isBeyond && holds(test.places)) ?? tests.find((test) => holds(test.places));
  if (!face) return { words: [`${lead} ${old}`], corners: [] };
  const shown = flat(model, joined, points, names, kept, face.places);
  return { ...shown, words: [`${lead} ${old}`, ...shown.words] };
}

/** The other corners and the origin as the newest corner sees them: directions, each brought to one plane. */
function seenFrom(points, names) {
  const [eye, ...others] = points;
  const ahead = others
    .reduce((sum, p) => sum.add(p), new Vector3())
    .multiplyScalar(1 / 3)
    .sub(eye);
  const aside = others[0].clone().sub(eye).projectOnPlane(ahead.clone().normalize()).normalize();
  const up = ahead.clone().normalize().cross(aside);
  const flatten = (p) => {
    const to = p.clone().sub(eye),
      depth = to.dot(ahead);
    return [to.dot(aside) / depth, to.dot(up) / depth];
  };
  const corners = others.map((p, i) => ({ name: names[i + 1], at: flatten(p) }));
  return insideFigure(corners, flatten(new Vector3()), names[0]);
}

/** Whether the origin is on the side of a face where the fourth corner is not. */
function isBeyond(points, places) {
  const [a, b, c] = places.map((i) => points[i]);
  const fourth = points[[0, 1, 2, 3].find((i) => !places.includes(i))];
  const normal = b.clone().sub(a).cross(c.clone().sub(a));
  return normal.dot(a) * normal.dot(fourth.clone().sub(a)) > 0;
}

/** A plane's own coordinates: of two points and the origin, or of three points, onto which the origin falls. */
function plane([a, b, c]) {
  const along = b.clone().sub(a).normalize(),
    towards = c ? c.clone().sub(a) : a.clone().negate();
  const aside = towards.clone().addScaledVector(along, -towards.dot(along)).normalize();
  const flatten = (p) => [p.clone().sub(a).dot(along), p.clone().sub(a).dot(aside)];
  return { flatten, foot: flatten(new Vector3()) };
}
