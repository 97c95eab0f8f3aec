// Chapter 3: a ball that rolls among walls: what of a quadtree, a BSP tree or a tree of boxes does the search go into?
import {pairs} from '../core/lists.js';
import {choice, number, place, shown} from '../core/state.js';

const view = {left: -0.3, right: 6.7, bottom: -0.3, top: 6.2};
const trees = ['octree', 'bsp', 'bvh'];

// The parts of the plane that the tree makes: a row of numbers as api/partitioning.cpp writes it.
function partsOf(numbers) {
  const parts = [];
  for (let at = 0; at < numbers.length;) {
    const [corners, wentIn, isLeaf] = numbers.slice(at, at + 3), next = at + 3 + 2 * corners;
    parts.push({corners: pairs(numbers.slice(at + 3, next)), wentIn, isLeaf});
    at = next;
  }
  return parts.filter(({corners}) => corners.length);
}

const between = (from, to, t) => from.map((each, i) => each + t * (to[i] - each));

export const partitioning = {
  program: 'partitioning',
  views: [view],
  parameters: {
    from: place([5.9, 0.5], {least: [0, 0], most: [6.4, 5.8]}),
    to: place([0.4, 4.3], {least: [0, 0], most: [6.4, 5.8]}),
    tree: choice(0, trees),
    radius: number(0.15, {least: 0, most: 0.6, step: 0.05, fine: 0.01}),
  },

  numbers: ({from, to, radius, tree}) => [...from, ...to, radius, tree],
  options: ({from, to, radius}) => ({'--from': from, '--to': to, '--radius': radius}),

  draw([pen], {from, to, radius}, {walls: {contact}, drawn}) {
    const parts = partsOf(drawn.parts), end = contact ? between(from, to, contact.time) : to;
    const ends = pairs(drawn.walls);
    const wall = (i) => pen.line(ends[2 * i], ends[2 * i + 1], i === contact?.wall ? 'lit' : 'obstacle');
    return [[
      ...parts.filter(({wentIn, isLeaf}) => wentIn && isLeaf).map(({corners}) => pen.path(corners, 'gone-into', true)),
      ...parts.map(({corners}) => pen.path(corners, 'thin', true)),
      ...parts.filter(({wentIn}) => wentIn).map(({corners}) => pen.path(corners, 'way-in', true)),
      ...Array.from({length: ends.length / 2}, (_, i) => wall(i)),
      pen.ball(from, radius, 'mover'), pen.ball(end, radius, 'mover there'), pen.arrow(from, to, 'motion'),
    ]];
  },

  answers: ({tree}, {walls}, words) => [
    ...trees.map((name, i) =>
      [words.tree.choices[i], [words.work(walls[name].nodes, walls[name].tests), i === tree ? 'right' : '']]),
    ['<i>t</i>', [shown(walls.contact?.time)]]],

  told({tree}, {walls, walls: {contact}, drawn}, words) {
    const {nodes, tests} = walls[trees[tree]];
    return [contact ? words.touches(contact.wall + 1, shown(contact.time)) : words.free,
            words.takes(words.tree.choices[tree], nodes, tests, drawn.walls.length / 4)].join(' ');
  },
};
