// Would the tests notice? Changes one token of the library at a time, builds it, and runs the tests, until one fails.
//   node tests/mutants/mutants.mjs [--count N] [--seed N] [--jobs N] [FOLDER or FILE ...]
// Prints the survivors: mutants that no test notices. Those that cannot be noticed stand in equivalent.json, with the
// reason. Ends with status 1 if more than one in twenty of the others survives. A run that is broken off goes on where it
// stood when it is begun again.
import {execFileSync, spawn} from 'node:child_process';
import {copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {availableParallelism} from 'node:os';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';
import {parseArgs} from 'node:util';
import {changed, marked, mutantsOf} from './tokens.mjs';
import {Verdicts} from './verdicts.mjs';

const here = dirname(fileURLToPath(import.meta.url)), root = resolve(here, '../..');
const library = 'common/first_contact';
const mathematics = ['geometry', 'mesh_io', 'sweep', 'trees', 'bvh', 'batch', 'pairs', 'response', 'motion', 'stage'];
const mostSurviving = 0.05;
const secondsToRun = 120;  // of the processor, for each of the tests' programs

const secondsToBuild = 1200;

// What must notice, the quickest first: each with its program in the folder of the tests' build, and what it is asked.
const tests = ['--abort', '~[slow]'];
const judges = [
  {target: 'digest', program: 'digest/digest', words: ['data/digest.txt']},
  ...['unit_tests', 'property_tests', 'oracle_tests'].map((name) => ({target: name, program: name, words: tests})),
];

function refuse(words) {
  console.error(`course: mutants ${words}`);
  process.exit(2);
}

function wholeNumber(name, text, least) {
  const number = Number(text);
  if (!/^\d+$/.test(text) || number < least || number > 1e6) refuse(`--${name} ${text}: must be a whole number from ${least} to 1000000`);
  return number;
}

function options() {
  const known = {count: {type: 'string', default: '100'}, seed: {type: 'string', default: '1'},
                 jobs: {type: 'string', default: String(availableParallelism?.() ?? 2)}};
  try {
    const {values, positionals} = parseArgs({options: known, allowPositionals: true});
    return {count: wholeNumber('count', values.count, 1), seed: wholeNumber('seed', values.seed, 0),
            jobs: wholeNumber('jobs', values.jobs, 1), places: positionals.length ? positionals : mathematics};
  } catch (error) {
    return refuse(error.message);
  }
}

const git = (...words) => execFileSync('git', words, {cwd: root, encoding: 'utf8'}).split('\n').filter(Boolean);
const isCode = (file) => /\.[ch]pp$/.test(file);

function filesOf(place) {
  const folder = existsSync(join(root, library, place)) ? join(library, place) : place;
  const files = git('ls-files', folder).filter(isCode);
  if (!files.length) refuse(`${place}: must be a folder or a file of ${library}`);
  return files;
}

// A small generator that gives the same mutants for the same seed on every machine (mulberry32).
function chance(seed) {
  let state = seed >>> 0;
  return () => {
    state = state + 0x6D2B79F5 | 0;
    let t = Math.imul(state ^ state >>> 15, 1 | state);
    t = t + Math.imul(t ^ t >>> 7, 61 | t) ^ t;
    return ((t ^ t >>> 14) >>> 0) / 2 ** 32;
  };
}

function chosen({count, seed, places}) {
  const all = places.flatMap(filesOf).flatMap((file) =>
    mutantsOf(textOf(file)).map((mutant) => ({file, ...mutant})));
  const random = chance(seed);
  for (let i = all.length - 1; i > 0; --i) {
    const j = Math.floor(random() * (i + 1));
    [all[i], all[j]] = [all[j], all[i]];
  }
  return {mutants: all.slice(0, count), of: all.length};
}

// Runs a command, for so many seconds of the processor. \returns 'ok', 'failed' or 'without an end'
function run(folder, command, words, seconds) {
  return new Promise((done) => {
    const limited = ['-c', `ulimit -t ${seconds}; exec "$0" "$@"`, command, ...words];
    spawn('sh', limited, {cwd: folder, stdio: 'ignore'}).on('exit', (status, signal) =>
      done(status === 0 ? 'ok' : signal === 'SIGKILL' || signal === 'SIGXCPU' ? 'without an end' : 'failed'));
  });
}

// Makes a folder what the project is, and leaves alone what is the same: only what differs is compiled anew.
function copyProject(folder) {
  const same = (from, to) => existsSync(to) && readFileSync(from).equals(readFileSync(to));
  const files = git('ls-files', '-c', '-o', '--exclude-standard').filter((file) => existsSync(join(root, file)));
  for (const file of files) {
    const from = join(root, file), to = join(folder, file);
    mkdirSync(dirname(to), {recursive: true});
    if (!same(from, to)) copyFileSync(from, to);
  }
  if (!existsSync(join(folder, 'build'))) return;
  const known = new Set(files);
  for (const file of readdirSync(join(folder, library), {recursive: true}))
    if (isCode(file) && !known.has(join(library, file))) rmSync(join(folder, library, file));
}

// A copy of the project, with the library shared: so that after a change of one file only that file is compiled.
class Workshop {
  constructor(number) {
    this.folder = join(root, 'build/mutants', String(number));
    this.build = join(this.folder, 'build');
  }
  async open() {
    copyProject(this.folder);
    const set = ['-G', 'Ninja', '-DCMAKE_BUILD_TYPE=', '-DCMAKE_CXX_FLAGS=-O2', '-DBUILD_SHARED_LIBS=ON',
                 '-DCMAKE_LINK_DEPENDS_NO_SHARED=ON'];
    if (await run(this.folder, 'cmake', ['-S', '.', '-B', 'build', ...set], secondsToBuild) !== 'ok')
      throw new Error(`${this.folder}: the project as it is cannot be configured`);
    for (const judge of judges) {
      if (!await this.make(judge)) throw new Error(`${judge.target}: does not build from the project as it is`);
      if (await this.ask(judge) !== 'ok') throw new Error(`${judge.target}: fails on the project as it is`);
    }
  }
  async make({target}) {
    return await run(this.folder, 'cmake', ['--build', 'build', '-j1', '--target', target], secondsToBuild) === 'ok';
  }
  ask({program, words}) {
    return run(join(this.folder, 'tests'), join(this.build, 'tests', program), words, secondsToRun);
  }
  // \returns which of the judges noticed, 'compiler' if it is no program at all, or 'survives'
  async judge(mutant) {
    const path = join(this.folder, mutant.file), text = readFileSync(path, 'utf8');
    writeFileSync(path, changed(text, mutant));
    try {
      for (const judge of judges) {
        if (!await this.make(judge)) return 'compiler';
        const answer = await this.ask(judge);
        if (answer !== 'ok') return answer === 'failed' ? judge.target : `${judge.target}, ${answer}`;
      }
      return 'survives';
    } finally {
      writeFileSync(path, text);
    }
  }
}

const equivalent = JSON.parse(readFileSync(join(here, 'equivalent.json'), 'utf8'));
const reasonOf = ({file, line, column, to}) => equivalent.find((known) =>
  file.endsWith('/' + known.file) && known.line === line && known.column === column && known.to === to.trim())?.reason;

const textOf = (file) => readFileSync(join(root, file), 'utf8');

async function work(jobs, mutants, tell) {
  const whole = git('ls-files', library, 'tests').filter((file) => existsSync(join(root, file))).map(textOf);
  const verdicts = new Verdicts(join(root, 'build/mutants/verdicts'), whole), open = [];
  for (const mutant of mutants) {
    const fate = verdicts.of(mutant, textOf(mutant.file));
    fate ? tell(mutant, fate) : open.push(mutant);
  }
  const shops = Array.from({length: Math.min(jobs, open.length)}, (_, i) => new Workshop(i + 1));
  await Promise.all(shops.map((shop) => shop.open()));
  await Promise.all(shops.map(async (shop) => {
    for (let mutant = open.shift(); mutant; mutant = open.shift()) {
      const fate = await shop.judge(mutant);
      verdicts.keep(mutant, textOf(mutant.file), fate);
      tell(mutant, fate);
    }
  }));
}

const asked = options(), {mutants, of} = chosen(asked);
console.log(`${mutants.length} of ${of} mutants, seed ${asked.seed}`);
const counts = new Map(), survivors = [];
let excused = 0;
await work(asked.jobs, mutants, (mutant, fate) => {
  const reason = fate === 'survives' && reasonOf(mutant);
  const verdict = reason ? 'equivalent' : fate;
  counts.set(verdict, (counts.get(verdict) ?? 0) + 1);
  if (reason) ++excused;
  else if (fate === 'survives') survivors.push(mutant);
  const done = [...counts.values()].reduce((a, b) => a + b);
  if (done % 20 === 0) console.error(`  ${done} of ${mutants.length}`);
  if (fate === 'survives') console.log(`${verdict}: ${mutant.file}:${mutant.number}: ${marked(mutant)}${reason ? ` (${reason})` : ''}`);
});
const judged = mutants.length - (counts.get('compiler') ?? 0) - excused;
console.log([...counts].map(([fate, n]) => `${fate}: ${n}`).join('; '));
console.log(`${judged - survivors.length} of ${judged} noticed (${(100 * (judged - survivors.length) / Math.max(judged, 1)).toFixed(1)} %), ` +
            `${survivors.length} survive, ${excused} cannot be noticed`);
writeFileSync(join(root, 'build/mutants/survivors.json'), JSON.stringify(survivors.map(({file, line, column, to}) =>
  ({file: file.replace(library + '/', ''), line, column, to: to.trim(), reason: ''})), null, 1) + '\n');
process.exit(survivors.length > mostSurviving * judged ? 1 : 0);
