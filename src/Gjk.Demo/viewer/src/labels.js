import { element } from './dom.js';

/** How far from its point a label may stand, in pixels. */
const FAR = 66;

/** Where a label may stand beside its point, in pixels: to the right first, then around it, then further away. */
const PLACES = [12, 19, 26, 35, 44, 55, FAR].flatMap((away) =>
  [
    [1, 0],
    [-1, 0],
    [0.6, -1],
    [0.6, 1],
    [-0.6, -1],
    [-0.6, 1],
    [0, -1],
    [0, 1],
  ].map(([x, y]) => [x * away, y * away]),
);

/** Pixels between two labels. */
const GAP = 2;

/** Half the side of the square that a point keeps free, in pixels. */
const POINT = 5;

/**
 * Short texts at points of a stage. They follow the points when the stage is turned, and no two overlap: a label goes
 * to the first free place around its point, or beside a body that is near it. Where all are taken it is left
 * out, or stands at the first one. What `bodies` returns, the corners of a box around each body, is kept free if it
 * can be, and what `lines` returns, the two ends of each.
 */
export class Labels {
  constructor(stage, mayHide = false, bodies = () => [], lines = () => []) {
    this.stage = stage;
    this.mayHide = mayHide;
    this.bodies = bodies;
    this.lines = lines;
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
    const seen = (point) => {
      const { x, y } = this.stage.project(point);
      return { x: x - stage.left, y: y - stage.top };
    };
    const bodies = this.bodies().map((corners) => boxOf(corners.map(seen)));
    const lines = this.lines().map((ends) => ends.map(seen));
    spread(items, stage, this.mayHide, bodies, lines).forEach((found, i) => {
      const { style } = this.items[i].label;
      style.visibility = found ? 'visible' : 'hidden';
      if (!found) return;
      style.left = `${found.left}px`;
      style.top = `${found.top}px`;
    });
  }
}

/**
 * A box for each label {x, y, width, height}, beside its point or a body near it: none overlaps another,
 * or a point, or a body or a line if that can be; one with `isName` may lie on a body, since it names it. A line is its
 * two ends. A label that has no free place, or is not shown, gets null, or the first place where it must not hide.
 */
export function spread(items, bounds, mayHide, bodies = [], lines = []) {
  const taken = items.map(({ x, y }) => around(x, y));
  return items.map(({ x, y, width, height, isShown = true, isName = false }) => {
    if (!isShown) return null;
    const near = PLACES.map((place) => box(x, y, place, width, height));
    const about = bodies.filter((body) => overlap(body, around(x, y, FAR)));
    const places = [...near, ...about.flatMap((body) => beside(body, x, y, width, height))];
    const isFree = (b) => isInside(b, bounds) && !taken.some((other) => overlap(b, other));
    const isClear = (b) => isFree(b) && (isName || !bodies.some((body) => overlap(b, body)));
    const isOff = (b) => isFree(b) && !lines.some((line) => crosses(line, b));
    const found = places.find((b) => isOff(b) && isClear(b)) ?? near.find(isOff)
      ?? places.find(isClear) ?? near.find(isFree) ?? (mayHide ? null : near[0]);
    if (found) taken.push(found);
    return found;
  });
}

/** Boxes for a label above a body, to the right of it, to the left and below. */
const beside = (body, x, y, width, height) => [
  sized(x - width / 2, body.top - 2 * GAP - height, width, height),
  sized(body.right + 2 * GAP, y - height / 2, width, height),
  sized(body.left - 2 * GAP - width, y - height / 2, width, height),
  sized(x - width / 2, body.bottom + 2 * GAP, width, height),
];

/** The smallest box around points. */
export function boxOf(points) {
  const [xs, ys] = [points.map(({ x }) => x), points.map(({ y }) => y)];
  return { left: Math.min(...xs), top: Math.min(...ys), right: Math.max(...xs), bottom: Math.max(...ys) };
}

const around = (x, y, by = POINT) => ({ left: x - by, top: y - by, right: x + by, bottom: y + by });

/** A label's box beside a point: to the right of it, to the left or over it, and in the middle, above or below. */
function box(x, y, [aside, down], width, height) {
  const back = aside < 0 ? width : aside > 0 ? 0 : width / 2;
  return sized(x + aside - back, y + down - height / 2, width, height);
}

const sized = (left, top, width, height) => ({ left, top, right: left + width, bottom: top + height });

const isInside = (b, stage) => b.left >= 0 && b.top >= 0 && b.right <= stage.width && b.bottom <= stage.height;

/** Whether a line comes into a box, or as near as two labels may (Liang and Barsky, 1984). */
function crosses([from, to], b) {
  let [enter, leave] = [0, 1];
  for (const [axis, low, high] of [['x', b.left - GAP, b.right + GAP], ['y', b.top - GAP, b.bottom + GAP]]) {
    const along = to[axis] - from[axis], start = from[axis];
    if (along === 0 && (start < low || start > high)) return false;
    if (along === 0) continue;
    const [near, far] = along > 0 ? [low, high] : [high, low];
    enter = Math.max(enter, (near - start) / along);
    leave = Math.min(leave, (far - start) / along);
  }
  return enter <= leave;
}

const overlap = (p, q) =>
  p.left < q.right + GAP && q.left < p.right + GAP && p.top < q.bottom + GAP && q.top < p.bottom + GAP;
