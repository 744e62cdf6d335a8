import { wordsOf } from '../engine.js';
import { Placement } from './placement.js';
import { Store } from './store.js';
import { StudyView } from './view.js';

const ACROSS = [1, 0, 0], DOWN = [0, 1, 0];

/** The study of a page: its plan, the library, the view, and what is stored. */
export class App {
  constructor(engine, plan) {
    Object.assign(this, { engine, plan, view: new StudyView(), store: new Store(plan), surfaces: new Map() });
    this.places = new Map();
    for (const pair of plan.pairs) {
      pair.shapes = [pair.a, pair.b].map((record) => engine.shape(wordsOf(record)));
      pair.colliderShapes = Object.fromEntries(
        Object.entries(pair.colliders).map(([name, record]) => [name, engine.shape(wordsOf(record))]));
    }
  }

  surface(shape) {
    if (!this.surfaces.has(shape)) this.surfaces.set(shape, this.engine.surface(shape));
    return this.surfaces.get(shape);
  }

  surfacesOf({ pair }) {
    return pair.shapes.map((shape) => this.surface(shape));
  }

  /** Where a trial's bodies may be, and the shape of B that is drawn there. */
  placed({ pair, collider }) {
    const [a, drawn] = pair.shapes, b = collider ? pair.colliderShapes[collider] : drawn;
    const { rotationA, rotationB } = pair;
    const key = `${a} ${b} ${rotationA} ${rotationB} ${collider ?? ''}`;
    if (!this.places.has(key))
      this.places.set(key, new Placement(this.engine, { a, b, rotationA, rotationB }, collider ? DOWN : ACROSS));
    return { place: this.places.get(key), drawn };
  }

  /** How far both objects reach from the place where they meet, with room for the largest start. */
  reachOf(trial, place) {
    const [a, b] = this.surfacesOf(trial).map(reach);
    return Math.max(Math.abs(place.contact) + a, b + Math.max(0, trial.start ?? 0));
  }
}

function reach({ vertices: v }) {
  let most = 0;
  for (let i = 0; i < v.length; i += 3) most = Math.max(most, Math.hypot(v[i], v[i + 1], v[i + 2]));
  return most;
}
