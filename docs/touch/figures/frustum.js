// Chapter 2: a plank before a camera, as seen from above: how far it is before or behind each plane of the frustum.
import {pairs} from '../core/lists.js';
import {number, place, shown} from '../core/state.js';

const view = {left: -0.6, right: 9, bottom: -3.8, top: 4.8};
const size = [0.25, 3];  // of R and S, which are level; T stands upright
const sides = ['left', 'right', 'lower', 'upper', 'near', 'far'];

function axes({turn}) {
  const angle = turn * Math.PI / 180, [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [[c * size[0], s * size[0]], [-s * size[1], c * size[1]]];
}

// From above the vertices 0, 1, 3 and 2 are the corners: the bits of a vertex's number are its signs along R and S.
const outline = ({box}) => [0, 1, 3, 2].map((i) => [box[3 * i], box[3 * i + 1]]);

// Far ends of the line in which a plane that stands upright cuts the paper.
function ends([a, c, offset]) {
  return [-20, 20].map((along) => [-a * offset - along * c, -c * offset + along * a]);
}

export const frustum = {
  program: 'box',
  asks: 'frustum',
  views: [view],
  parameters: {
    plank: place([6.18, 3.66], {least: [0.4, -4], most: [8.6, 4.6]}),
    turn: number(60, {least: -90, most: 90, step: 10, fine: 1}),
  },

  numbers: (state) => [...state.plank, ...axes(state).flat()],
  options(state) {
    const [r, s] = axes(state);
    return {'--from': [...state.plank, 0], '--r': [...r, 0], '--s': [...s, 0], '--t': [0, 0, 0.8]};
  },

  draw([pen], {plank}, {camera: {rejected}, drawn}) {
    const around = pairs(drawn.frustum), eye = [0, 0], upright = drawn.worst === 2 || drawn.worst === 3;
    const worst = drawn.planes.slice(3 * drawn.worst, 3 * drawn.worst + 3);
    return [[
      pen.path(around, 'ground', true), ...around.slice(0, 2).map((corner) => pen.line(eye, corner, 'offset')),
      ...(upright ? [] : [pen.path(ends(worst), 'printed')]), pen.path(around, 'obstacle', true),
      pen.path(outline(drawn), rejected ? 'box-there' : 'box', true), pen.dot(eye), pen.dot(plank),
      pen.label('*Q*', plank, [10, -10]),
    ]];
  },

  answers: (state, {camera: {highest, rejected}}, words) => [
    ...sides.map((side) => [words[side], [shown(highest[side]), highest[side] < 0 ? 'printed' : '']]),
    [words.verdict, [rejected ? words.rejected : words.kept, 'right']]],

  told: (state, {camera: {highest, rejected}, drawn: {worst}}, words) =>
    (rejected ? words.behind : words.before)(words[sides[worst]], shown(Math.abs(highest[sides[worst]]))),
};
