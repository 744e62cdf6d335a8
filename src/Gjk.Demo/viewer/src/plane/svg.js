// Pictures of the plane: x to the right, y up, in units of the plane. A part of a picture can have a name, by which the
// words beside it find it.
import { boxOf, spread } from '../labels.js';
import { minus, plus, times } from './geometry.js';

const SVG = 'http://www.w3.org/2000/svg';

/** The size of labels and the height of their lines, in pixels. */
const LETTERS = 13, LINE = 17;

/** The radius of a handle, in pixels. */
const HANDLE = 8;

/** In pixels: how near a finger or the mouse must come to a handle. */
export const REACH = 24;

const pen = document.createElement('canvas').getContext('2d');

export function shape(tag, attributes = {}, ...children) {
  const result = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) result.setAttribute(name, value);
  result.append(...children);
  return result;
}

/** A picture of the plane around the origin. */
export class Picture {
  constructor(label) {
    this.root = shape('svg', { role: 'img', 'aria-label': label, class: 'picture' });
    new ResizeObserver(() => this.onResize?.()).observe(this.root);
  }

  /** Begins a drawing in which at least so much of the plane is visible to each side, and up and down. */
  begin(wide, tall) {
    const { clientWidth: w, clientHeight: h } = this.root;
    this.unit = Math.max((2 * wide) / Math.max(1, w), (2 * tall) / Math.max(1, h));
    [this.wide, this.tall] = [w, h].map((x) => (x * this.unit) / 2);
    this.root.setAttribute('viewBox', `${-this.wide} ${-this.tall} ${2 * this.wide} ${2 * this.tall}`);
    this.parts = [];
    this.labels = [];
    this.bodies = [];
    this.lines = [];
  }

  /** Shows what was drawn, with each label at a free place beside its point. */
  end() {
    const { wide, tall, unit } = this;
    const seen = ([x, y]) => ({ x: (x + wide) / unit, y: (tall - y) / unit });
    const items = this.labels.map(({ at, width, isName }) => ({ ...seen(at), width, height: LINE, isName }));
    const bodies = this.bodies.map((corners) => boxOf(corners.map(seen)));
    const lines = this.lines.map((ends) => ends.map(seen));
    spread(items, { width: (2 * wide) / unit, height: (2 * tall) / unit }, false, bodies, lines).forEach((box, i) => {
      const { part, content } = this.labels[i];
      part.setAttribute('x', box.left * unit - wide);
      part.setAttribute('y', (box.top + 0.77 * LINE) * unit - tall);
      part.textContent = content;
    });
    this.root.replaceChildren(...this.parts, ...this.labels.map(({ part }) => part));
  }

  /** The corners of what is visible. */
  window() {
    const [w, t] = [this.wide, this.tall];
    return [[-w, -t], [w, -t], [w, t], [-w, t]];
  }

  /** The point of the plane under a point of the window. */
  at(event) {
    const box = this.root.getBoundingClientRect();
    return [(event.clientX - box.left) * this.unit - this.wide, this.tall - (event.clientY - box.top) * this.unit];
  }

  /** The point of the window at a point of the plane. */
  place([x, y]) {
    const box = this.root.getBoundingClientRect();
    return { x: box.left + (x + this.wide) / this.unit, y: box.top + (this.tall - y) / this.unit };
  }

  add(tag, attributes, className, name) {
    const part = shape(tag, { ...attributes, class: className, ...(name ? { 'data-part': name } : {}) });
    this.parts.push(part);
    return part;
  }

  polygon(points, className, name) {
    if (className.startsWith('body')) this.bodies.push(points);
    this.lines.push(...points.map((p, i) => [p, points[(i + 1) % points.length]]));
    return this.add('polygon', { points: points.map(([x, y]) => `${x},${-y}`).join(' ') }, className, name);
  }

  line([x, y], [z, w], className, name) {
    if (className !== 'axis') this.lines.push([[x, y], [z, w]]);
    return this.add('line', { x1: x, y1: -y, x2: z, y2: -w }, className, name);
  }

  dot([x, y], className, name, pixels = 5) {
    return this.add('circle', { cx: x, cy: -y, r: pixels * this.unit }, className, name);
  }

  /** A handle, with room for a finger around it. */
  handle(at, name) {
    this.dot(at, 'reach', name, REACH);
    this.dot(at, 'handle', name, HANDLE);
    for (const arm of [[HANDLE, 0], [0, HANDLE]].map((d) => times(d, this.unit)))
      this.lines.push([minus(at, arm), plus(at, arm)]);
  }

  square([x, y], className, name, pixels = 5) {
    const r = pixels * this.unit;
    return this.add('rect', { x: x - r, y: -y - r, width: 2 * r, height: 2 * r }, className, name);
  }

  arrow(from, to, className, name) {
    const along = [to[0] - from[0], to[1] - from[1]], whole = Math.hypot(...along);
    if (whole === 0) return;
    const [x, y] = along.map((d) => d / whole), size = Math.min(12 * this.unit, whole);
    const neck = [to[0] - x * size, to[1] - y * size], wide = size * 0.4;
    this.line(from, neck, className, name);
    const [left, right] = [1, -1].map((side) => [neck[0] - side * y * wide, neck[1] + side * x * wide]);
    this.polygon([to, left, right], `${className} head`, name);
  }

  /** A label beside a point. */
  text(at, content, className = '', name = content) {
    const part = shape('text', { class: className, 'font-size': LETTERS * this.unit, 'data-part': name });
    pen.font = `750 ${LETTERS}px system-ui, "DejaVu Sans", sans-serif`;
    this.labels.push({ at, content, part, width: pen.measureText(content).width + 2, isName: className === 'name' });
  }
}
