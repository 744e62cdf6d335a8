// A query as C#.

/** The most corners of a mesh that are written out, and the most characters of a record. */
const MOST_CORNERS = 64, MOST_RECORD = 4000;

/** The shortest text that a float is read back from. */
export function floatText(value) {
  for (let digits = 1; digits <= 9; digits++) {
    const text = Number(value.toPrecision(digits));
    if (Math.fround(text) === Math.fround(value)) return String(text).replace('e+', 'e');
  }
  return String(value);
}

const literal = (value) => floatText(value) + (Number.isInteger(value) && Math.abs(value) < 1e7 ? '' : 'f');
const list = (numbers) => numbers.map(literal).join(', ');
const vector = (numbers) => `new Vector3(${list(numbers)})`;
const pose = (n) => `new RigidPose(new Quaternion(${list(n.slice(0, 4))}), ${vector(n.slice(4, 7))})`;

const DECORATORS = {
  '*': { count: 3, code: (n) => `.Scaled(${vector(n)})` },
  '+': { count: 1, code: (n) => `.Rounded(${literal(n[0])})` },
  '>': { count: 7, code: (n) => `.Placed(${pose(n)})` },
};

/**
 * A shape's words as an expression, or null where it is too long to write out, where a scale made numbers that no
 * float can hold, or where the kind is none of those here (a half-space).
 */
export function shapeCode(words) {
  const [kind, ...rest] = words.split(' ');
  const end = rest.findIndex((word) => '*+>'.includes(word));
  const own = (end < 0 ? rest : rest.slice(0, end)).map(Number);
  if (kind === 'mesh' && own[0] > MOST_CORNERS) return null;
  if (rest.some((word) => !'*+>'.includes(word) && Math.fround(word) !== Number(word))) return null;
  const core = coreCode(kind, own);
  return core && core + (end < 0 ? '' : decorations(rest.slice(end)));
}

function coreCode(kind, n) {
  const [a, b, c] = [n.slice(0, 3), n.slice(3, 6), n.slice(6, 9)];
  switch (kind) {
    case 'point': return n[0] > 0 ? `ConvexShape.Sphere(${literal(n[0])})` : 'ConvexShape.Point()';
    case 'segment': return segmentCode(a, b, n[6]);
    case 'triangle': return `ConvexShape.Triangle(${[a, b, c].map(vector).join(', ')})`;
    case 'box': return `ConvexShape.Box(${vector(a)})`;
    case 'ellipsoid': return `ConvexShape.Ellipsoid(${vector(a)})`;
    case 'cylinder': return `ConvexShape.Cylinder(${list(a.slice(0, 2))})`;
    case 'cone': return `ConvexShape.Cone(${list(a.slice(0, 2))})`;
    case 'taperedcapsule': return `ConvexShape.TaperedCapsule(${list(a)})`;
    case 'mesh': return `ConvexShape.Mesh(new Vector3[]\n{\n${corners(n.slice(1))}})`;
    default: return null;
  }
}

function segmentCode(a, b, radius) {
  const isUpright = a[0] === 0 && a[2] === 0 && b.every((x, i) => x === -a[i]) && a[1] > 0;
  if (radius > 0 && isUpright) return `ConvexShape.Capsule(${literal(radius)}, ${literal(a[1])})`;
  return `ConvexShape.Segment(${vector(a)}, ${vector(b)})` + (radius > 0 ? `.Rounded(${literal(radius)})` : '');
}

function corners(numbers) {
  let text = '';
  for (let i = 0; i < numbers.length; i += 3) text += `    new(${list(numbers.slice(i, i + 3))}),\n`;
  return text;
}

function decorations(words) {
  let text = '';
  for (let i = 0; i < words.length;) {
    const { count, code } = DECORATORS[words[i]];
    text += code(words.slice(i + 1, i + 1 + count).map(Number));
    i += 1 + count;
  }
  return text;
}

const CALLS = {
  distance: 'DistanceResult result = ConvexQuery.Distance(a, poseA, b, poseB);',
  signed: 'DistanceResult result = ConvexQuery.SignedDistance(a, poseA, b, poseB);',
  cast: 'CastResult result = ConvexQuery.Cast(a, poseA, velocityA, b, poseB, velocityB);',
  turning: `CastResult result = ConvexQuery.TimeOfImpact(
    a, new RigidMotion(poseA, velocityA, spinA), b, new RigidMotion(poseB, velocityB, spinB));`,
};

/** The query of two bodies {words, motion} as a program. Their record stands in for shapes that are no code. */
export function queryCode(question, bodies, record) {
  const codes = bodies.map(({ words }) => shapeCode(words));
  const isShort = codes.every(Boolean);
  const turns = bodies.some(({ motion }) => motion.slice(10).some((x) => x !== 0));
  const lines = ['using System;', 'using System.IO;', 'using System.Numerics;', 'using Gjk.Core;'];
  const isFile = !isShort && record.length > MOST_RECORD;
  if (!isFile) lines.splice(1, 1);
  if (!isShort) lines.push('using Gjk.Core.Diagnostics;');
  lines.push('');
  if (!isShort) {
    if (isFile) lines.push('// The record of this query, in a file.');
    const text = isFile ? 'File.ReadAllText("pair.txt")' : `\n    "${record}"`;
    lines.push(`QueryRecord pair = QueryRecord.Parse(${text});`);
  }
  bodies.forEach(({ motion }, i) => {
    const letter = 'ab'[i], capital = 'AB'[i];
    lines.push(`ConvexShape ${letter} = ${isShort ? codes[i] : `pair.${capital}`};`);
    lines.push(`var pose${capital} = ${pose(motion)};`);
    if (question !== 'impact') return;
    lines.push(`var velocity${capital} = ${vector(motion.slice(7, 10))};`);
    if (turns) lines.push(`var spin${capital} = ${vector(motion.slice(10))};`);
  });
  lines.push(CALLS[question === 'impact' ? (turns ? 'turning' : 'cast') : question], 'Console.WriteLine(result);');
  return `${lines.join('\n')}\n`;
}
