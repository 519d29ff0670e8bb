import test from 'node:test'
import { panel, same } from './panel.js'

const { Refused, asking, wireOf, unpacked, socketWire, pageToken, widgetWire, visible, polling } = panel
const bytes = text => new TextEncoder().encode(text)
const soon = () => new Promise(resolve => setTimeout(resolve))

// A panel that keeps what is asked, with the means to answer
function far(patience) {
  const sent = [], { ask, take, drop } = asking(message => { sent.push(message) }, patience)
  return { sent, ask, take, drop }
}

test('Two views of one widget take their own answers', async () => {
  const one = far(), other = far(), asks = [one.ask('act', { do: 'zoom' }, 1e6), other.ask('poll', {}, 1e6)]
  for (const view of [one, other]) {
    view.take({ ref: other.sent[0].ref, tag: 'x-1' }, ['JPEG'])
    view.take({ ref: one.sent[0].ref, error: 'there is no zoom' })
  }
  const error = await asks[0].catch(error => error), { message, buffers } = await asks[1]
  same([error.message, error instanceof Refused], ['there is no zoom', true])
  same([message.tag, buffers, one.sent[0].do], ['x-1', ['JPEG'], 'zoom'])
})

test('An answer that does not come, and a link that is lost', async () => {
  const silent = far(() => new Refused('the kernel does not answer')), lost = far()
  same(await silent.ask('poll', {}, 1).catch(error => error.message), 'the kernel does not answer')
  const asked = [lost.ask('poll', {}, 1e6), lost.ask('act', {}, 1e6)].map(ask => ask.catch(error => error.message))
  lost.drop(new Error('gone'))
  same(await Promise.all(asked), ['gone', 'gone'])
  same(await far().ask('act', {}, 1).catch(error => [error.message, error instanceof Refused]), ['no link to the panel', false])
})

test('What the view may ask', async () => {
  const asked = []
  const answers = { poll: { tag: 'x-1', status: null, pictures: [['1/100', 4, 1.5, [47.4, 8.5]], ['1/101', 0, null, null]] }, ticket: { url: 'download/T/a' },
    act: { ok: true, text: 'ACCEPTED', ref: 1 }, map: { map: { type: 'FeatureCollection' } },
    tiles: { tiles: { url: '', least: 3 } }, files: { all: true, entries: [] } }
  const wire = wireOf(async (kind, more) => {
    asked.push([kind, more])
    return { message: answers[kind] ?? {}, buffers: [bytes('JPEG'), bytes('WEBP')] }
  })
  const news = await wire.poll({ seen: '', after: {} }), { '1/100': first, '1/101': second } = news.pictures
  same([news.tag, first.number, await first.blob.text(), await second.blob.text(), second.time], ['x-1', 4, 'JPEG', 'WEBP', null])
  same([first.sight, second.sight], [[47.4, 8.5], null])
  same(await wire.tiles(), { url: '', least: 3 })
  same([(await wire.tile({ z: 3, x: 4, y: 5, left: 17, n: 0 })).slice(0, 5), asked.at(-1)], ['blob:', ['tile', { z: 3, x: 4, y: 5 }]])
  same(Math.abs(Date.now() - 1500 - first.time) < 500, true)
  same(await wire.act({ do: 'zoom', of: '1/100', args: {} }), { ok: true, text: 'ACCEPTED' })
  same([await wire.map(), await wire.files('1/100', '/')], [{ type: 'FeatureCollection' }, { all: true, entries: [] }])
  same([await wire.download('1/100', '/a'), await wire.play('1/100', '/a')], ['download/T/a', 'download/T/a'])
  for (const url of [await wire.thumbnail('1/100', 3), await wire.photo('1/100', '/a')]) same(url.slice(0, 5), 'blob:')
  same(asked.slice(-4).map(([kind, { play, key }]) => [kind, play ?? key]), [['ticket', false], ['ticket', true], ['thumbnail', 3], ['photo', null]])
})

