// The editions in other languages: each is built, which compares it with the English one, and its links lead somewhere.
import {spawnSync} from 'node:child_process';
import {join} from 'node:path';
import {build, complain, data, docs} from '../tools/book.mjs';
import {checkLinksIn} from './links.mjs';

const others = Object.keys(data('strings.json')).filter((language) => language !== 'en');

export function checkEditions() {
  const said = others.map((language) => {
    const {status, stderr} = spawnSync(process.execPath, [join(docs, 'build.mjs'), '--lang', language], {encoding: 'utf8'});
    if (status !== 0) {
      stderr.trim().split('\n').forEach((line) => complain(language, line));
      return `${language} is not built`;
    }
    return `${language}: ${checkLinksIn(join(build, language, 'html'))}`;
  });
  return said.join('; ');
}
