import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  SphereGeometry,
  Vector3,
} from 'three';
import { arrow as solidArrow } from './arrows.js';
import { ARROW, DOT, ORIGIN, ROD, addPlane, addSimplex, arrow, dot } from './marks.js';
import { COLORS } from './theme.js';

/** A surface of more corners is drawn without a dot at each of them. */
const MOST_DOTS = 60;

/** The head of the way out, in units. */
const HEAD = 0.6;

/**
 * Draws a step of the search for the depth, and returns its labels: the surface, its lowest face, the ball inside, and
 * the support point.
 */
export function addSurface(group, depth, at, size, planeRadius) {
  const step = depth.steps[at],
    faces = depth.surface(at);
  const labels = [['origin', ORIGIN]];
  addFaces(
    group,
    [...faces.values()].map((corners) => corners.map((i) => depth.point(i))),
  );
  const corners = new Set([...faces.values()].flat());
  if (corners.size <= MOST_DOTS)
    for (const i of corners) group.add(dot(depth.point(i), COLORS.simplex, DOT * 0.6 * size));
  if (step.below > 0) {
    const skin = new MeshLambertMaterial({ color: COLORS.nearest, transparent: true, opacity: 0.3, depthWrite: false });
    group.add(new Mesh(new SphereGeometry(step.below * depth.unit, 40, 28), skin));
  }
  if (step.lowest === undefined) return labels;

  const lowest = faces.get(step.lowest),
    points = lowest.map((i) => depth.point(i));
  addSimplex(group, points, COLORS.lowest, 0.5, ROD * size);
  const n = new Vector3(...step.normal),
    w = depth.point(step.vertex);
  const middle = points.reduce((sum, p) => sum.add(p), new Vector3()).multiplyScalar(1 / 3);
  addPlane(group, w, n, planeRadius);
  group.add(dot(w, COLORS.vertex, DOT * size));
  if (!depth.ends(at)) {
    const length = ARROW * 0.7 * size;
    group.add(arrow(middle, n, COLORS.vertex, length));
    labels.push(['n', middle.clone().addScaledVector(n, length)]);
  }
  for (const i of new Set([...lowest, step.vertex])) labels.push([depth.name(i), depth.point(i)]);
  return labels;
}

/** Draws the shortest way out, visible through everything, and returns its label. */
export function addWayOut(group, from, to, size) {
  if (from.distanceTo(to) > 0) {
    for (const geometry of solidArrow(from, to, ROD * 1.6 * size, HEAD * size)) {
      const mesh = new Mesh(
        geometry,
        new MeshBasicMaterial({ color: COLORS.out, depthTest: false, transparent: true }),
      );
      mesh.renderOrder = 3;
      group.add(mesh);
    }
  }
  return ['way out', to];
}

function addFaces(group, triangles) {
  const position = new Float32Array(triangles.length * 9),
    lines = [];
  triangles.forEach((corners, i) => {
    corners.forEach((p, k) => {
      p.toArray(position, 9 * i + 3 * k);
      lines.push(...p, ...corners[(k + 1) % 3]);
    });
  });
  const faces = new BufferGeometry(),
    edges = new BufferGeometry();
  faces.setAttribute('position', new BufferAttribute(position, 3));
  faces.computeVertexNormals();
  edges.setAttribute('position', new BufferAttribute(new Float32Array(lines), 3));
  group.add(
    new Mesh(
      faces,
      new MeshLambertMaterial({
        color: COLORS.simplex,
        transparent: true,
        opacity: 0.32,
        side: DoubleSide,
        depthWrite: false,
      }),
    ),
    new LineSegments(
      edges,
      new LineBasicMaterial({ color: COLORS.simplex, transparent: true, opacity: triangles.length > 200 ? 0.35 : 0.9 }),
    ),
  );
}
