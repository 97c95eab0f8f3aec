// Chapter 8: two discs and their impact, corrected beside as printed; energy and momentum as bars.
import {number, place, shown} from '../core/state.js';

const view = {left: -5.2, right: 5.2, bottom: -2.4, top: 2.9};
const anywhere = {least: [-4.5, -1.9], most: [4.5, 2.5]}, anyWay = {least: [-4, -2.5], most: [4, 2.5]};
const kinds = ['motion', 'right', 'printed'];  // before, after, as printed

const plus = ([a, b], [c, d]) => [a + c, b + d];

// One quantity three times, each with a bar; the longest is as long as there is room.
function balance(all, quantity, name) {
  const amounts = all.map(quantity), longest = Math.max(...amounts.map(Math.abs), 1e-9);
  return [name, ...amounts.map((amount, i) => [shown(amount), kinds[i], Math.abs(amount) / longest])];
}

const discs = (pen, radius, [one, two], kind) => [pen.ball(one, radius, `mover ${kind}`), pen.ball(two, radius, `other ${kind}`)];
const rings = (pen, radius, places, kind) => places.map((each) => pen.ball(each, radius, kind));

export const angleDemo = {
  program: 'angle_demo',
  views: [view],
  parameters: {
    p1: place([-3, 1], anywhere),
    v1: place([2, 0], {...anyWay, from: 'p1'}),
    p2: place([0.5, 0], anywhere),
    v2: place([0, 0.5], {...anyWay, from: 'p2'}),
    mass1: number(1, {least: 0.1, most: 10, step: 0.5, fine: 0.1}),
    mass2: number(1, {least: 0.1, most: 10, step: 0.5, fine: 0.1}),
    restitution: number(1, {least: 0, most: 1, step: 0.1, fine: 0.01}),
    radius: number(0.8, {least: 0, most: 1.2, step: 0.1, fine: 0.01}),
    time: number(0, {least: 0, most: 3, step: 0.1, fine: 0.01}),
  },
  play: {of: 'time', seconds: 3},

  numbers: ({p1, v1, p2, v2, mass1, mass2, restitution, radius, time}) =>
    [...p1, ...v1, ...p2, ...v2, mass1, mass2, restitution, radius, time],
  options: ({p1, v1, p2, v2, mass1, mass2, restitution, radius}) => ({
    '--mass': [mass1, mass2], '--p1': p1, '--p2': p2, '--v1': v1, '--v2': v2,
    '--restitution': restitution, '--radius': radius, '--model': 'contact'}),

  draw([pen], {p1, v1, p2, v2, radius}, {contact, printed, drawn}) {
    const after = contact.collides ? [0, 1].flatMap((i) => [
      pen.ball(drawn.met[i], radius, 'trace'), pen.arrow(drawn.met[i], plus(drawn.met[i], contact.velocities[i]), 'right')]) : [];
    const wrong = printed.collides ? [...rings(pen, radius, [drawn.printed[0], drawn.printed[1]], 'printed'),
      ...[p1, p2].map((p, i) => pen.arrow(p, plus(p, printed.velocities[i]), 'printed'))] : [];
    return [[
      ...wrong, ...discs(pen, radius, [drawn.at[0], drawn.at[1]], ''), ...after,
      pen.arrow(p1, plus(p1, v1), 'motion'), pen.arrow(p2, plus(p2, v2), 'motion'),
      pen.label('P_1', p1, [-8, -16]), pen.label('P_2', p2, [-8, -16]),
      pen.label('*v_1*', plus(p1, v1), [10, -10], 'motion'), pen.label('*v_2*', plus(p2, v2), [10, -10], 'motion'),
    ]];
  },

  answers: (state, {contact, printed, before}, words) => [
    ['<i>t</i>', [shown(contact.time), 'right']],
    [words.velocities, [pairs(contact.velocities), 'right'], [pairs(printed.velocities), 'printed']],
    balance([before, contact, printed], ({energy}) => energy, words.energy),
    balance([before, contact, printed], ({momentum}) => momentum[0], words.momentumX),
    balance([before, contact, printed], ({momentum}) => momentum[1], words.momentumY)],

  told: (state, {contact, printed}, words) => [
    contact.collides ? words.meets(shown(contact.time)) : words.misses,
    printed.collides ? contact.collides ? words.printedToo : words.printedAlone : words.printedNot].join(' '),
};

function pairs(velocities) {
  return [0, 1].map((i) => `(${velocities[i].map(shown).join(', ')})`).join(' ');
}
