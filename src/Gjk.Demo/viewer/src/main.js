import { scenePage } from './scene-page.js';

const data = JSON.parse(document.getElementById('data').textContent);
const pages = { scene: scenePage };

// What a test or a curious reader can ask the page about.
window.__gjk = pages[data.kind](data);
