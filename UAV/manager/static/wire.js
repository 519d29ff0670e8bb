// How the view gets news and sends presses: by a WebSocket on a page, by the kernel's connection in a notebook.
//
// The view needs a few functions, and doesn't depend on what is behind them. `poll` waits for news, `act` presses a
// button, and the others fetch what their names say. Both ways send the same messages, and differ only in how the
// bytes travel.
//
// What the panel refuses is for you to read, so it has a class of its own. Other errors mean that no answer came.

export class Refused extends Error { }

export const PATIENCE = 5000, NO_LINK = 'no link to the panel'

// A question has a number, and so has its answer. Two views of one widget hear each other's answers, so each begins
// at a number of its own.
export function asking(send, late = () => {}) {
  const waiting = new Map()
  let ref = Math.floor(Math.random() * 2 ** 40)
  function settle(ref, does) {
    const one = waiting.get(ref)
    if (!one) return
    waiting.delete(ref)
    clearTimeout(one.timer)
    does(one)
  }
  const take = (message, buffers) => settle(message.ref, one =>
    message.error ? one.reject(new Refused(message.error)) : one.resolve({ message, buffers }))
  const drop = error => { for (const ref of [...waiting.keys()]) settle(ref, one => one.reject(error)) }
  const ask = (kind, more, patience) => new Promise((resolve, reject) => {
    const now = ref += 1, giveUp = () => settle(now, one => one.reject(late(kind) ?? new Error(NO_LINK)))
    waiting.set(now, { resolve, reject, timer: setTimeout(giveUp, patience) })
    Promise.resolve(send({ kind, ref: now, ...more })).catch(error => settle(now, one => one.reject(error)))
  })
  return { ask, take, drop }
}

// What the view may ask. A poll is given up after ten seconds, while a press or a file may take longer. The time of a
// picture is on this computer's clock, in milliseconds, because the answer has only its age.
export function wireOf(ask, slow = 12 * PATIENCE) {
  const jpeg = bytes => new Blob([bytes], { type: 'image/jpeg' })
  const image = async (kind, more) => URL.createObjectURL(jpeg((await ask(kind, more, slow)).buffers[0]))
  async function poll(what) {
    const { message: { tag, status, pictures }, buffers } = await ask('poll', what, 2 * PATIENCE), now = Date.now()
    const shown = pictures.map(([id, number, age, sight], i) =>
      [id, { number, blob: jpeg(buffers[i]), time: age == null ? null : now - 1000 * age, sight }])
    return { tag, status, pictures: Object.fromEntries(shown) }
  }
  async function act(what) {
    const { message: { ok, text } } = await ask('act', what, slow)
    return { ok, text }
  }
  async function files(of, path) {
    const { message: { all, entries } } = await ask('files', { of, path }, slow)
    return { all, entries }
  }
  const ticket = async (of, path, play) => (await ask('ticket', { of, path, play }, slow)).message.url
  return {
    poll, act, files, thumbnail: (of, key) => image('thumbnail', { of, key }),
    map: async () => (await ask('map', {}, 2 * PATIENCE)).message.map,
    tiles: async () => (await ask('tiles', {}, 2 * PATIENCE)).message.tiles,
    tile: ({ z, x, y }) => image('tile', { z, x, y }),
    photo: (of, path) => image('photo', { of, path }),
    sight: async (of, age) => (await ask('sight', { of, age }, PATIENCE)).message.sight,
    download: (of, path) => ticket(of, path, false), play: (of, path) => ticket(of, path, true),
  }
}

// On a page: An answer with pictures is one message of bytes: the length of the JSON, the JSON, and the pictures.
export function unpacked(data) {
  if (typeof data === 'string') return [JSON.parse(data), []]
  const start = 4 + new DataView(data).getUint32(0)
  const message = JSON.parse(new TextDecoder().decode(data.slice(4, start)))
  let at = start
  return [message, message.sizes.map(size => data.slice(at, at += size))]
}

