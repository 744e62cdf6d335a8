import {
  BufferAttribute,
  BufferGeometry,
  Group,
  LineBasicMaterial,
  LineDashedMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  SphereGeometry,
} from 'three';
import { arrow } from './arrows.js';
import { themed } from './theme.js';

/** The radius of an impact and the length of its normal, in units (a scene is 20 across). */
const DOT = 0.09,
  NORMAL = 1.1;

/** The dashes of a path, in units. */
const DASH = 0.22,
  GAP = 0.16;

/** With more bodies than this at their impacts, only the selected pair's are drawn: they are drawn one by one. */
const MOST_GHOSTS = 300;

/** After the bodies, through which paths and impacts are visible, and the contacts, and before the arrows. */
const ORDER = 0.8;

/**
 * The paths of the objects over the frame that follows, their outlines where they first meet another, and the points of
 * impact with their normals. With a pair selected, only that pair's.
 */
export class Casts {
  constructor(stage, model, outlineOf) {
    this.model = model;
    this.outlineOf = outlineOf;
    this.group = new Group();
    stage.scene.add(this.group);
    this.line = themed(new LineBasicMaterial({ transparent: true, opacity: 0.85 }), 'impact');
    const seen = { depthTest: false, transparent: true };
    this.dashed = themed(new LineDashedMaterial({ ...seen, dashSize: DASH, gapSize: GAP }), 'impact');
    this.solid = themed(new MeshBasicMaterial(seen), 'impact');
    this.paths = 0;
    this.impacts = [];
  }

  fill(selected, isShown) {
    const { model, group } = this;
    for (const child of group.children) if (!child.isGhost) child.geometry.dispose();
    group.clear();
    this.paths = 0;
    this.impacts = [];
    if (!isShown || !model.castData.isMoving) return;
    const of =
      selected < 0 ? Array.from({ length: model.objects }, (_, i) => i) : [model.a[selected], model.b[selected]];
    this.addPaths(of);
    const ghosts = selected < 0 ? this.firstOf(of) : of.map((object) => [object, selected]);
    for (const [object, pair] of ghosts) this.addGhost(object, model.impact(pair));
    for (const pair of new Set(ghosts.map(([, each]) => each))) this.addImpact(pair);
  }

  /** Each object with the pair of its first impact. */
  firstOf(objects) {
    const first = this.model.firstImpacts();
    const found = objects.filter((object) => first[object] >= 0).map((object) => [object, first[object]]);
    return found.length <= MOST_GHOSTS ? found : [];
  }

  addPaths(objects) {
    const { model } = this;
    const ends = [];
    for (const object of objects) {
      const moved = model.moved(object, 1);
      if (!(moved.lengthSq() > 0)) continue;
      const from = model.position(object);
      ends.push(...from, ...moved.add(from));
      this.paths++;
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(ends), 3));
    const lines = new LineSegments(geometry, this.dashed);
    lines.computeLineDistances();
    lines.renderOrder = ORDER;
    this.group.add(lines);
  }

  addGhost(object, impact) {
    const outline = impact?.isKnown ? this.outlineOf(object) : null;
    const moved = impact ? this.model.moved(object, impact.fraction) : null;
    if (!outline || !(moved.lengthSq() > 0)) return;
    const ghost = new LineSegments(outline, this.line);
    ghost.isGhost = true;
    ghost.position.copy(this.model.position(object)).add(moved);
    ghost.quaternion.copy(this.model.rotation(object));
    this.group.add(ghost);
  }

  addImpact(pair) {
    const impact = this.model.impact(pair);
    if (!impact?.isKnown) return;
    const at = this.model.drawn(...impact.point);
    const tip = at.clone();
    for (const [axis, n] of impact.normal.entries()) tip.setComponent(axis, at.getComponent(axis) + NORMAL * n);
    const ball = new SphereGeometry(DOT, 16, 12).translate(at.x, at.y, at.z);
    for (const geometry of [ball, ...arrow(at, tip, DOT / 3, NORMAL / 4)]) {
      const mesh = new Mesh(geometry, this.solid);
      mesh.renderOrder = ORDER;
      this.group.add(mesh);
    }
    this.impacts.push({ pair, at });
  }

  /** The pair whose impact is nearest to a ray, or -1 if none comes within reach. */
  pick(ray, reach) {
    let best = -1,
      least = reach * reach;
    for (const { pair, at } of this.impacts) {
      const squared = ray.distanceSqToPoint(at);
      if (squared > least) continue;
      least = squared;
      best = pair;
    }
    return best;
  }
}
