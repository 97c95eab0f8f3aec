import assert from 'node:assert/strict';
import {test} from 'node:test';
import {changed, marked, mutantsOf} from './tokens.mjs';

const allOf = (text) => mutantsOf(text).map((mutant) => changed(text, mutant));

test('a comparison, a sum and a number each make a mutant', () =>
  assert.deepEqual(allOf('return a < b + 1;'), ['return a <= b + 1;', 'return a < b - 1;', 'return a < b + 2;']));

test('comments, texts, directives and brackets of templates stay as they are', () => {
  for (const text of ['// a < b + 1', 'x = "a < b";', '#if A < 2', 'std::vector<int> v;', 'static_assert(a < 2);', 'T* p;'])
    assert.deepEqual(allOf(text), [], text);
});

test('a mutant keeps its name when lines above it come and go', () => {
  const [before] = mutantsOf('  return a < b;'), [after] = mutantsOf('// a line more\n\n    return a < b;');
  assert.deepEqual([after.line, after.column, after.to], [before.line, before.column, before.to]);
  assert.equal(after.number, 3);
});

test('the change is shown in its line', () => assert.equal(marked(mutantsOf('return a < b;')[0]), 'return a[< -> <=]b;'));