// The token stands behind the # of the address, which a browser sends to nobody.
const behind = () => new URLSearchParams(location.hash.slice(1))
export const pageToken = () => behind().get('token') ?? ''

function socketAddress() {
  const address = new URL('socket', location.href)
  address.protocol = address.protocol.replace('http', 'ws')
  address.hash = ''
  return address.href
}

// A poll opens the socket when there is none, so whoever goes on asking comes back by himself. All else needs an open
// one: a press isn't kept for later. A socket that doesn't answer a poll is given up. Codes from 4000 on are the
// panel's own, and their reason is a sentence.
export function socketWire(token) {
  let link = null
  const told = code => code === 1001 ? 'the panel has ended' : NO_LINK
  function lose(one, error) {
    if (link !== one) return
    link = null
    one.socket.close()
    drop(error)
  }
  function open() {
    const one = link = { socket: new WebSocket(socketAddress()) }, { socket } = one
    socket.binaryType = 'arraybuffer'
    socket.onmessage = ({ data }) => take(...unpacked(data))
    one.ready = new Promise(resolve => {
      socket.onopen = () => {
        const key = typeof token === 'function' ? token() : token
        resolve(socket.send(JSON.stringify({ kind: 'token', token: key })))
      }
    })
    socket.onclose = ({ code, reason }) => lose(one, code >= 4000 ? new Refused(reason) : new Error(told(code)))
    return one
  }
  async function send(message) {
    const one = link ?? (message.kind === 'poll' ? open() : null)
    if (!one) throw new Error(NO_LINK)
    await one.ready
    one.socket.send(JSON.stringify(message))
  }
  const late = kind => { if (kind === 'poll' && link) lose(link, new Error(NO_LINK)) }
  const { ask, take, drop } = asking(send, late), stop = () => { if (link) lose(link, new Error(NO_LINK)) }
  const video = async (of, offer) => (await ask('watch', { of, offer }, 2 * PATIENCE)).message.answer
  const watch = behind().has('jpeg') ? undefined : video          // `&jpeg` behind the token: pictures only as JPEGs
  return { ...wireOf(ask), watch, stop, patient: false }
}

// In a notebook: Pictures travel beside a message, as they are. The kernel may be busy, and a press is done when the
// kernel comes to it. So such a view is `patient`: buttons stay usable meanwhile. Files are saved from the page.
export function widgetWire(model) {
  const { ask, take, drop } = asking(message => model.send(message), () => new Refused('the kernel does not answer'))
  model.on('msg:custom', take)
  const stop = () => {
    model.off('msg:custom', take)
    drop(new Error(NO_LINK))
  }
  return { ...wireOf(ask, 60 * PATIENCE), download: undefined, play: undefined, stop, patient: true }
}

// The loop: A hidden tab asks for nothing. It goes on when you come back to it.
export function visible() {
  if (!document.hidden) return
  return new Promise(resolve => {
    const look = () => {
      if (document.hidden) return
      document.removeEventListener('visibilitychange', look)
      resolve()
    }
    document.addEventListener('visibilitychange', look)
  })
}

// As soon as an answer is shown, the next is asked for. So a slow browser gets fewer pictures, and never old ones.
// When no answer comes for two and a half seconds, the view says so. When the server is gone, the view tries again:
// at once, then less often, every two seconds at the most. A panel that was started anew comes back by itself.
export const SILENT = 2500, LONGEST_PAUSE = 2000
export const later = milliseconds => new Promise(resolve => setTimeout(resolve, milliseconds))
export async function polling(panel, wire) {
  let pause = 0
  while (!panel.closed) {
    await visible()
    const late = setTimeout(panel.unlinked, SILENT, 'no answer from the panel')
    try {
      await panel.take(await wire.poll(panel.wanted()))
      pause = 0
    } catch (error) {
      panel.unlinked(error instanceof Refused ? error.message : NO_LINK)
      pause = pause ? Math.min(LONGEST_PAUSE, 2 * pause) : 250
    }
    clearTimeout(late)
    if (pause) await later(pause)
  }
}
