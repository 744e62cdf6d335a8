import {
  ArrowHelper, BufferAttribute, BufferGeometry, CircleGeometry, DoubleSide, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, MeshLambertMaterial,
  Quaternion, SphereGeometry, Vector3,
} from 'three';
import { edges, rod, surface } from './geometry.js';
import { Labels } from './labels.js';

export const COLORS = { a: 0x5b9bff, b: 0xc77dff, vertex: 0xffd166, simplex: 0xff8c61, nearest: 0xffffff, plane: 0x4cc9f0, old: 0x97a3b4 };

/** In units. The Minkowski difference reaches about 10 from the origin. */
const DOT = 0.16, ROD = 0.05, ARROW = 2.6, THIN = 0.03;

const ORIGIN = new Vector3();

/** The Minkowski difference around the origin, with the simplex inside. */
export class DifferenceView {
  constructor(stage, model) {
    this.stage = stage;
    this.model = model;
    this.labels = new Labels(stage);
    this.changing = new Group();
    stage.scene.add(this.changing, dot(ORIGIN, 0xffffff, DOT * 0.9));
    this.addDifference(model.difference);
    stage.fit(this.balls());
  }

  addDifference(difference) {
    const skin = new MeshLambertMaterial({ color: 0x8aa4d6, transparent: true, opacity: 0.16, side: DoubleSide, depthWrite: false });
    this.stage.scene.add(new Mesh(surface(difference, 1, THIN), skin));
    if (difference.dimension < 2) return;
    const lines = new LineBasicMaterial({ color: 0x8aa4d6, transparent: true, opacity: difference.edges.length > 400 ? 0.16 : 0.45 });
    this.stage.scene.add(new LineSegments(edges(difference, 1), lines));
  }

  balls() {
    const v = this.model.difference.vertices;
    const balls = [{ center: ORIGIN, radius: DOT }];
    for (let i = 0; i < v.length; i += 3) balls.push({ center: new Vector3(v[i], v[i + 1], v[i + 2]), radius: DOT });
    return balls;
  }

  /** The size of the marks. It suits a small difference far from the origin and a large one around it. */
  get size() {
    return Math.max(0.35, Math.min(1, this.stage.camera.position.distanceTo(this.stage.controls?.target ?? ORIGIN) / 26));
  }

  show(at) {
    const { model, changing } = this;
    changing.clear();
    const step = model.steps[at];
    if (!step) return this.finish([['origin', ORIGIN]]);
    const w = model.drawn(step.w), n = new Vector3(...step.normal), size = this.size;
    const point = (i) => model.drawn(model.steps[i].w);
    for (const i of step.before) changing.add(dot(point(i), COLORS.old, DOT * 0.8 * size));
    addSimplex(changing, step.before.map(point), COLORS.old, 0.1, ROD * 0.6 * size);
    const from = step.before.length ? this.nearestBefore(at) : n.clone().multiplyScalar(Math.max(w.dot(n), 0) + ARROW);
    changing.add(arrow(from, n.clone().negate(), COLORS.vertex, ARROW * size));
    addPlane(changing, w, n, this.planeRadius());
    changing.add(dot(w, COLORS.vertex, DOT * size));
    const labels = [['origin', ORIGIN], ...step.before.map((i) => [`w${i + 1}`, point(i)]), [`w${at + 1}`, w]];
    if (step.after) {
      addSimplex(changing, step.after.map(point), COLORS.simplex, 0.38, ROD * size);
      for (const i of step.after) if (i !== at) changing.add(dot(point(i), COLORS.simplex, DOT * size));
    }
    const nearest = step.after ? (step.after.length === 4 ? ORIGIN : model.drawn(step.nearest)) : this.nearestBefore(at);
    if (nearest.length() > 0) {
      changing.add(new Mesh(rod(ORIGIN, nearest, ROD * 0.8 * size), new MeshBasicMaterial({ color: COLORS.nearest })), dot(nearest, COLORS.nearest, DOT * 0.7 * size));
      labels.push(['v', nearest.clone().multiplyScalar(0.5)]);
    }
    this.finish(labels);
  }

  /** The point of the simplex that was nearest to the origin when a step began. */
  nearestBefore(at) {
    for (let i = at - 1; i >= 0; i--) if (this.model.steps[i].after) return this.model.drawn(this.model.steps[i].nearest);
    return ORIGIN.clone();
  }

