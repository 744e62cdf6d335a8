import { number } from './data.js';
import { button, element } from './dom.js';
import { CodeList } from './trace-code.js';
import { regionsOf } from './trace-regions.js';
import { cells, paragraph, reveal, table } from './trace-table.js';

/** The pseudo-code line by line, and the regions of the simplex. */
export class CodePanel {
  constructor(model, go) {
    this.model = model;
    this.code = new CodeList(model.code.exact);
    this.figure = element('div', { className: 'regions-box' });
    const back = button('◀ line', () => go(-1)),
      on = button('line ▶', () => go(1));
    const keys = element('span', { className: 'help', textContent: 'keys ↑ ↓' });
    this.root = element(
      'div',
      { className: 'tab text' },
      element('div', { className: 'controls' }, back, on, keys),
      this.code.root,
      this.figure,
    );
  }

  /** Lights a line of a step. */
  show(at, line) {
    const { model } = this;
    const lines = model.lines(at);
    this.code.show(lines.slice(0, line + 1), lines[line]);
    if (!lines.length) return this.figure.replaceChildren(element('p', { textContent: this.withoutLines(at) }));
    const { figure, words } = regionsOf(model, at);
    const heading = element('h2', { textContent: 'Where is the origin?' });
    this.figure.replaceChildren(heading, ...(figure ? [figure] : []), ...words.map(said));
  }

  withoutLines(at) {
    return this.model.isDepth(at)
      ? 'The search for the depth is another algorithm, which grows a surface inside A − B. The steps tell it.'
      : 'This query took no step.';
  }
}

/** The textbook's steps beside the exact ones. */
export class TextbookPanel {
  constructor(model, show) {
    this.model = model.textbook;
    this.code = new CodeList(model.code.textbook);
    this.story = element('div', { className: 'story', 'aria-live': 'polite' });
    this.rows = this.model.steps.map((step, i) => {
      const exact = model.steps[i] ? cells(model, model.steps[i], i)[2] : '';
      const mine = step.after ? (step.after.length === 4 ? '0' : number(step.upper ?? NaN)) : 'end';
      const texts = [String(i + 1), mine, exact, step.after ? this.model.feature(step.after) : 'proved nearest'];
      const row = element(
        'tr',
        { onclick: () => show(i) },
        ...texts.map((textContent) => element('td', { textContent })),
      );
      row.classList.toggle('rises', step.rises);
      return row;
    });
    const list = element(
      'div',
      { className: 'steps' },
      table(['step', '|v|, float', '|v|, exact', 'simplex'], this.rows),
    );
    this.root = element(
      'div',
      { className: 'tab text textbook' },
      element(
        'p',
        { className: this.model.isRight ? 'verdict' : 'verdict bad' },
        `GJK as books print it, in float: ${this.model.mark}.`,
      ),
      this.story,
      list,
      this.code.root,
      ...ABOUT.map(said),
    );
  }

  show(at) {
    const step = this.model.steps[at];
    this.rows.forEach((row, i) => row.classList.toggle('current', i === at));
    this.story.replaceChildren(...this.model.story(at).map(([kind, text]) => paragraph(kind, text)));
    const first = at === 0 ? ['start', 'repeat', 'support'] : ['repeat', 'support', 'met'];
    const ran = !step.after ? first : [...first, 'join', step.after.length === 4 ? 'inside' : 'region'];
    if (step.after && step.after.length < 4) ran.push('next');
    this.code.show(ran, ran.at(-1));
    reveal(this.rows[at]);
  }
}

const said = (textContent) => element('p', { textContent });

const ABOUT = [
  [
    'Both algorithms walk alike. They differ in how they end.',
    'The textbook compares w with v in float, with a tolerance of a millionth of |v|².',
    'Near parallel faces many vertices are equally far, and rounding makes one of them seem further.',
    'It joins again, and the simplex has a corner twice, or goes back to one that was there.',
  ],
  [
    'The exact query compares two bounds, the height of the simplex and that of the plane.',
    'Both come from the vertices, not from v, and the query ends when they meet.',
    'When |v| no longer falls before they do, it begins again with 106 bits: it can neither go round nor guess.',
  ],
  [
    'The usual cures answer something else. A larger tolerance is wrong for small shapes,',
    'and a limit on the steps turns “I do not know” into “apart”.',
  ],
  [
    'gjk-demo trace --example loop shows a pair for which the textbook never ends,',
    'and --example wrong one that it takes for intersecting.',
  ],
].map((sentences) => sentences.join(' '));
