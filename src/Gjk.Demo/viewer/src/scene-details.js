import { number, vector, point } from './data.js';
import { button, definitions, element } from './dom.js';

/** How long a button says that it has copied. */
const COPIED_MS = 1500;

/** The words about a pair or an object: beside the list, and under the pointer. */
export class SceneDetails {
  constructor(model) {
    this.model = model;
  }

  /** The panel of a selected pair. */
  panel(pair) {
    const { model } = this;
    const points = model.pointTexts(pair);
    const extra = points
      ? [
          ['on A', points[0]],
          ['on B', points[1]],
        ]
      : [];
    const copy = button('copy', () => copyText(model.copyText(pair), copy), { title: 'copy the points' });
    return [
      element(
        'div',
        { className: 'title' },
        element('h2', { textContent: this.title(pair) }),
        ...(points ? [copy] : []),
      ),
      definitions(this.facts(pair, extra)),
    ];
  }

  /** What is under the pointer. */
  tip({ pair, object }) {
    const { model } = this;
    if (pair !== undefined) return [element('b', { textContent: this.title(pair) }), definitions(this.facts(pair))];
    const name = element('b', { textContent: model.names[object] });
    if (model.hit[object]) {
      const words = (each) => `${model.names[model.partner(each, object)]} (${model.overlapText(each)})`;
      return [name, `intersects ${model.hitsOf(object).map(words).join(', ')}`];
    }
    const nearest = model.nearest[object];
    if (nearest < 0) return [name];
    return [name, `nearest: ${model.names[model.partner(nearest, object)]}`, definitions(this.facts(nearest))];
  }

  title(pair) {
    const { names, a, b } = this.model;
    return `${names[a[pair]]} – ${names[b[pair]]}`;
  }

  facts(pair, points = []) {
    const { model } = this;
    const status = model.statusName(pair);
    const entries = model.overlaps(pair)
      ? this.overlapFacts(pair)
      : [
          ['distance', number(model.distance(pair))],
          ['normal', vector(model.normal(pair))],
        ];
    if (status !== 'Separated' && status !== 'Overlapping') entries.push(['status', status]);
    const iterations = String(model.iterations[model.index(pair)]);
    for (const [object, part] of model.partsOf(pair)) entries.push([`part of ${model.names[object]}`, String(part)]);
    return [...entries, ...points, ...this.impactFacts(pair), ['iterations', iterations]];
  }

  overlapFacts(pair) {
    const { model } = this;
    if (!model.hasDepth(pair)) return [['distance', '0']];
    const isTouching = model.distance(pair) === 0;
    const facts = [['depth', model.depth(pair) + (isTouching ? ' (touching)' : '')]];
    if (!isTouching) facts.push(['way out', vector(model.normal(pair))]);
    return [...facts, ...this.contactFacts(pair)];
  }

  contactFacts(pair) {
    const { model } = this;
    if (model.contactData.isLeftOut(pair)) return [['contact points', 'left out, the page has too many']];
    const gaps = model.contacts(pair).map((contact) => contact.gap);
    if (!gaps.length) return [];
    const [least, most] = [number(Math.min(...gaps)), number(Math.max(...gaps))];
    const range = least === most ? ['gap', least] : ['gaps', `${least} to ${most}`];
    return [['contact points', String(gaps.length)], range];
  }

  impactFacts(pair) {
    const text = this.model.impactText(pair),
      impact = this.model.impact(pair);
    if (!text) return [];
    if (!impact?.isKnown) return [['impact', text]];
    return [
      ['impact after', `${text} of a frame`],
      ['impact at', point(impact.point)],
      ['impact normal', vector(impact.normal)],
    ];
  }
}

async function copyText(text, from) {
  const isCopied =
    (await navigator.clipboard.writeText(text).then(
      () => true,
      () => false,
    )) || copySelected(text);
  from.textContent = isCopied ? 'copied' : 'cannot copy';
  setTimeout(() => {
    from.textContent = 'copy';
  }, COPIED_MS);
}

/** The older way, for browsers that keep the clipboard from pages on a disk. */
function copySelected(text) {
  const area = element('textarea', { value: text, className: 'unseen' });
  document.body.append(area);
  area.select();
  const isCopied = document.execCommand('copy');
  area.remove();
  return isCopied;
}