  planeRadius() {
    return 0.3 * Math.max(...this.balls().map(({ center }) => center.length()), 1);
  }

  finish(labels) {
    this.labels.set(labels);
    this.stage.drawNow();
  }
}

/** The two shapes with the support points of a step. */
export class ShapesView {
  constructor(stage, model) {
    this.stage = stage;
    this.model = model;
    this.changing = new Group();
    const a = this.body(model.shapeA, COLORS.a), b = this.body(model.shapeB, COLORS.b);
    b.position.copy(model.drawn(model.position));
    b.quaternion.copy(model.rotationB);
    stage.scene.add(a, b, this.changing);
    stage.fit([...this.corners(model.shapeA, a), ...this.corners(model.shapeB, b)]);
  }

  body(shape, color) {
    const group = new Group();
    group.add(new Mesh(surface(shape, this.model.unit, THIN * 3), new MeshLambertMaterial({ color, transparent: true, opacity: 0.55, side: DoubleSide, depthWrite: false })));
    if (shape.dimension > 1 && shape.edges.length < 400) group.add(new LineSegments(edges(shape, this.model.unit), new LineBasicMaterial({ color })));
    return group;
  }

  corners(shape, group) {
    const balls = [];
    group.updateMatrixWorld();
    for (let i = 0; i < shape.vertices.length; i += 3) balls.push({ center: this.model.drawn(Array.from(shape.vertices.subarray(i, i + 3))).applyMatrix4(group.matrixWorld), radius: DOT });
    return balls;
  }

  show(at) {
    const { model, changing } = this;
    changing.clear();
    const step = model.steps[at];
    if (step) {
      const n = new Vector3(...step.normal), onA = model.drawn(step.onA), onB = model.drawn(step.onB);
      changing.add(dot(onA, COLORS.vertex, DOT), dot(onB, COLORS.vertex, DOT));
      changing.add(arrow(onA, n.clone().negate(), COLORS.vertex, ARROW * 0.8), arrow(onB, n, COLORS.vertex, ARROW * 0.8));
      const last = model.steps.slice(0, at + 1).findLast((s) => s.after);
      if (last) {
        const [a, b] = model.witnesses(last);
        if (a.distanceTo(b) > 1e-6) changing.add(new Mesh(rod(a, b, ROD), new MeshBasicMaterial({ color: COLORS.nearest })));
        changing.add(dot(a, COLORS.nearest, DOT * 0.7), dot(b, COLORS.nearest, DOT * 0.7));
      }
    }
    // The marks lie on the shapes, and often inside them. So they are drawn visible through the shapes.
    changing.traverse((mark) => {
      if (!mark.material) return;
      mark.material.depthTest = false;
      mark.material.transparent = true;
      mark.renderOrder = 2;
    });
    this.stage.drawNow();
  }
}

function dot(at, color, size) {
  return new Mesh(new SphereGeometry(size, 20, 14).translate(at.x, at.y, at.z), new MeshBasicMaterial({ color }));
}

function arrow(from, direction, color, length) {
  return new ArrowHelper(direction.clone().normalize(), from, length, color, length * 0.22, length * 0.11);
}

function addPlane(group, at, normal, radius) {
  const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), normal);
  const disc = new Mesh(new CircleGeometry(radius, 64), new MeshBasicMaterial({ color: COLORS.plane, transparent: true, opacity: 0.16, side: DoubleSide, depthWrite: false }));
  disc.quaternion.copy(turn);
  disc.position.copy(at);
  group.add(disc);
}

/** Draws edges as rods and faces as thin sheets. */
function addSimplex(group, points, color, opacity, thickness) {
  for (let i = 0; i < points.length; i++) {
    for (let j = 0; j < i; j++) {
      if (points[i].distanceTo(points[j]) > 0) group.add(new Mesh(rod(points[i], points[j], thickness), new MeshBasicMaterial({ color })));
      for (let k = 0; k < j; k++) group.add(sheet(points[i], points[j], points[k], color, opacity));
    }
  }
}

function sheet(a, b, c, color, opacity) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array([...a, ...b, ...c]), 3));
  return new Mesh(geometry, new MeshBasicMaterial({ color, transparent: true, opacity, side: DoubleSide, depthWrite: false }));
}
