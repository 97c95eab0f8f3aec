// The site is byte for byte the same when it is built twice.
import {spawnSync} from 'node:child_process';
import {createHash} from 'node:crypto';
import {readFileSync} from 'node:fs';
import {join, relative} from 'node:path';
import {complain, docs, filesBelow, html} from '../tools/book.mjs';

function built() {
  const {status, stderr} = spawnSync(process.execPath, [join(docs, 'build.mjs')], {encoding: 'utf8'});
  if (status !== 0) stderr.trim().split('\n').forEach((line) => complain('build', line));
  return new Map(filesBelow(html).map((file) =>
    [relative(html, file), createHash('sha256').update(readFileSync(file)).digest('hex')]));
}

export function checkTwice() {
  const first = built(), second = built();
  for (const name of new Set([...first.keys(), ...second.keys()]))
    if (first.get(name) !== second.get(name)) complain(`html/${name}`, 'differs when built again');
  return `${first.size} files built twice`;
}
