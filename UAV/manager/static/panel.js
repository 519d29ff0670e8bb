// The whole view of the panel in one script: `UAV.manager.server` gives it to a page, `UAV.manager.widget`
// to a notebook. It is one module with two names, `mount` for a page and a default export with `render` for anywidget.
// It has no other file and needs none. Its tests are in tests/js, and in nbs/api/manager/08_script.ipynb in Chromium.

import { button, closeButton, h, holding, letPicturesGo, paint, say, show } from './parts.js'
import { Refused, pageToken, polling, socketWire, widgetWire } from './wire.js'
import { cardsView, rowOf } from './cards.js'
import { gamepad } from './gamepad.js'
import { keysHelp, shortcuts, turnKeys, zoomKeys } from './keys.js'

// The log: The newest command is the first line. A line changes when its command is done, and a screen reader
// hears of it when it has time.
function logLine(item, entry) {
  const { at, who, what, state, text, took } = entry, now = JSON.stringify(entry)
  if (item.told === now) return
  item.told = now
  item.dataset.state = state
  const words = [at, who, what, state.toLowerCase(), text, took == null ? '' : took.toFixed(2) + ' s']
  item.replaceChildren(...words.map(word => h('span', {}, word)))
}

function logView() {
  const list = h('ol'), lines = new Map()
  const node = h('div', { class: 'log', role: 'log', 'aria-label': 'Commands', tabindex: 0 }, list)
  function update({ log }) {
    const numbers = new Set(log.map(entry => entry.n))
    for (const [n, item] of lines) if (!numbers.has(n)) lines.delete(n, item.remove())
    for (const entry of log) {
      if (!lines.has(entry.n)) lines.set(entry.n, list.insertBefore(h('li'), list.firstChild))
      logLine(lines.get(entry.n), entry)
    }
  }
  return { node, update }
}

// The bar at the top: *Exit* ends the panel for all who look at it. So it asks once more.
const DOUBLE = 500
function exitButton(row) {
  const node = h('button', { type: 'button', class: 'exit', 'data-do': 'exit' }, 'Exit')
  let timer = null, asked = 0
  const calm = () => {
    timer = null
    say(node, 'Exit')
  }
  node.addEventListener('click', ({ timeStamp }) => {
    if (timer && timeStamp - asked < DOUBLE) return
    if (timer) return row.act('exit')
    asked = timeStamp
    say(node, 'Press again to end the panel')
    timer = setTimeout(calm, 3000)
  })
  return node
}

function userButtons(row) {
  const users = ['auto', 'reset', 'pause'].map(what => button(row, what, what[0].toUpperCase() + what.slice(1)))
  for (const press of users) show(press, false)
  function update({ buttons }) {
    for (const press of users) paint(press, buttons[press.dataset.do], show(press, press.dataset.do in buttons))
  }
  return { users, update }
}

// The log is behind a button of the bar, in a drawer of its own.
function logDrawer(log, opens) {
  const close = closeButton(() => press.click())
  const node = h('aside', { class: 'drawer', hidden: true, 'aria-label': 'Log' },
    h('header', {}, h('h2', {}, 'Log'), close), log.node)
  const press = h('button', { type: 'button', 'data-open': 'log', 'aria-expanded': 'false', onclick: toggle }, 'Log')
  function toggle() {
    if (node.hidden) opens()
    show(node, node.hidden)
    press.setAttribute('aria-expanded', !node.hidden)
    if (node.hidden) press.focus({ preventScroll: true })
  }
  return { node, press, toggle, close: () => { if (!node.hidden) toggle() } }
}

function topBar(panel, ...presses) {
  const row = rowOf(panel, ''), title = h('h1'), us = h('span', { class: 'quiet' })
  const { users, update: paintUsers } = userButtons(row), link = h('span', { class: 'link', role: 'status' })
  const bar = h('fieldset', { class: 'group', 'aria-label': 'Panel' }, ...users, ...presses, exitButton(row))
  function update(status) {
    say(title, status.title)
    say(us, status.us)
    paintUsers(status)
  }
  const node = h('header', { class: 'top' }, title, us, link, bar)
  return { node, note: row.note, tell: row.tell, update, link, presses: bar }
}

// The panel: All that is held down ends at once when the link is lost, when the tab is hidden, and when the window
// loses the focus.
function holdsOf() {
  const holds = new Set()
  function hold(send, release, refused) {
    const live = holding(send, args => holds.delete(live) && release(args), refused)
    holds.add(live)
    return live
  }
  const letGo = () => { for (const live of holds) live.end() }
  return { hold, letGo }
}

// A press always gets an answer, also when there is no link.
function actionsOf(wire) {
  const failed = error => ({ ok: false, text: error instanceof Refused ? error.message : 'no link to the panel' })
  return (what, of, args) => wire.act({ do: what, of, args }).catch(failed)
}

// Without a link all buttons are off, unless the connection is patient. A panel that was started anew counts its
// pictures from the beginning: what we know of the old ones is forgotten.
function linkedOf(element, top, all, patient) {
  return why => {
    const usable = !why || !!patient
    say(top.link, why)
    for (const [what, yes] of [['unlinked', !!why], ['lost', !usable]]) element.toggleAttribute('data-' + what, yes)
    top.presses.disabled = all.disabled = !usable
  }
}

function takeOf(panel, parts, cards) {
  return async ({ tag, status, pictures }) => {
    if (panel.closed) return
    if (tag.split('-')[0] !== panel.tag.split('-')[0]) cards.forget()
    panel.tag = tag
    if (status) for (const part of parts) part.update(status)
    if (status) panel.ended = status.closed
    panel.unlinked(panel.ended ? 'the panel has ended' : '')
    await cards.take(pictures)
  }
}

