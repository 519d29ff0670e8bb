// Keys of the whole panel, and the help that shows them.
//
// `shortcuts(node, map)` hears keys, `zoomKeys(main)` and `turnKeys(main)` make those that act while they are down,
// and `keysHelp()` is what `?` opens. All together:
//
//     const help = keysHelp(), main = () => cards.hands() ?? null
//     const end = shortcuts(element, { r: record, '?': help.toggle, ...zoomKeys(main), ...turnKeys(main) })

import { TAP, h } from './parts.js'
import { arrows, speed } from './gimbal.js'

// Which key? A page has the panel and nothing else, so its keys count wherever the focus is. In a notebook they
// count only while the focus is in the panel. Who types into a field means the field. A slider takes arrows, not
// letters, so letters still count there.
export function typing(target) {
  if (target.isContentEditable || /^(TEXTAREA|SELECT)$/.test(target.tagName)) return true
  return target.tagName === 'INPUT' && !/^(range|checkbox|radio|button)$/.test(target.type)
}

// The space bar presses the button that has the focus, and arrows scroll a list. So these count only on the picture,
// on the pad (both have the role `application`) and where nothing has the focus.
export function atHome(target, node) {
  return target === node || target === document.body || target.getAttribute('role') === 'application'
}

export function meantFor(node, target) {
  return node.contains(target) || target === document.body && node.parentElement === document.body
}

// A letter counts with Caps Lock, too, and not with Shift. `?` and `+` need Shift on some keyboards.
export function keyOf({ key, shiftKey }) { return key.length > 1 ? key : shiftKey ? key.toUpperCase() : key.toLowerCase() }

export function countsFor(node, event, key) {
  const { target, shiftKey } = event
  if (event.defaultPrevented || event.isComposing || !meantFor(node, target)) return false
  if (target.closest('dialog')) return false
  if (key === 'Escape') return target.tagName !== 'SELECT'
  if (typing(target)) return false
  return /^( |Enter|Arrow.*)$/.test(key) ? !shiftKey && atHome(target, node) : true
}

// `map` has for each key a function, or `{ down, up }` for what lasts while it is down. `up` is called when you let
// go, and also when the letting go may never be seen: the window loses the focus, the tab is hidden, a menu opens,
// or another key makes it a shortcut of the browser. A key that repeats begins nothing. Returns a function that
// ends it.
export function shortcuts(node, map) {
  const held = new Map()
  const letGo = () => {
    for (const up of held.values()) up()
    held.clear()
  }
  const down = event => {
    if (event.ctrlKey || event.altKey || event.metaKey) return letGo()
    const key = keyOf(event), does = Object.hasOwn(map, key) ? map[key] : null
    if (!does || !countsFor(node, event, key)) return
    event.preventDefault()
    if (event.repeat) return
    if (typeof does === 'function') return does(event)
    release(event)
    held.set(event.code || key, does.up)
    does.down(event)
  }
  const release = event => {
    const name = event.code || keyOf(event), up = held.get(name)
    held.delete(name)
    up?.()
  }
  const hidden = () => { if (document.hidden) letGo() }
  const all = [[document, 'keydown', down], [document, 'keyup', release], [document, 'visibilitychange', hidden],
    [document, 'contextmenu', letGo], [window, 'blur', letGo], [window, 'pagehide', letGo]]
  for (const [on, kind, heard] of all) on.addEventListener(kind, heard)
  return () => {
    for (const [on, kind, heard] of all) on.removeEventListener(kind, heard)
    letGo()
  }
}

// Zoom like the buttons beside the slider: a tap is one step, and a longer press zooms until you let go. `main` is
// what `gamepad` uses: it returns the main camera with its `row`, or null.
export function zoomKey(main, direction) {
  let row = null, timer = null, live = null
  const begin = () => {
    timer = null
    live = row.hold('zoom_hold', 'zoom_release')
    live.aim({ direction })
  }
  const down = () => {
    row = main()?.row
    if (row) timer = setTimeout(begin, TAP)
  }
  const up = () => {
    clearTimeout(timer)
    if (timer) row.act('zoom_step', { step: direction })
    live?.end()
    timer = live = null
  }
  return { down, up }
}

export function zoomKeys(main) {
  const more = zoomKey(main, 1), less = zoomKey(main, -1)
  return { '+': more, '=': more, '-': less }
}

