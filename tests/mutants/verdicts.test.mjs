import assert from 'node:assert/strict';
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, test} from 'node:test';
import {Verdicts} from './verdicts.mjs';

const folder = mkdtempSync(join(tmpdir(), 'verdicts-')), path = join(folder, 'kept/verdicts');
after(() => rmSync(folder, {recursive: true}));

const mutant = {file: 'a.cpp', at: 9, to: ' <= '}, other = {...mutant, to: ' > '};
new Verdicts(path, ['library', 'tests']).keep(mutant, 'a < b', 'unit_tests');
new Verdicts(path, ['library', 'tests']).keep(other, 'a < b', 'survives');

test('a mutant that was noticed is not judged again, unless its file has changed', () => {
  assert.equal(new Verdicts(path, ['library', 'more tests']).of(mutant, 'a < b'), 'unit_tests');
  assert.equal(new Verdicts(path, ['library', 'tests']).of(mutant, 'a < c'), undefined);
});

test('a survivor is judged again once the library or a test has changed', () => {
  assert.equal(new Verdicts(path, ['library', 'tests']).of(other, 'a < b'), 'survives');
  assert.equal(new Verdicts(path, ['library', 'more tests']).of(other, 'a < b'), undefined);
});
