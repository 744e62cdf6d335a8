import { element } from './dom.js';

/** Where a label may stand beside its point, in pixels: to the right first, then around it, then further away. */
const PLACES = [12, 26, 44, 66].flatMap((away) =>
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
    const items = this.items.map(({ point, width, height }) => {
      const { x, y, depth } = this.stage.project(point);
      return { x: x - stage.left, y: y - stage.top, width, height, isShown: depth < 1 };
    });
    spread(items, stage, this.mayHide).forEach((found, i) => {
      const { style } = this.items[i].label;
      style.visibility = found ? 'visible' : 'hidden';
      if (!found) return;
      style.left = `${found.left}px`;
      style.top = `${found.top}px`;
    });
  }
}

/**
 * A box for each label {x, y, width, height}, beside its point: none overlaps another, or a point. A label that has no
 * free place, or is not shown, gets null, or the first place where it must not hide.
 */
export function spread(items, bounds, mayHide) {
  const taken = items.map(({ x, y }) => around(x, y));
  return items.map(({ x, y, width, height, isShown = true }) => {
    if (!isShown) return null;
    const at = (place) => box(x, y, place, width, height);
    const isFree = (b) => isInside(b, bounds) && !taken.some((other) => overlap(b, other));
    const found = PLACES.map(at).find(isFree) ?? (mayHide ? null : at(PLACES[0]));
    if (found) taken.push(found);
    return found;
  });
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
