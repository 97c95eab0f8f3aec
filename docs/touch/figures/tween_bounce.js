// Chapter 7: the ball of programs 1 to 3, height over time; it can be frozen at any time, and its path given its name.
import {number, place, shown} from '../core/state.js';

const view = {left: -0.6, right: 10.2, bottom: -4, top: 44, tall: 0.62};
const lasts = 10;  // seconds
const samples = ({dt}) => Math.round(lasts / dt) + 1;

// So many points as can be told apart.
function curve(pen, times, heights, kind) {
  const each = Math.max(1, Math.floor(times.length / 500));
  return pen.path(times.flatMap((t, i) => i % each ? [] : [[t, heights[i]]]), kind);
}

export const tweenBounce = {
  program: 'tween_bounce',
  views: [view],
  parameters: {
    v0: number(50, {least: -25, most: 60, step: 5, fine: 0.5}),
    y0: number(25, {least: 0, most: 40, step: 5, fine: 0.5}),
    g: number(9.82, {least: 0, most: 20, step: 1, fine: 0.01}),
    restitution: number(0.5, {least: 0, most: 1, step: 0.1, fine: 0.01}),
    dt: number(0.01, {least: 0.01, most: 0.2, step: 0.01}),
    time: number(0, {least: 0, most: lasts, step: 0.5, fine: 0.01}),
    label: place([1.6, 20], {least: [0, 0], most: [9.4, 42], step: 0.5, fine: 0.1}),
  },
  play: {of: 'time', seconds: lasts},
  rightButton: 'label',

  numbers: ({v0, y0, g, restitution, dt, time}) => [v0, y0, g, dt, samples({dt}), restitution, time],
  options: ({v0, y0, g, restitution, dt}) => ({
    '--v0': v0, '--y0': y0, '--g': g, '--dt': dt, '--samples': samples({dt}), '--restitution': restitution}),

  draw([pen], {time, label}, {drawn}, words) {
    const {t, printed, physical, ball, true_ball: obeys} = drawn;
    return [[
      pen.path([[-1, 0], [11, 0], [11, -9], [-1, -9]], 'ground', true), ...pen.axes([0, 2, 4, 6, 8, 10], [0, 10, 20, 30, 40]),
      curve(pen, t, physical, 'right'), curve(pen, t, printed, 'printed'), pen.line([time, 0], [time, 42], 'thin'),
      pen.dot([time, obeys], 'ball right', 8), pen.dot([time, ball], 'mover', 8),
      pen.label('t', [9.7, 0], [0, -8]), pen.label('y', [0, 42], [8, 4]), pen.words(words.path, label, [14, 5]),
    ]];
  },

  answers: (state, {impacts, apexes, true_t1: t1, true_v1: v1, drawn}, words) => [
    [words.height, [shown(drawn.ball), 'printed'], [shown(drawn.true_ball), 'right']],
    [words.hit, [shown(impacts?.[0].time), 'printed'], [shown(t1), 'right']],
    [words.speed, [shown(impacts?.[0].speed), 'printed'], [shown(v1), 'right']],
    [words.top, [shown(apexes?.[0].height), 'printed']]],

  told: ({time}, {impacts, true_t1: t1, drawn}, words) => [
    impacts ? words.hits(shown(impacts[0].time), shown(t1)) : words.never,
    words.frozen(shown(time), shown(drawn.ball), shown(drawn.true_ball))].join(' '),
};
