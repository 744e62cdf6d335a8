// Reads the parts of a Wavefront OBJ file (o and g), each as the corners of its faces.

/**
 * The parts: {name, words}.
 * @throws {Error} The text is not such a file.
 */
export function partsOf(text) {
  const vertices = [], parts = new Map();
  let object = '', group = '';
  text.split('\n').forEach((line, i) => {
    const [word, ...rest] = line.split('#')[0].trim().split(/\s+/);
    const wrong = (why) => new Error(`line ${i + 1}: ${why}`);
    if (word === 'o') [object, group] = [rest.join(' '), ''];
    if (word === 'g') group = rest.join(' ');
    if (word === 'v') {
      const at = rest.slice(0, 3).map((x) => Math.fround(Number(x)));
      if (at.length < 3 || !at.every(Number.isFinite)) throw wrong('a vertex needs three finite coordinates');
      vertices.push(at);
    }
    if (word !== 'f') return;
    const name = [object, group === 'default' ? '' : group].filter(Boolean).join('/') || 'default';
    if (!parts.has(name)) parts.set(name, new Set());
    for (const corner of rest) {
      const index = Number(corner.split('/')[0]), at = index < 0 ? vertices.length + index : index - 1;
      if (!vertices[at]) throw wrong(`there is no vertex ${corner}`);
      parts.get(name).add(vertices[at].join(' '));
    }
  });
  if (parts.size === 0 && vertices.length > 0) parts.set('points', new Set(vertices.map((v) => v.join(' '))));
  if (parts.size === 0) throw new Error('there are no vertices in it');
  return [...parts].map(([name, points]) => ({ name, words: `mesh ${points.size} ${[...points].join(' ')}` }));
}
