// Light or dark. It follows the system until the user chooses.
const SYSTEM = window.matchMedia('(prefers-color-scheme: light)');
const listeners = [];
let chosen = null;

export const isLight = () => (chosen ?? (SYSTEM.matches ? 'light' : 'dark')) === 'light';

/** Calls a listener now and after every change. */
export function onTheme(listener) {
  listeners.push(listener);
  listener();
}

export const toggleTheme = () => setTheme(isLight() ? 'dark' : 'light');

/** Chooses 'light' or 'dark'. */
export function setTheme(name) {
  chosen = name;
  apply();
}

/** A colour of the style sheet, as a number. */
export function colorOf(name) {
  const text = getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
  return Number(`0x${text.slice(1)}`);
}

function apply() {
  document.documentElement.dataset.theme = isLight() ? 'light' : 'dark';
  for (const listener of listeners) listener();
}

SYSTEM.addEventListener('change', apply);
apply();