// What each key does; `?` shows them.
function keyMap(element, cards, log, help) {
  const main = () => cards.hands() ?? null, toggle = which => () => main()?.toggle(which, log.close())
  const numbers = [1, 2, 3, 4, 5, 6, 7, 8, 9].map(n => [String(n), () => cards.nth(n - 1)])
  return {
    ...zoomKeys(main), ...turnKeys(main), ...Object.fromEntries(numbers), '?': help.toggle,
    ' ': () => main()?.shutter(), r: () => main()?.record(), t: () => main()?.track(),
    c: () => main()?.press('center'), d: () => main()?.press('down'),
    m: toggle('map'), f: toggle('files'), s: toggle('settings'), i: toggle('info'), l: log.toggle,
    h: () => element.toggleAttribute('data-bare'),
    Escape: () => {
      main()?.escape()
      log.close(element.removeAttribute('data-bare'))
    },
  }
}

// Controls vanish when nothing happens for five seconds, unless something turns, a drawer is open, or the pointer or
// the focus is on one of them. Who can't see a control can't mean it: where they have vanished, a touch only brings
// them back, from its first event to the click. A mouse has moved there before, which has brought them back.
const IDLE = 5000
const BUSY = '.drawer:not([hidden]), dialog[open], [data-turning], ' +
  ':is(.rail, .turned, .shots, .looks, .top .group):is(:hover, :focus-within)'
const GESTURE = ['pointerdown', 'pointermove', 'pointerup', 'pointercancel', 'touchstart', 'touchmove', 'touchend',
  'mousedown', 'mouseup', 'click', 'dblclick', 'contextmenu']
function idling(element) {
  let timer, waking = false
  const hidden = node => Number(window.getComputedStyle(node).opacity) < .5
  const asleep = () => element.hasAttribute('data-idle') &&
    [...element.querySelectorAll('.card[data-main] > :is(.rail, .looks, .shots, .turned)')].some(hidden)
  const rest = () => element.querySelector(BUSY) ? wake() : element.setAttribute('data-idle', '')
  function wake() {
    element.removeAttribute('data-idle')
    clearTimeout(timer)
    timer = setTimeout(rest, IDLE)
  }
  function first(event) {
    const { type, pointerType, isPrimary, detail } = event
    if (type === 'pointerdown' && isPrimary) waking = pointerType !== 'mouse' && asleep()
    if (!waking || pointerType === 'mouse' || type === 'click' && !detail) return       // 0: it was a key
    event.stopImmediatePropagation()
    if (event.cancelable) event.preventDefault()
    if (type === 'pointerdown') wake()
  }
  for (const kind of GESTURE) element.addEventListener(kind, first, { capture: true, passive: false })
  for (const kind of ['pointermove', 'pointerdown', 'keydown', 'focusin']) element.addEventListener(kind, wake)
  wake()
  return () => clearTimeout(timer)
}

function panelOf(element, wire) {
  const panel = { wire, closed: false, tag: '', act: actionsOf(wire), ...holdsOf() }
  const cards = cardsView(panel), list = logView(), help = keysHelp()
  const log = logDrawer(list, () => cards.hands()?.close())
  const top = topBar(panel, log.press, help.button), all = h('fieldset', { class: 'all' }, cards.node)
  const linked = linkedOf(element, top, all, wire.patient)
  panel.choose = cards.choose
  panel.unlinked = why => linked(why, why && panel.letGo())
  panel.wanted = () => ({ seen: panel.tag, after: cards.after() })
  panel.take = takeOf(panel, [top, cards, list], cards)
  cards.node.addEventListener('click', ({ target }) => { if (target.closest('[data-open]')) log.close() })
  const pads = { main: () => cards.hands() ?? null, swap: cards.next, tell: top.tell }
  const keyed = shortcuts(element, keyMap(element, cards, log, help))
  const ends = [cards.stop, gamepad(pads), idling(element), keyed]
  panel.stop = () => { for (const end of ends) end?.() }
  element.replaceChildren(all, top.node, top.note, log.node, help.node)
  return panel
}

function whenAway(f) {
  const hidden = () => { if (document.hidden) f() }
  const all = [[document, 'visibilitychange', hidden], [window, 'blur', f], [window, 'pagehide', f]]
  for (const [on, kind, heard] of all) on.addEventListener(kind, heard)
  return () => { for (const [on, kind, heard] of all) on.removeEventListener(kind, heard) }
}

// `mount` puts a panel into an element, and gives a function that takes it out. JupyterLab listens to keys all
// over the page, and `r` would make a cell raw there. An attribute of the panel tells it not to.
export function mount(element, wire) {
  element.classList.add('uav-panel')
  element.setAttribute('data-lm-suppress-shortcuts', 'true')
  const panel = panelOf(element, wire), stay = whenAway(panel.letGo)
  polling(panel, wire)
  return () => {
    panel.closed = true
    for (const end of [panel.letGo, panel.stop, stay, wire.stop]) end?.()
    letPicturesGo(element)
    element.replaceChildren()
  }
}

// A page says where the panel belongs with `data-uav-panel`. anywidget calls `render`.
export default { render: ({ model, el }) => mount(el.appendChild(h('div')), widgetWire(model)) }

const page = globalThis.document?.querySelector('[data-uav-panel]')
if (page) mount(page, socketWire(pageToken))
