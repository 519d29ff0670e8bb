import assert from 'node:assert/strict'
import test from 'node:test'
import { panel, same } from './panel.js'

const { AWAY, FRAMELESS, canZoom, padInUse, gamepad, hands, padName } = panel

// A gamepad with a standard mapping; `down` are the numbers of its buttons, and `triggers` their values
function pad({ axes = [0, 0, 0, 0], down = [], triggers = [0, 0], mapping = 'standard', index = 0, ...more } = {}) {
  const buttons = [...Array(17)].map((_, n) => ({ pressed: down.includes(n), value: down.includes(n) ? 1 : 0 }))
  buttons[6].value = triggers[0]
  buttons[7].value = triggers[1]
  return { id: 'Pad', connected: true, index, mapping, axes, buttons, timestamp: 1, ...more }
}

// What is done by one gamepad after another, in short: `T` turns, `.` stops, `Z1` zooms, `[a]` presses
function play(...pads) {
  let state = AWAY
  const word = ([what, how]) => ({ turn: 'T', stop: '.', zoom: 'Z' + how, press: '[' + how + ']' })[what]
  return pads.map(now => {
    const after = hands(state, { pad: now && !now.of ? now : now?.pad ?? null, of: now?.of ?? 1 })
    state = after.state
    return after.actions.map(word).join(' ')
  })
}
const still = pad(), right = pad({ axes: [1, 0, 0, 0] }), half = pad({ axes: [.5, 0, 0, 0] })

test('A stick turns like the pad: farther out is faster, and a zoomed gimbal turns slower', () => {
  const turned = (axes, fastest) => hands(hands(AWAY, { pad: still }).state, { pad: pad({ axes }), fastest }).state.turn
  same(turned([1, 0, 0, 0]), { pitch: 0, yaw: 30 })
  same(turned([0, -1, 0, 0], 6), { pitch: 6, yaw: 0 })
  same(turned([-7, 0, 0, 0]).yaw, -30)
  same([.2, .4, .6, .8].map(x => Math.round(turned([x, 0, 0, 0]).yaw)), [1, 6, 14, 24])
})

test('Rates are sent when they change, and no more when they stay', () => {
  same(play(still, right, right, half, pad({ axes: [.5005, 0, 0, 0] }), still, still), ['', 'T', '', 'T', '', '.', ''])
})

test('A worn stick that rests at .1 turns nothing, and one on the edge does not begin and end all the time', () => {
  const worn = pad({ axes: [.1, -.05, .1, .1] }), edge = x => pad({ axes: [x, 0, 0, 0] })
  same(play(worn, worn, still, worn), ['', '', '', ''])
  same(play(still, edge(.13), edge(.11), edge(.13), right, edge(.13), edge(.14), edge(.11)), ['', '', '', '', 'T', 'T', '', '.'])
})

test('Nothing that turns outlives its gamepad', () => {
  same(play(still, right, null), ['', 'T', '.'])
  same(play(still, right, { ...right, connected: false }), ['', 'T', '.'])
  same(play(still, pad({ triggers: [0, 1] }), null), ['', 'Z1', 'Z0'])
  same(play(still, right, pad({ axes: [1, 0, 0, 0], index: 1 })), ['', 'T', '.'])
  same(play(null, null), ['', ''])
})

test('A stick that is aslant when it comes does nothing until it was in the middle', () => {
  same(play(right, right, still, right), ['', '', '', 'T'])
  same(play(still, right, null, right, half, still, half), ['', 'T', '.', '', '', '', 'T'])
  const zooming = pad({ triggers: [1, 0] }), stick = pad({ axes: [0, 0, 0, -1] })
  same(play(zooming, zooming, still, zooming), ['', '', '', 'Z-1'])
  same(play(stick, still, stick, null, stick), ['', '', 'Z1', 'Z0', ''])
})

test('A button that is down when it comes is no press', () => {
  const shoot = pad({ down: [0] })
  same(play(shoot, shoot, still, shoot, shoot), ['', '', '', '[shutter]', ''])
  same(play(still, shoot, null, shoot), ['', '[shutter]', '', ''])
  const all = [0, 1, 2, 3, 4, 5].map(n => pad({ down: [n] }))
  same(play(still, ...all).join(''), '[shutter][record][center][down][previous][next]')
})

