import {
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  Quaternion,
  Vector3,
} from 'three';
import { addSurface, addWayOut } from './depth-view.js';
import { edges, rod, surface } from './geometry.js';
import { Labels } from './labels.js';
import { ARROW, DOT, ORIGIN, ROD, THIN, addPlane, addSimplex, addWalls, arrow, dot } from './marks.js';
import { COLORS, themed } from './theme.js';

/** The Minkowski difference around the origin, with the simplex inside, and then the surface that grows in it. */
export class DifferenceView {
  constructor(stage, model) {
    this.stage = stage;
    this.model = model;
    this.labels = new Labels(stage);
    this.changing = new Group();
    const origin = dot(ORIGIN, COLORS.nearest, DOT * 0.9);
    themed(origin.material, 'nearest');
    stage.scene.add(this.changing, origin);
    this.addDifference(model.difference);
    this.reset();
  }

  reset() {
    this.stage.look = null;
    this.stage.fit([...this.balls(), ...this.rims()]);
  }

  addDifference(difference) {
    const skin = new MeshLambertMaterial({
      transparent: true,
      opacity: 0.16,
      side: DoubleSide,
      depthWrite: false,
    });
    this.stage.scene.add(new Mesh(surface(difference, 1, THIN), themed(skin, 'skin')));
    if (difference.dimension < 2) return;
    const lines = new LineBasicMaterial({
      transparent: true,
      opacity: difference.edges.length > 400 ? 0.16 : 0.45,
    });
    this.stage.scene.add(new LineSegments(edges(difference, 1), themed(lines, 'skin')));
  }

  balls() {
    const v = this.model.difference.vertices;
    const balls = [{ center: ORIGIN, radius: DOT }];
    const out = this.model.depth?.wayOut;
    if (out) balls.push({ center: out, radius: DOT });
    for (let i = 0; i < v.length; i += 3) balls.push({ center: new Vector3(v[i], v[i + 1], v[i + 2]), radius: DOT });
    return balls;
  }

  /** The ends of the support planes: a step's plane must not be cut off by the picture. */
  rims() {
    const radius = this.planeRadius(), { model } = this;
    return model.steps.flatMap((step) => {
      const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(...step.normal));
      return Array.from({ length: 8 }, (_, i) => ({
        center: new Vector3(Math.cos(i * Math.PI / 4), Math.sin(i * Math.PI / 4), 0).multiplyScalar(radius)
          .applyQuaternion(turn).add(model.drawn(step.w)),
        radius: 0,
      }));
    });
  }

  /** The size of the marks. It suits a small difference far from the origin and a large one around it. */
  get size() {
    return Math.max(
      0.35,
      Math.min(1, this.stage.camera.position.distanceTo(this.stage.controls?.target ?? ORIGIN) / 26),
    );
  }

  /** Draws a step of a walk up to a stage, with the walls between the regions of some corners. */
  show(walk, at, stage, walls) {
    const { changing } = this;
    clear(changing);
    const labels = walk.isDepth(at) ? this.showSurface(walk, at) : this.showSimplex(walk, at, stage);
    addWalls(changing, walls);
    if (walk.isLast(at) && walk.depth?.wayOut) labels.push(addWayOut(changing, ORIGIN, walk.depth.wayOut, this.size));
    this.labels.set(labels);
    this.stage.drawNow();
  }

  showSurface(walk, at) {
    return addSurface(this.changing, walk.depth, at - walk.steps.length, this.size, this.planeRadius());
  }

  /** The stages: 0 the simplex before, 1 the search, 2 its plane, 3 and 4 the new simplex, 5 its nearest point. */
  showSimplex(walk, at, stage) {
    const { changing, size } = this;
    const step = walk.steps[at];
    if (!step) return [['origin', ORIGIN]];
    const w = walk.drawn(step.w),
      n = new Vector3(...step.normal),
      d = n.clone().negate();
    const point = (i) => walk.drawn(walk.steps[i].w);
    const labels = new Map([['origin', ORIGIN], ...step.before.map((i) => [walk.vertexName(i), point(i)])]);
    for (const i of step.before) changing.add(dot(point(i), COLORS.old, DOT * 0.8 * size));
    addSimplex(changing, step.before.map(point), COLORS.old, 0.1, ROD * 0.6 * size);
    const from = step.before.length ? nearestBefore(walk, at) : n.clone().multiplyScalar(Math.max(w.dot(n), 0) + ARROW);
    if (stage > 1) addPlane(changing, w, n, this.planeRadius());
    if (stage > 0) {
      changing.add(arrow(from, d, COLORS.vertex, ARROW * size), dot(w, COLORS.vertex, DOT * size));
      labels.set(walk.vertexName(at), w);
    }
    if (stage > 3 && step.after) {
      addSimplex(changing, step.after.map(point), COLORS.simplex, 0.38, ROD * size);
      for (const i of step.after) if (i !== at) changing.add(dot(point(i), COLORS.simplex, DOT * size));
    }
    if (stage > 4 && step.after?.length !== 4) {
      this.addNearest(step.after ? walk.drawn(step.nearest) : nearestBefore(walk, at), labels);
    }
    if (stage > 0) labels.set('d', from.addScaledVector(d, ARROW * size * 0.7));
    return [...labels];
  }

  addNearest(nearest, labels) {
    if (!(nearest.length() > 0)) return;
    const white = new MeshBasicMaterial({ color: COLORS.nearest });
    this.changing.add(
      new Mesh(rod(ORIGIN, nearest, ROD * 0.8 * this.size), white),
      dot(nearest, COLORS.nearest, DOT * 0.7 * this.size),
    );
    labels.set('v', nearest.clone().multiplyScalar(0.5));
  }

  planeRadius() {
    return 0.3 * Math.max(...this.balls().map(({ center }) => center.length()), 1);
  }
}

