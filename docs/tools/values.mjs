// The numbers of the notes: every program is run, and its results are looked up by name.
import {execFileSync} from 'node:child_process';
import {existsSync, mkdirSync} from 'node:fs';
import {join} from 'node:path';
import {binaries, build, chapters, read} from './book.mjs';

const runs = new Map();  // "plane" or "plane@steep" -> results

function run(program, name, options) {
  const folder = join(build, 'values');
  mkdirSync(folder, {recursive: true});
  const file = join(folder, name + '.json');
  const results = execFileSync(join(binaries, program), ['--json', '--no-figures', '--values', file, ...options],
                               {encoding: 'utf8', cwd: folder});
  runs.set(name, {...JSON.parse(results), ...JSON.parse(read(file))});
}

/// Runs the programs of these chapters, with their defaults, if they have been built.
export function runPrograms(wanted = chapters) {
  for (const {program} of wanted)
    if (existsSync(join(binaries, program))) run(program, program, []);
}

/// A further run that an essay asks for: <!-- run steep: plane --to 0,0,-3 -->
export function runNamed(name, line) {
  const [program, ...options] = line.trim().split(/\s+/);
  if (!chapters.some((chapter) => chapter.program === program)) throw new Error(`there is no program ${program}`);
  run(program, `${program}@${name}`, options);
}

function inside(value, path) {
  if (value === undefined || !path.length) return value;
  for (let n = path.length; n > 0; --n) {  // a name given to program.value may have dots itself
    const key = path.slice(0, n).join('.');
    if (value !== null && typeof value === 'object' && Object.hasOwn(value, key))
      return inside(value[key], path.slice(n));
  }
  return undefined;
}

function namesOf(value, prefix) {
  if (value === null || typeof value !== 'object') return [prefix];
  const parts = Array.isArray(value) ? [['0', value[0] ?? null]] : Object.entries(value);  // of a list the first stands for all
  return parts.flatMap(([key, part]) => namesOf(part, `${prefix}.${key}`));
}

/// Every name that can be looked up.
export const allNames = () => [...runs].flatMap(([name, results]) => namesOf(results, name));

/// The value of that name. \throws an Error that says which names there are.
export function valueOf(name) {
  const [program, ...path] = name.split('.');
  if (!runs.has(program)) throw new Error(`there is no run ${program} (for ${name})`);
  const value = inside(runs.get(program), path);
  if (value === undefined || value === null || typeof value === 'object')
    throw new Error(`${name} is ${value === null ? 'null' : 'no value'}; there are ${namesOf(runs.get(program), program).join(', ')}`);
  return value;
}

const trimmed = (text) => text.replace(/(\.\d*?)0+(e|$)/, '$1$2').replace(/\.(e|$)/, '$1');

function plain(value, form) {
  const [, commas, digits, kind] = /^(,?)(?:\.(\d+))?([fged%]?)$/.exec(form) ?? [];
  if (commas === undefined) throw new Error(`the format ${form} is none of .3f .4g .2e d , %`);
  const text = kind === 'f' ? value.toFixed(digits ?? 6)
             : kind === '%' ? (100 * value).toFixed(digits ?? 0)
             : kind === 'd' ? String(Math.round(value))
             : kind === 'e' ? value.toExponential(digits ?? 3)
             : trimmed(value.toPrecision(digits ?? 6));
  return commas ? text.replace(/^-?\d+/, (whole) => whole.replace(/\B(?=(\d{3})+$)/g, ',')) : text;
}

/// A value as a reader wants it: six significant digits if no format asks for others; in a formula as TeX.
export function formatted(value, form = '', inFormula = false) {
  if (typeof value !== 'number') return String(value);
  const text = plain(value === 0 ? 0 : value, form);
  const [mantissa, exponent] = text.split('e');
  if (inFormula) return mantissa.replaceAll(',', '{,}') + (exponent ? `\\times 10^{${+exponent}}` : '');
  const power = exponent ? `\u00a0×\u00a010<sup>${String(+exponent).replace('-', '−')}</sup>` : '';
  return mantissa.replace('-', '−') + power;
}
