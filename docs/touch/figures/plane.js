// Chapter 1: a ball, a floor through P and Q, and the floor raised by the radius; what frames see; a normal of another length.
import {flat} from '../core/lists.js';
import {number, place, shown} from '../core/state.js';

const view = {left: -2.6, right: 2.6, bottom: -0.7, top: 2.95};

// N = (A, C) is at right angles to the way from P to Q; D = -N.P.
function coefficients({p, q}) {
  const [a, c] = [p[1] - q[1], q[0] - p[0]].map((each) => Number(each.toFixed(2)));
  return [a, 0, c, Number((-a * p[0] - c * p[1]).toFixed(4))].map((each) => each + 0);
}

// Far ends of the line of all points at that distance along the normal from the line E.
function ends({drawn: {normal: [a, , c], offset}}, distance) {
  const foot = [a * (distance - offset), c * (distance - offset)];
  return [-9, 9].map((along) => [foot[0] + along * c, foot[1] - along * a]);
}

const centers = ({drawn: {centers: list}}) => list.flatMap((x, i) => i % 3 ? [] : [[x, list[i + 2]]]);

// The frames of a film: rings, the first in which the two overlap stronger.
const frames = (pen, {radius}, answer) => centers(answer).map((center, i) =>
  pen.ball(center, radius, i === answer.frames?.first_overlap ? 'frame caught' : 'frame'));

function contact(pen, {from, radius}, {contact: {center, point}}, words) {
  return [pen.ball(flat(center), radius, 'mover there'), pen.arrow(from, flat(center), 'motion'), pen.dot(flat(point)),
          pen.label('C', flat(point), [7, 17]), pen.label(words.center, flat(center), [-10, 20], '', 'end')];
}

export const plane = {
  program: 'plane',
  views: [view],
  parameters: {
    from: place([-0.9, 2.1], {least: [-2.5, -0.6], most: [2.5, 2.9]}),
    to: place([0.75, 0.5], {least: [-2.5, -0.6], most: [2.5, 2.9]}),
    p: place([-2, 0], {least: [-2.5, -0.6], most: [-0.5, 1.5]}),
    q: place([2, 0], {least: [0.5, -0.6], most: [2.5, 1.5]}),
    radius: number(0.7, {least: 0, most: 1.2, step: 0.1, fine: 0.01}),
    frames: number(3, {least: 1, most: 24, step: 1}),
    length: number(2, {least: 0.25, most: 3, step: 0.25, fine: 0.05}),
  },

  numbers: (state) => [...coefficients(state), state.from[0], 0, state.from[1], state.to[0], 0, state.to[1],
                       state.radius, state.length, state.frames],
  options: (state) => ({
    '--plane': coefficients(state), '--from': [state.from[0], 0, state.from[1]], '--to': [state.to[0], 0, state.to[1]],
    '--radius': state.radius, '--length': state.length, '--frames': state.frames}),

//! [draw_plane]
  draw([pen], state, answer, words) {
    const {from, to, p, q, radius} = state, line = ends(answer, 0), raised = ends(answer, answer.drawn.raised);
    const foot = [0.7 * p[0] + 0.3 * q[0], 0.7 * p[1] + 0.3 * q[1]], [n, , m] = answer.drawn.normal;
    const half = 0.5 * state.length, tip = [foot[0] + half * n, foot[1] + half * m];  // drawn at half its length
    return [[
      pen.path([...line, [9, -9], [-9, -9]], 'ground', true),
      pen.path(line, 'obstacle'), pen.path(raised, 'offset'),
      ...frames(pen, state, answer), pen.ball(from, radius, 'mover'), pen.arrow(from, to, 'motion rest'),
      ...(answer.contact ? contact(pen, state, answer, words) : []),
      pen.arrow(foot, tip, 'normal'), pen.label('*N*', tip, [9, 8]),
      pen.dot(from), pen.dot(to), pen.label('S_0', from, [12, -12]), pen.label('S_1', to, [12, -12]),
      pen.label('P', p, [-4, 24]), pen.label('Q', q, [-4, 24]),
      pen.label('E', [2.4, heightAt(line, 2.4)], [0, 18], 'obstacle'),
      pen.label('E′', [2.4, heightAt(raised, 2.4)], [0, -8], 'offset'),
    ]];
  },
//! [draw_plane]

  answers: (state, {gap, toward, contact: found, frames: seen, scaled_time: scaled}, words) => [
    [words.gap, [shown(gap)]], ['<b>N</b> · <b>V</b>', [shown(toward)]], ['<i>t</i>', [shown(found?.time), 'right']],
    [words.frame, [shown(seen?.first_overlap)]], [words.printed, [shown(scaled), 'printed']]],

  told: ({frames: count}, {contact: found, frames: seen, gap}, words) =>
    [found ? words.touches(shown(gap), shown(found.time), ...flat(found.point).map(shown)) : words.free(shown(gap)),
     seen?.first_overlap === undefined ? found ? words.tunnels : '' : words.seen(seen.first_overlap, count)].join(' '),
};

function heightAt([[x0, y0], [x1, y1]], x) {
  return y0 + (x - x0) / (x1 - x0) * (y1 - y0);
}
