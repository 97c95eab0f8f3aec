// What ./course format asks of the scripts, beside what ESLint itself recommends.
import js from '@eslint/js';
import globals from 'globals';

// Functions and files may be as long as those of C++, lines a little longer: HTML and patterns stay in one piece.
const rules = {
  eqeqeq: 'error',
  'max-len': ['error', {code: 130, ignoreTemplateLiterals: true, ignoreRegExpLiterals: true}],
  'max-lines': ['error', 300],
  'max-lines-per-function': ['error', {max: 40, skipComments: true}],
  'no-var': 'error',
  'object-shorthand': 'error',
  'prefer-const': 'error',
};

export default [
  js.configs.recommended,
  {languageOptions: {globals: {...globals.node, ...globals.browser}}, rules},
];
