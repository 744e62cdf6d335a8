import { number } from './data.js';
import { element } from './dom.js';

/** The cells of a step of the distance. */
export function cells(model, step, i) {
  const bound = step.bound === 0 ? '0' : Number.isFinite(step.bound) ? number(step.bound) : '–';
  const gap = step.best > 0 && Number.isFinite(step.bound) ? number(Math.max(step.bound - step.best, 0)) : '–';
  const simplex = step.after ? model.feature(step.after) : 'proved';
  return [`${i + 1}${step.extended ? ' ×2' : ''}`, step.best > 0 ? number(step.best) : '–', bound, gap, simplex];
}

/** The cells of a step of the depth. */
export function depthCells({ below, above, count, outcome }, at) {
  const least = Math.max(below ?? 0, 0);
  const [most, gap] = above === null ? ['–', '–'] : [number(above), number(Math.max(above - least, 0))];
  return [
    String(at + 1),
    number(least),
    most,
    gap,
    count ? `${count} triangles` : outcome === 'Flat' ? 'none' : 'no room',
  ];
}

export function table(columns, rows) {
  const head = element('tr', {}, ...columns.map((textContent) => element('th', { textContent })));
  return element('table', {}, element('thead', {}, head), element('tbody', {}, ...rows));
}

/** Scrolls the list, and nothing around it, until a row is in view below the list's head. */
export function reveal(row) {
  const list = row.closest('.steps'),
    box = list.getBoundingClientRect(),
    { top, bottom } = row.getBoundingClientRect();
  const head = row.closest('table').tHead.getBoundingClientRect().height;
  if (top < box.top + head) list.scrollTop -= box.top + head - top;
  else if (bottom > box.bottom) list.scrollTop += bottom - box.bottom;
}

/** Makes the word before the colon bold. */
export function paragraph(kind, text) {
  const [, head, rest] = /^([^:]{1,12}:)?(.*)$/s.exec(text);
  const bold = head ? [element('b', { textContent: head })] : [];
  return element('p', { className: kind === 'answer' ? 'answer' : '' }, ...bold, rest);
}
