// Plane figures, as SVG that the theme colours.

const SVG = 'http://www.w3.org/2000/svg';

/** Creates an SVG element with attributes and children. */
export function svg(tag, attributes = {}, ...children) {
  const result = document.createElementNS(SVG, tag);
  for (const [key, value] of Object.entries(attributes)) result.setAttribute(key, value);
  result.append(...children);
  return result;
}

const text = (x, y, words, name = '') => svg('text', { x, y, class: name }, words);

/** A closed outline of points [x, y]. */
const outline = (points, name, fill = 'none') =>
  svg('polygon', { points: points.map((p) => p.join(',')).join(' '), class: name, fill });

/** Maps points of a plane into a box of a figure, with the second axis upwards. */
function fitted(points, [left, top, width, height], border) {
  const low = [0, 1].map((axis) => Math.min(...points.map((p) => p[axis])));
  const high = [0, 1].map((axis) => Math.max(...points.map((p) => p[axis])));
  const sizes = [0, 1].map((axis) => high[axis] - low[axis]);
  const scale = Math.min((width - 2 * border) / (sizes[0] || 1), (height - 2 * border) / (sizes[1] || 1));
  const middle = [left + width / 2, top + height / 2];
  return ([x, y]) => [
    middle[0] + scale * (x - (low[0] + high[0]) / 2),
    middle[1] - scale * (y - (low[1] + high[1]) / 2),
  ];
}

const WIDTH = 420,
  HEIGHT = 230,
  BORDER = 52;

/** How far a region is drawn: beyond the figure. */
const FAR = 2000;

/**
 * The regions of an edge or a triangle, seen so that they are regions of the plane. The origin's foot lies in one of
 * them. Each corner is {name, at: [x, y]}; the newest comes first. A region is named by its corners' places.
 */
export function regionFigure(corners, foot, here, skipped) {
  return drawn(corners, foot, corners.length === 2 ? edgeRegions : triangleRegions, here, skipped, []);
}

/** The old triangle of a tetrahedron as its newest corner sees it, with the origin behind or before it. */
export function insideFigure(corners, foot, newest) {
  return drawn(corners, foot, (at) => triangleRegions(at).slice(0, 1), '012', [], [newest]);
}

function drawn(corners, foot, regionsOf, here, skipped, unseen) {
  const place = fitted([...corners.map((c) => c.at), foot], [0, 0, WIDTH, HEIGHT], BORDER);
  const at = corners.map((c) => place(c.at)),
    origin = place(foot);
  const named = ([...places]) => [...unseen, ...places.map((i) => corners[i].name)].join(' ');
  const parts = regionsOf(at).map(({ key, points }) => {
    const name = key === here ? 'region here' : skipped.includes(key) ? 'region skipped' : 'region';
    const shape = outline(points, name, name.endsWith('skipped') ? 'url(#skipped)' : 'none');
    shape.dataset.region = named(key);
    return shape;
  });
  const lines = outline(at, 'simplex');
  const dots = at.map(([cx, cy], i) =>
    svg('circle', { cx, cy, r: i ? 4 : 5, class: i || unseen.length ? 'old' : 'newest' }),
  );
  const middle = [0, 1].map((axis) => at.reduce((sum, p) => sum + p[axis], 0) / at.length);
  const names = at.map(([x, y], i) => {
    const away = [x - middle[0], y - middle[1]],
      length = Math.hypot(...away) || 1;
    return text(x + (18 * away[0]) / length, y + (18 * away[1]) / length + 4, corners[i].name);
  });
  return svg(
    'svg',
    { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: 'figure regions', role: 'img', 'aria-label': 'Voronoi regions' },
    hatch(),
    ...parts,
    lines,
    ...dots,
    ...names,
    ...originMark(origin),
  );
}

function originMark([cx, cy]) {
  const isHigh = cy < 24;
  return [svg('circle', { cx, cy, r: 5, class: 'origin' }), text(cx, cy + (isHigh ? 18 : -10), 'origin', 'strong')];
}

const hatch = () =>
  svg(
    'defs',
    {},
    svg(
      'pattern',
      { id: 'skipped', width: 7, height: 7, patternUnits: 'userSpaceOnUse', patternTransform: 'rotate(45)' },
      svg('path', { d: 'M0 0V7', class: 'stripe' }),
    ),
  );

