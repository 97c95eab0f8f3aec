// Chapter 2: a box that is turned above a floor: three bars reach twice as high as its effective radius; it lands on a
// vertex, an edge or a face.
import {threes} from '../core/lists.js';
import {number, place, shown} from '../core/state.js';

const view = {left: -3.6, right: 3.6, bottom: -1.1, top: 3.6};
const anywhere = {least: [-2.4, 0], most: [2.6, 3.3]};
const lengths = [1.8, 1.2, 0.9];  // of R, S and T
const kinds = ['red', 'green', 'pink'], letters = ['R', 'S', 'T'];

// As one sees it from the front and a little from above and the left.
const seen = ([x, y, z]) => [x + 0.35 * y, z + 0.22 * y];
const depth = (corners) => corners.reduce((sum, [, y, z]) => sum + y - 0.3 * z, 0);

// The axes of a box that is turned first about x, then about y; in degrees.
function axes({lean, turn}) {
  const [a, b] = [lean, turn].map((degrees) => degrees * Math.PI / 180);
  const [ca, sa, cb, sb] = [Math.cos(a), Math.sin(a), Math.cos(b), Math.sin(b)];
  const directions = [[cb, 0, -sb], [sb * sa, ca, cb * sa], [sb * ca, -sa, cb * ca]];
  return directions.map((direction, i) => direction.map((each) => each * lengths[i] + 0));
}

// The six faces of eight vertices, the farthest first: the bits of a vertex's number are its signs along R, S and T.
function faces(vertices) {
  const all = [1, 2, 4].flatMap((bit) => [0, bit].map((side) => {
    const [one, other] = [1, 2, 4].filter((each) => each !== bit);
    return [side, side + one, side + one + other, side + other].map((i) => vertices[i]);
  }));
  return all.sort((one, other) => depth(other) - depth(one));
}

const drawBox = (pen, numbers, kind) => faces(threes(numbers)).map((corners) => pen.path(corners.map(seen), kind, true));

// R.N, S.N and T.N stacked beside the box, from its lowest vertex to its highest.
function bars(pen, climbs, foot) {
  let low = 0;
  return climbs.map(Math.abs).flatMap((climb, i) => {
    const from = low;
    low += climb;
    const label = climb > 0.15 ? [pen.label(`*${letters[i]}*`, [foot, from + climb / 2], [9, 5], `bar-${kinds[i]}`)] : [];
    return [pen.line([foot, from], [foot, low], `bar-${kinds[i]}`), ...label];
  });
}

export const box = {
  program: 'box',
  views: [view],
  parameters: {
    from: place([-1.2, 2.4], anywhere),
    to: place([1.4, 0.2], anywhere),
    lean: number(30, {least: -90, most: 90, step: 15, fine: 1}),
    turn: number(20, {least: -90, most: 90, step: 10, fine: 1}),
  },

  numbers: (state) => [...state.from, ...state.to, ...axes(state).flat()],
  options(state) {
    const [r, s, t] = axes(state), {from, to} = state;
    return {'--from': [from[0], 0, from[1]], '--to': [to[0], 0, to[1]], '--r': r, '--s': s, '--t': t};
  },

  draw([pen], {from, to}, {effective_radius: radius, climbs, contact, drawn}) {
    const corner = (x, y) => seen([x, y, 0]), floor = [corner(-3.2, -1.4), corner(3, -1.4), corner(3, 1.4), corner(-3.2, 1.4)];
    const landed = contact ? [
      ...drawBox(pen, drawn.landed, 'box-there'), pen.arrow(from, seen(contact.center), 'motion'),
      ...Object.values(contact.points).map((point) => pen.dot(seen(point), 'lit', 5))] : [];
    return [[
      pen.path(floor, 'ground', true), pen.path(floor, 'obstacle', true), pen.line([-3.3, radius], [3.3, radius], 'offset'),
      ...drawBox(pen, drawn.box, 'box'), pen.arrow(from, to, 'motion rest'), ...landed, ...bars(pen, climbs, -3.2),
      pen.label('Q_0', from, [12, -12]), pen.label('Q_1', to, [12, 18]), pen.label('E′', [3.3, radius], [0, -8], 'offset'),
    ]];
  },

  answers: (state, {effective_radius: radius, climbs, contact}, words) => [
    ['<i>r</i><sub>eff</sub>', [shown(radius)]],
    ...climbs.map(Math.abs).map((climb, i) => [`|<b>${letters[i]}</b> · <b>N</b>|`, [shown(climb), kinds[i], climb / 1.8]]),
    ['<i>t</i>', [shown(contact?.time), 'right']], [words.lands, [contact ? words[contact.feature] : '–', 'right']]],

  told: (state, {effective_radius: radius, contact}, words) => [
    words.reaches(shown(radius)), contact
      ? words.touches(words[contact.feature], shown(contact.time), Object.keys(contact.points).length) : words.free].join(' '),
};
