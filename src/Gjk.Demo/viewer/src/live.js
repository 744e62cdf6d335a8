// Lets the bodies of a page of `gjk-demo view` be dragged: the library in the page answers their pairs anew. The page
// has three.js already, so this script takes its classes from there.
import { floats, ints } from './data.js';
import { element } from './dom.js';
import { AT_REST, Engine, wordsOf } from './engine.js';

/** In the order in which the page stores them. */
const STATUS = ['Separated', 'Overlapping', 'BeyondMaxDistance', 'IterationLimit', 'InvalidInput', 'InvalidShape'];

/** Numbers of a pose: rotation and position. */
const POSE = 7;

/** The most contact points of a pair. */
const CONTACTS = 4;

class LiveScene {
  constructor(engine, page, data) {
    Object.assign(this, { engine, page, model: page.model });
    const shapes = data.shapes.map((record) => engine.shape(wordsOf(record)));
    this.shapes = Array.from(ints(data.shapeOf), (shape) => shapes[shape]);
    this.mostGaps = floats(data.mostGaps);
    engine.reserve(this.shapes.length, Math.max(1, this.model.pairs));
    this.pairsOf = this.shapes.map(() => []);
    for (let pair = 0; pair < this.model.pairs; pair++)
      for (const object of [this.model.a[pair], this.model.b[pair]]) this.pairsOf[object].push(pair);
  }

  /** Moves an object of the current frame, and answers its pairs. */
  move(object, by) {
    const { model } = this, at = POSE * (model.frame * model.objects + object) + 4;
    by.toArray().forEach((x, axis) => { model.poses[at + axis] += x / model.unit; });
    this.tell();
    this.answer(this.pairsOf[object]);
    this.contacts();
    this.page.showFrame(model.frame);
  }

  tell() {
    const { model } = this;
    this.shapes.forEach((shape, i) => {
      const at = POSE * (model.frame * model.objects + i);
      this.engine.set(i, shape, [...model.poses.subarray(at, at + POSE), ...AT_REST.slice(POSE)]);
    });
  }

  answer(pairs) {
    const { model } = this, first = model.frame * model.pairs;
    const answers = this.engine.ask('signed', pairs.map((pair) => [model.a[pair], model.b[pair]]));
    pairs.forEach((pair, i) => {
      const { status, distance, pointA, pointB, normal, iterations } = answers[i], at = first + pair;
      model.overlapping[model.frame] -= model.overlaps(pair) ? 1 : 0;
      model.status[at] = STATUS.indexOf(status);
      model.distances[at] = distance;
      model.iterations[at] = iterations;
      model.pointsA.set(pointA, 3 * at);
      model.pointsB?.set(pointB, 3 * at);
      model.normals.set(normal, 3 * at);
      model.overlapping[model.frame] += model.overlaps(pair) ? 1 : 0;
    });
  }

  /** From now on the contact points of all pairs are the library's, and impacts are no longer told. */
  contacts() {
    const { model, engine } = this, known = new Map();
    const of = (pair) => {
      if (!model.overlaps(pair)) return [];
      if (!known.has(pair)) {
        const { points } = engine.contacts(model.a[pair], model.b[pair], this.mostGaps[pair]);
        known.set(pair, points.map(({ point, gap }) => [...point, gap]));
      }
      return known.get(pair);
    };
    model.contactData = { most: model.contactData.most, begin() {}, next() {}, isLeftOut: () => false, of };
    const { isMoving } = model.castData;
    model.castData = { isMoving, applies: () => false, velocity: () => [0, 0, 0], entry: () => null };
    this.hasMoved = true;
  }
}

/** Room for the arrows and contact points of all pairs, of which more may overlap than when the page was made. */
function makeRoom({ arrows, contacts }, pairs) {
  for (const [meshes, most] of [[arrows.meshes, pairs], [contacts.meshes, CONTACTS * pairs]]) {
    for (const mesh of meshes) {
      const { constructor: Attribute } = mesh.instanceMatrix;
      mesh.instanceMatrix = new Attribute(new Float32Array(16 * most), 16);
      mesh.instanceColor = null;
    }
  }
}

/** Bodies follow the mouse or a finger; a drag of the background still turns the view. */
function watchPointer(live, stage, view) {
  const canvas = stage.renderer.domElement;
  let hold = null, asked = 0;
  stage.root.addEventListener('pointerdown', (event) => {
    if (hold || event.button > 0) return;
    const hit = stage.ray(event.clientX, event.clientY).intersectObjects(view.bodies)[0];
    if (!hit) return;
    hold = { object: hit.object.objects[hit.instanceId], point: hit.point, to: hit.point, pointer: event.pointerId };
    stage.controls.enabled = false;
    canvas.setPointerCapture(event.pointerId);
  }, { capture: true });
  canvas.addEventListener('pointermove', (event) => {
    if (hold?.pointer !== event.pointerId) return;
    // Where the ray meets the plane of the screen through the point that is held.
    const { ray } = stage.ray(event.clientX, event.clientY);
    const facing = hold.point.clone().setFromMatrixColumn(stage.camera.matrixWorld, 2);
    const away = facing.dot(hold.point.clone().sub(ray.origin)) / facing.dot(ray.direction);
    hold.to = ray.origin.clone().addScaledVector(ray.direction, away);
    asked ||= requestAnimationFrame(follow);
  });
  function follow() {
    asked = 0;
    if (!hold || hold.to.distanceTo(hold.point) === 0) return;
    live.move(hold.object, hold.to.clone().sub(hold.point));
    hold.point = hold.to;
  }
  const release = (event) => {
    if (hold?.pointer !== event.pointerId) return;
    follow();
    hold = null;
    stage.controls.enabled = true;
  };
  for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, release);
}

const page = window.__gjk;
const live = new LiveScene(await Engine.start(), page, JSON.parse(document.getElementById('live').textContent));
makeRoom(page.view, page.model.pairs);
if (page.stage.renderer) watchPointer(live, page.stage, page.view);
const hint = 'drag a body: its distances, depths and contact points follow; impacts are then left out';
document.querySelector('.legend')?.append(element('span', { textContent: hint }));
page.live = live;
