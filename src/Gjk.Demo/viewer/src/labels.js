import { element } from './dom.js';

/** Where a label may stand beside its point, in pixels: to the right first, then around it, then further away. */
const PLACES = [12, 26, 44].flatMap((away) =>
  [
    [1, 0],
    [-1, 0],
    [0.6, -1],
    [0.6, 1],
    [-0.6, -1],
    [-0.6, 1],
  ].map(([x, y]) => [x * away, y * away]),
);

/** Pixels between two labels. */
const GAP = 2;

/** Half the side of the square that a point keeps free, in pixels. */
const POINT = 5;

/**
 * Short texts at points of a stage. They follow the points when the stage is turned, and no two overlap: a label goes
 * to the first free place around its point. Where all are taken it is left out, or stands at the first one.
 */
export class Labels {
  constructor(stage, mayHide = false) {
    this.stage = stage;
    this.mayHide = mayHide;
    this.items = [];
    stage.onDraw(() => this.place());
  }

  /** Shows exactly these entries: [text, point]. */
  set(entries) {
    for (const { label } of this.items) label.remove();
    this.items = entries.map(([textContent, point]) => {
      return { point, label: element('div', { className: 'label', textContent }) };
    });
    this.stage.root.append(...this.items.map(({ label }) => label));
    for (const item of this.items) [item.width, item.height] = [item.label.offsetWidth, item.label.offsetHeight];
  }

  place() {
    const stage = this.stage.root.getBoundingClientRect();
    const points = this.items.map(({ point }) => this.stage.project(point));
    // A label may stand beside every point, and on none.
    const taken = points.map(({ x, y }) => around(x - stage.left, y - stage.top));
    this.items.forEach(({ label, width, height }, i) => {
      const { x, y, depth } = points[i];
      const at = (place) => box(x - stage.left, y - stage.top, place, width, height);
      const isFree = (b) => isInside(b, stage) && !taken.some((other) => overlap(b, other));
      const found = PLACES.map(at).find(isFree) ?? (this.mayHide ? null : at(PLACES[0]));
      const isShown = depth < 1 && found !== null;
      label.style.visibility = isShown ? 'visible' : 'hidden';
      if (!isShown) return;
      taken.push(found);
      label.style.left = `${found.left}px`;
      label.style.top = `${found.top}px`;
    });
  }
}

const around = (x, y) => ({ left: x - POINT, top: y - POINT, right: x + POINT, bottom: y + POINT });

/** A label's box beside a point: to the right of it or to the left, and in the middle, above or below. */
function box(x, y, [aside, down], width, height) {
  const left = aside < 0 ? x + aside - width : x + aside;
  const top = y + down - height / 2;
  return { left, top, right: left + width, bottom: top + height };
}

const isInside = (b, stage) => b.left >= 0 && b.top >= 0 && b.right <= stage.width && b.bottom <= stage.height;

const overlap = (p, q) =>
  p.left < q.right + GAP && q.left < p.right + GAP && p.top < q.bottom + GAP && q.top < p.bottom + GAP;
