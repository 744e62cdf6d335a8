import { element } from '../dom.js';
import { isLight, onTheme, toggleTheme } from './theme.js';

export function button(textContent, onclick) {
  return element('button', { type: 'button', className: 'button', textContent, onclick });
}

export function section(title, ...children) {
  return element('section', {}, element('h2', { textContent: title }), ...children);
}

/** A button that copies a text. Where the browser refuses, it says so. */
export function copyButton(text) {
  const root = button('copy', async () => {
    try {
      await navigator.clipboard.writeText(text());
      root.textContent = 'copied';
    } catch {
      root.textContent = 'select it instead';
    }
    setTimeout(() => { root.textContent = 'copy'; }, 1500);
  });
  return root;
}

/** Changes between light and dark. */
export function themeButton() {
  const root = button('', toggleTheme);
  onTheme(() => {
    root.textContent = isLight() ? 'dark' : 'light';
    root.setAttribute('aria-label', `${root.textContent} theme`);
  });
  return root;
}

/** What the colours mean, and how to come nearer: entries of a colour of the style sheet and its words. */
export function legend(entries) {
  const keys = entries.map(([color, words]) => {
    const mark = element('i');
    mark.style.background = `var(--${color})`;
    return element('span', {}, mark, words);
  });
  return element('p', { className: 'legend' }, ...keys, element('span', { className: 'hint' }, 'scroll or pinch: zoom'));
}

/** The licences, which are many, are shown on request. */
export function notices() {
  const root = element('details', { className: 'notices' },
    element('summary', { textContent: 'Licences of what is in this page' }));
  root.ontoggle = () => {
    if (root.children.length > 1) return;
    root.append(element('pre', { textContent: document.getElementById('notices').content.textContent }));
  };
  return root;
}
