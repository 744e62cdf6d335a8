import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  EdgesGeometry,
  Group,
  InstancedMesh,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  SphereGeometry,
  Vector3,
} from 'three';
import { Arrows, arrow } from './arrows.js';
import { Casts } from './casts.js';
import { Contacts } from './contacts.js';
import { Axes } from './axes.js';
import { edges, partSurface, rod, surface } from './geometry.js';
import { Hatch } from './hatch.js';
import { Labels } from './labels.js';
import { COLORS, theme } from './theme.js';

/** While a pair is selected, all other bodies keep this share of their colour. */
const DIMMED = 0.28;

/**
 * The most bodies, and the most edges in all, for which edges are drawn. Edges are drawn body by body, so more would be
 * slow.
 */
const MOST_EDGED = 2000,
  MOST_EDGES = 300_000;

/** The most names that are shown. More would hide the scene, and placing them would be slow. */
const MOST_NAMES = 200;

/** The thickness of a drawn point or segment, in units (a scene is 20 across). */
const THIN = 0.035;

/** How much of the colour of a lit part is seen. */
const LIT = 0.7;

/** In degrees. The outline of a round shape is its net, whose facets are further apart than this. */
const ROUND_ANGLE = 5;

/** A path is brought into view where it is no longer than this, in units. */
const LONGEST_PATH = 30;

/** The bodies and lines of a scene in three.js. */
export class SceneView {
  constructor(stage, model) {
    this.stage = stage;
    this.model = model;
    this.lineMode = 'all';
    this.selected = -1;
    this.surfaces = model.shapes.map((s) => surface(s, model.unit, THIN));
    this.makeBodies();
    this.makeLines();
    this.contacts = new Contacts(stage, model);
    this.edges = new Map();
    this.showsCasts = true;
    this.casts = new Casts(stage, model, (object) => this.outlineOf(object));
    this.arrows = new Arrows(stage, model);
    this.marks = new Group();
    stage.scene.add(this.marks);
    this.axes = new Axes(stage, model);
    this.labels = new Labels(stage, true);
    this.showsNames = false;
    theme.onChange(() => this.paint());
  }

  makeBodies() {
    const { model, stage } = this;
    const counts = new Int32Array(model.shapes.length);
    this.place = Array.from(model.shapeOf, (s) => counts[s]++);
    this.hatches = [];
    this.bodies = model.shapes.map((s, i) => {
      const material = new MeshLambertMaterial({
        side: s.dimension === 2 ? DoubleSide : 0,
        polygonOffset: true,
        polygonOffsetFactor: 1,
        polygonOffsetUnits: 1,
      });
      const mesh = new InstancedMesh(this.surfaces[i], material, counts[i]);
      this.hatches.push(new Hatch(mesh, stage.renderer?.getPixelRatio() ?? 1));
      mesh.objects = [];
      stage.scene.add(mesh);
      return mesh;
    });
    model.shapeOf.forEach((s, i) => {
      this.bodies[s].objects[this.place[i]] = i;
    });
    this.outlines = [];
    const lineCount = model.shapeOf.reduce((sum, s) => sum + model.shapes[s].edges.length / 2, 0);
    if (model.objects > MOST_EDGED || lineCount > MOST_EDGES) return;
    const shared = model.shapes.map((s) => (s.dimension > 1 ? edges(s, model.unit) : null));
    const faint = model.shapes.map(
      (s) => new LineBasicMaterial({ color: 0x0a0d12, transparent: true, opacity: s.edges.length > 200 ? 0.22 : 0.6 }),
    );
    this.outlines = Array.from(model.shapeOf, (s) => {
      if (!shared[s]) return null;
      const lines = new LineSegments(shared[s], faint[s]);
      lines.matrixAutoUpdate = false;
      stage.scene.add(lines);
      return lines;
    });
  }

