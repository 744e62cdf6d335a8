import { element } from './dom.js';

/** Short texts at points of a stage. They follow the points when the stage is turned. */
export class Labels {
  constructor(stage) {
    this.stage = stage;
    this.items = [];
    stage.afterDraw = () => this.place();
  }

  /** Shows exactly these entries: [text, point]. */
  set(entries) {
    for (const { label } of this.items) label.remove();
    this.items = entries.map(([textContent, point]) => ({ point, label: element('div', { className: 'label', textContent }) }));
    this.stage.root.append(...this.items.map(({ label }) => label));
  }

  place() {
    const box = this.stage.root.getBoundingClientRect();
    for (const { label, point } of this.items) {
      const { x, y, depth } = this.stage.project(point);
      label.style.left = `${x - box.left}px`;
      label.style.top = `${y - box.top}px`;
      label.style.visibility = depth < 1 ? 'visible' : 'hidden';
    }
  }
}
