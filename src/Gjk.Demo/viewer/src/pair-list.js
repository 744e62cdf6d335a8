import { number } from './data.js';
import { element } from './dom.js';

/** The height of a row, where the pointer is fine and where it is a finger. */
const ROW = 27,
  TOUCH_ROW = 44;

/** The same as in the style. */
const TOUCH = window.matchMedia('(pointer: coarse), (max-width: 820px)');

const height = () => (TOUCH.matches ? TOUCH_ROW : ROW);

/** The most rows of the list. The tallest element of a browser holds about 30 million pixels. */
const MOST_ROWS = 700_000;

const AT_REST = [
  ['a', 'A'],
  ['b', 'B'],
  ['distance', 'distance'],
  ['iterations', 'iter.'],
];

/** With the fraction of the frame after which a pair meets. */
const MOVING = [
  ['a', 'A'],
  ['b', 'B'],
  ['distance', 'distance'],
  ['impact', 'impact'],
  ['iterations', 'iter.'],
];

/** A fraction in a narrow column. */
const short = (x) => (x < 1e-4 ? x.toExponential(0) : String(Number(x.toPrecision(4))));

/** The table of pairs, sorted by a column. It may have any length, because only the visible rows exist. */
export class PairList {
  constructor(model, select) {
    this.model = model;
    this.select = select;
    this.column = 'distance';
    this.rising = true;
    this.object = -1;
    this.selected = -1;
    this.order = new Int32Array(0);
    this.columns = model.castData.isMoving ? MOVING : AT_REST;
    this.className = model.castData.isMoving ? 'row moving' : 'row';
    this.buttons = this.columns.map(([key, text]) =>
      element('button', {
        type: 'button',
        textContent: text,
        className: key === 'a' || key === 'b' ? '' : 'number',
        onclick: () => this.sortBy(key),
      }),
    );
    this.head = element('div', { className: `${this.className} head` }, ...this.buttons);
    this.filler = element('div');
    this.rows = element('div', { className: 'rows', tabIndex: 0, role: 'listbox', 'aria-label': 'pairs' }, this.filler);
    this.rows.onscroll = () => this.fill();
    new ResizeObserver(() => this.fill()).observe(this.rows);
    TOUCH.addEventListener('change', () => this.update());
  }

  sortBy(column) {
    this.rising = this.column === column ? !this.rising : true;
    this.column = column;
    this.update();
  }

  /** Sorts again after a change of the frame, the column or the filter. */
  update() {
    const { model } = this;
    const keep = [];
    for (let pair = 0; pair < model.pairs; pair++) {
      if (this.object < 0 || model.a[pair] === this.object || model.b[pair] === this.object) keep.push(pair);
    }
    const key = {
      a: (pair) => model.a[pair],
      b: (pair) => model.b[pair],
      iterations: (pair) => model.iterations[model.index(pair)],
      distance: (pair) => {
        const d = model.distance(pair);
        return Number.isNaN(d) ? Infinity : d;
      },
      impact: (pair) => (model.overlaps(pair) ? -1 : (model.impact(pair)?.fraction ?? Infinity)),
    }[this.column];
    const keys = new Float64Array(model.pairs);
    for (const pair of keep) keys[pair] = key(pair);
    const sign = this.rising ? 1 : -1;
    this.order = Int32Array.from(keep).sort((p, q) => (keys[p] < keys[q] ? -sign : keys[p] > keys[q] ? sign : p - q));
    this.buttons.forEach((button, i) => {
      const isKey = this.columns[i][0] === this.column;
      button.textContent = this.columns[i][1] + (isKey ? (this.rising ? ' ↑' : ' ↓') : '');
      if (isKey) button.setAttribute('aria-sort', this.rising ? 'ascending' : 'descending');
      else button.removeAttribute('aria-sort');
    });
    this.filler.style.height = `${Math.min(this.order.length, MOST_ROWS) * height()}px`;
    this.fill();
  }

  show(pair) {
    this.selected = pair;
    const at = this.order.indexOf(pair);
    if (at >= 0) {
      const top = at * height(),
        bottom = top + height(),
        view = this.rows;
      if (top < view.scrollTop) view.scrollTop = top;
      else if (bottom > view.scrollTop + view.clientHeight) view.scrollTop = bottom - view.clientHeight;
    }
    this.fill();
  }

  fill() {
    const first = Math.floor(this.rows.scrollTop / height());
    const last = Math.min(this.order.length, MOST_ROWS, first + Math.ceil(this.rows.clientHeight / height()) + 1);
    const made = [];
    for (let at = first; at < last; at++) made.push(this.row(this.order[at], at));
    const none = element('p', { className: 'none', textContent: 'There are no pairs to list.' });
    this.rows.replaceChildren(this.filler, ...(this.order.length ? made : [none]));
  }

  row(pair, at) {
    const { model } = this;
    const hit = model.overlaps(pair);
    const isSelected = pair === this.selected;
    const text = hit
      ? model.overlapText(pair)
      : Number.isNaN(model.distance(pair))
        ? model.statusName(pair)
        : number(model.distance(pair));
    const row = element(
      'div',
      {
        className: `${this.className}${hit ? ' hit' : ''}${isSelected ? ' selected' : ''}`,
        role: 'option',
        'aria-selected': isSelected,
        'data-pair': pair,
        onclick: () => this.select(isSelected ? -1 : pair),
      },
      ...[model.a, model.b].map((objects) => {
        const name = model.names[objects[pair]];
        return element('span', { textContent: name, title: name });
      }),
      element('span', { className: 'number', textContent: text }),
      ...(model.castData.isMoving
        ? [element('span', { className: 'number', textContent: model.impactText(pair, short) })]
        : []),
      element('span', { className: 'number', textContent: model.iterations[model.index(pair)] }),
    );
    row.style.top = `${at * height()}px`;
    return row;
  }

  /** Selects the next pair of the list, or the one before. */
  go(step) {
    if (!this.order.length) return;
    const at = this.order.indexOf(this.selected);
    this.select(this.order[Math.max(0, Math.min(this.order.length - 1, at + step))]);
  }
}
