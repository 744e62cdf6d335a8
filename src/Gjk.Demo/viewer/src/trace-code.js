import { element } from './dom.js';

/** Pseudo-code of which one line is lit, and those are marked that the step ran before it. */
export class CodeList {
  constructor(lines, go = null) {
    this.lines = lines;
    this.source = element('p', { className: 'source' });
    this.rows = lines.map(({ indent, text, file, member }, i) => {
      const row = element('li', { textContent: text, title: `${file}, ${member}` });
      row.style.paddingLeft = `${14 + 18 * indent}px`;
      if (go) row.onclick = () => go(lines[i].id);
      return row;
    });
    this.root = element('div', { className: 'code' }, element('ol', {}, ...this.rows), this.source);
  }

  /** Lights a line after others; none where nothing runs. */
  show(ran, lit) {
    this.lines.forEach(({ id }, i) => {
      this.rows[i].classList.toggle('lit', id === lit);
      this.rows[i].classList.toggle('ran', ran.includes(id));
    });
    const line = this.lines.find(({ id }) => id === lit);
    this.source.textContent = line ? `${line.file}: ${line.member}` : '';
  }
}
