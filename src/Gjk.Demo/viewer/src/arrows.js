import {
  Color,
  ConeGeometry,
  CylinderGeometry,
  InstancedMesh,
  Matrix4,
  MeshBasicMaterial,
  Quaternion,
  Vector3,
} from 'three';
import { rod } from './geometry.js';
import { COLORS } from './theme.js';

/** The radius of a shaft and the length of a head, in units (a scene is 20 across). */
const THICKNESS = 0.045,
  HEAD = 0.42;

/** The most of both for a short arrow, as shares of its length. */
const MOST_THICKNESS = 0.06,
  MOST_HEAD = 0.5;

/** The radius of a head over its length. */
const SLOPE = 0.42;

/** While another pair is selected, an arrow keeps this share of its colour. */
const DIMMED = 0.4;

const UP = new Vector3(0, 1, 0);

/** An arrow that is drawn alone: its shaft and its head. */
export function arrow(from, to, thickness, head) {
  const { along, length, neck } = parts(from, to, head);
  const cone = new ConeGeometry(SLOPE * length, length, 20).translate(0, length / 2, 0);
  cone.applyQuaternion(new Quaternion().setFromUnitVectors(UP, along)).translate(neck.x, neck.y, neck.z);
  return [rod(from, neck, Math.min(thickness, SLOPE * length)), cone];
}

/** The ways out of all intersecting pairs. They lie inside both bodies, so they are visible through everything. */
export class Arrows {
  constructor(stage, model) {
    this.model = model;
    this.pairs = [];
    this.ends = [];
    const most = model.overlapping.reduce((x, y) => Math.max(x, y), 1);
    const shaft = new CylinderGeometry(1, 1, 1, 10).translate(0, 0.5, 0);
    const head = new ConeGeometry(1, 1, 20).translate(0, 0.5, 0);
    this.meshes = [shaft, head].map((geometry) => {
      const mesh = new InstancedMesh(geometry, new MeshBasicMaterial({ depthTest: false, transparent: true }), most);
      mesh.frustumCulled = false;
      mesh.renderOrder = 1;
      stage.scene.add(mesh);
      return mesh;
    });
  }

  /** Draws the arrows of the model's frame, or none. */
  fill(selected, isShown) {
    const {
      model,
      meshes: [shafts, heads],
    } = this;
    const [color, accent] = [new Color(COLORS.wayOut), new Color(COLORS.accent)];
    const dimmed = color.clone().lerp(new Color(COLORS.back), 1 - DIMMED);
    const turn = new Quaternion(),
      size = new Vector3(),
      matrix = new Matrix4();
    this.pairs = [];
    this.ends = [];
    for (let pair = 0; pair < model.pairs && isShown; pair++) {
      const ends = model.wayOut(pair);
      if (!ends) continue;
      const { along, whole, length, neck } = parts(...ends, HEAD);
      turn.setFromUnitVectors(UP, along);
      const thickness = Math.min(THICKNESS, MOST_THICKNESS * whole),
        at = this.pairs.length;
      shafts.setMatrixAt(at, matrix.compose(ends[0], turn, size.set(thickness, whole - length, thickness)));
      heads.setMatrixAt(at, matrix.compose(neck, turn, size.set(SLOPE * length, length, SLOPE * length)));
      const shade = selected < 0 ? color : selected === pair ? accent : dimmed;
      for (const mesh of this.meshes) mesh.setColorAt(at, shade);
      this.pairs.push(pair);
      this.ends.push(ends);
    }
    for (const mesh of this.meshes) {
      mesh.count = this.pairs.length;
      mesh.instanceMatrix.needsUpdate = true;
      if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
    }
  }

  /** The pair whose arrow passes nearest to a ray, or -1 if none comes within reach. */
  pick(ray, reach) {
    let best = -1,
      least = reach * reach;
    this.ends.forEach(([from, to], i) => {
      const squared = ray.distanceSqToSegment(from, to);
      if (squared > least) return;
      least = squared;
      best = this.pairs[i];
    });
    return best;
  }
}

/** The direction and the length of an arrow, the length of its head, and where the head begins. */
function parts(from, to, head) {
  const along = to.clone().sub(from),
    whole = along.length();
  along.normalize();
  const length = Math.min(head, MOST_HEAD * whole);
  return { along, whole, length, neck: to.clone().addScaledVector(along, -length) };
}
