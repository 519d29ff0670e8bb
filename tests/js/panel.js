// The panel's modules as one that gives all of its functions, for tests: `node --test tests/js/*.test.js`.
import assert from 'node:assert/strict'
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { pathToFileURL } from 'node:url'

const IMPORTS = /^import [^']*'\.\/([\w.]+)'\n/gm
const places = ['manager', 'video'].map(folder => new URL('../../UAV/' + folder + '/static/', import.meta.url))
const read = name => readFileSync(places.map(place => new URL(name, place)).find(existsSync), 'utf8')
const inOrder = name => [...new Set([...[...read(name).matchAll(IMPORTS)].flatMap(([, inner]) => inOrder(inner)), name])]

export const modules = Object.fromEntries(inOrder('panel.js').map(name => [name, read(name)]))
export const source = Object.values(modules).map(text => text.replace(IMPORTS, '').replace(/^export (?!default)/gm, ''))
  .join('\n')
const names = [...source.matchAll(/^(?:async )?(?:function|class|const) (\w+)/gm)].map(([, name]) => name)

async function load() {
  const folder = mkdtempSync(join(tmpdir(), 'panel-')), path = join(folder, 'panel.mjs')
  writeFileSync(path, source + '\nexport { ' + names + ' }\n')
  try { return await import(pathToFileURL(path)) } finally { rmSync(folder, { recursive: true }) }
}

export const panel = await load()

// Both are the same when they are written as JSON
export function same(given, expected) { assert.deepEqual(JSON.parse(JSON.stringify(given ?? null)), expected) }
