import {
  BoxGeometry, Color, DoubleSide, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, MeshLambertMaterial,
  SphereGeometry, Vector3,
} from 'three';
import { arrow } from '../arrows.js';
import { edges, rod, surface } from '../geometry.js';
import { Labels } from '../labels.js';
import { Stage } from '../stage.js';
import { colorOf, onTheme } from './theme.js';

/** The thickness of a drawn point or segment, of a line, and the radius of a dot, in units. */
const THIN = 0.04, LINE = 0.03, DOT = 0.09;

const SEEN_THROUGH = 0.5, SOLID = 0.92, GHOST = 0.25;

/** Both bodies and the answer in three.js. */
export class WorldView {
  constructor(model) {
    this.model = model;
    this.active = 0;
    this.stage = new Stage();
    this.labels = new Labels(this.stage, false, () => this.bodies.map(cornersOf), () => this.lines);
    this.lines = [];
    this.bodies = ['a', 'b'].map((name) => ({ name, group: new Group() }));
    this.ghosts = [new Group(), new Group()];
    this.marks = new Group();
    this.stage.scene.add(...this.bodies.map(({ group }) => group), ...this.ghosts, this.marks);
    onTheme(() => this.paint());
  }

  /** Sets the colours of the theme. */
  paint() {
    this.stage.scene.background = new Color(colorOf('back'));
    for (const body of this.bodies) body.surface = null;
    this.update();
  }

  /** Draws the model as it is now. */
  update() {
    this.model.bodies.forEach((body, i) => this.place(i, body));
    this.mark();
    this.stage.draw();
  }

  fit() {
    const { model, stage } = this;
    stage.look = null;
    const ball = (i) => ({ center: model.position(i), radius: model.bodies[i].radius * model.unit + 0.3 });
    stage.fit([ball(0), ball(1)]);
  }

  place(index, { surface: shape }) {
    const body = this.bodies[index], { model } = this;
    if (body.surface !== shape || body.unit !== model.unit) this.make(body, shape, this.ghosts[index]);
    body.group.position.copy(model.position(index));
    body.group.quaternion.copy(model.rotation(index));
    const isHit = model.answer.status === 'Overlapping';
    body.mesh.material.opacity = isHit ? SEEN_THROUGH : SOLID;
    body.mesh.material.depthWrite = !isHit;
    if (body.lines) body.lines.material.color.copy(this.edge(body.name, index === this.active));
    const { impact } = model, ghost = this.ghosts[index];
    ghost.visible = impact?.status === 'Hit' && model.velocity(index).length() > 0;
    if (!ghost.visible) return;
    ghost.position.copy(body.group.position).addScaledVector(model.velocity(index), impact.fraction);
    ghost.quaternion.copy(turnedBy(model, index, impact.fraction));
  }

  /** The colour of a body's edges: dark, and the body's own, only brighter, where keys move it. */
  edge(name, isActive) {
    const edge = new Color(colorOf('edge'));
    return isActive ? edge.set(colorOf(name)).lerp(new Color(colorOf('line')), 0.45) : edge;
  }

  make(body, shape, ghost) {
    const color = colorOf(body.name), { unit } = this.model;
    body.surface = shape;
    body.unit = unit;
    const geometry = surface(shape, unit, THIN);
    body.mesh = new Mesh(geometry, new MeshLambertMaterial({
      color, side: shape.dimension < 3 ? DoubleSide : 0, transparent: true,
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
    }));
    body.lines = shape.dimension > 1 && shape.edges.length
      ? new LineSegments(edges(shape, unit), new LineBasicMaterial()) : null;
    replaceAll(body.group, [body.mesh, body.lines]);
    const faint = new MeshLambertMaterial({
      color, transparent: true, opacity: GHOST, depthWrite: false, side: DoubleSide,
    });
    replaceAll(ghost, [new Mesh(geometry, faint)]);
  }