test('After a swap the old camera is stopped, and the stick must come back to the middle', () => {
  same(play(still, right, { pad: right, of: 2 }, { pad: still, of: 2 }, { pad: right, of: 2 }), ['', 'T', '.', '', 'T'])
  const held = pad({ down: [5] })
  same(play(still, held, { pad: held, of: 2 }, { pad: held, of: 3 }), ['', '[next]', '', ''])
})

test('An axis that is no number stops the stick until it was in the middle', () => {
  const wrong = [NaN, undefined, Infinity * 0].map(x => pad({ axes: [x, 0, 0, 0] }))
  for (const one of wrong) same(play(still, right, one, right, still, right), ['', 'T', '.', '', '', 'T'])
  same(play(still, pad({ axes: [0, 0, 0, -1] }), pad({ axes: [0, 0, 0, NaN] }), pad({ axes: [0, 0, 0, -1] })), ['', 'Z1', 'Z0', ''])
  const none = pad({ axes: [] })
  same(play(none, pad({ axes: [], down: [0] }), none), ['', '[shutter]', ''])
  same(play(none, { ...none, buttons: [] }), ['', ''])
})

test('The triggers and the other stick zoom, with an end that is nearer than the begin', () => {
  const trigger = value => pad({ triggers: [0, value] })
  same(play(still, ...[.25, .35, .25, .15, .25].map(trigger)), ['', '', 'Z1', '', 'Z0', ''])
  same(play(still, pad({ axes: [0, 0, 0, 1] }), pad({ axes: [0, 0, 0, -1] })), ['', 'Z-1', 'Z1'])
  same(play(still, pad({ triggers: [1, 1] })), ['', ''])
})

test('A gamepad that the browser does not know turns and shoots, and does not zoom', () => {
  const odd = more => pad({ mapping: '', ...more })
  same(play(odd(), odd({ axes: [1, 0, -1, -1], triggers: [1, 0] }), odd({ down: [0] })), ['', 'T', '. [shutter]'])
})

test('Of several gamepads the one in use stays; one that the browser knows goes first', () => {
  const mouse = pad({ mapping: '' }), first = pad({ index: 1 }), second = pad({ index: 2 })
  same([padInUse([mouse, first, second], null).index, padInUse([mouse, first, second], '2 Pad').index], [1, 2])
  same([padInUse([mouse], null).mapping, padInUse([first, mouse], '0 Pad').index, padInUse([], '1 Pad')], ['', 1, null])
})

test('Words and flags', () => {
  same(padName({ id: 'Xbox 360 Controller (XInput STANDARD GAMEPAD Vendor: 045e)' }), 'Xbox 360 Controller')
  same(padName({ id: '' }), 'Gamepad')
  same([{ status: { can: [] } }, { status: { can: ['HAS_BASIC_ZOOM'] } }, {}].map(canZoom), [false, true, true])
})

// A browser with one gamepad: `frame()` is its next frame, `happen(kind)` an event of window or document
function browser(t) {
  const heard = new Map(), told = [], frames = new Map()
  const listen = { addEventListener: (kind, f) => heard.set(kind, f), removeEventListener: kind => heard.delete(kind) }
  const view = { pads: [pad()], main: null, focus: true, told, heard, frames, tick: 0 }
  globalThis.document = { ...listen, hidden: false, hasFocus: () => view.focus }
  globalThis.window = { ...listen, navigator: { getGamepads: () => view.pads },
    requestAnimationFrame: f => { frames.set(++view.tick, f); return view.tick }, cancelAnimationFrame: n => frames.delete(n) }
  view.frame = (...pads) => {
    if (pads.length) view.pads = pads
    for (const [n, f] of [...frames]) f(frames.delete(n))
  }
  view.happen = (kind, event = {}) => heard.get(kind)(event)
  const camera = called => ({
    turning: { turn: rates => told.push(called + ' turn ' + rates.yaw), stop: () => told.push(called + ' stop') },
    zoom: () => 0, shutter: () => told.push(called + ' shutter'), record: () => told.push(called + ' record'),
    press: what => told.push(called + ' ' + what),
    row: { hold: (...how) => ({ aim: ({ direction }) => told.push(how[0] + ' ' + direction), end: () => told.push(how[1]) }) },
  })
  view.main = camera('A')
  view.other = camera('B')
  t.mock.timers.enable({ apis: ['setTimeout'] })
  view.end = gamepad({ main: () => view.main, swap: by => told.push('swap ' + by), tell: text => told.push(text) })
  t.after(() => { view.end(); delete globalThis.window; delete globalThis.document })
  return view
}

