// Runs Doxygen over the woven pages and the library's headers; a warning is a fault.
import {spawnSync} from 'node:child_process';
import {complain, root} from './book.mjs';

// Where its style sheet is: Debian's package, or a copy of one's own.
const DOXYGEN_AWESOME = process.env.DOXYGEN_AWESOME ?? '/usr/share/doxygen-awesome-css';

export function runDoxygen() {
  const {status, stdout, stderr, error} =
      spawnSync('doxygen', ['docs/Doxyfile'], {cwd: root, encoding: 'utf8', env: {...process.env, DOXYGEN_AWESOME}});
  if (error) throw error;
  for (const line of (stdout + stderr).split('\n'))
    if (line.trim()) complain('doxygen', line.replace(root + '/', ''));
  if (status !== 0) complain('doxygen', `ended with status ${status}`);
}
