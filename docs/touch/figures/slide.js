// Chapter 5: a ball slides along the ground and a second wall: the ways that it might go, and wall after wall.
import {flat, listed} from '../core/lists.js';
import {number, place, shown} from '../core/state.js';

const view = {left: -3.4, right: 3.6, bottom: -1.1, top: 3.1};
const anywhere = {least: [-3.2, -0.9], most: [3.4, 2.9]};
const foot = [1, 0];  // of the second wall

function drawPath(pen, positions, radius) {
  const places = positions.map(flat), end = places.at(-1);
  return [...places.slice(1, -1).map((each) => pen.ball(each, radius, 'trace')), pen.ball(end, radius, 'mover there'),
          ...places.slice(1).map((each, i) => pen.arrow(places[i], each, i ? 'right' : 'motion'))];
}

export const slide = {
  program: 'slide',
  views: [view],
  parameters: {
    p1: place([-2, 2], anywhere),
    p2: place([2.4, -0.6], anywhere),
    wall: place([1.2, 1.8], {least: [-2, 0.2], most: [2.2, 2.6], from: foot}),
    radius: number(0.5, {least: 0, most: 1, step: 0.1, fine: 0.01}),
  },

  numbers: ({p1, p2, wall, radius}) => [...p1, ...p2, ...wall, radius],
  options: ({p1, p2, wall, radius}) => ({
    '--from': [p1[0], 0, p1[1]], '--to': [p2[0], 0, p2[1]], '--wall': [wall[0], 0, wall[1]], '--radius': radius}),

  draw([pen], {p1, p2, wall, radius}, {positions, contacts, drawn, wall_after_wall: other}) {
    const top = [foot[0] + wall[0], foot[1] + wall[1]], path = listed(positions);
    const ways = listed(drawn.ways).map(({from, to}) => pen.arrow(flat(from), flat(to), 'way'));
    return [[
      pen.path([[-3, 0], [3, 0]], 'obstacle'), pen.path([foot, top], 'obstacle'),
      pen.ball(p1, radius, 'mover'), pen.line(p1, p2, 'offset'), ...ways, ...drawPath(pen, path, radius),
      ...(contacts ? [pen.ball(flat(other), radius, 'printed'), pen.dot(flat(other), 'dot printed')] : []),
      ...listed(contacts).map(({point}) => pen.dot(flat(point))),
      pen.label('P_1', p1, [-8, -16]), pen.label('P_2', p2, [12, 6]),
    ]];
  },

  answers: (state, {end, contacts, wall_after_wall: other}, words) => [
    [words.contacts, [String(listed(contacts).length)]], ['<i>t</i>', ...listed(contacts).map(({time}) => [shown(time)])],
    [words.end, [at(end), 'right']], [words.other, [at(other), 'printed']]],

  told: (state, {contacts, drawn, end}, words) => {
    const count = listed(contacts).length;
    return count ? [words.meets(count), drawn.arrived ? words.arrives(at(end)) : words.stands(at(end))].join(' ') : words.free;
  },
};

function at(point) {
  return `(${flat(point).map(shown).join(', ')})`;
}
