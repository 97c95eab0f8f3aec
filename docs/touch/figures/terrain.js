// Chapter 5: a ball is steered over a terrain, and slides along what it meets; it stands in the middle of the picture.
import {listed} from '../core/lists.js';
import {exact, number, place, shown} from '../core/state.js';

const view = {left: -9, right: 9, bottom: -5, top: 5.4};
const larger = 5;  // so many times as long are the arrows of a step

const points = (list) => list.map(shown).join(', ');
const along = (from, way, count) => from.map((each, i) => each + count * way[i]);
const way = (from, to) => to.map((each, i) => each - from[i]);

export const terrain = {
  program: 'slide',
  asks: 'terrain',
  views: [view],
  space: {asks: 'terrain_mesh', colour: 'sky', turn: 'turn', tilt: 'tilt'},
  steered: {by: 'wish', at: 'at'},
  parameters: {
    at: exact([32, 32, 2.1], {least: [4, 4, -3], most: [60, 60, 6]}),
    wish: place([0.3, 0.3], {least: [-0.5, -0.5], most: [0.5, 0.5], step: 0.3, fine: 0.05}),
    radius: number(0.8, {least: 0.1, most: 2, step: 0.1, fine: 0.01}),
    pull: number(0.3, {least: 0, most: 1, step: 0.1, fine: 0.01}),
    turn: number(-120, {least: -180, most: 180, step: 5, fine: 1}),
    tilt: number(32, {least: 10, most: 85, step: 5, fine: 1}),
  },

  numbers: ({at, wish, radius, pull, turn, tilt}) => [...at, ...wish, pull, radius, turn, tilt],
  options: ({radius}, {drawn: {from, to}}) => ({'--terrain': 64, '--from': from, '--to': to, '--radius': radius}),

  draw: () => [[]],

  inSpace({radius}, {contacts, end, drawn: {from, to}}, space) {
    space.ball(end, radius, 'amber', 0.85);
    space.arrow(end, along(end, way(from, to), larger), 'red');
    space.arrow(end, along(end, way(from, end), larger), 'green');
    for (const {point, normal} of listed(contacts)) space.arrow(point, along(point, normal, radius + 1), 'ink');
  },

  answers: (state, {contacts, end}, words) => [
    [words.contacts, [String(listed(contacts).length)]],
    [words.triangle, ...listed(contacts).slice(0, 3).map(({triangle}) => [String(triangle)])],
    ['<i>t</i>', ...listed(contacts).slice(0, 3).map(({time}) => [shown(time)])], [words.end, [`(${points(end)})`, 'right']]],

  told: (state, {contacts, end}, words) => {
    const count = listed(contacts).length;
    return `${count ? words.meets(count) : words.free} ${words.stands(points(end))}`;
  },
};
