import { BufferAttribute, BufferGeometry, CylinderGeometry, SphereGeometry, Quaternion, Vector3 } from 'three';

/** A cosine. Edges of curved shapes that are sharper than this stay sharp. The angle is 30 degrees. */
const CREASE = 0.866;

/**
 * The surface of a shape. Its vertices are multiplied by the unit in double, so that no size is too small or too large
 * to draw.
 */
export function surface(shape, unit, thickness) {
  const at = corners(shape.vertices, unit);
  if (shape.dimension === 0) return new SphereGeometry(thickness * 2, 16, 12).translate(at[0].x, at[0].y, at[0].z);
  if (shape.dimension === 1) return rod(at[0], at[1], thickness);

  const triangles = shape.triangles;
  const faces = [];
  for (let i = 0; i < triangles.length; i += 3) {
    const a = at[triangles[i]];
    const normal = at[triangles[i + 1]]
      .clone()
      .sub(a)
      .cross(at[triangles[i + 2]].clone().sub(a));
    faces.push({ normal: normal.clone().normalize(), weighted: normal });
  }
  const around = shape.smooth ? facesAround(triangles, at.length) : null;
  const position = new Float32Array(triangles.length * 3);
  const normals = new Float32Array(triangles.length * 3);
  triangles.forEach((vertex, i) => {
    const flat = faces[Math.floor(i / 3)].normal;
    at[vertex].toArray(position, 3 * i);
    (around ? smoothed(flat, around[vertex], faces) : flat).toArray(normals, 3 * i);
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(position, 3));
  geometry.setAttribute('normal', new BufferAttribute(normals, 3));
  return geometry;
}

/** The triangles of one part of a surface or a compound. */
export function partSurface({ vertices, triangles, partStarts }, part, unit) {
  const position = [];
  for (let i = 3 * partStarts[part]; i < 3 * partStarts[part + 1]; i++)
    for (let axis = 0; axis < 3; axis++) position.push(vertices[3 * triangles[i] + axis] * unit);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(position), 3));
  return geometry;
}

/** The sharp edges, as pairs of points; all edges of a surface. */
export function edges(shape, unit) {
  const at = corners(shape.vertices, unit);
  const position = new Float32Array(shape.edges.length * 3);
  shape.edges.forEach((vertex, i) => at[vertex].toArray(position, 3 * i));
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(position, 3));
  return geometry;
}

/** The distance of the furthest vertex from the local origin. */
export function radius(shape, unit) {
  return Math.max(0, ...corners(shape.vertices, unit).map((v) => v.length()));
}

/** A thin cylinder between two points. */
export function rod(a, b, thickness) {
  const along = b.clone().sub(a);
  const geometry = new CylinderGeometry(thickness, thickness, along.length(), 10);
  geometry.applyQuaternion(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), along.clone().normalize()));
  const center = a.clone().addScaledVector(along, 0.5);
  return geometry.translate(center.x, center.y, center.z);
}

function corners(vertices, unit) {
  const result = [];
  for (let i = 0; i < vertices.length; i += 3)
    result.push(new Vector3(vertices[i] * unit, vertices[i + 1] * unit, vertices[i + 2] * unit));
  return result;
}

function facesAround(triangles, count) {
  const around = Array.from({ length: count }, () => []);
  triangles.forEach((vertex, i) => around[vertex].push(Math.floor(i / 3)));
  return around;
}

function smoothed(flat, around, faces) {
  const sum = new Vector3();
  for (const face of around) if (faces[face].normal.dot(flat) > CREASE) sum.add(faces[face].weighted);
  return sum.lengthSq() > 0 ? sum.normalize() : flat;
}
