// What has been judged is kept, so that a run that was broken off goes on where it stood. That a mutant is noticed stays
// true as long as its file is what it was; that it survives, as long as the whole library and its tests are.
import {createHash} from 'node:crypto';
import {appendFileSync, existsSync, mkdirSync, readFileSync} from 'node:fs';
import {dirname} from 'node:path';

const hash = (...texts) => texts.reduce((sum, text) => sum.update(text).update('\0'), createHash('sha1')).digest('hex');

export class Verdicts {
  /// \param path  of the file that keeps them, a line each
  /// \param whole  all that a survivor depends on
  constructor(path, whole) {
    this.path = path;
    this.state = hash(...whole);
    this.known = new Map();
    mkdirSync(dirname(path), {recursive: true});
    if (!existsSync(path)) return;
    for (const line of readFileSync(path, 'utf8').split('\n').filter(Boolean)) {
      const {key, fate, state} = JSON.parse(line);
      this.known.set(key, {fate, state});
    }
  }
  static key = ({file, at, to}, text) => hash(file, text, String(at), to);

  /// What became of a mutant of this text, if that is still so.
  of(mutant, text) {
    const {fate, state} = this.known.get(Verdicts.key(mutant, text)) ?? {};
    return fate === 'survives' && state !== this.state ? undefined : fate;
  }
  keep(mutant, text, fate) {
    appendFileSync(this.path, JSON.stringify({key: Verdicts.key(mutant, text), fate, state: this.state}) + '\n');
  }
}
