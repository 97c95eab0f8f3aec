// The figures to touch: the book's own C++ as WebAssembly, built by CMake where clang and its C library for WebAssembly
// are, and the scripts of docs/touch as one file.
import {spawnSync} from 'node:child_process';
import {existsSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {gzipSync} from 'node:zlib';
import {buildSync} from 'esbuild';
import {complain, docs, html, read, root} from './book.mjs';

const source = join(docs, 'touch'), place = join(root, 'build/touch');
const toolchain = join(root, 'tests/digest/wasm/toolchain.cmake');

const run = (command, ...options) => spawnSync(command, options, {encoding: 'utf8'});

/// Is there what makes WebAssembly of C++? Without it the book is made as it is in print.
export const canTouch = existsSync('/usr/include/wasm32-wasi') && run('clang++', '--version').status === 0;

// A build knows where it was made; in a folder that was moved or copied since it is made anew.
const isConfigured = () => existsSync(join(place, 'build.ninja')) &&
  read(place, 'CMakeCache.txt').includes(`CMAKE_HOME_DIRECTORY:INTERNAL=${source}\n`);

// CMake and Ninja know what is to be done; as a rule nothing.
function buildModule() {
  if (!isConfigured()) rmSync(place, {recursive: true, force: true});
  const configured = isConfigured() ? {status: 0} :
    run('cmake', '-G', 'Ninja', '-S', source, '-B', place, '-DCMAKE_BUILD_TYPE=None', `-DCMAKE_TOOLCHAIN_FILE=${toolchain}`);
  const built = configured.status === 0 ? run('cmake', '--build', place) : configured;
  if (built.status !== 0) complain('docs/touch', `the C++ of the figures to touch is not built: ${built.stdout}${built.stderr}`);
  return built.status === 0;
}

/// Every colour of the figures by its name, and a shade of it for letters.
export function colourVariables(forLetters) {
  const palette = read(root, 'common/first_contact/figure/palette.hpp');
  const colours = [...palette.matchAll(/constexpr Colour (\w+)\{"\w+", 0x(\w{6}), 0x(\w{6})\}/g)];
  const rules = colours.filter(([, name]) => name !== 'paper' && name !== 'ink').map(([, name, light, dark]) =>
    `  --${name}: light-dark(#${light}, #${dark});\n` +
    `  --${name}-letters: light-dark(${forLetters('#' + light, 'light')}, ${forLetters('#' + dark, 'dark')});\n`);
  return `:root {\n${rules.join('')}}\n`;
}

/// What the head of a page has that a figure to touch is on.
export const touchLinks = '<link href="touch.css" rel="stylesheet"><script src="touch.js" defer></script>\n';

// The numbers of a mesh file in the format OFF, as a script: the same digits, and so the same doubles.
function meshScript(name) {
  const lines = read(root, 'chapters/meshes', `${name}.off`).split('\n').filter((line) => line && !line.startsWith('#'));
  const vertices = lines.slice(2, 2 + parseInt(lines[1])), faces = lines.slice(2 + vertices.length);
  const numbers = (list) => list.join(' ').replaceAll(' ', ',');
  const corners = faces.map((line) => line.slice(line.indexOf(' ') + 1));
  return `(globalThis.firstContactMeshes ??= {}).${name} = {vertices: [${numbers(vertices)}], faces: [${numbers(corners)}]};\n`;
}

const bundle = (from, to, options) =>
  buildSync({entryPoints: [join(source, from)], outfile: join(html, to), bundle: true, format: 'iife', charset: 'utf8',
             logLevel: 'silent', ...options});

/// So many bytes a reader's browser may be sent for the module, packed; and as many it is sent.
export const mostBytes = 150 * 1024;
export const bytesSent = () => gzipSync(readFileSync(join(html, 'touch-module.js')), {level: 9}).length;

/// Puts into the site what its figures to touch need.
export function buildTouch() {
  if (!canTouch || !buildModule()) return;
  const packed = gzipSync(readFileSync(join(place, 'book.wasm')), {level: 9}).toString('base64');
  writeFileSync(join(html, 'touch-module.js'), `globalThis.firstContactModule = "${packed}";\n`);
  writeFileSync(join(html, 'touch-bunny.js'), meshScript('bunny'));
  bundle('main.js', 'touch.js');
  bundle('space/three.js', 'touch-space.js', {globalName: 'firstContactSpace', minify: true, legalComments: 'inline'});
}
