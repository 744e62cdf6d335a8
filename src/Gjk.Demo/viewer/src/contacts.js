import {
  Color,
  CylinderGeometry,
  InstancedMesh,
  Matrix4,
  MeshBasicMaterial,
  Quaternion,
  SphereGeometry,
  Vector3,
} from 'three';
import { COLORS } from './theme.js';

/** The radius of a dot and of a stick, in units (a scene is 20 across). */
const DOT = 0.07,
  STICK = 0.018;

/** The most radius of a dot, as a share of the smaller body's radius. */
const MOST_DOT = 0.07;

/** The least radius of a selected pair's dots, in pixels. */
const LEAST_PIXELS = 3.5;

/** With more points than this in a frame, only the selected pair's are drawn: all would be slow, and a cloud. */
const MOST_DRAWN = 3000;

/** While another pair is selected, a point keeps this share of its colour. */
const DIMMED = 0.4;

/** After the bodies, which have the order 0, and before the arrows, which have 1. */
const ORDER = 0.5;

const UP = new Vector3(0, 1, 0),
  NO_TURN = new Quaternion();

/**
 * The contact points of the intersecting pairs: a dot on A's surface, and a stick from there to B's. They lie inside
 * the bodies, so they are visible through everything. The arrows are drawn over them, whose tips are the deepest
 * points.
 */
export class Contacts {
  constructor(stage, model) {
    this.stage = stage;
    this.model = model;
    this.points = [];
    this.showsAll = model.contactData.most <= MOST_DRAWN;
    const most = Math.min(model.contactData.most, MOST_DRAWN);
    const stick = new CylinderGeometry(1, 1, 1, 8).translate(0, 0.5, 0);
    const dot = new SphereGeometry(1, 14, 10);
    this.meshes = [stick, dot].map((geometry) => {
      const material = new MeshBasicMaterial({ depthTest: false, transparent: true });
      const mesh = new InstancedMesh(geometry, material, most);
      mesh.frustumCulled = false;
      mesh.renderOrder = ORDER;
      stage.scene.add(mesh);
      return mesh;
    });
  }

  /** Draws the points of the model's frame, of all pairs or of the selected one, or none. */
  fill(selected, isShown) {
    const {
      model,
      meshes: [sticks, dots],
    } = this;
    const color = new Color(COLORS.contact),
      dimmed = color.clone().lerp(new Color(COLORS.back), 1 - DIMMED);
    const turn = new Quaternion(),
      size = new Vector3(),
      matrix = new Matrix4();
    this.points = [];
    for (let pair = 0; pair < model.pairs && isShown; pair++) {
      if (!this.showsAll && selected !== pair) continue;
      const contacts = model.contacts(pair);
      if (!contacts.length) continue;
      const radius = this.radius(pair, selected === pair ? contacts[0].ends[0] : null);
      const thickness = (STICK / DOT) * radius;
      for (const {
        ends: [onA, onB],
      } of contacts) {
        const along = onB.clone().sub(onA),
          length = along.length(),
          at = this.points.length;
        turn.setFromUnitVectors(UP, along.normalize());
        sticks.setMatrixAt(at, matrix.compose(onA, turn, size.set(thickness, length, thickness)));
        dots.setMatrixAt(at, matrix.compose(onA, NO_TURN, size.setScalar(radius)));
        for (const mesh of this.meshes) mesh.setColorAt(at, selected < 0 || selected === pair ? color : dimmed);
        this.points.push({ pair, onA, onB });
      }
    }
    for (const mesh of this.meshes) {
      mesh.count = this.points.length;
      mesh.instanceMatrix.needsUpdate = true;
      if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
    }
  }

  /** The radius of a pair's dots; if the pair is selected, large enough to be seen at that place. */
  radius(pair, place) {
    const { model } = this;
    const smaller = Math.min(...[model.a[pair], model.b[pair]].map((object) => model.radius(object)));
    const radius = Math.min(DOT, MOST_DOT * smaller);
    return place && this.stage.renderer ? Math.max(radius, LEAST_PIXELS * this.stage.pixelAt(place)) : radius;
  }

  /** The pair whose point passes nearest to a ray, or -1 if none comes within reach. */
  pick(ray, reach) {
    let best = -1,
      least = reach * reach;
    for (const { pair, onA, onB } of this.points) {
      const squared = ray.distanceSqToSegment(onA, onB);
      if (squared > least) continue;
      least = squared;
      best = pair;
    }
    return best;
  }
}
