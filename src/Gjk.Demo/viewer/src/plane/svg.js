// Pictures of the plane: x to the right, y up, in units of the plane.
const SVG = 'http://www.w3.org/2000/svg';

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
  }

  end() {
    this.root.replaceChildren(...this.parts);
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

  add(part) {
    this.parts.push(part);
    return part;
  }

  polygon(points, className) {
    return this.add(shape('polygon', { points: points.map(([x, y]) => `${x},${-y}`).join(' '), class: className }));
  }

  line([x, y], [z, w], className) {
    return this.add(shape('line', { x1: x, y1: -y, x2: z, y2: -w, class: className }));
  }

  dot([x, y], className, pixels = 5) {
    return this.add(shape('circle', { cx: x, cy: -y, r: pixels * this.unit, class: className }));
  }

  square([x, y], className, pixels = 5) {
    const r = pixels * this.unit;
    return this.add(shape('rect', { x: x - r, y: -y - r, width: 2 * r, height: 2 * r, class: className }));
  }

  arrow(from, to, className) {
    const along = [to[0] - from[0], to[1] - from[1]], whole = Math.hypot(...along);
    if (whole === 0) return;
    const [x, y] = along.map((d) => d / whole), size = Math.min(12 * this.unit, whole);
    const neck = [to[0] - x * size, to[1] - y * size], wide = size * 0.4;
    this.line(from, neck, className);
    const [left, right] = [1, -1].map((side) => [neck[0] - side * y * wide, neck[1] + side * x * wide]);
    this.polygon([to, left, right], `${className} head`);
  }

  text([x, y], content, className = '', dx = 9, dy = -9) {
    const place = { x: x + dx * this.unit, y: -y + dy * this.unit };
    const part = shape('text', { ...place, class: className, 'font-size': 13 * this.unit });
    part.textContent = content;
    this.add(part);
  }
}