/** The two shapes with the support points of a step. */
export class ShapesView {
  constructor(stage, model) {
    this.stage = stage;
    this.model = model;
    this.changing = new Group();
    this.labels = new Labels(stage);
    const a = this.body(model.shapeA, 'a'),
      b = this.body(model.shapeB, 'b');
    b.position.copy(model.drawn(model.position));
    b.quaternion.copy(model.rotationB);
    stage.scene.add(a, b, this.changing);
    const balls = [...this.corners(model.shapeA, a), ...this.corners(model.shapeB, b)];
    if (model.depth?.wayOut) {
      // B as it is after the way out.
      this.moved = this.body(model.shapeB, 'b', 0.3);
      this.moved.position.copy(b.position).add(model.depth.wayOut);
      this.moved.quaternion.copy(b.quaternion);
      stage.scene.add(this.moved);
      balls.push(...this.corners(model.shapeB, this.moved));
    }
    this.balls = balls;
    this.names = [
      ['A', model.drawn([0, 0, 0])],
      ['B', b.position],
    ];
    this.reset();
  }

  reset() {
    this.stage.look = null;
    this.stage.fit(this.balls);
  }

  body(shape, color, share = 1) {
    const group = new Group(),
      { unit } = this.model;
    const skin = { transparent: true, opacity: 0.55 * share, side: DoubleSide, depthWrite: false };
    group.add(new Mesh(surface(shape, unit, THIN * 3), themed(new MeshLambertMaterial(skin), color)));
    if (shape.dimension > 1 && shape.edges.length < 400) {
      const line = new LineBasicMaterial({ transparent: share < 1, opacity: share });
      group.add(new LineSegments(edges(shape, unit), themed(line, color)));
    }
    return group;
  }

  corners(shape, group) {
    const balls = [];
    group.updateMatrixWorld();
    for (let i = 0; i < shape.vertices.length; i += 3) {
      const center = this.model.drawn(Array.from(shape.vertices.subarray(i, i + 3)));
      balls.push({ center: center.applyMatrix4(group.matrixWorld), radius: DOT });
    }
    return balls;
  }

  show(walk, at) {
    const { model, changing } = this;
    clear(changing);
    if (this.moved) this.moved.visible = walk.depth !== null && walk.isLast(at);
    const labels = walk.isDepth(at) ? this.showGrowth(at) : this.showSearch(walk, at);
    if (this.moved?.visible) addWayOut(changing, model.depth.deepestOnB, model.depth.deepestOnA, 1);
    // The marks lie on the shapes, and often inside them. So they are drawn visible through the shapes.
    changing.traverse((mark) => {
      if (!mark.material) return;
      mark.material.depthTest = false;
      mark.material.transparent = true;
      mark.renderOrder = 2;
    });
    this.labels.set([...this.names, ...labels]);
    this.stage.drawNow();
  }

  /** The support points of a step of the search for the depth: A's along n, and B's against it. */
  showGrowth(at) {
    const { model } = this;
    const step = model.depth.steps[at - model.steps.length];
    return step.normal ? this.showSupports(step, new Vector3(...step.normal), 'n', !model.isLast(at)) : [];
  }

  /** The support points of a step, A's along d and B's against it, and the nearest points so far. */
  showSearch(walk, at) {
    const { changing } = this;
    const step = walk.steps[at];
    if (!step) return [];
    const labels = this.showSupports(step, new Vector3(...step.normal).negate(), 'd', true);
    const last = walk.steps.slice(0, at + 1).findLast((s) => s.after);
    if (!last) return labels;
    const [a, b] = walk.witnesses(last);
    if (a.distanceTo(b) > 1e-6) {
      changing.add(new Mesh(rod(a, b, ROD), new MeshBasicMaterial({ color: COLORS.nearest })));
    }
    changing.add(dot(a, COLORS.nearest, DOT * 0.7), dot(b, COLORS.nearest, DOT * 0.7));
    return labels;
  }

  showSupports(step, d, name, hasArrows) {
    const { model, changing } = this;
    const onA = model.drawn(step.onA),
      onB = model.drawn(step.onB),
      length = ARROW * 0.8;
    changing.add(dot(onA, COLORS.vertex, DOT), dot(onB, COLORS.vertex, DOT));
    if (!hasArrows) return [];
    const back = d.clone().negate();
    changing.add(arrow(onA, d, COLORS.vertex, length), arrow(onB, back, COLORS.vertex, length));
    return [
      [name, onA.addScaledVector(d, length)],
      [`−${name}`, onB.addScaledVector(back, length)],
    ];
  }
}

/** The point of the simplex that was nearest to the origin when a step began. */
function nearestBefore(walk, at) {
  const before = walk.steps.slice(0, at).findLast((step) => step.after);
  return before ? walk.drawn(before.nearest) : ORIGIN.clone();
}

/** Empties a group, and gives back the memory of what was drawn. */
function clear(group) {
  group.traverse((mark) => {
    mark.geometry?.dispose();
  });
  group.clear();
}
