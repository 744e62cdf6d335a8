// The shapes that the playground makes itself, as words of a record.

const extents = (words) => ({
  fields: [['x', 1], ['y', 0.7], ['z', 0.5]], words: ([x, y, z]) => `${words} ${x} ${y} ${z}`,
});
const upright = (word) => ({
  fields: [['radius', 0.6], ['half height', 0.8]], words: ([r, h]) => `${word} ${r} ${h} 0`,
});
const corner = (name, at) => ['x', 'y', 'z'].map((axis, i) => [`${name} ${axis}`, at[i]]);

const GOLD = (1 + Math.sqrt(5)) / 2;
const gem = [[0, 1, GOLD], [1, GOLD, 0], [GOLD, 0, 1]]
  .flatMap((v) => [1, -1].flatMap((s) => [1, -1].map((t) => {
    const signs = [s, t];
    return v.map((x) => (x === 0 ? 0 : x * signs.shift() * 0.5));
  })));

/** Every kind has sizes, which a user may change, and the words that they make. */
export const KINDS = {
  box: extents('box'),
  sphere: { fields: [['radius', 0.8]], words: ([r]) => `point ${r}` },
  capsule: {
    fields: [['radius', 0.4], ['half height', 0.7]], words: ([r, h]) => `segment 0 ${h} 0 0 ${-h} 0 ${r}`,
  },
  cylinder: upright('cylinder'),
  cone: upright('cone'),
  ellipsoid: extents('ellipsoid'),
  'tapered capsule': {
    fields: [['top radius', 0.3], ['bottom radius', 0.6], ['half height', 0.6]],
    words: ([top, bottom, h]) => `taperedcapsule ${top} ${bottom} ${h}`,
  },
  'convex mesh': { fields: [], words: () => `mesh ${gem.length} ${gem.flat().map(Math.fround).join(' ')}` },
  triangle: {
    fields: [...corner('a', [-0.8, -0.5, 0]), ...corner('b', [0.9, -0.4, 0]), ...corner('c', [0, 0.9, 0.2])],
    words: (n) => `triangle ${n.join(' ')}`, isSigned: true,
  },
  segment: {
    fields: [...corner('a', [-0.8, 0, 0]), ...corner('b', [0.8, 0.3, 0])],
    words: (n) => `segment ${n.join(' ')} 0`, isSigned: true,
  },
  point: { fields: [], words: () => 'point 0' },
};

/** A radius that every kind may be rounded by. */
export const ROUNDING = ['rounding', 0];

export const sizesOf = (kind) => [...KINDS[kind].fields, ROUNDING].map(([, value]) => value);

/** The words of a kind with its sizes, the last of which is the rounding. Records hold floats. */
export function wordsFor(kind, sizes) {
  const floats = sizes.map(Math.fround), rounding = floats.at(-1);
  return KINDS[kind].words(floats.slice(0, -1)) + (rounding > 0 ? ` + ${rounding}` : '');
}
