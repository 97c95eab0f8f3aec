// The figures of a chapter in the language of the edition, drawn by the chapter's own program.
import {spawnSync} from 'node:child_process';
import {join} from 'node:path';
import {binaries, complain, figureFile, language} from './book.mjs';

/// Draws them where this edition looks for them.
export function drawFigures({program, folder}) {
  const {status, stderr} = spawnSync(join(binaries, program), ['--lang', language, '--out', figureFile(`figures/${folder}`)], {encoding: 'utf8'});
  if (status !== 0) complain(program, `does not draw in ${language}: ${stderr}`);
}
