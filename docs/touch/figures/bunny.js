// Chapter 4: a ball thrown at the rabbit, which a hand turns: a ray through the pointer picks where it is sent, and the fast
// tree finds what it meets.
import {number, place, shown} from '../core/state.js';

const view = {left: -8.5, right: 7.5, bottom: -5.6, top: 6.4};
const anywhere = {least: [-8.3, -5.4], most: [7.3, 6.2], step: 0.2, fine: 0.02};
const again = 100;  // sweeps, to be long enough for the page's clock

const points = (list) => list.map(shown).join(', ');

export const bunny = {
  program: 'general_sphere',
  asks: 'bunny',
  views: [view],
  space: {mesh: 'bunny', colour: 'sky', turn: 'turn', tilt: 'tilt', point: 'aim'},
  parameters: {
    hand: place([-6.2, -3.8], anywhere),
    aim: place([1.2, 0.8], anywhere),
    turn: number(-106, {least: -180, most: 180, step: 5, fine: 1}),
    tilt: number(14, {least: -80, most: 80, step: 5, fine: 1}),
    radius: number(0.4, {least: 0, most: 1.5, step: 0.1, fine: 0.01}),
    time: number(1, {least: 0, most: 1, step: 0.05, fine: 0.01}),
  },
  play: {of: 'time', seconds: 1.2},

  numbers: ({turn, tilt, hand, aim, radius, time}) => [turn, tilt, ...hand, ...aim, radius, time],
  options: ({radius}, {drawn}) => ({
    '--mesh': 'chapters/meshes/bunny.off', '--from': drawn.from, '--to': drawn.to, '--radius': radius}),

  /// How many microseconds a sweep takes.
  measure(ask, {radius}, {drawn}) {
    const begun = performance.now();
    ask('bunny_again', ...drawn.from, ...drawn.to, radius, again);
    return (performance.now() - begun) * 1000 / again;
  },

  draw([pen], {hand, aim}, answer, words) {
    return [[pen.label(words.start, hand, [0, 26], 'motion', 'middle'),
             pen.path([[aim[0] - 0.3, aim[1]], [aim[0] + 0.3, aim[1]]], 'hair'),
             pen.path([[aim[0], aim[1] - 0.3], [aim[0], aim[1] + 0.3]], 'hair')]];
  },

  inSpace({radius}, {drawn: {from, to, ball, picked}, contact}, space) {
    space.arrow(from, contact ? contact.center : to, 'red');
    space.ball(from, radius, 'amber', 0.35);
    space.ball(ball, radius, 'amber', 0.8);
    if (picked) space.triangle(picked.triangle, 'amber');
    if (!contact) return;
    space.triangle(contact.triangle, 'green');
    space.arrow(contact.point, contact.point.map((each, i) => each + 1.6 * contact.normal[i]), 'ink');
  },

  answers: (state, {contact, drawn}, words, microseconds) => [
    ['<i>t</i>', [shown(contact?.time), 'right']], [words.feature, [contact ? words[contact.feature] : '–', 'right']],
    [words.triangle, [contact ? String(contact.triangle) : '–']], ['<i>C</i>', [contact ? `(${points(contact.point)})` : '–']],
    ['<b>N</b>', [contact ? `(${points(contact.normal)})` : '–']],
    [words.opened, [words.work(drawn.nodes, drawn.leaves)]], [words.takes, [words.micro(microseconds.toFixed(1))]]],

  told: (state, {contact, drawn}, words) => [
    drawn.picked ? words.picks(drawn.picked.triangle) : words.picksNone,
    contact ? words.touches(words[contact.feature], contact.triangle, shown(contact.time)) : words.free].join(' '),
};