  /** Draws the closest points, the way out, the contacts, and the motion with its impact. */
  mark() {
    const { model, marks } = this, { answer } = model;
    const names = [['A', model.position(0)], ['B', model.position(1)]];
    const parts = [];
    this.lines = [];
    if (Number.isFinite(answer.distance)) {
      const [a, b] = [answer.pointA, answer.pointB].map((p) => model.drawn(p));
      const isApart = answer.distance > 0 && a.distanceTo(b) > 0;
      if (isApart) parts.push(through(rod(a, b, LINE), colorOf('line')));
      if (answer.distance < 0 && a.distanceTo(b) > 0)
        parts.push(...arrow(b, a, LINE, 0.35).map((geometry) => through(geometry, colorOf('out'))));
      parts.push(dot(a, colorOf('a')), dot(b, colorOf('b')));
      this.lines.push([a, b]);
      const middle = a.clone().lerp(b, 0.5);
      if (isApart && !model.impact) names.push([model.answerText, middle]);
      if (answer.distance < 0 && !model.impact) names.push(['way out', middle]);
    }
    for (const { point } of model.contacts?.points ?? []) parts.push(cube(model.drawn(point), colorOf('contact')));
    if (model.question === 'impact') parts.push(...this.motion(names));
    replaceAll(marks, parts);
    this.labels.set(names);
  }

  motion(names) {
    const { model } = this, { impact } = model, parts = [];
    for (const index of [0, 1]) {
      const from = model.position(index), to = this.tip(index);
      this.lines.push([from, to]);
      if (from.distanceTo(to) > 0)
        parts.push(...arrow(from, to, LINE, 0.35).map((geometry) => through(geometry, colorOf('motion'))));
      if (index === this.active) parts.push(dot(to, colorOf('accent'), 1.6));
    }
    if (impact?.status === 'Hit') {
      const at = model.drawn(impact.point);
      parts.push(dot(at, colorOf('motion'), 1.3));
      names.push(['first touch', at]);
    }
    return parts;
  }

  /** The end of a body's velocity, which is a handle. */
  tip(index) {
    return this.model.position(index).add(this.model.velocity(index));
  }

  /** The body under a point of the window, or -1, and where. */
  pick(clientX, clientY) {
    if (!this.stage.renderer) return { body: -1 };
    const hit = this.stage.ray(clientX, clientY).intersectObjects(this.bodies.map(({ mesh }) => mesh))[0];
    return hit ? { body: this.bodies.findIndex(({ mesh }) => mesh === hit.object), point: hit.point } : { body: -1 };
  }

  /** Directions of the screen: to the right, up, and towards the reader. */
  axes() {
    return [0, 1, 2].map((column) => new Vector3().setFromMatrixColumn(this.stage.camera.matrixWorld, column));
  }
}

/** The corners of the box around a body, turned with it. */
function cornersOf({ group, mesh }) {
  mesh.geometry.computeBoundingBox();
  group.updateMatrixWorld();
  const { min, max } = mesh.geometry.boundingBox;
  return Array.from({ length: 8 }, (_, i) => new Vector3(
    (i & 1 ? max : min).x, (i & 2 ? max : min).y, (i & 4 ? max : min).z).applyMatrix4(group.matrixWorld));
}

/** Where a body points after a part of its motion. */
function turnedBy(model, index, fraction) {
  const spin = new Vector3(...model.bodies[index].motion.slice(10)), turned = model.rotation(index);
  const angle = spin.length() * fraction;
  if (angle === 0) return turned;
  const half = spin.normalize().multiplyScalar(Math.sin(angle / 2));
  return turned.premultiply(turned.clone().set(half.x, half.y, half.z, Math.cos(angle / 2)));
}

export function dot(at, color, size = 1) {
  return through(new SphereGeometry(DOT * size, 16, 12).translate(at.x, at.y, at.z), color);
}

function cube(at, color) {
  return through(new BoxGeometry(1.6 * DOT, 1.6 * DOT, 1.6 * DOT).translate(at.x, at.y, at.z), color);
}

/** A mark that is visible through everything. */
export function through(geometry, color) {
  const mark = new Mesh(geometry, new MeshBasicMaterial({ color, depthTest: false, transparent: true }));
  mark.renderOrder = 2;
  return mark;
}

/**
 * Puts parts into a group, and frees the geometry of the ones before. Disposing of their materials would free the
 * shader with the last of them, and the next part would have it compiled again.
 */
export function replaceAll(group, parts) {
  for (const old of group.children) old.geometry.dispose();
  group.clear();
  group.add(...parts.filter(Boolean));
}
