import {
  BufferAttribute,
  BufferGeometry,
  CircleGeometry,
  DoubleSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  Quaternion,
  SphereGeometry,
  Vector3,
} from 'three';
import { arrow as solidArrow } from './arrows.js';
import { rod } from './geometry.js';
import { COLORS } from './theme.js';

/** In units. The Minkowski difference reaches about 10 from the origin. */
export const DOT = 0.16,
  ROD = 0.05,
  ARROW = 2.6,
  THIN = 0.03;

/** The height of a wall, as a share of its edge. */
const WALL = 0.3;

export const ORIGIN = new Vector3();

export function dot(at, color, size) {
  return new Mesh(new SphereGeometry(size, 20, 14).translate(at.x, at.y, at.z), new MeshBasicMaterial({ color }));
}

export function arrow(from, direction, color, length) {
  const to = from.clone().addScaledVector(direction.clone().normalize(), length);
  const parts = solidArrow(from, to, length * 0.02, length * 0.24);
  return new Group().add(...parts.map((geometry) => new Mesh(geometry, new MeshBasicMaterial({ color }))));
}

export function addPlane(group, at, normal, radius, color = COLORS.plane) {
  const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), normal);
  const disc = new Mesh(
    new CircleGeometry(radius, 64),
    new MeshBasicMaterial({
      color,
      transparent: true,
      opacity: 0.16,
      side: DoubleSide,
      depthWrite: false,
    }),
  );
  disc.quaternion.copy(turn);
  disc.position.copy(at);
  group.add(disc);
}

/** Draws the walls between the Voronoi regions of an edge or a triangle: they stand on its ends or on its edges. */
export function addWalls(group, corners) {
  if (corners.length === 2) {
    const along = corners[1].clone().sub(corners[0]);
    const radius = Math.max(WALL * along.length(), ARROW);
    for (const at of corners) addPlane(group, at, along.clone().normalize(), radius, COLORS.old);
  }
  if (corners.length !== 3) return;
  const [a, b, c] = corners;
  const normal = b.clone().sub(a).cross(c.clone().sub(a)).normalize();
  corners.forEach((p, i) => {
    const q = corners[(i + 1) % 3],
      up = normal.clone().multiplyScalar(Math.max(WALL * p.distanceTo(q), ARROW));
    const [low, high] = [[p, q].map((at) => at.clone().sub(up)), [p, q].map((at) => at.clone().add(up))];
    group.add(sheet(low[0], low[1], high[1], COLORS.old, 0.1), sheet(low[0], high[1], high[0], COLORS.old, 0.1));
  });
}

/** Draws edges as rods and faces as thin sheets. */
export function addSimplex(group, points, color, opacity, thickness) {
  for (let i = 0; i < points.length; i++) {
    for (let j = 0; j < i; j++) {
      if (points[i].distanceTo(points[j]) > 0)
        group.add(new Mesh(rod(points[i], points[j], thickness), new MeshBasicMaterial({ color })));
      for (let k = 0; k < j; k++) group.add(sheet(points[i], points[j], points[k], color, opacity));
    }
  }
}

export function sheet(a, b, c, color, opacity) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array([...a, ...b, ...c]), 3));
  return new Mesh(
    geometry,
    new MeshBasicMaterial({ color, transparent: true, opacity, side: DoubleSide, depthWrite: false }),
  );
}