  makeLines() {
    const most = this.model.pairs;
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(most * 6), 3));
    geometry.setAttribute('color', new BufferAttribute(new Float32Array(most * 8), 4));
    this.lines = new LineSegments(
      geometry,
      new LineBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false }),
    );
    this.lines.frustumCulled = false;
    this.lines.pairs = [];
    this.stage.scene.add(this.lines);
  }

  /** Draws the model's frame. */
  update() {
    const { model } = this;
    const matrix = new Matrix4(),
      one = new Vector3(1, 1, 1);
    for (let i = 0; i < model.objects; i++) {
      matrix.compose(model.position(i), model.rotation(i), one);
      this.bodies[model.shapeOf[i]].setMatrixAt(this.place[i], matrix);
      if (this.outlines[i]) this.outlines[i].matrix.copy(matrix);
    }
    for (const body of this.bodies) {
      body.instanceMatrix.needsUpdate = true;
      body.computeBoundingSphere();
    }
    this.paint();
  }

  /** Sets colours and lines, which also change with the selection. */
  paint() {
    const { model } = this;
    const color = new Color(),
      back = new Color(COLORS.back);
    for (let i = 0; i < model.objects; i++) {
      color.set(model.hit[i] ? COLORS.hit : COLORS.free);
      if (this.selected >= 0 && !this.isSelected(i)) color.lerp(back, 1 - DIMMED);
      this.hatches[model.shapeOf[i]].set(this.place[i], model.hit[i]);
      this.bodies[model.shapeOf[i]].setColorAt(this.place[i], color);
    }
    for (const body of this.bodies) if (body.instanceColor) body.instanceColor.needsUpdate = true;
    this.fillLines();
    this.contacts.fill(this.selected, this.lineMode !== 'none');
    this.arrows.fill(this.selected, this.lineMode !== 'none');
    this.casts.fill(this.selected, this.showsCasts);
    this.markSelected();
    this.axes.fill();
    this.labels.set([...this.axes.labels, ...this.names()]);
    this.stage.draw();
  }

  /** The edges of an object's shape; a round one's surface as a net. A point has none. */
  outlineOf(object) {
    const at = this.model.shapeOf[object],
      shape = this.model.shapes[at];
    if (shape.dimension === 0) return null;
    if (!this.edges.has(at)) {
      const isRound = shape.smooth && shape.edges.length === 0;
      this.edges.set(at, isRound ? new EdgesGeometry(this.surfaces[at], ROUND_ANGLE) : edges(shape, this.model.unit));
    }
    return this.edges.get(at);
  }

  /** The names of the objects, of the selected pair first: where there is no room, the later ones are left out. */
  names() {
    const { model, selected } = this;
    if (!this.showsNames) return [];
    const all = Array.from({ length: Math.min(model.objects, MOST_NAMES) }, (_, i) => i);
    const first = selected < 0 ? [] : [model.a[selected], model.b[selected]];
    return [...new Set([...first, ...all])].map((object) => [model.names[object], model.position(object)]);
  }

  isSelected(object) {
    return this.selected >= 0 && (this.model.a[this.selected] === object || this.model.b[this.selected] === object);
  }

  fillLines() {
    const { model, lines } = this;
    const position = lines.geometry.attributes.position,
      color = lines.geometry.attributes.color;
    const shade = new Color(COLORS.line);
    const faint = Math.min(0.5, Math.max(0.05, 60 / Math.max(model.pairs, 1)));
    lines.pairs = [];
    for (let pair = 0; pair < model.pairs && this.lineMode !== 'none'; pair++) {
      const isNearest = model.nearest[model.a[pair]] === pair || model.nearest[model.b[pair]] === pair;
      if (!isNearest && this.lineMode === 'nearest') continue;
      const ends = model.line(pair);
      if (!ends) continue;
      const opacity = (isNearest ? 1 : faint) * (this.selected >= 0 ? 0.25 : 1);
      ends.forEach((end, k) => {
        position.setXYZ(2 * lines.pairs.length + k, end.x, end.y, end.z);
        color.setXYZW(2 * lines.pairs.length + k, shade.r, shade.g, shade.b, opacity);
      });
      lines.pairs.push(pair);
    }
    lines.geometry.setDrawRange(0, 2 * lines.pairs.length);
    position.needsUpdate = color.needsUpdate = true;
    lines.geometry.computeBoundingSphere();
  }

  /**
   * Draws the selected pair's line as a rod with balls at its ends, or its way out as an arrow. It is visible through
   * everything.
   */
  markSelected() {
    this.marks.clear();
    if (this.selected >= 0) for (const at of this.model.partsOf(this.selected)) this.markPart(...at);
    const line = this.selected < 0 ? null : this.model.line(this.selected);
    const wayOut = this.selected < 0 ? null : this.model.wayOut(this.selected);
    const ends = line ?? wayOut;
    if (!ends) return;
    const material = new MeshBasicMaterial({ color: COLORS.accent, depthTest: false, transparent: true });
    const size = this.stage.pixelAt(ends[0]);
    const ball = (at) => new SphereGeometry(size * 4, 16, 12).translate(at.x, at.y, at.z);
    const parts = line ? [rod(...line, size * 1.3), ...line.map(ball)] : arrow(...wayOut, size * 1.3, size * 14);
    for (const part of parts) this.marks.add(new Mesh(part, material));
    for (const mark of this.marks.children) mark.renderOrder = 2;
  }

  /** Lights a triangle or part of the selected pair, also through what hides it. */
  markPart(object, part) {
    const { model } = this;
    const side = { side: DoubleSide, depthTest: false, transparent: true, opacity: LIT };
    const geometry = partSurface(model.shapes[model.shapeOf[object]], part, model.unit);
    const lit = new Mesh(geometry, new MeshBasicMaterial({ color: COLORS.accent, ...side }));
    lit.position.copy(model.position(object));
    lit.quaternion.copy(model.rotation(object));
    this.marks.add(lit);
  }

  /** Finds what is under a point of the window: {object}, {pair} or nothing. */
  pick(clientX, clientY) {
    const ray = this.stage.ray(clientX, clientY);
    const reach = 5 * this.stage.pixelAt(this.stage.controls.target);
    for (const marks of [this.arrows, this.casts, this.contacts]) {
      const pair = marks.pick(ray.ray, reach);
      if (pair >= 0) return { pair };
    }
    const body = ray.intersectObjects(this.bodies)[0];
    ray.params.Line.threshold = reach;
    const line = this.lines.pairs.length
      ? ray
          .intersectObject(this.lines)
          .filter((hit) => !body || hit.distance <= body.distance)
          .sort((x, y) => x.distanceToRay - y.distanceToRay)[0]
      : null;
    if (line) return { pair: this.lines.pairs[line.index / 2] };
    return body ? { object: body.object.objects[body.instanceId] } : {};
  }

  colorOf(object) {
    const color = new Color();
    this.bodies[this.model.shapeOf[object]].getColorAt(this.place[object], color);
    return `#${color.getHexString()}`;
  }

  balls() {
    const { model } = this;
    const here = Array.from(model.shapeOf, (_, i) => ({ center: model.position(i), radius: model.radius(i) }));
    const paths = here.flatMap(({ center }, i) => {
      const moved = model.moved(i, 1),
        length = moved.length();
      return length > 0 && length <= LONGEST_PATH ? [{ center: moved.add(center), radius: 0.2 }] : [];
    });
    return [...here, ...paths, ...this.axes.balls()];
  }
}
