// Writes bunny.off from the npm package "bunny" 1.0.1:
//   npm install --prefix FOLDER bunny@1.0.1 && node convert-bunny.mjs FOLDER/node_modules/bunny/index.js
// Every number keeps the digits that it has in the package. There y points up; here, as in all scenes of the course,
// z does: (x, y, z) becomes (x, -z, y).
import { renameSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const { positions, cells } = createRequire(import.meta.url)(resolve(process.argv[2]));
const lines = [
  'OFF',
  '# The Stanford bunny, 3,674 triangles: from the npm package "bunny" 1.0.1 by Mikola Lysenko (public domain),',
  '# after the scan by Greg Turk and Marc Levoy (1994), Stanford 3D Scanning Repository,',
  '# http://graphics.stanford.edu/data/3Dscanrep/. Written by convert-bunny.mjs. z points up.',
  `${positions.length} ${cells.length} 0`,
  ...positions.map(([x, y, z]) => [x, -z, y].join(' ')),
  ...cells.map((cell) => ['3', ...cell].join(' ')),
];
const target = join(dirname(fileURLToPath(import.meta.url)), 'bunny.off');
writeFileSync(`${target}.part`, lines.join('\n') + '\n');
renameSync(`${target}.part`, target);
