import test from 'node:test'
import { panel, same } from './panel.js'

const { Refused, holdsOf, actionsOf, idling, takeOf, whenAway } = panel

test("All that is held ends at once", () => {
  const told = [], { hold, letGo } = holdsOf()
  const live = [1, 2].map(i => hold(async args => { told.push([i, args.n]); return { ok: true } }, () => told.push([i, 'end']), () => { }))
  for (const one of live) one.aim({})
  letGo()
  letGo()
  same(told, [[1, 1], [2, 1], [1, "end"], [2, "end"]])
})

test("A press is asked of the wire", async () => {
  const act = actionsOf({ act: async what => what })
  same(await act('zoom', '1/100', { percent: 5 }), {"do": "zoom", "of": "1/100", "args": {"percent": 5}})
})

test("A press without a link has an answer", async () => {
  const act = actionsOf({ act: async () => { throw new TypeError() } })
  same(await act('zoom'), {"ok": false, "text": "no link to the panel"})
})

test("A refused press tells the reason", async () => {
  const act = actionsOf({ act: async () => { throw new Refused('no token') } })
  same(await act('zoom').then(answer => answer.text), "no token")
})

test("A panel that was started anew forgets the old pictures", async () => {
  const told = [], cards = { forget: () => told.push('forget'), take: async pictures => { told.push(pictures) } }
  const panel = { tag: '', unlinked: why => told.push(why) }, take = takeOf(panel, [{ update: status => told.push(status.title) }], cards)
  await take({ tag: 'a-1', status: { title: 'Survey', closed: false }, pictures: 1 })
  await take({ tag: 'a-2', status: null, pictures: 2 })
  await take({ tag: 'b-1', status: { title: 'Survey', closed: true }, pictures: 3 })
  same(await told, ["forget", "Survey", "", 1, "", 2, "forget", "Survey", "the panel has ended", 3])
})

test("The window loses the focus, or is hidden", () => {
  const told = [], [document, window] = [globalThis.document, globalThis.window] = [new EventTarget(), new EventTarget()]
  const stay = whenAway(() => told.push('away'))
  window.dispatchEvent(new Event('blur'))
  document.dispatchEvent(new Event('visibilitychange'))       // it is seen again
  document.hidden = true
  document.dispatchEvent(new Event('visibilitychange'))
  stay()
  window.dispatchEvent(new Event('blur'))
  same(told.length, 2)
})

// A panel in which the controls have vanished, and what comes through to it
function resting(opacity) {
  const element = new EventTarget(), marks = new Set(['data-idle']), through = []
  globalThis.window = { getComputedStyle: () => ({ opacity }) }
  Object.assign(element, { querySelector: () => null, querySelectorAll: () => [{}], hasAttribute: name => marks.has(name),
    setAttribute: name => marks.add(name), removeAttribute: name => marks.delete(name) })
  const stop = idling(element)
  marks.add('data-idle')
  for (const kind of ['pointerdown', 'touchstart', 'pointerup', 'click']) element.addEventListener(kind, () => through.push(kind))
  const send = (kind, more) => {
    const event = Object.assign(new Event(kind, { cancelable: true }), more)
    element.dispatchEvent(event)
    return event.defaultPrevented
  }
  const tap = pointerType => ['pointerdown', 'touchstart', 'pointerup', 'click'].map(kind =>
    send(kind, { pointerType: kind === 'touchstart' ? undefined : pointerType, isPrimary: true, ...kind === 'click' && { detail: 1 } }))
  return { marks, through, send, tap, stop }
}

test("The touch that brings controls back does nothing else", () => {
  const { marks, through, send, tap, stop } = resting('0')
  same(tap('touch'), [true, true, true, true])
  same([through, [...marks]], [[], []])
  send('click', { pointerType: '', detail: 0 })           // a key presses a button
  same(through.splice(0), ["click"])
  send('pointerdown', { pointerType: 'touch', isPrimary: false })         // a second finger of that touch, if it lasts
  same(through.splice(0), [])
  same(tap('touch'), [false, false, false, false])
  same(through, ["pointerdown", "touchstart", "pointerup", "click"])
  stop()
})

test("A pen is a finger, and a mouse has moved there", () => {
  const pen = resting('0'), mouse = resting('0')
  pen.tap('pen')
  mouse.tap('mouse')
  same([pen.through.length, mouse.through.length], [0, 4])
  for (const one of [pen, mouse]) one.stop()
})

test("Controls that are seen act at once", () => {
  const { through, tap, stop } = resting('1')
  tap('touch')
  same(through.length, 4)
  stop()
})
