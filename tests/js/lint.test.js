// A linter of a few lines, in place of a package: names that nobody declares, functions that nobody uses, and what the
// panel's script must not do. Scopes are not looked at: a name counts as declared when any function declares it.
import assert from 'node:assert/strict'
import test from 'node:test'
import { modules, panel, source } from './panel.js'

const KEYWORDS = `async await break case catch class const continue default delete do else export extends false finally for
  from function get if import in instanceof let new null of return super switch this throw true try typeof undefined void while`
const GLOBALS = `AbortController AbortSignal Array Blob Boolean DataView Date Error Image IntersectionObserver JSON Map Math
  MediaStream Number Object Promise RTCPeerConnection Set String TextDecoder WebSocket
  TextEncoder URL URLSearchParams clearInterval clearTimeout document fetch globalThis location performance setInterval setTimeout window`
const words = text => text.split(/\s+/)

// The code without comments, texts and regular expressions
function bare(code) {
  const quoted = /\/\/.*|\/\*[^]*?\*\/|'(?:\\.|[^'\\\n])*'|"(?:\\.|[^"\\\n])*"|(?<=[(,=:[!&|?{}]\s*|\breturn\s)\/(?![*/])(?:\\.|\[[^\]]*\]|[^/\n\\])+\/\w*/g
  return code.replace(quoted, found => found.startsWith('/') ? '' : "''")
}

// From an opening bracket at `from` to behind its closing one
function balanced(code, from) {
  let depth = 0
  for (let i = from; i < code.length; i++) {
    if ('([{'.includes(code[i])) depth += 1
    if (')]}'.includes(code[i]) && (depth -= 1) === 0) return code.slice(from, i + 1)
  }
  return code.slice(from)
}

const bound = pattern => pattern.match(/[A-Za-z_$][\w$]*(?!\s*:|[\w$])/g) ?? []

function declared(code) {
  const names = new Set()
  const add = found => { for (const name of found) names.add(name) }
  for (const [, name] of code.matchAll(/\b(?:function|class)\s+([\w$]+)/g)) names.add(name)
  for (const { 0: head, index } of code.matchAll(/\bfunction\b[^(]*/g)) add(bound(balanced(code, index + head.length)))
  for (const [, name] of code.matchAll(/([\w$]+)\s*=>/g)) names.add(name)
  for (const { index } of code.matchAll(/\(/g)) {
    const inside = balanced(code, index)
    if (/^\s*(=>|\{)/.test(code.slice(index + inside.length))) add(bound(inside))       // an arrow, a method, a catch
  }
  for (const [, names] of code.matchAll(/\b(?:const|let)\s+([^\n;]*)/g)) declarations(names, add)
  return names
}

// `a = 1, { b, c: d } = e, [f]`: the patterns before each `=`, and between commas that stand in no bracket
function declarations(line, add) {
  let rest = line
  while (rest) {
    const pattern = /^[{[]/.test(rest) ? balanced(rest, 0) : rest.match(/^[\w$]*/)[0]
    add(bound(pattern))
    rest = rest.slice(pattern.length)
    while (rest && rest[0] !== ',') rest = '([{'.includes(rest[0]) ? rest.slice(balanced(rest, 0).length) : rest.slice(1)
    rest = rest.replace(/^,\s*/, '')
  }
}

function used(code) {
  const all = code.matchAll(/(?<![\w$])(?<!(?<!\.\.)\.)[A-Za-z_$][\w$]*/g), keys = /^\s*:(?!:)/
  const names = [...all].filter(({ 0: name, index }) =>
    !(keys.test(code.slice(index + name.length)) && /[{,]\s*$/.test(code.slice(0, index))))
  return names.map(([name]) => name)
}

function undeclared(code) {
  const text = bare(code), known = new Set([...words(KEYWORDS), ...words(GLOBALS), ...declared(text)])
  return [...new Set(used(text).filter(name => !known.has(name)))]
}

test('The linter finds a name that nobody declares', () => {
  assert.deepEqual(undeclared("function f(a, { b: c }) { const [d] = a, e = c; return x => d + e + y + '' }"), ['y'])
  assert.deepEqual(undeclared('const f = async what => ({ what, z })'), ['z'])
})

test('Each name is declared', () => assert.deepEqual(undeclared(source), []))

test('Each module imports the names that it uses, and no other', () => {
  const own = text => [...text.matchAll(/^(?:export )?(?:async )?(?:function|class|const) (\w+)/gm)].map(([, name]) => name)
  const home = new Map(Object.entries(modules).flatMap(([file, text]) => own(text).map(name => [name, file])))
  assert.equal(home.size, Object.values(modules).flatMap(own).length, 'a name is in two modules')
  for (const [file, text] of Object.entries(modules)) {
    const body = bare(text.replace(/^import [^']*'.*'\n/gm, '')), words = used(body)
    const imported = [...text.matchAll(/^import \{([^}]*)\}/gm)].flatMap(([, names]) => names.match(/\w+/g))
    assert.deepEqual(imported.filter(name => !words.includes(name)), [], file)
    const local = new Set(declared(body)), foreign = words.filter(name => home.has(name) && home.get(name) !== file)
    assert.deepEqual([...new Set(foreign)].filter(name => !imported.includes(name) && !local.has(name)), [], file)
  }
})

test('Each function is used', () => {
  const text = used(bare(source)), count = name => text.filter(word => word === name).length
  const exported = ['mount', 'page', 'default']
  assert.deepEqual(Object.keys(panel).filter(name => !exported.includes(name) && count(name) < 2), [])
})

test('Nothing is read as HTML or as code, fetched from elsewhere, or kept', () => {
  const dangers = ['innerHTML', 'outerHTML', 'insertAdjacentHTML', 'eval(', 'new Function', 'document.write', 'https:',
    'localStorage', 'alert(', 'fetch("/', "fetch('/"]
  assert.deepEqual(dangers.filter(danger => source.includes(danger)), [])
  assert.deepEqual([...new Set(source.match(/\w+:\/\/[^'"]+/g))], ['http://www.w3.org/2000/svg'])    // the name of SVG
})

test('Lines have 120 characters at most', () => assert.deepEqual(source.split('\n').filter(line => line.length > 120), []))
