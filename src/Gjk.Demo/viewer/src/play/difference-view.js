import { Color, DoubleSide, Group, LineBasicMaterial, LineSegments, Mesh, MeshLambertMaterial, Vector3 } from 'three';
import { edges, rod, surface } from '../geometry.js';
import { Labels } from '../labels.js';
import { Stage } from '../stage.js';
import { colorOf, onTheme } from './theme.js';
import { reachOf } from './world-model.js';
import { dot, replaceAll, through } from './world-view.js';

const THIN = 0.04, LINE = 0.03, OPACITY = 0.45;

/** A surface that takes longer than this to make, in milliseconds, is a coarse one while a body turns. */
const MOST_TIME = 8;

/** After this long without a turn, in milliseconds, the surface is the fine one again. */
const REST = 150;

/** The Minkowski difference A - B and the origin: the shortest way between them is the distance, or the depth. */
export class DifferenceView {
  constructor(model) {
    this.model = model;
    this.stage = new Stage();
    this.labels = new Labels(this.stage);
    this.stage.camera.position.set(0, 0, 1);
    new ResizeObserver(() => { this.look(); this.stage.draw(); }).observe(this.stage.root);
    this.body = new Group();
    this.marks = new Group();
    this.stage.scene.add(this.body, this.marks);
    this.made = '';
    this.isSlow = false;
    onTheme(() => {
      this.stage.scene.background = new Color(colorOf('back'));
      this.made = '';
      this.update();
    });
  }

  update() {
    const { model } = this;
    const turned = model.rotation(0).invert().multiply(model.rotation(1)).toArray().map((x) => x.toFixed(6)).join();
    const key = `${model.bodies[0].words}|${model.bodies[1].words}|${turned}|${model.unit}`;
    if (key !== this.made) this.make(key, this.made !== '' && this.isSlow);
    this.body.quaternion.copy(model.rotation(0));
    this.body.position.copy(model.position(0)).sub(model.position(1));
    this.mark();
    this.look();
    this.stage.draw();
  }

  make(key, isCoarse) {
    clearTimeout(this.timer);
    if (isCoarse) this.timer = setTimeout(() => { this.make(this.made, false); this.stage.draw(); }, REST);
    this.made = key;
    const start = performance.now(), { unit } = this.model;
    const shape = this.model.difference(isCoarse);
    if (!isCoarse) this.isSlow = performance.now() - start > MOST_TIME;
    this.radius = reachOf(shape) * unit;
    replaceAll(this.body, [
      new Mesh(surface(shape, unit, THIN), new MeshLambertMaterial({
        color: colorOf('difference'), transparent: true, opacity: OPACITY, side: DoubleSide, depthWrite: false,
      })),
      shape.dimension > 1 && shape.edges.length
        ? new LineSegments(edges(shape, unit), new LineBasicMaterial({ color: colorOf('edge') })) : null,
    ]);
  }

  /** Draws the origin, and the point of A - B that is nearest to it: the difference of the closest points. */
  mark() {
    const { answer, unit } = this.model, origin = new Vector3();
    const parts = [dot(origin, colorOf('text'), 1.3)], names = [['origin', origin]];
    if (Number.isFinite(answer.distance) && answer.distance !== 0) {
      const nearest = new Vector3(...answer.pointA.map((x, axis) => (x - answer.pointB[axis]) * unit));
      const color = colorOf(answer.distance > 0 ? 'line' : 'out');
      if (nearest.length() > 0) parts.push(through(rod(origin, nearest, LINE), color));
      parts.push(dot(nearest, color));
    }
    replaceAll(this.marks, parts);
    this.labels.set(names);
  }

  /** Keeps the origin and A - B in view, from the side from which the bodies are seen. */
  look() {
    const { camera, controls } = this.stage;
    if (!controls) return;
    const center = this.body.position.clone().multiplyScalar(0.5);
    const reach = center.length() + this.radius;
    const along = camera.position.clone().sub(controls.target).normalize();
    const wide = Math.tan(camera.fov * Math.PI / 360) * Math.min(1, camera.aspect);
    const distance = 1.15 * reach / wide || 10;
    controls.target.copy(center);
    camera.near = distance / 500;
    camera.far = distance * 40;
    camera.position.copy(center).addScaledVector(along, distance);
    camera.updateProjectionMatrix();
  }
}

/** Two stages that are always seen from the same side. */
export function turnTogether(one, other) {
  let isFollowing = false;
  const follow = (from, to) => () => {
    if (isFollowing || !from.controls) return;
    isFollowing = true;
    const distance = to.camera.position.distanceTo(to.controls.target);
    const along = from.camera.position.clone().sub(from.controls.target).normalize();
    to.camera.position.copy(to.controls.target).addScaledVector(along, distance);
    to.drawNow();
    isFollowing = false;
  };
  if (!one.controls) return;
  one.controls.addEventListener('change', follow(one, other));
  other.controls.addEventListener('change', follow(other, one));
}
