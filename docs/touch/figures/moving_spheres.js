// Chapter 6: two moving balls, and beside them what is seen from Q: a point that moves with u, past a ball of radius d.
import {flat} from '../core/lists.js';
import {number, place, shown} from '../core/state.js';

const world = {left: -5, right: 4, bottom: -2, top: 4.6};
const relative = {left: -6, right: 3, bottom: -4.3, top: 2.3};
const anywhere = {least: [-4.8, -1.8], most: [3.8, 4.4]};

const along = (from, way, t) => [from[0] + t * way[0], from[1] + t * way[1]];

function drawWorld(pen, {p1, p2, q1, q2, rp, rq}, {contact, drawn}, words) {
  const touch = contact ? [pen.ball(flat(contact.p), rp, 'trace'), pen.ball(flat(contact.q), rq, 'trace'),
                           pen.dot(flat(contact.point)), pen.label('C', flat(contact.point), [8, 5])] : [];
  return [
    pen.caption(words.world), pen.ball(flat(drawn.q), rq, 'other'), pen.ball(flat(drawn.p), rp, 'mover'),
    pen.arrow(q1, q2, 'obstacle'), pen.arrow(p1, p2, 'motion'), ...touch,
    pen.label('P_1', p1, [-8, -15]), pen.label('P_2', p2, [10, -12]),
    pen.label('Q_1', q1, [10, -12]), pen.label('Q_2', q2, [10, 20]),
  ];
}

function drawRelative(pen, state, {drawn, t1, t2, closest_time: closest}, words) {
  const w = flat(drawn.w), u = flat(drawn.u), times = [['t_1', t1], ['t_2', t2]].filter(([, t]) => t !== undefined);
  const nearest = closest === undefined ? [] : [pen.line([0, 0], along(w, u, closest), 'normal-line')];
  return [
    pen.caption(words.fromQ), pen.ball([0, 0], drawn.d, 'other there'), pen.line(along(w, u, -9), along(w, u, 9), 'thin'),
    ...nearest, pen.arrow([0, 0], w, 'normal'), pen.arrow(w, along(w, u, 1), 'motion'),
    pen.line([0, 0], [0, drawn.d], 'offset'), pen.label('d', [0, 0.55 * drawn.d], [6, 0]),
    ...times.flatMap(([name, t]) => [pen.dot(along(w, u, t)), pen.label(name, along(w, u, t), [4, 20])]),
    pen.dot([0, 0]), pen.label('Q', [0, 0], [8, 16]), pen.label('*w*', along([0, 0], w, 0.5), [-16, -8]),
    pen.label('*u*', along(w, u, 0.3), [4, 22], 'motion'), pen.dot(flat(drawn.between), 'mover', 7),
  ];
}

export const movingSpheres = {
  program: 'moving_spheres',
  views: [world, relative],
  parameters: {
    p1: place([-3.2, 0], anywhere),
    p2: place([1.8, 0.5], anywhere),
    q1: place([1.5, 3.1], anywhere),
    q2: place([-0.5, 0.6], anywhere),
    rp: number(1.2, {least: 0, most: 1.6, step: 0.1, fine: 0.01}),
    rq: number(0.8, {least: 0, most: 1.6, step: 0.1, fine: 0.01}),
    time: number(0.5, {least: 0, most: 1, step: 0.05, fine: 0.005}),
  },
  play: {of: 'time', seconds: 3},

  numbers: ({p1, p2, q1, q2, rp, rq, time}) => [...p1, ...p2, ...q1, ...q2, rp, rq, time],
  options: ({p1, p2, q1, q2, rp, rq}) => ({
    '--p1': [p1[0], 0, p1[1]], '--p2': [p2[0], 0, p2[1]], '--rp': rp,
    '--q1': [q1[0], 0, q1[1]], '--q2': [q2[0], 0, q2[1]], '--rq': rq}),

  draw: ([left, right], ...scene) => [drawWorld(left, ...scene), drawRelative(right, ...scene)],

  answers: (state, {discriminant, t1, t2, closest_time: time, closest_distance: distance, drawn}, words) => [
    ['<i>d</i>', [shown(drawn.d)]], [words.now, [shown(drawn.distance)]],
    [words.closest, [`${shown(distance)} ${words.at} ${shown(time)}`]], [words.discriminant, [shown(discriminant)]],
    ['<i>t</i><sub>1</sub>', [shown(t1), 'right']], ['<i>t</i><sub>2</sub>', [shown(t2)]]],

  told: ({time}, {contact, discriminant, separation_time: parts, drawn}, words) => [
    contact ? words.meets(shown(contact.time), shown(parts)) : discriminant < 0 ? words.passes : words.later,
    words.distance(shown(time), shown(drawn.distance), shown(drawn.d))].join(' '),
};
