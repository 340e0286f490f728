// SPDX-License-Identifier: Apache-2.0
// Files that MyRobotLab loads are scripts for AngularJS 1.5, files that they load are modules. No semicolons. Browsers
// provide the globals.
import js from '@eslint/js'

const browser = ['angular', 'clearInterval', 'clearTimeout', 'console', 'document', 'location', 'navigator',
    'setInterval', 'setTimeout', 'window', 'FileReader', 'WebSocket', 'Blob', 'URL', 'XMLHttpRequest', 'history',
    'confirm', 'atob', 'btoa', 'Uint8Array', 'localStorage', 'fetch', '$']

export default [
    js.configs.recommended,
    {
        languageOptions: {
            ecmaVersion: 2022,
            sourceType: 'script',
            globals: Object.fromEntries(browser.map(name => [name, 'readonly']))
        },
        linterOptions: {reportUnusedDisableDirectives: 'error'},
        rules: {
            'no-unused-vars': ['error', {args: 'none', caughtErrors: 'none'}],
            'no-use-before-define': ['error', {functions: false, variables: false}],
            'no-unexpected-multiline': 'error',
            'no-implicit-globals': 'error',
            'no-eval': 'error',
            'no-implied-eval': 'error',
            'no-new-func': 'error',
            'no-script-url': 'error',
            'no-shadow': 'error',
            'no-return-assign': 'error',
            'no-self-compare': 'error',
            'no-throw-literal': 'error',
            'no-unused-expressions': 'error',
            'no-console': ['error', {allow: ['error', 'warn']}],
            'max-len': ['error', {code: 120}],
            'max-lines-per-function': ['error', {max: 80, IIFEs: true}],
            'no-var': 'error',
            'prefer-const': 'error',
            'prefer-arrow-callback': 'error',
            'arrow-body-style': 'error',
            'object-shorthand': 'error',
            'array-callback-return': 'error',
            'default-case-last': 'error',
            'eqeqeq': ['error', 'always', {null: 'ignore'}],
            'radix': 'error',
            'semi': ['error', 'never'],
            'strict': ['error', 'never']
        }
    },
    {
        files: ['**/js/sear/**', '**/src/test/js/**'],
        languageOptions: {sourceType: 'module'},
        rules: {'no-invalid-this': 'error'}
    }
]
