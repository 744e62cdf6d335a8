import { Vector3 } from 'three';
import { number, vector } from './data.js';
import { definitions, element, player, segmented, swatch } from './dom.js';
import { PairList } from './pair-list.js';
import { SceneModel } from './scene-model.js';
import { CONTACT, IMPACT, SceneView, WAY_OUT } from './scene-view.js';
import { Stage } from './stage.js';

/** With more pairs than this, the page starts with only the lines to nearest partners. */
const MANY_PAIRS = 400;

const FRAME_MS = 60;

export function scenePage(json) {
  const model = new SceneModel(json);
  const stage = new Stage();
  const view = new SceneView(stage, model);
  if (model.pairs > MANY_PAIRS) view.lineMode = 'nearest';

  const summary = element('div', { className: 'summary' });
  const detail = element('section', { className: 'detail', hidden: true });
  const chipName = element('strong');
  const chip = element('div', { className: 'chip', hidden: true }, 'pairs of', chipName,
    element('button', { type: 'button', className: 'plain', textContent: 'show all', onclick: () => filter(-1) }));
  const list = new PairList(model, select);
  const lines = segmented('lines', [['all', 'all'], ['nearest', 'nearest'], ['none', 'none']], view.lineMode, (mode) => {
    view.lineMode = mode;
    view.paint();
  });
  const casts = segmented('paths and impacts', [[true, 'shown'], [false, 'hidden']], true, (isShown) => {
    view.showsCasts = isShown;
    view.paint();
  });
  const frames = player('frame', model.frames, showFrame, FRAME_MS);
  const tip = element('div', { className: 'tip', hidden: true });
  const legend = element('div', { className: 'legend' }, swatch('#e5484d', 'intersecting'), swatch('#38a873', 'free'),
    swatch('#fff', 'closest points'), swatch(`#${WAY_OUT.toString(16)}`, 'shortest way out'),
    swatch(`#${CONTACT.toString(16)}`, 'contact points'),
    ...(model.castData.isMoving ? [swatch(`#${IMPACT.toString(16)}`, 'path of a frame, impact')] : []),
    element('span', { textContent: 'drag to turn, scroll to zoom, click to pick' }));
  stage.root.append(legend, tip);
  document.body.append(
    element('main', { className: 'stage' }, stage.root, frames.root),
    element('aside', { className: 'side' },
      element('header', {}, element('h1', { textContent: model.name }), summary, element('div', { className: 'controls' }, 'lines', lines.root,
        element('button', { type: 'button', className: 'plain', textContent: 'reset view', onclick: () => { stage.look = null; stage.fit(view.balls()); } })),
        element('div', { className: 'controls', hidden: !model.castData.isMoving }, 'paths and impacts', casts.root)),
      chip, list.head, list.rows, detail));

  function showFrame(frame) {
    model.show(frame);
    view.update();
    list.update();
    frames.show(frame);
    const hits = model.overlapping[frame];
    document.body.dataset.overlapping = hits;
    summary.replaceChildren(
      `${model.objects} objects, ${model.allPairs} pairs, `, element('span', { className: 'hit', textContent: `${hits} intersecting` }),
      model.pairs < model.allPairs ? `; listed: those that intersect, and each object’s nearest (${model.pairs})` : '');
    showDetail();
  }

  function select(pair) {
    view.selected = pair;
    view.paint();
    list.show(pair);
    showDetail();
  }

  function filter(object) {
    list.object = object;
    chip.hidden = object < 0;
    chipName.textContent = object < 0 ? '' : model.names[object];
    list.rows.scrollTop = 0;
    list.update();
  }

  function showDetail() {
    detail.hidden = view.selected < 0;
    if (view.selected >= 0) detail.replaceChildren(element('h2', { textContent: title(view.selected) }), facts(view.selected));
  }

  const title = (pair) => `${model.names[model.a[pair]]} – ${model.names[model.b[pair]]}`;

  function facts(pair) {
    const entries = model.overlaps(pair) ? overlapFacts(pair)
      : [['distance', number(model.distance(pair))], ['normal', vector(model.normal(pair))]];
    const status = model.statusName(pair);
    if (status !== 'Separated' && status !== 'Overlapping') entries.push(['status', status]);
    return definitions([...entries, ...impactFacts(pair), ['iterations', String(model.iterations[model.index(pair)])]]);
  }

  function overlapFacts(pair) {
    const isTouching = model.distance(pair) === 0;
    const facts = [['depth', model.depth(pair) + (isTouching ? ' (touching)' : '')]];
    if (!isTouching) facts.push(['way out', vector(model.normal(pair))]);
    return [...facts, ...contactFacts(pair)];
  }

  function contactFacts(pair) {
    if (model.contactData.isLeftOut(pair)) return [['contact points', 'left out, the page has too many']];
    const gaps = model.contacts(pair).map((contact) => contact.gap);
    if (!gaps.length) return [];
    const [least, most] = [number(Math.min(...gaps)), number(Math.max(...gaps))];
    const range = least === most ? ['gap', least] : ['gaps', `${least} to ${most}`];
    return [['contact points', String(gaps.length)], range];
  }

  function impactFacts(pair) {
    const text = model.impactText(pair), impact = model.impact(pair);
    if (!text) return [];
    if (!impact?.isKnown) return [['impact', text]];
    const point = `(${impact.point.map(number).join(', ')})`;
    return [['impact after', `${text} of a frame`], ['impact at', point], ['impact normal', vector(impact.normal)]];
  }

  function describe(hit) {
    if (hit.pair !== undefined) return [element('b', { textContent: title(hit.pair) }), facts(hit.pair)];
    const name = element('b', { textContent: model.names[hit.object] });
    if (model.hit[hit.object]) {
      const hits = model.hitsOf(hit.object)
        .map((pair) => `${model.names[model.partner(pair, hit.object)]} (depth ${model.depth(pair)})`);
      return [name, `intersects ${hits.join(', ')}`];
    }
    const nearest = model.nearest[hit.object];
    if (nearest < 0) return [name];
    return [name, `nearest: ${model.names[model.partner(nearest, hit.object)]}`, facts(nearest)];
  }

  watchPointer(stage, view, {
    hover(hit, x, y) {
      tip.hidden = hit.pair === undefined && hit.object === undefined;
      if (tip.hidden) return;
      tip.replaceChildren(...describe(hit));
      const box = stage.root.getBoundingClientRect();
      tip.style.left = `${Math.max(0, Math.min(x - box.left + 16, box.width - tip.offsetWidth - 8))}px`;
      tip.style.top = `${Math.max(0, Math.min(y - box.top + 16, box.height - tip.offsetHeight - 8))}px`;
    },
    click(hit) {
      if (hit.pair !== undefined) return select(hit.pair);
      filter(hit.object ?? -1);
      select(hit.object === undefined ? -1 : list.order[0] ?? -1);
    },
  });
  showFrame(0);
  stage.fit(view.balls());

  return {
    kind: 'scene', model, view, stage, select, showFrame,
    counts: () => ({
      objects: model.objects, pairs: model.pairs, frames: model.frames, frame: model.frame,
      overlapping: model.overlapping[model.frame], lines: view.lines.pairs.length, arrows: view.arrows.pairs.length,
      contacts: view.contacts.points.length, paths: view.casts.paths, impacts: view.casts.impacts.length,
    }),
    colorOf: (object) => view.colorOf(object),
    positionOf: (object) => stage.project(model.position(object)),
    lineAt: (pair, share) => {
      const [from, to] = model.line(pair) ?? model.wayOut(pair);
      return stage.project(new Vector3().lerpVectors(from, to, share));
    },
    contactAt: (pair, i) => stage.project(model.contacts(pair)[i].ends[0]),
    impactAt: (pair) => stage.project(model.drawn(...model.impact(pair).point)),
    selected: () => view.selected,
    drawNow: () => stage.drawNow(),
  };
}

/** Handles hovering, and clicks that do not end a drag. */
function watchPointer(stage, view, { hover, click }) {
  if (!stage.renderer) return;
  const canvas = stage.renderer.domElement;
  let down = null;
  canvas.addEventListener('pointerdown', (event) => { down = [event.clientX, event.clientY]; hover({}); });
  canvas.addEventListener('pointermove', (event) => { if (!event.buttons) hover(view.pick(event.clientX, event.clientY), event.clientX, event.clientY); });
  canvas.addEventListener('pointerleave', () => hover({}));
  canvas.addEventListener('pointerup', (event) => {
    if (down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 4) click(view.pick(event.clientX, event.clientY));
    down = null;
  });
}
