// What an address asks of a figure; one that was cut, mistyped or invented asks for nothing.
import assert from 'node:assert/strict';
import test from 'node:test';
import {exact, fragmentOf, number, place, stateFrom} from './state.js';

const parameters = {from: place([1, 2], {least: [-5, -5], most: [5, 5]}),
                    radius: number(0.5, {least: 0, most: 1, step: 0.1, fine: 0.01})};
const start = {from: [1, 2], radius: 0.5};
const stateOf = (fragment) => stateFrom(fragment, 'touch-plane', parameters);

test('an address leads to the state that it was made of', () => {
  const state = {from: [-1.25, 3], radius: 0.75};
  assert.deepEqual(stateOf(fragmentOf('touch-plane', state)), state);
});

test('where a step ended is sent to the last bit', () => {
  const parameters = {at: exact([1, 2, 3], {least: [0, 0, 0], most: [9, 9, 9]})}, state = {at: [1 / 3, Math.PI, 9]};
  assert.deepEqual(stateFrom(fragmentOf('touch-terrain', state), 'touch-terrain', parameters), state);
});

for (const fragment of ['', '#', '#%', '#touch-plane:%', '#touch-plane:%E0%A4%A', '#touch-box:radius=1',
                        '#touch-planes:radius=1'])
  test(`"${fragment}" asks for no state`, () => assert.equal(stateOf(fragment) ?? undefined, undefined));

for (const said of ['', 'constructor=3', 'toString=3', '__proto__=3', 'radius=', 'radius=NaN', 'radius=1e999', 'radius=1,2',
                    'radius=0x1', 'radius= 1', 'from=1', 'from=a,b', 'from=3,', 'from=,', ';;;=;'])
  test(`"${said}" leaves the state as it is at the start`, () => assert.deepEqual(stateOf(`#touch-plane:${said}`), start));

test('what is out of range is brought into it', () =>
  assert.deepEqual(stateOf('#touch-plane:radius=-5;from=1e300,-9'), {from: [5, -5], radius: 0}));
