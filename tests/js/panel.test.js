import test from 'node:test'
import { panel, same } from './panel.js'

const { Refused, holdsOf, actionsOf, takeOf, whenAway } = panel

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
