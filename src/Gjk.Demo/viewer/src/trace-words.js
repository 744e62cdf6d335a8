import { number } from './data.js';
import { differenceFigure } from './figure.js';
import { element } from './dom.js';

/** What the words of the page mean, with the numbers of this pair. */
export function words(model) {
  const { nameA, nameB, marginA, marginB } = model;
  const margin = (name, of) => `${name} ${of > 0 ? `has a margin of ${number(of)}` : 'is all core and has no margin'}`;
  const entries = [
    [
      'A − B',
      'All differences a − b of a point a of A and a point b of B: the Minkowski difference.',
      'A difference is the origin where a = b, so A and B share a point exactly where A − B holds the origin.',
      'Where they share none, the distance from the origin to A − B is the distance between A and B.',
      'GJK never builds A − B. It asks for one point of it at a time; this page draws all of it.',
    ],
    [
      'Support point',
      'The furthest point of a shape along a direction d.',
      'The furthest point of A − B along d is A’s furthest along d less B’s furthest against d.',
      'So each step asks both shapes once, and gets a new vertex w.',
    ],
    [
      'Simplex',
      'One to four of these vertices: a point, an edge, a triangle or a tetrahedron inside A − B.',
      'v is its point nearest the origin. |v| is an upper bound of the distance.',
    ],
    [
      'Support plane',
      'Nothing of A − B lies before the plane through w across d.',
      'The distance from the origin to the plane is a lower bound of the distance.',
      'The query ends where both bounds have met, or where the simplex holds the origin.',
    ],
    [
      'Core and margin',
      'A shape is a core and a margin, which rounds the core by one thickness.',
      'The core of a sphere is its centre, that of a capsule a segment; a box or a mesh is all core.',
      'GJK works on the cores, whose vertices are exact, and takes both margins off the distance at the end.',
      `${margin(nameA, marginA)}; ${margin(nameB, marginB)}.`,
    ],
  ];
  const [difference, ...others] = entries.map(([term, ...sentences]) => [
    element('h2', { textContent: term }),
    element('p', { textContent: sentences.join(' ') }),
  ]);
  const caption = 'In the plane: the line from B’s nearest point to A’s is the line from the origin to A − B.';
  const figure = [differenceFigure(), element('p', { className: 'quiet', textContent: caption })];
  const drag = 'gjk-demo play writes a page on which you drag two shapes, and see their A − B change.';
  return element(
    'section',
    { className: 'tab text words' },
    ...difference,
    ...figure,
    ...others.flat(),
    element('p', { className: 'quiet', textContent: drag }),
  );
}
