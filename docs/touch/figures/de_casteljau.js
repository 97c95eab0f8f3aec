// Chapter 7: the curve of four control points, by cutting corners; by its parameter, or by its length.
import {pairs} from '../core/lists.js';
import {number, place, shown, toggle} from '../core/state.js';

const view = {left: -0.8, right: 8.8, bottom: -0.9, top: 4.9};
const anywhere = {least: [-0.6, -0.6], most: [8.6, 4.6]};

// Four points, three, two and one.
function levelsOf(numbers) {
  const all = pairs(numbers);
  return [all.slice(0, 4), all.slice(4, 7), all.slice(7, 9), all.slice(9)];
}

export const deCasteljau = {
  program: 'tween-bounce',
  asks: 'de_casteljau',
  views: [view],
  play: {of: 'part', seconds: 4},
  parameters: {
    a: place([0, 0], anywhere), b: place([0.5, 4], anywhere), c: place([2, 4], anywhere), d: place([8, 0], anywhere),
    part: number(0.4, {least: 0, most: 1, step: 0.1, fine: 0.01}),
    even: toggle(0),
  },

  numbers: ({a, b, c, d, part, even}) => [...a, ...b, ...c, ...d, part, even],
  options: ({a, b, c, d, part}) => ({'--curve': [a, b, c, d], '--part': part}),

  draw([pen], {a, b, c, d}, {drawn: {line, dots, levels}}) {
    const [control, second, third, [point]] = levelsOf(levels);
    return [[
      pen.path(control, 'thin'), pen.path(second, 'obstacle'), pen.path(third, 'motion-line'), pen.path(pairs(line), 'right'),
      ...pairs(dots).map((dot) => pen.dot(dot, 'lit', 2.6)), ...[...second, ...third].map((each) => pen.dot(each)),
      pen.ball(point, 0.13, 'mover'),
      ...[a, b, c, d].map((each, i) => pen.label(`P_${i}`, each, [12, each[1] > 2 ? -10 : 22])),
    ]];
  },

  answers: (state, {curve}, words) => [
    [words.length, [shown(curve.length)]], [words.speed, [shown(curve.speed)]],
    [words.parameter, [shown(curve.even_parameter), 'right']]],

  told: ({part, even}, {curve}, words) => even
    ? words.evenly(...curve.even_point.slice(0, 2).map(shown), shown(part), shown(curve.length), shown(curve.even_parameter))
    : words.at(...curve.point.slice(0, 2).map(shown), shown(part), shown(curve.length)),
};
