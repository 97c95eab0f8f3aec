// Chapter 3: a leaf, a hook and a pointer: boxes against boxes, shapes against shapes, and a ray that counts its crossings.
import {pairs} from '../core/lists.js';
import {place} from '../core/state.js';

const view = {left: -1.2, right: 6.2, bottom: -1, top: 4.6};

const cornersOf = ([left, low, right, high]) => [[left, low], [right, low], [right, high], [left, high]];

// The arrow of a mouse, its tip at a point.
const arrow = [[0, 0], [0, -0.62], [0.14, -0.49], [0.24, -0.71], [0.33, -0.67], [0.23, -0.45], [0.42, -0.43]];

export const hitTest = {
  program: 'partitioning',
  asks: 'hit_test',
  views: [view],
  parameters: {
    pointer: place([2.35, 2.05], {least: [-1, -0.8], most: [6, 4.4]}),
    leaf: place([0, 0], {least: [-1, -0.8], most: [2.6, 1]}),
    hook: place([3.1, 1.4], {least: [1, -0.8], most: [5.2, 2]}),
  },

  numbers: ({leaf, hook, pointer}) => [...leaf, ...hook, ...pointer],
  options: ({leaf, hook, pointer}) => ({'--leaf': leaf, '--hook': hook, '--pointer': pointer}),

  draw([pen], {pointer}, {drawn: {leaf, hook, crossings}, hit_tests: tests}) {
    const [x, y] = pointer, shape = ({corners}, kind) => pen.path(pairs(corners), kind, true);
    const box = ({box}, hit) => pen.path(cornersOf(box), hit ? 'box hit' : 'offset', true);
    return [[
      box(leaf, tests.boxes || tests.point_in_box), box(hook, tests.boxes),
      shape(leaf, tests.point_in_shape || tests.shapes ? 'shape hit' : 'shape'),
      shape(hook, tests.shapes ? 'shape hit' : 'shape'),
      pen.line(pointer, [view.right, y], 'thin'), ...crossings.map((each) => pen.dot([each, y], 'dot', 4.2)),
      pen.path(arrow.map(([u, v]) => [x + u, y + v]), 'pointer', true),
    ]];
  },

  answers: (state, {hit_tests: tests, drawn: {crossings}}, words) => [
    ['hitTestPoint', [words.whether(tests.point_in_box)]], ['shapeFlag', [words.whether(tests.point_in_shape), 'right']],
    [words.crossings, [String(crossings.length)]],
    ['hitTestObject', [words.whether(tests.boxes)]], [words.shapes, [words.whether(tests.shapes), 'right']]],

  told: (state, {hit_tests: tests, drawn: {crossings}}, words) => [
    tests.point_in_shape ? words.inside(crossings.length) : tests.point_in_box ? words.inBox(crossings.length) : words.outside,
    tests.shapes ? words.meet : tests.boxes ? words.boxesMeet : words.apart].join(' '),
};
