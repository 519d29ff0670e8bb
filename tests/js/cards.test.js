import test from 'node:test'
import { panel, same } from './panel.js'

const { rowOf, whereabouts, inSight } = panel

function row(of) {
  globalThis.document = { createElement: () => ({ append() { }, setAttribute() { } }) }
  return rowOf({ act: async (...asked) => ({ ok: true, asked }), hold: (send, release) => [send, release] }, of)
}

test('A row presses its own buttons', async () => {
  same(await row('1/100').act('zoom', { percent: 5 }), { ok: true, asked: ['zoom', '1/100', { percent: 5 }] })
})

test('A row holds its own buttons', async () => {
  const [send] = row('1/154/1').hold('hold', 'release')
  same((await send({ n: 1 })).asked, ['hold', '1/154/1', { n: 1 }])
})

test('What is lost says since when', () => {
  const states = [{ state: 'alive', age: 0 }, { state: 'lost', age: 12.3 }]
  same(states.map(state => whereabouts('1/100', state)), ['1/100', 'lost, 12 s'])
})

test('A card counts as seen at first', () => {
  globalThis.IntersectionObserver = class { observe() { } unobserve() { } disconnect() { } }
  same(inSight().seen('a card'), true)
})
