import { element } from '../dom.js';

/** A text in which {w1} or {w1|the corner} names a part of the pictures: its words and buttons for those parts. */
export function marked(text) {
  return text.split(/(\{[^}]*\})/).filter(Boolean).map((piece) => {
    if (piece[0] !== '{') return piece;
    const [part, words = part] = piece.slice(1, -1).split('|');
    return element('span', { className: 'part', tabIndex: 0, 'data-part': part, textContent: words });
  });
}

/** Lights up all that has the name of what is pointed at, touched or focused: parts of a picture, and words. */
export function lights(root) {
  let lit = '';
  const again = () => {
    for (const each of root.querySelectorAll('[data-part]')) each.classList.toggle('lit', each.dataset.part === lit);
  };
  const show = (part) => {
    if (part === lit) return;
    lit = part;
    again();
  };
  for (const happening of ['pointerover', 'pointerdown', 'focusin'])
    root.addEventListener(happening, (event) => show(event.target.closest('[data-part]')?.dataset.part ?? ''));
  root.addEventListener('pointerleave', () => show(''));
  return { again, show };
}
