// Chapter 7: a film of three keys, tested before it is played: the plan, what becomes of it, and the time line with the
// easing of both ways.
import {flat, listed, pairs} from '../core/lists.js';
import {number, place, shown} from '../core/state.js';

const end = 3, radius = 0.4, side = 1.2, depth = 4;
const stage = {left: -5.2, right: 5.2, bottom: -1.4, top: 4.6};
const chart = {left: -0.4, right: 3.3, bottom: -0.8, top: 1.5, tall: 0.577};
const ground = [0, -0.5];  // of the chart: there lies the time line
const anywhere = {least: [-4.6, -1], most: [4.6, 4]};

// A point that an easing's curve is led by: part of the time and part of the way, from one key to the next.
const lead = (start, frame) => place(start, {least: [0, -0.2], most: [1, 1.2], view: 1, frame});
const first = ({time1: [t]}) => ({base: [0, 0], unit: [t, 1]});
const second = ({time1: [t]}) => ({base: [t, 0], unit: [end - t, 1]});
const inChart = ({base, unit}, point) => point.map((each, i) => base[i] + unit[i] * each);

// As a film's file has it, without a blank.
const textOf = ({key0, key1, key2, time1: [time], in1, out1, in2, out2, box, restitution}) => JSON.stringify({
  ball: {radius},
  keys: [{time: 0, place: [key0[0], 0, key0[1]], easing: {'cubic-bezier': [...in1, ...out1]}},
         {time, place: [key1[0], 0, key1[1]], easing: {'cubic-bezier': [...in2, ...out2]}},
         {time: end, place: [key2[0], 0, key2[1]]}],
  obstacles: [{plane: [0, 0, 1, 0]}, {box: {sides: [side, depth, side], centre: [box[0], 0, box[1]]}}],
  contact: {do: 'bounce', restitution},
});

const boxAt = ([x, z]) => [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([i, k]) => [x + i * side / 2, z + k * side / 2]);
const ahead = (point, normal) => point.map((each, i) => each + 0.7 * normal[i]);

// As many as can be read.
const firstOf = (contacts) => listed(contacts).slice(0, 4);

function onStage(pen, {key0, key1, key2, box, time}, {last, contacts, drawn: {plan, way}}) {
  const all = pairs(way), made = all.slice(0, Math.floor(time / end * (all.length - 1)) + 1);
  return [
    pen.path([[-6, 0], [6, 0], [6, -3], [-6, -3]], 'ground', true), pen.path([[-6, 0], [6, 0]], 'obstacle'),
    pen.path(boxAt(box), 'solid', true), pen.path(pairs(plan), 'offset'), pen.path([...made, flat(last.place)], 'motion-line'),
    ...[key0, key1, key2].map((each) => pen.ball(each, radius, 'trace')), pen.ball(flat(last.place), radius, 'mover'),
    ...listed(contacts).flatMap(({point, normal}) =>
      [pen.arrow(flat(point), ahead(flat(point), flat(normal)), 'normal'), pen.dot(flat(point))]),
    ...[key0, key1, key2].map((each, i) => pen.label(`K_${i}`, each, [13, -13])),
  ];
}

// From one key to the next: the part of the way that is made over the time, and the two points that lead the curve.
function onWay(pen, frame, parts, leads) {
  const [a, b, c, d] = [[0, 0], ...leads, [1, 1]].map((each) => inChart(frame, each));
  return [pen.line(a, b, 'thin'), pen.line(d, c, 'thin'),
          pen.path(parts.map((part, i) => inChart(frame, [i / (parts.length - 1), part])), 'right')];
}

function onChart(pen, state, {contacts, drawn: {easings}}, words) {
  const {time1: [t], in1, out1, in2, out2, time} = state, low = ground[1];
  return [
    pen.path([[0, 1.3], [0, low], [end, low]], 'axis'),
    ...[0, 1].map((part) => pen.words(part, [0, part], [-6, 4], 'tic', 'end')),
    ...[0, 1, 2, 3].map((each) => pen.words(each, [each, low], [0, 24], 'tic', 'middle')),
    pen.words(words.part, [0, 1.3], [8, 4], 'tic'), pen.label('t', [end, low], [17, 22]),
    pen.line([t, low], [t, 1.2], 'thin'), pen.line([time, low], [time, 1.3], 'hair'),
    ...onWay(pen, first(state), easings[0], [in1, out1]), ...onWay(pen, second(state), easings[1], [in2, out2]),
    ...[0, t, end].map((each, i) => pen.label(`K_${i}`, [each, low], [10, -12])),
    ...[0, t, end].map((each) => pen.dot([each, low], 'lit', 5)),
    ...listed(contacts).map(({time: at}) => pen.dot([at, low], 'dot', 4)),
  ];
}

export const film = {
  program: 'tween_bounce',
  asks: 'film',
  views: [stage, chart],
  parameters: {
    key0: place([-4, 3.4], {least: [-4.6, 1], most: [-2.8, 4]}),
    key1: place([-0.6, -0.6], anywhere), key2: place([4.2, 2.4], anywhere),
    box: place([2.2, 0.8], {least: [-1, 0], most: [4.4, 3.6]}),
    time1: place([1.2, 0], {least: [0.2, 0], most: [2.8, 0], view: 1, from: ground}),
    in1: lead([0.42, 0], first), out1: lead([1, 1], first), in2: lead([0.42, 0], second), out2: lead([0.58, 1], second),
    restitution: number(0.6, {least: 0, most: 1, step: 0.1, fine: 0.01}),
    time: number(end, {least: 0, most: end, step: 0.1, fine: 0.01}),
  },
  play: {of: 'time', seconds: end},

  numbers: ({key0, key1, key2, time1: [t], in1, out1, in2, out2, box, restitution, time}) =>
    [radius, ...key0, ...key1, ...key2, t, end, ...in1, ...out1, ...in2, ...out2, ...box, side, depth, restitution, time],
  options: (state) => ({'--film': `'${textOf(state)}'`, '--at': state.time}),

  draw: ([left, right], state, answer, words) => [onStage(left, state, answer), onChart(right, state, answer, words)],

  answers: (state, {contacts, last}, words) => [
    [words.position, [`(${flat(last.place).map(shown).join(', ')})`]],
    [words.contacts, ...firstOf(contacts).map(({time: at}) => [shown(at)])]],

  told: ({time}, {contacts, last}, words) => [
    words.met(listed(contacts).length, firstOf(contacts).map(({time: at}) => shown(at)), shown(time)),
    words.at(flat(last.place).map(shown).join(', '))].join(' '),
};