const LOSSES = {
  'the event': view => view.happen('gamepaddisconnected', { gamepad: { id: 'Pad' } }),
  'connected is false': view => view.frame({ ...right, connected: false }), 'not in the list': view => view.frame(null),
  blur: view => view.happen('blur'), pagehide: view => view.happen('pagehide'), 'the end': view => view.end(),
  hidden: view => { document.hidden = true; view.happen('visibilitychange') },
}
for (const [how, lose] of Object.entries(LOSSES)) test('What turns and zooms stops at once: ' + how, t => {
  const view = browser(t)
  view.frame(pad({ axes: [1, 0, 0, -1] }))
  same(view.told, ['A turn 30', 'zoom_hold 1'])
  if (how === 'the event') view.pads = [null]
  lose(view)
  same(view.told.filter(text => !text.endsWith('lost')).slice(2), ['A stop', 'zoom_release'])
  same(view.frames.size, 0, 'no frame is asked for')
})

test('A broken one is seen: without its loss, nothing is stopped', t => {
  const view = browser(t)
  view.frame(right)
  view.happen('focus')
  view.frame()
  same(view.told, ['A turn 30'])
})

test('A frame that does not come stops, too', t => {
  const view = browser(t)
  view.frame(right)
  t.mock.timers.tick(FRAMELESS - 1)
  same(view.told, ['A turn 30'])
  t.mock.timers.tick(1)
  same(view.told, ['A turn 30', 'A stop'])
  view.frame(right)
  same(view.told.length, 2, 'the stick is still aslant')
  view.frame(still)
  view.frame(right)
  same(view.told.at(-1), 'A turn 30')
})

test('Frames are asked for only while a gamepad is there and the page is in front', t => {
  const view = browser(t)
  same(view.frames.size, 1)
  view.happen('focus')
  same(view.frames.size, 1)
  view.frame(null)
  same(view.frames.size, 0)
  view.pads = [still]
  view.focus = false
  view.happen('gamepadconnected', { gamepad: still })
  same([view.frames.size, view.told], [0, ['Pad is ready']])
  view.focus = document.hidden = true
  view.happen('focus')
  same(view.frames.size, 0)
  document.hidden = false
  view.happen('visibilitychange')
  same(view.frames.size, 1)
  view.end()
  same([view.frames.size, view.heard.size], [0, 0])
})

test('What was begun on a camera is ended there', t => {
  const view = browser(t)
  view.frame(pad({ axes: [1, 0, 0, -1] }))
  view.main = view.other
  view.frame()
  same(view.told, ['A turn 30', 'zoom_hold 1', 'A stop', 'zoom_release'])
  view.frame(still)
  view.frame(right)
  view.main = null
  view.frame()
  same(view.told.slice(4), ['B turn 30', 'B stop'])
})

test('Another gimbal on the same camera is not turned by a stick that is held', t => {
  const view = browser(t)
  view.frame(right)
  view.main = { ...view.main, turning: view.other.turning }
  view.frame()
  view.frame(half)
  same(view.told, ['A turn 30', 'A stop'])
})

test('Buttons press', t => {
  const view = browser(t)
  view.frame(pad({ down: [0, 1, 2, 3, 4, 5] }))
  same(view.told, ['A shutter', 'A record', 'A center', 'A down', 'swap -1', 'swap 1'])
})

test('A camera without a gimbal or a zoom, and a page that may not ask', t => {
  const view = browser(t)
  view.main = { ...view.main, turning: null, row: { status: { can: [] } } }
  view.frame(still)
  view.frame(pad({ axes: [1, 0, 0, -1] }))
  view.frame(null)
  window.navigator.getGamepads = () => { throw new Error('SecurityError') }
  view.happen('focus')
  delete window.navigator.getGamepads
  view.happen('focus')
  same([view.told, view.frames.size], [[], 0])
  assert.equal(view.heard.has('gamepadconnected'), true)
})
