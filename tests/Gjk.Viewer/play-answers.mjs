// What a page answers to the pairs of a table, and its comparison with the table to the last bit.
import assert from 'node:assert/strict';

/** The page's answers to the pairs of all rows. */
export function answersOf(page, question, rows) {
  return page.evaluate(([q, pairs]) => window.__gjk.answers(q, pairs), [question, rows.map(({ a, b }) => [a, b])]);
}

const three = (row, letter) => ['x', 'y', 'z'].map((axis) => row[letter + axis]);

export const distanceRow = (row) => ({
  status: row.status, distance: row.distance, lowerBound: row.lower_bound, pointA: [row.ax, row.ay, row.az],
  pointB: [row.bx, row.by, row.bz], normal: three(row, 'n'), iterations: row.iterations,
});

export const impactRow = (row) => ({
  status: row.status, fraction: row.fraction, point: three(row, 'p'), normal: three(row, 'n'),
  iterations: row.iterations,
});

/** The float's bits; a minus before 0 does not count, and an empty cell is a number that is none. */
function bits(value) {
  if (typeof value === 'string' && value !== '') return value;
  const float = new Float32Array([value === '' ? NaN : value + 0]);
  return Number.isNaN(float[0]) ? 'none' : new Uint32Array(float.buffer)[0];
}

export function assertSame(rows, answers, expected) {
  assert.equal(answers.length, rows.length);
  rows.forEach((row, i) => {
    const flat = (answer) => Object.fromEntries(
      Object.entries(answer).map(([name, value]) => [name, [value].flat().map(bits)]));
    assert.deepEqual(flat(answers[i]), flat(expected(row)), `pair ${row.a},${row.b}: ${JSON.stringify(answers[i])}`);
  });
}
