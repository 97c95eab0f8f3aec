// Runs a WebAssembly program: node run.mjs PROGRAM [FILE]. It sees the file, by the same name.
import { readFile } from 'node:fs/promises';
import { dirname, resolve } from 'node:path';
import { WASI } from 'node:wasi';

const [program, file] = process.argv.slice(2);
const folder = file ? { [dirname(resolve(file))]: dirname(resolve(file)) } : {};
const wasi = new WASI({ version: 'preview1', args: ['digest', ...(file ? [resolve(file)] : [])], preopens: folder });
const { instance } = await WebAssembly.instantiate(await readFile(program), wasi.getImportObject());
process.exitCode = wasi.start(instance);
