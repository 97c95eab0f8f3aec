// The paper map is whole and alive: each section, equation, figure, listing and printed number leads to a chapter, a
// function, a test and a figure that exist, and each printed number is the one that is computed. So are the errata.
import {existsSync} from 'node:fs';
import {join} from 'node:path';
import {chapters, complain, data, filesBelow, read, root, shownByBuild} from '../tools/book.mjs';
import {runNamed, runPrograms, valueOf} from '../tools/values.mjs';

// What the paper has.
const sections = '1.1 1.2 1.3 1.4 2.1 2.2 2.3 2.4.1 2.4.2 2.4.3 3.1.1 3.1.2 3.2.1 3.2.2 3.2.3 3.2.4 3.2.5'.split(' ');
const equations = {'1.2': 9, '1.3': 8, '1.4': 2, '2.2': 1, '2.3': 7, '2.4.2': 7};
const figures = 16, listings = 4, printedNumbers = 12;

function testNames() {
  const names = new Set();
  for (const file of filesBelow(join(root, 'tests'), (name) => name.endsWith('.cpp')))
    for (const [, text] of read(file).matchAll(/\b(?:TEST_CASE|SCENARIO|rc::prop|rc::check|prop|check)\(\s*((?:"(?:[^"\\]|\\.)*"\s*)+)/g))
      names.add([...text.matchAll(/"((?:[^"\\]|\\.)*)"/g)].map(([, part]) => part).join('').replaceAll('\\"', '"'));
  return names;
}

function identifiers() {
  const files = [...filesBelow(join(root, 'common/first_contact')), ...filesBelow(join(root, 'chapters'), (name) => /\.[ch]pp$/.test(name))];
  return new Set(files.flatMap((file) => read(file).match(/\b[A-Za-z_]\w*\b/g) ?? []));
}

const list = (value) => [value].flat().filter((part) => part !== undefined && part !== null);

function checkItem(kind, item, name, known) {
  const where = `docs/${kind}: ${name}`;
  for (const field of ['chapter', 'function', 'test', 'figure'])
    if (!list(item[field]).length) complain(where, `leads to no ${field}`);
  for (const number of list(item.chapter))
    if (!chapters.some((chapter) => chapter.number === number)) complain(where, `there is no chapter ${number}`);
  for (const word of list(item.function))
    if (!known.words.has(word)) complain(where, `there is no function ${word}`);
  for (const test of list(item.test))
    if (!known.tests.has(test)) complain(where, `there is no test "${test}"`);
  for (const figure of list(item.figure))
    if (!existsSync(join(root, 'figures', figure + '.svg'))) complain(where, `there is no figure ${figure}`);
}

function checkInventory(map) {
  const same = (what, found, wanted) => {
    for (const id of wanted) if (!found.includes(id)) complain('docs/paper-map.json', `${what} ${id} is not mapped`);
    for (const id of found) if (!wanted.includes(id)) complain('docs/paper-map.json', `the paper has no ${what} ${id}`);
    if (new Set(found).size !== found.length) complain('docs/paper-map.json', `a ${what} stands twice`);
  };
  const upTo = (n) => Array.from({length: n}, (_, i) => i + 1);
  const ids = (items) => items.map(({id}) => id);
  same('section', ids(map.sections), sections);
  same('equation', ids(map.equations), Object.entries(equations).flatMap(([section, n]) => upTo(n).map((i) => `${section}.${i}`)));
  same('figure', ids(map.figures), upTo(figures));
  same('listing', ids(map.listings), upTo(listings));
  if (map.numbers.length !== printedNumbers) complain('docs/paper-map.json', `${map.numbers.length} printed numbers, not ${printedNumbers}`);
}

// Equal to all digits that are printed.
function checkNumber({of, printed, value}) {
  try {
    const decimals = printed.split('.')[1]?.length ?? 0;
    const computed = valueOf(value);
    if (Math.abs(computed - Number(printed)) > 0.5001 * 10 ** -decimals)
      complain(`docs/paper-map.json: ${of}`, `${computed} is computed, ${printed} is printed`);
  } catch (error) {
    complain(`docs/paper-map.json: ${of}`, error.message);
  }
}

export function checkPaper() {
  const map = data('paper-map.json'), errata = data('errata.json');
  const known = {tests: testNames(), words: identifiers()};
  checkInventory(map);
  for (const kind of ['sections', 'equations', 'figures', 'listings', 'numbers'])
    for (const item of map[kind]) checkItem('paper-map.json', item, item.of ?? `${kind} ${item.id}`, known);
  for (const fault of errata) checkItem('errata.json', fault, fault.title, known);
  const derived = new Map(shownByBuild().equations);
  for (const {id, chapter} of map.equations) {
    const page = derived.get(id);
    if (!page) complain(`docs/paper-map.json: equation ${id}`, 'stands in no chapter (\\tag)');
    else if (page !== chapters[chapter - 1].id) complain(`docs/paper-map.json: equation ${id}`, `stands in ${page}, not in chapter ${chapter}`);
  }
  runPrograms();
  for (const [name, line] of Object.entries(map.runs)) try { runNamed(name, line); } catch (error) { complain(`run ${name}`, error.message.split('\n')[0]); }
  map.numbers.forEach(checkNumber);
  return `${map.sections.length} sections, ${map.equations.length} equations, ${map.figures.length} figures, ` +
         `${map.listings.length} listings, ${map.numbers.length} numbers, ${errata.length} errata`;
}
