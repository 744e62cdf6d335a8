// The page's data. It is JSON whose long columns are base64 of little-endian numbers.

function bytes(text) {
  const raw = atob(text);
  const result = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) result[i] = raw.charCodeAt(i);
  return result;
}

export const floats = (text) => new Float32Array(bytes(text).buffer);
export const ints = (text) => new Int32Array(bytes(text).buffer);
export const shorts = (text) => new Uint16Array(bytes(text).buffer);
export { bytes };

export function shape(json) {
  const partStarts = json.partStarts === undefined ? null : ints(json.partStarts);
  const edges = ints(json.edges);
  return { ...json, vertices: floats(json.vertices), triangles: ints(json.triangles), edges, partStarts };
}

/** Formats a number for a reader. It has six digits, and an exponent only if it needs one. */
export function number(x) {
  if (!Number.isFinite(x)) return Number.isNaN(x) ? 'none' : x > 0 ? '∞' : '−∞';
  if (x === 0) return '0';
  const size = Math.abs(x);
  const text =
    size >= 1e6 || size < 1e-4
      ? x.toExponential(4)
      : x
          .toPrecision(6)
          .replace(/(\.\d*?)0+$/, '$1')
          .replace(/\.$/, '');
  return text.replace('-', '−').replace('e−', 'e-').replace('e+', 'e');
}

/** The shortest decimal that reads back as the same float. */
export function exact(x) {
  for (let digits = 1; digits < 9; digits++) {
    const rounded = Number(x.toPrecision(digits));
    if (Math.fround(rounded) === x) return String(rounded);
  }
  return String(Number(x.toPrecision(9)));
}

const fixed = (x) => (Math.abs(x) < 5e-5 ? 0 : x).toFixed(4).replace('-', '−');

/** Formats a vector with four decimals. */
export const vector = (v) => `(${v.map(fixed).join(', ')})`;

/** A point, each coordinate as number formats it; 0 where it is only rounding beside the largest. */
export const point = (v) => {
  const noise = 1e-14 * Math.max(...v.map(Math.abs));
  return `(${v.map((x) => number(Math.abs(x) <= noise ? 0 : x)).join(', ')})`;
};

/** A count with its noun: "1 pair", "2 pairs". */
export const count = (n, noun) => `${n} ${noun}${n === 1 ? '' : 's'}`;
