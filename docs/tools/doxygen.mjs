// Runs Doxygen over the woven pages and the library's headers; a warning is a fault.
import {spawnSync} from 'node:child_process';
import {complain, docs, root} from './book.mjs';

export function runDoxygen() {
  const {status, stdout, stderr, error} = spawnSync('doxygen', ['docs/Doxyfile'], {cwd: root, encoding: 'utf8'});
  if (error) throw error;
  for (const line of (stdout + stderr).split('\n'))
    if (line.trim()) complain('doxygen', line.replace(root + '/', ''));
  if (status !== 0) complain('doxygen', `ended with status ${status}`);
}
