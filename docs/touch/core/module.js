// The book's own C++ as WebAssembly: what is asked by name is answered by an object of numbers, {contact: {time: 0.875}}.
// The module stands in a script of its own, packed, as letters, so that it can be read from a disk too; it is loaded when
// a figure first comes near.

const memory = {instance: undefined, answer: {}};
const utf8 = new TextDecoder(), utf8Of = new TextEncoder();
const buffer = () => memory.instance.exports.memory.buffer;

// A word of C++ by its address; without a length it ends at a zero.
function wordAt(address, length) {
  const all = new Uint8Array(buffer());
  return utf8.decode(all.subarray(address, length === undefined ? all.indexOf(0, address) : address + length));
}

//! [put]
// "contact/time" is put where a JSON pointer of that name leads.
function put(name, length, value) {
  const path = wordAt(name, length).split('/'), last = path.pop();
  let place = memory.answer;
  for (const part of path) place = place[part] ??= {};
  place[last] = value;
}
//! [put]

// "bunny/faces", of what a script of the page has brought.
const given = (name, length) =>
  wordAt(name, length).split('/').reduce((place, part) => place[part], globalThis.firstContactMeshes);

// What api/page.cpp calls; the rest is what the C library asks an operating system for, and there is none.
const page = {
  number: put,
  numbers: (name, length, first, count) =>
    put(name, length, [...new Float64Array(buffer(), first, count)]),
  whether: (name, length, isSo) => put(name, length, Boolean(isSo)),
  word: (name, length, word) => put(name, length, wordAt(word)),
  count: (name, length) => given(name, length).length,
  copy: (name, length, to) =>
    new Float64Array(buffer(), to, given(name, length).length).set(given(name, length)),
  text: (value, to, most) =>
    utf8Of.encodeInto(String(Number(value.toPrecision(6))), new Uint8Array(buffer(), to, most)).written,
  refused: (why) => { throw new Error(wordAt(why)); },
};
const noSystem = new Proxy({}, {get: () => () => 52});

function begin(module) {
  memory.instance = new WebAssembly.Instance(module, {page, wasi_snapshot_preview1: noSystem});
  memory.instance.exports._initialize();
}

/// Loads a script of the book.
export const script = (file) => new Promise((resolve, reject) => {
  const element = document.createElement('script');
  Object.assign(element, {src: file, onload: resolve, onerror: () => reject(new Error(`${file} is not there`))});
  document.head.append(element);
});

async function load() {
  await script('touch-module.js');
  const {body} = await fetch(`data:;base64,${globalThis.firstContactModule}`);
  const whole = await new Response(body.pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
  const module = await WebAssembly.compile(whole);
  begin(module);
  return (name, ...numbers) => ask(module, name, numbers);
}

//! [ask]
function ask(module, name, numbers) {
  memory.answer = {};
  try {
    memory.instance.exports[name](...numbers);
  } catch (refusal) {
    begin(module);  // what was refused has left its stack as it stood
    return {refused: refusal.message};
  }
  return memory.answer;
}
//! [ask]

let loaded;
/// The one function that asks, `ask('plane', ...numbers)`, loaded once for all figures of the page.
export const book = () => loaded ??= load();