test('Pictures behind the JSON', async () => {
  same(unpacked('{"ref":1}'), [{ ref: 1 }, []])
  const head = bytes(JSON.stringify({ ref: 2, sizes: [3, 4] })), data = new Uint8Array([0, 0, 0, head.length, ...head, ...bytes('onetwo!')])
  const [message, pictures] = unpacked(data.buffer)
  same([message.ref, ...await Promise.all(pictures.map(picture => new Blob([picture]).text()))], [2, 'one', 'two!'])
})

// A browser's WebSocket, whose other side is the test
function sockets() {
  const all = []
  globalThis.location = { href: 'https://drone.local/panel/?x=1#token=my-token', hash: '#token=my-token' }
  globalThis.WebSocket = class {
    constructor(url) { all.push(Object.assign(this, { url, sent: [], closed: false })) }
    send(text) { this.sent.push(JSON.parse(text)) }
    close() { this.closed = true }
  }
  return all
}

test('A page shows its token first, and asks by the same socket', async () => {
  const all = sockets(), wire = socketWire(pageToken)
  const early = await wire.act({ do: 'zoom' }).catch(error => error.message), news = wire.poll({ seen: '', after: {} })
  same([early, all.length, all[0].url, all[0].sent], ['no link to the panel', 1, 'wss://drone.local/panel/socket', []])
  all[0].onopen()
  await soon()
  const [first, { ref, ...poll }] = all[0].sent
  same([first, poll], [{ kind: 'token', token: 'my-token' }, { kind: 'poll', seen: '', after: {} }])
  all[0].onmessage({ data: JSON.stringify({ ref, tag: 'x-1', status: {}, pictures: [] }) })
  same((await news).tag, 'x-1')
  const press = wire.act({ do: 'zoom', of: '1/100', args: {} })
  await soon()
  all[0].onmessage({ data: JSON.stringify({ ref: all[0].sent[2].ref, ok: true, text: '' }) })
  same([await press, all.length], [{ ok: true, text: '' }, 1])
  wire.stop()
  same(all[0].closed, true)
})

test('A socket that closes: what waits is over, and the next poll opens another', async () => {
  const all = sockets(), wire = socketWire('my-token'), ask = () => wire.poll({}).catch(error => [error.message, error instanceof Refused])
  const lost = ask()
  all[0].onclose({ code: 1006, reason: '' })
  same(await lost, ['no link to the panel', false])
  const refused = ask()
  all[1].onopen()
  all[1].onclose({ code: 4403, reason: 'this link has no token, or an old one' })
  same(await refused, ['this link has no token, or an old one', true])
  const next = ask()
  all[1].onclose({ code: 1006, reason: '' })            // late news of an old one
  same([all.length, all[2].closed], [3, false])
  wire.stop()
  await next
})

test('The wire of a notebook', async () => {
  const sent = [], heard = new Set()
  const model = { on: (kind, f) => heard.add(f), off: (kind, f) => heard.delete(f), send: message => { sent.push(message) } }
  const wire = widgetWire(model), news = wire.poll({ seen: '', after: {} }), tell = (...what) => { for (const f of heard) f(...what) }
  tell({ ref: sent[0].ref, tag: 'x-1', status: null, pictures: [['1/100', 4, 0]] }, [new DataView(bytes('JPEG').buffer)])
  same(await (await news).pictures['1/100'].blob.text(), 'JPEG')
  same([wire.patient, wire.download, wire.play], [true, undefined, undefined].map(x => x ?? null))
  const open = wire.act({ do: 'zoom' }).catch(error => error.message)
  wire.stop()
  same([heard.size, await open], [0, 'no link to the panel'])
})

test('A tab that is seen asks at once', async () => {
  globalThis.document = { hidden: false }
  same(await visible(), null)
})

test('The loop says why there is no link, and goes on', async () => {
  globalThis.document = { hidden: false }
  const told = [], results = ['a', new Error('gone'), new Refused('no token'), 'b']
  const panel = { wanted: () => ({}), closed: false, unlinked: why => told.push(why) }
  panel.take = async answer => { told.push(answer); panel.closed = answer === 'b' }
  const poll = async () => { const result = results.shift(); if (result instanceof Error) throw result; return result }
  await polling(panel, { poll })
  same(told, ['a', 'no link to the panel', 'no token', 'b'])
})
