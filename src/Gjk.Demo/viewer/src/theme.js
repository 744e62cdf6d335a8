// The two themes of the pages: the colours of what is drawn. The colours of the text around it are in page.css.

const DARK = {
  back: '#12161d',
  hit: '#e5484d',
  free: '#38a873',
  line: '#ffffff',
  edge: '#0a0d12',
  grid: '#3a4759',
  wayOut: '#7cc4ff',
  contact: '#f0a6ff',
  impact: '#ffb86b',
  accent: '#ffd166',
  x: '#ff7b72',
  y: '#7ee787',
  z: '#79b8ff',
  a: '#4a8dff',
  b: '#dcb4ff',
  vertex: '#ffd166',
  simplex: '#ff8c61',
  nearest: '#ffffff',
  plane: '#4cc9f0',
  old: '#97a3b4',
  lowest: '#7ee787',
  out: '#4da3ff',
  skin: '#8aa4d6',
};

const LIGHT = {
  back: '#f4f6fa',
  hit: '#e5484d',
  free: '#38a873',
  line: '#1b2430',
  edge: '#0a0d12',
  grid: '#bcc6d4',
  wayOut: '#0b57c2',
  contact: '#8a10a8',
  impact: '#a04a00',
  accent: '#8a5a00',
  x: '#c1121f',
  y: '#1a7f37',
  z: '#0b57c2',
  a: '#1f5fd0',
  b: '#b283ea',
  vertex: '#a86a00',
  simplex: '#d2491a',
  nearest: '#11161d',
  plane: '#0786ad',
  old: '#667285',
  lowest: '#1a7f37',
  out: '#0b57c2',
  skin: '#4f6ca8',
};

/** The colours of the current theme, by what they are for. */
export const COLORS = {};

const listeners = [];

/** The system's theme, until the user chooses one. */
export const theme = {
  name: 'dark',

  set(name) {
    this.name = name;
    Object.assign(COLORS, name === 'light' ? LIGHT : DARK);
    const root = document.documentElement;
    root.dataset.theme = name;
    for (const [key, color] of Object.entries(COLORS)) root.style.setProperty(`--c-${key}`, color);
    for (const listener of listeners) listener();
  },

  toggle() {
    this.isChosen = true;
    this.set(this.name === 'light' ? 'dark' : 'light');
  },

  onChange(listener) {
    listeners.push(listener);
  },
};

/** Gives a material a colour of the theme, now and after every change. */
export function themed(material, key) {
  const paint = () => material.color.set(COLORS[key]);
  paint();
  theme.onChange(paint);
  return material;
}

const light = window.matchMedia('(prefers-color-scheme: light)');
theme.set(light.matches ? 'light' : 'dark');
light.addEventListener('change', () => {
  if (!theme.isChosen) theme.set(light.matches ? 'light' : 'dark');
});
