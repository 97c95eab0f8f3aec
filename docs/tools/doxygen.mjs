// Runs Doxygen over the woven pages and the library's headers; a warning is a fault.
import {spawnSync} from 'node:child_process';
import {mkdirSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {build, complain, docs, fromRoot, isOriginal, language, read, root} from './book.mjs';
import {say, scriptWords} from './words.mjs';

// Where its style sheet is: Debian's package, or a copy of one's own.
const DOXYGEN_AWESOME = process.env.DOXYGEN_AWESOME ?? '/usr/share/doxygen-awesome-css';

const inDoxygensWords = {en: 'English', 'zh-TW': 'Chinese-Traditional'};
const inHtml = {en: 'en', 'zh-TW': 'zh-Hant-TW'};

// The frame of each page, with the words of this edition.
function writeHeader() {
  const words = {language: inHtml[language], skip: say('skip'), contents: say('contents'), dark: say('dark'),
                 words: JSON.stringify(scriptWords())};
  const frame = read(docs, 'theme/header.html').replace(/\{(\w+)\}/g, (_, name) => words[name]);
  writeFileSync(join(build, 'header.html'), frame);
}

// What differs from docs/Doxyfile. An edition in another language has its own pages; the library speaks English.
function settings() {
  const place = fromRoot(build);
  const own = {OUTPUT_DIRECTORY: place, HTML_HEADER: `${place}/header.html`, OUTPUT_LANGUAGE: inDoxygensWords[language]};
  if (!isOriginal) Object.assign(own, {INPUT: `${place}/pages`, USE_MDFILE_AS_MAINPAGE: `${place}/pages/index.md`});
  return '@INCLUDE = docs/Doxyfile\n' + Object.entries(own).map(([name, value]) => `${name} = ${value}\n`).join('');
}

// Newer ones warn that nobody has brought their own words in a language up to date: nothing of ours.
const ofItsOwnWords =
  /warning: The selected output language "[^"]*" has not been updated\s+since release [\s\S]*? may appear in English\.\n/g;

export function runDoxygen() {
  mkdirSync(build, {recursive: true});
  writeHeader();
  const {status, stdout, stderr, error} =
      spawnSync('doxygen', ['-'], {cwd: root, encoding: 'utf8', input: settings(), env: {...process.env, DOXYGEN_AWESOME}});
  if (error) throw error;
  for (const line of (stdout + stderr).replaceAll(ofItsOwnWords, '').split('\n'))
    if (line.trim()) complain('doxygen', line.replace(root + '/', ''));
  if (status !== 0) complain('doxygen', `ended with status ${status}`);
}
