import { Cast } from './cast.js';
import { Depth } from './depth.js';
import { Lesson } from './lesson.js';
import { Loop } from './loop.js';
import { SHAPES } from './presets.js';
import { Search } from './search.js';
import { Support } from './support.js';

const ALL = ['line', 'regions', 'weights'];

const search = (name, shapes, layers, turns = false) => (
  { name, shapes: SHAPES[shapes], make: (model) => new Search(model, { layers, turns }) });

const other = (name, shapes, Kind) => ({ name, shapes: SHAPES[shapes], make: (model) => new Kind(model) });

/** The figures by their names in the page's address. */
export const KINDS = {
  search: search('the whole search', 'triangles', ALL, true),
  origin: other('A − B and the origin', 'book', Lesson),
  touching: other('touching', 'touching', Lesson),
  support: other('the support', 'book', Support),
  simplex: search('the simplex', 'book', []),
  bounds: search('two bounds', 'book', ['line']),
  weights: search('weights', 'book', ['weights']),
  regions: search('regions', 'triangles', ['regions']),
  overlap: search('overlapping', 'overlap', ALL, true),
  parallel: search('parallel sides', 'parallel', ALL, true),
  depth: other('the depth', 'deep', Depth),
  loop: other('a loop without end', 'loop', Loop),
  cast: other('a cast', 'book', Cast),
};
