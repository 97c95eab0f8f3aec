// All checks of the notes, each in a file of its own under docs/checks. Exit status 1 and a line for each fault.
//   node docs/check.mjs [NAME ...]     one or more of twice, essays, words, names, code, paper, links, editions, browser, touch,
//   print; without a name all but print, and `browser` then looks at every page
// `twice` builds the book; the others look at what was built, `print` at what ./course notes --pdf has made.
import {checkBrowser} from './checks/browser.mjs';
import {checkCode} from './checks/code.mjs';
import {checkEditions} from './checks/editions.mjs';
import {checkEssays} from './checks/essays.mjs';
import {checkLinks} from './checks/links.mjs';
import {checkNames} from './checks/names.mjs';
import {checkPaper} from './checks/paper.mjs';
import {checkPrint} from './checks/print.mjs';
import {checkTouch} from './checks/touch.mjs';
import {checkTwice} from './checks/twice.mjs';
import {checkWords} from './checks/words.mjs';
import {complaints, stopIfWrong} from './tools/book.mjs';

const all = {twice: checkTwice, essays: checkEssays, words: checkWords, names: checkNames, code: checkCode, paper: checkPaper,
             links: checkLinks, editions: checkEditions, browser: checkBrowser, touch: checkTouch, print: checkPrint};
const wanted = process.argv.slice(2);
for (const name of wanted)
  if (!all[name]) {
    console.error(`check ${name}: must be one of ${Object.keys(all).join(' ')}`);
    process.exit(2);
  }

for (const [name, check] of Object.entries(all)) {
  if (wanted.length ? !wanted.includes(name) : name === 'print') continue;
  const before = complaints.length;
  const said = await check({everyOne: !wanted.length});
  console.log(`${name}: ${said}${complaints.length > before ? `; ${complaints.length - before} faults` : ''}`);
}
stopIfWrong('checking the notes');
