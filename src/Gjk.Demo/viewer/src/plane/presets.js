// The figures that the plane begins with. A corner is (x, y) in the polygon's own frame.

const square = [[-1, -1], [1, -1], [1, 1], [-1, 1]];
const first = [[-1.1, -0.9], [1.1, -0.5], [0.3, 1.2]];
const second = [[-0.9, 0.2], [0.8, -1], [0.9, 1.1]];
const pentagon = [0, 1, 2, 3, 4].map((i) => {
  const angle = (2 * Math.PI * i) / 5 + 0.3;
  return [1.3 * Math.cos(angle), 1.3 * Math.sin(angle)];
});

export const PRESETS = {
  triangles: {
    name: 'two triangles', a: { corners: first, at: [-1.8, -0.3] }, b: { corners: second, at: [1.7, 0.5] },
  },
  touching: {
    name: 'touching', a: { corners: square, at: [-1, 0] },
    b: { corners: [[0, 0], [1.5, -1.2], [1.5, 1]], at: [0, 0.25] },
  },
  overlap: {
    name: 'overlapping', a: { corners: pentagon, at: [-0.6, 0.1] }, b: { corners: second, at: [0.7, 0] },
  },
  parallel: {
    name: 'parallel sides', a: { corners: square, at: [-1.75, 0] }, b: { corners: square, at: [1.75, 0.5] },
  },
  origin: {
    name: 'a polygon and the origin', a: { corners: pentagon, at: [1.6, 0.9] }, b: { corners: [[0, 0]], at: [0, 0] },
  },
};
