// Points and convex polygons of the plane, for drawing. What GJK decides, the library decides.

export const plus = ([x, y], [z, w]) => [x + z, y + w];
export const minus = ([x, y], [z, w]) => [x - z, y - w];
export const times = ([x, y], s) => [x * s, y * s];
export const dot = ([x, y], [z, w]) => x * z + y * w;
export const length = (v) => Math.hypot(...v);
export const across = ([x, y]) => [-y, x];
export const turned = ([x, y], angle) => {
  const [sin, cos] = [Math.sin(angle), Math.cos(angle)];
  return [cos * x - sin * y, sin * x + cos * y];
};
const side = (o, a, b) => dot(across(minus(a, o)), minus(b, o));

/** The corners of the hull, counter-clockwise. */
export function hull(points) {
  const sorted = [...points].sort(([x, y], [z, w]) => x - z || y - w);
  const half = (all) => {
    const chain = [];
    for (const p of all) {
      while (chain.length > 1 && side(chain.at(-2), chain.at(-1), p) <= 0) chain.pop();
      chain.push(p);
    }
    return chain.slice(0, -1);
  };
  const result = [...half(sorted), ...half(sorted.reverse())];
  return result.length ? result : points.slice(0, 1);
}

/** The part of a polygon in which all half-planes {normal, least} hold: normal · x >= least. */
export function clip(polygon, halfPlanes) {
  let result = polygon;
  for (const { normal, least } of halfPlanes) {
    const height = (p) => dot(normal, p) - least;
    result = result.flatMap((p, i) => {
      const next = result[(i + 1) % result.length], [h, k] = [height(p), height(next)];
      const cut = h * k < 0 ? [plus(p, times(minus(next, p), h / (h - k)))] : [];
      return h >= 0 ? [p, ...cut] : cut;
    });
  }
  return result;
}

const beyond = (normal, through) => ({ normal, least: dot(normal, through) });

/**
 * The half-planes of a feature's Voronoi region: the points for which it is the nearest feature of a simplex of one to
 * three points. The feature is a list of indices.
 */
export function region(simplex, feature) {
  const others = simplex.map((_, i) => i).filter((i) => !feature.includes(i));
  const planes = [];
  for (const i of feature) {
    // Before an end of an edge, and beyond a corner.
    if (feature.length === 1) for (const k of others) planes.push(beyond(minus(simplex[i], simplex[k]), simplex[i]));
    if (feature.length === 2) {
      const [p, q] = [simplex[i], simplex[feature.find((k) => k !== i)]];
      planes.push(beyond(minus(q, p), p));
    }
  }
  const sides = feature.length === 3 ? [[0, 1, 2], [1, 2, 0], [2, 0, 1]] : [];
  if (feature.length === 2 && others.length) sides.push([...feature, others[0]]);
  for (const [i, k, other] of sides) {
    const along = across(minus(simplex[k], simplex[i]));
    const isInside = dot(along, minus(simplex[other], simplex[i])) > 0;
    planes.push(beyond(times(along, isInside === (feature.length === 3) ? 1 : -1), simplex[i]));
  }
  return planes;
}

/** All features of a simplex. */
export function features(count) {
  const corners = [[0], [1], [2]].slice(0, count);
  return [[], corners, [...corners, [0, 1]], [...corners, [0, 1], [1, 2], [2, 0], [0, 1, 2]]][count];
}
