// A translation that says something else than its English page is found: each kind of difference, one by one.
import assert from 'node:assert/strict';
import {createHash} from 'node:crypto';
import test from 'node:test';
import {complaints} from './book.mjs';
import {blocksOf, checkTranslation} from './translation.mjs';

const english = `# The plane

It is at $h = 2$, see §1.2 and [chapter 2](box.md), with 50 digits: {{plane.gap}}.

$$ \\text{height} = h \\tag{1.2.1} $$

![A ball above a floor.](ball.svg)
{#ball} The ball.

\\snippet plane.cpp plane

\`\`\`sh
./course run plane

./course run box
\`\`\`
`;
const markOf = (text) => createHash('sha256').update(text).digest('hex').slice(0, 8);
const marked = (text, n) => `<!-- ${markOf(blocksOf(english)[n].text)} -->\n${text}`;
const chinese = [
  marked('# 平面', 0),
  marked('高度 $h = 2$，取 50 位數，見[第 2 章](box.md)與 §1.2：{{plane.gap}}。$h = 2$ 不變。', 1),
  marked('$$ \\text{高度} = h \\tag{1.2.1} $$', 2),
  marked('![地板上方有一顆球。](ball.svg)\n{#ball} 球。', 3),
  '\\snippet plane.cpp plane',
  '```sh\n./course run plane --lang zh-TW\n\n./course run box\n```',
];

function complaintsOn(blocks) {
  complaints.length = 0;
  checkTranslation(blocksOf(blocks.join('\n\n') + '\n'), blocksOf(english),
                   {source: 'plane.zh-TW.md', file: 'plane.md', language: 'zh-TW'});
  return complaints.splice(0);
}
const changed = (n, from, to) => chinese.map((block, i) => i === n ? block.replace(from, to) : block);

test('a translation with the same formulas, values, links, pictures, listings and commands is taken', () =>
  assert.deepEqual(complaintsOn(chinese), []));

for (const [what, n, from, to, said] of [
  ['a number', 1, '50', '51', '50 is missing, 51 is not there'],
  ['a formula', 1, '$h = 2$，', '，$h = 3$', '$h = 3$ is not there'],
  ['a value', 1, 'plane.gap', 'plane.time', '{{plane.gap}} is missing'],
  ['a link', 1, 'box.md', 'slide.md', '](box.md) is missing'],
  ['a section', 1, '§1.2', '§1.3', '§1.2 is missing'],
  ['an equation', 2, '= h', '= -h', 'must be the formula'],
  ['a picture', 3, 'ball.svg', 'box.svg', 'must be the picture'],
  ['a listing', 4, 'plane.cpp', 'box.cpp', 'must be the listing'],
  ['a command', 5, 'run box', 'run slide', 'must be the command'],
  ['a mark', 1, /<!-- .* -->\n/, '', 'must stand under the mark'],
  ['its English block', 1, /<!-- .* -->/, '<!-- 00000000 -->', 'is another by now'],
])
  test(`${what} that differs is found`, () => {
    const found = complaintsOn(changed(n, from, to));
    assert.equal(found.length, 1, found.join('\n'));
    assert.ok(found[0].includes(said), found[0]);
  });

test('a block too few is found', () => assert.match(complaintsOn(chinese.slice(0, -1)).join('\n'), /has 5 blocks, its English page 6/));
