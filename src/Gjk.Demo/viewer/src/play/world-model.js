import { Quaternion, Vector3 } from 'three';
import { AT_REST, Engine, MOTION, wordsOf } from '../engine.js';
import { sizesOf, wordsFor } from './catalog.js';

/** The distance from the middle of both bodies to their ends as they are drawn, in units. */
const DRAWN_RADIUS = 4;

/** How far a body is put from another, in radii of both; and how many times further it may already be. */
const NEAR = 1.25, MOST_APART = 2.5;

/** Points of contact are shown up to a gap of this share of the bodies' size. */
const CONTACT_GAP = 0.01;

/** Two bodies, the question, and its answer. World coordinates are those of the library; drawn ones fit into floats. */
export class WorldModel {
  /** @param {Engine} engine The library. */
  constructor(engine) {
    this.engine = engine;
    this.question = 'signed';
    this.showsContacts = false;
    this.bodies = [
      made('box', [-1.6, 0.1, 0], [0.1, 0.2, 0.05]),
      made('cone', [1.1, 0.2, 0.2], [0.25, 0, -0.5]),
    ];
    for (const body of this.bodies) this.refresh(body);
    this.measure();
    this.ask();
  }

  /** Replaces a body. Throws where its words are no shape, and changes nothing then. */
  replace(index, body) {
    const next = { ...this.bodies[index], ...body };
    this.refresh(next);
    this.bodies[index] = next;
  }

  /** Brings a body that is many times its size from the other one near it, so that both can be seen. */
  settle(index) {
    const { motion, radius } = this.bodies[index], other = this.bodies[1 - index];
    const way = [4, 5, 6].map((i) => motion[i] - other.motion[i]), apart = Math.hypot(...way);
    const near = NEAR * (radius + other.radius);
    if (apart <= MOST_APART * near || near === 0) return;
    way.forEach((x, axis) => { motion[4 + axis] = Math.fround(other.motion[4 + axis] + (x * near) / apart); });
  }

  refresh(body) {
    body.shape = this.engine.shape(body.words);
    body.surface = this.engine.surface(body.shape);
    body.radius = reachOf(body.surface);
  }

  /** Takes both bodies of a record. Throws where it is none. */
  open(record) {
    const words = this.engine.checked(record).split(' @');
    const [first, middle, last] = [words[0].slice('gjk1 '.length), words[1], words[2]];
    const [motionA, rest] = motionOf(middle), [motionB] = motionOf(last);
    this.replace(0, { name: 'A of the record', kind: null, words: first, motion: motionA });
    this.replace(1, { name: 'B of the record', kind: null, words: rest, motion: motionB });
    this.measure();
  }

  /** Chooses the middle and the unit of what is drawn. */
  measure() {
    const [a, b] = this.bodies.map(({ motion }) => motion.slice(4, 7));
    this.center = a.map((x, axis) => x / 2 + b[axis] / 2);
    const apart = Math.hypot(...a.map((x, axis) => x - b[axis]));
    const size = apart / 2 + Math.max(...this.bodies.map(({ radius }) => radius));
    this.unit = size > 0 ? DRAWN_RADIUS / size : 1;
  }

  drawn(v) {
    return new Vector3(...v.map((x, axis) => (x - this.center[axis]) * this.unit));
  }

  position(index) {
    return this.drawn(this.bodies[index].motion.slice(4, 7));
  }

  rotation(index) {
    return new Quaternion(...this.bodies[index].motion.slice(0, 4)).normalize();
  }

  /** A body's way over one frame, as it is drawn. */
  velocity(index) {
    return new Vector3(...this.bodies[index].motion.slice(7, 10)).multiplyScalar(this.unit);
  }

  /** Moves a body's numbers from an index on, by a vector as it is drawn. */
  shift(index, from, by) {
    const { motion } = this.bodies[index];
    by.toArray().forEach((x, axis) => { motion[from + axis] = Math.fround(motion[from + axis] + x / this.unit); });
  }

  move(index, by) {
    this.shift(index, 4, by);
  }

  /** Turns a body about an axis of the world. */
  turn(index, axis, angle) {
    const turned = this.rotation(index).premultiply(new Quaternion().setFromAxisAngle(axis, angle)).normalize();
    turned.toArray().forEach((x, i) => { this.bodies[index].motion[i] = Math.fround(x); });
  }

  /** Asks the library. */
  ask() {
    const { engine } = this, start = performance.now();
    this.tell();
    this.answer = engine.ask(this.question === 'distance' ? 'distance' : 'signed', [[0, 1]])[0];
    this.impact = this.question === 'impact' ? engine.ask('impact', [[0, 1]])[0] : null;
    const size = Math.max(...this.bodies.map(({ radius }) => radius));
    this.contacts = this.showsContacts ? engine.contacts(0, 1, CONTACT_GAP * size) : null;
    this.milliseconds = performance.now() - start;
  }

  /** Tells the library where both bodies are. */
  tell() {
    this.bodies.forEach(({ shape, motion }, i) => this.engine.set(i, shape, motion));
  }

  record() {
    this.tell();
    return this.engine.record(0, 1);
  }

  /** The surface of A - B in A's frame. */
  difference(isCoarse) {
    this.tell();
    return this.engine.difference(0, 1, isCoarse);
  }
}

function made(kind, position, axis) {
  const q = new Quaternion().setFromAxisAngle(new Vector3(...axis).normalize(), new Vector3(...axis).length() * 2);
  const motion = [...q.toArray(), ...position, ...AT_REST.slice(7)].map(Math.fround);
  const sizes = sizesOf(kind);
  return { name: kind, kind, sizes, words: wordsFor(kind, sizes), motion };
}

/** The motion that begins a text after its @, and the words after it. */
function motionOf(text) {
  const [pose, moving] = text.trim().split(' ~');
  const numbers = pose.trim().split(' ');
  const motion = [...AT_REST];
  numbers.slice(0, 7).forEach((x, i) => { motion[i] = Number(x); });
  if (moving === undefined) return [motion, numbers.slice(7).join(' ')];
  const more = moving.trim().split(' ');
  more.slice(0, 6).forEach((x, i) => { motion[7 + i] = Number(x); });
  return [motion, more.slice(6).join(' ')];
}

/** How far a surface reaches from its own origin. */
export function reachOf({ vertices: v }) {
  let most = 0;
  for (let i = 0; i < v.length; i += 3) most = Math.max(most, Math.hypot(v[i], v[i + 1], v[i + 2]));
  return most;
}

/** The bodies that a page was given, as choices. */
export function givenBodies(data, floats, shapeOf) {
  return [...shapeOf].map((shape, i) => ({
    name: data.names[i] ?? `#${i}`, words: wordsOf(data.shapes[shape]),
    motion: Array.from(floats.slice(MOTION * i, MOTION * (i + 1))),
  }));
}