// Arrows turn the gimbal of the main camera. It is stopped where it was begun: the main camera may be another one by
// then. After such a swap, what is still down turns nothing until you press again.
export function turnKeys(main) {
  const down = new Set()
  let turning = null
  const aim = () => {
    const now = main()
    if (!down.size || turning && now?.turning !== turning) return stop()
    turning = now?.turning ?? null
    turning?.turn(arrows(down, speed(now.zoom())))
  }
  const stop = () => {
    turning?.stop()
    turning = null
    down.clear()
  }
  const key = which => ({ down: () => aim(down.add(which)), up: () => { if (down.delete(which)) aim() } })
  return Object.fromEntries(['ArrowUp', 'ArrowDown', 'ArrowLeft', 'ArrowRight'].map(which => [which, key(which)]))
}

// What the help says. A text may be several keys, `'+ −'`, and a list is always several.
export const KEYBOARD = [
  ['← ↑ ↓ →', 'Turn the gimbal'], ['Space', 'Photo, or video in video mode'], ['R', 'Start or stop recording'],
  ['+ −', 'Zoom: tap for a step, or hold'], ['C', 'Centre the gimbal'], ['D', 'Look straight down'],
  ['T', 'Track a target'], ['M', 'Map'], ['F', 'Files'], ['S', 'Settings'], ['I', 'Info'], ['L', 'Log'],
  ['1 … 9', 'Choose a camera'], ['H', 'Hide the controls'], ['Esc', 'Close what is open'], ['?', 'This table'],
]
export const GAMEPAD = [
  ['Left stick', 'Turn the gimbal'], ['Right stick', 'Zoom: up is in'], [['RT', 'LT'], 'Zoom in, zoom out'],
  ['A', 'Photo, or video in video mode'], ['B', 'Start or stop recording'], ['X', 'Centre the gimbal'],
  ['Y', 'Look straight down'], [['LB', 'RB'], 'Previous, next camera'],
]
export const TOUCH = [
  ['Tap the picture', 'Look there'], ['Hold the pad', 'Turn the gimbal: farther out is faster'],
  ['Hold + or −', 'Zoom until you let go'], ['Round button', 'Photo, or video in video mode'],
  ['Track, then drag', 'Draw a rectangle around the target'], ['Tap a small picture', 'Choose that camera'],
  ['Tap the map', 'Look at that place'],
]

export function namesOf(keys) {
  if (typeof keys !== 'string') return keys
  return /^\S( \S)+$/.test(keys) ? keys.split(' ') : [keys]
}

// A key looks like one, a movement of the hand is plain words.
export function keysTable(title, entries) {
  const keyCaps = keys => namesOf(keys).map(one => one === '…' || / /.test(one) ? one + ' ' : h('kbd', {}, one))
  const line = ([keys, meaning]) => h('tr', {}, h('th', { scope: 'row' }, ...keyCaps(keys)), h('td', {}, meaning))
  return h('table', {}, h('caption', {}, title), h('tbody', {}, ...entries.map(line)))
}

// `button` is the round `?`, and `node` the dialog; both belong inside the panel. The browser keeps the focus inside
// an open dialog, closes it with Escape, and gives the focus back. A click beside it closes it, too, and so does `?`.
export function keysHelp(entries = KEYBOARD, gamepad = GAMEPAD, touch = TOUCH) {
  const close = h('button', { type: 'button', 'aria-label': 'Close', onclick: () => node.close() }, '✕')
  const id = 'keys-' + Math.random().toString(36).slice(2)
  const tables = [['Keyboard', entries], ['Gamepad', gamepad], ['Touch', touch]].filter(([, rows]) => rows.length)
  const inside = h('div', { class: 'inside' }, h('header', {}, h('h2', { id }, 'Keys'), close),
    h('div', { class: 'tables' }, ...tables.map(([title, rows]) => keysTable(title, rows))))
  const node = h('dialog', { class: 'keys', 'aria-labelledby': id }, inside)
  const toggle = () => node.open ? node.close() : node.showModal()
  const button = h('button', { type: 'button', class: 'help', 'aria-label': 'Keys', 'aria-haspopup': 'dialog',
    title: 'Keys (?)', onclick: toggle }, '?')
  node.addEventListener('click', ({ target }) => { if (target === node) node.close() })
  node.addEventListener('keydown', event => {
    if (event.key !== '?' || event.repeat) return
    event.preventDefault()
    toggle()
  })
  return { node, button, toggle }
}