/** The strips beyond each end of an edge, and the one beside it. */
function edgeRegions([a, b]) {
  const along = unit([b[0] - a[0], b[1] - a[1]]),
    across = [-along[1] * FAR, along[0] * FAR];
  const strip = (p, q) => [plus(p, across), plus(q, across), plus(q, across, -1), plus(p, across, -1)];
  return [
    { key: '0', points: strip(plus(a, along, -FAR), a) },
    { key: '1', points: strip(b, plus(b, along, FAR)) },
    { key: '01', points: strip(a, b) },
  ];
}

/** The triangle itself, the strips beside its edges, and the wedges at its corners. */
function triangleRegions(at) {
  const turn = Math.sign(cross(minus(at[1], at[0]), minus(at[2], at[0]))) || 1;
  const outwards = (p, q) => {
    const [x, y] = unit(minus(q, p));
    return [y * turn * FAR, -x * turn * FAR];
  };
  const regions = [{ key: '012', points: at }];
  for (const [i, j] of [
    [0, 1],
    [1, 2],
    [2, 0],
  ]) {
    const out = outwards(at[i], at[j]);
    const key = [i, j].sort().join('');
    regions.push({ key, points: [at[i], plus(at[i], out), plus(at[j], out), at[j]] });
  }
  for (const [h, i, j] of [
    [2, 0, 1],
    [0, 1, 2],
    [1, 2, 0],
  ]) {
    const before = outwards(at[h], at[i]),
      after = outwards(at[i], at[j]);
    const corner = plus(plus(at[i], before), after);
    regions.push({ key: String(i), points: [at[i], plus(at[i], before), corner, plus(at[i], after)] });
  }
  return regions;
}

/**
 * What A − B is, in the plane: two polygons with the differences of all their corners, and the arrow from the nearest
 * point of B to that of A, which is the arrow from the origin to A − B.
 */
export function differenceFigure() {
  const a = [
      [0, 0],
      [2, 0.4],
      [0.8, 1.8],
    ],
    b = [
      [3.4, 0.9],
      [4.8, 0.7],
      [4.9, 2],
      [3.5, 2.1],
    ];
  const differences = hull(a.flatMap((p) => b.map((q) => minus(p, q))));
  const left = fitted([...a, ...b], [0, 0, 210, HEIGHT], 22);
  const right = fitted([...differences, [0, 0]], [210, 0, 210, HEIGHT], 26);
  const onA = [2, 0.4],
    onB = nearestOnEdge(onA, b[0], b[3]),
    v = minus(onA, onB);
  const line = (map, p, q) => {
    const [[x1, y1], [x2, y2]] = [map(p), map(q)];
    return svg('line', { x1, y1, x2, y2, class: 'nearest' });
  };
  const label = (map, p, words, name) => text(...map(p), words, name);
  return svg(
    'svg',
    { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: 'figure', role: 'img', 'aria-label': 'A, B and A minus B' },
    outline(a.map(left), 'a'),
    outline(b.map(left), 'b'),
    line(left, onB, onA),
    outline(differences.map(right), 'difference'),
    line(right, [0, 0], v),
    ...originMark(right([0, 0])),
    label(left, [0.9, 0.75], 'A', 'strong'),
    label(left, [4.2, 1.4], 'B', 'strong'),
    label(right, [-3.3, -0.55], 'A − B', 'strong'),
  );
}

function nearestOnEdge(p, from, to) {
  const along = minus(to, from);
  const share = dot(minus(p, from), along) / dot(along, along);
  return plus(from, along, Math.max(0, Math.min(1, share)));
}

/** The convex hull of points of the plane, turning one way (Andrew's chain). */
function hull(points) {
  const sorted = [...points].sort((p, q) => p[0] - q[0] || p[1] - q[1]);
  const chain = (all) => {
    const kept = [];
    for (const p of all) {
      while (kept.length > 1 && cross(minus(kept.at(-1), kept.at(-2)), minus(p, kept.at(-1))) <= 0) kept.pop();
      kept.push(p);
    }
    return kept.slice(0, -1);
  };
  return [...chain(sorted), ...chain(sorted.reverse())];
}

const minus = (p, q) => [p[0] - q[0], p[1] - q[1]];
const plus = (p, q, times = 1) => [p[0] + times * q[0], p[1] + times * q[1]];
const dot = (p, q) => p[0] * q[0] + p[1] * q[1];
const cross = (p, q) => p[0] * q[1] - p[1] * q[0];

function unit(p) {
  const length = Math.hypot(...p) || 1;
  return [p[0] / length, p[1] / length];
}
