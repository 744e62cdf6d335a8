import {
  BufferAttribute,
  BufferGeometry,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  Vector3,
} from 'three';
import { arrow } from './arrows.js';
import { number } from './data.js';
import { COLORS } from './theme.js';

/** About how many lines the grid has in each direction. */
const LINES = 12;

/** The length of an axis, in steps of the grid. */
const AXIS = 1.5;

/** The radius of an axis and the length of its head, in units (a scene is 20 across). */
const THICKNESS = 0.04,
  HEAD = 0.45;

/** A grid on the ground below the scene's first frame, with the three axes of the world at its near corner. */
export class Axes {
  constructor(stage, model) {
    this.model = model;
    this.group = new Group();
    this.isShown = false;
    stage.scene.add(this.group);
    const across = Math.max(model.high[0] - model.low[0], model.high[2] - model.low[2]);
    this.step = roundStep((across > 0 ? across : 1) / LINES);
    const down = (x) => Math.floor(x / this.step) * this.step,
      up = (x) => Math.ceil(x / this.step) * this.step;
    this.y = down(model.low[1]);
    [this.left, this.right] = [down(model.low[0]), up(model.high[0])];
    [this.far, this.near] = [down(model.low[2]), up(model.high[2])];
  }

  /** What the grid measures, in words. */
  get text() {
    return `ground y = ${number(this.y)}, lines ${number(this.step)} apart`;
  }

  /** The names of the axes, and where they stand. */
  get labels() {
    return this.isShown ? this.ends().map(([name, , end]) => [name, end]) : [];
  }

  fill() {
    for (const child of this.group.children) child.geometry.dispose();
    this.group.clear();
    if (!this.isShown) return;
    const material = new LineBasicMaterial({ color: COLORS.grid });
    this.group.add(new LineSegments(this.lines(), material));
    for (const [name, from, to] of this.ends()) {
      const axis = new MeshBasicMaterial({ color: COLORS[name] });
      for (const geometry of arrow(from, to, THICKNESS, HEAD)) this.group.add(new Mesh(geometry, axis));
    }
  }

  lines() {
    const { model, y, step, left, right, far, near } = this;
    const points = [];
    const add = (...ends) => ends.forEach(([x, z]) => points.push(...model.drawn(x, y, z)));
    for (let i = 0; left + i * step <= right + step / 2; i++) add([left + i * step, far], [left + i * step, near]);
    for (let i = 0; far + i * step <= near + step / 2; i++) add([left, far + i * step], [right, far + i * step]);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(points), 3));
    return geometry;
  }

  ends() {
    const { model, y, step, left, near } = this;
    const corner = model.drawn(left, y, near),
      length = AXIS * step * model.unit;
    return ['x', 'y', 'z'].map((name, axis) => {
      return [name, corner, corner.clone().addScaledVector(new Vector3().setComponent(axis, 1), length)];
    });
  }

  /** Balls that must be in view with the grid. */
  balls() {
    if (!this.isShown) return [];
    const corners = [this.left, this.right].flatMap((x) => [this.far, this.near].map((z) => [x, z]));
    const points = corners.map(([x, z]) => this.model.drawn(x, this.y, z));
    return [...points, ...this.ends().map(([, , end]) => end)].map((center) => ({ center, radius: 0.2 }));
  }
}

/** The least of 1, 2, 5, 10 and so on that is no less than a length. */
function roundStep(length) {
  const power = 10 ** Math.floor(Math.log10(length));
  return [1, 2, 5, 10].map((digit) => digit * power).find((step) => step >= length * (1 - 1e-9)) ?? 10 * power;
}
