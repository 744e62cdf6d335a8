import { scenePage } from './scene-page.js';
import { tracePage } from './trace-page.js';

const data = JSON.parse(document.getElementById('data').textContent);
const pages = { scene: scenePage, trace: tracePage };

// What a test or a developer can query about the page.
window.__gjk = pages[data.kind](data);
