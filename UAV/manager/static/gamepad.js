// A gamepad turns the gimbal, zooms and takes pictures.
//
// The left stick turns the gimbal of the main camera, as the pad does, so the right thumb is free for the shutter.
// The right stick, up and down, and the triggers zoom. A takes a picture, B records, X centres the gimbal, Y looks
// down, and the shoulder buttons swap cameras.
//
// `gamepad(panel)` returns a function that ends it. It needs of the panel:
//
// * `main()`: the camera that fills the window, or null while there is none. It is asked once a frame:
//   `{ row, turning, zoom, shutter, record, press }`
//   * `row`: its row (`rowOf`), the same object for as long as it is the same camera; `row.hold` zooms, and
//     `row.status`, when it is there, says whether the camera can
//   * `turning`: `{ turn({ pitch, yaw }), stop() }`, as `nowTurning` makes it, the same object each time;
//     null when no gimbal turns this camera
//   * `zoom()`: percent, or null; a zoomed gimbal turns slower
//   * `shutter()`, `record()`: what the buttons do, and `press(what)`: a button of the gimbal, `'center'` or `'down'`
// * `swap(by)`: make the next (1) or the previous (-1) camera the main one
// * `tell(text)`: show words for a moment: a gamepad has come, or is lost
//
// What turns must stop when the gamepad goes. So nothing here waits for a stick to come back: no gamepad, no window
// in front, no frame for 0.4 s, each means stop. And a stick that is held aslant when the gamepad comes, or when you
// come back to the page, does nothing until it was in the middle once. A button that is down then is no press.

import { FASTEST, STILL, rates, speed } from './gimbal.js'

// A worn stick rests at .1. The stick begins a little farther out than it ends, so one that rests on the edge does
// not begin and end all the time.
export const EDGE = .04
export const ZOOMS = { begin: .3, end: .2 }
export const PRESSES = ['shutter', 'record', 'center', 'down', 'previous', 'next']
export const FRAMELESS = 400

// Gamepads that the browser doesn't know have their axes and buttons in any order. The first two axes are a stick
// on nearly all of them; what the others are, nobody knows, and a trigger there may rest at −1. So they don't zoom.
// An axis that is missing or no number makes the whole stick null: it neither turns nor counts as in the middle.
export function lookOf({ axes }) {
  const [x, y] = [0, 1].map(n => Math.max(-1, Math.min(1, axes[n])))
  return Number.isFinite(x) && Number.isFinite(y) ? { x, y } : null
}

export function zoomOf({ mapping, axes, buttons }) {
  if (mapping !== 'standard') return 0
  const stick = -(axes[3] ?? 0), triggers = (buttons[7]?.value ?? 0) - (buttons[6]?.value ?? 0)
  const most = Math.abs(stick) > Math.abs(triggers) ? stick : triggers
  return Number.isFinite(stick) && Number.isFinite(triggers) ? most : null
}

export function downOf({ buttons }) { return PRESSES.map((_, n) => !!buttons[n]?.pressed) }

// The logic is a function of what was and what is now, without a clock and without a browser. `now` is
// `{ pad, of, fastest }`: a gamepad or null, a number that changes with the main camera, and degrees a second. It
// returns the state to give to it the next time, and what to do: `['turn', rates]`, `['stop']`, `['zoom', direction]`
// with 1, -1, or 0 to end it, and `['press', what]`.
export const AWAY = { pad: null, of: null, down: [], turn: null, zoom: 0, middle: { look: false, zoom: false } }

export function hands(previous, { pad, of = null, fastest = FASTEST }) {
  const known = pad && pad.connected !== false ? pad.index + ' ' + pad.id : null
  const came = known !== previous.pad, swapped = came || of !== previous.of
  const before = swapped ? { ...AWAY, down: came ? null : previous.down } : previous
  const ended = swapped ? doneSince(previous, AWAY) : []
  if (!known) return { state: AWAY, actions: ended }
  const down = downOf(pad), look = lookOf(pad), zoom = zoomOf(pad)
  const state = { pad: known, of, down, ...lookNow(before, look, fastest), ...zoomNow(before, zoom) }
  state.middle = { look: inMiddle(before.middle.look, look && Math.hypot(look.x, look.y), STILL),
    zoom: inMiddle(before.middle.zoom, zoom, ZOOMS.end) }
  const pressed = PRESSES.filter((_, n) => down[n] && before.down && !before.down[n])
  return { state, actions: [...ended, ...doneSince(before, state), ...pressed.map(what => ['press', what])] }
}

// Once in the middle, it stays true until the stick says nonsense.
export function inMiddle(was, far, still) { return far != null && (was || Math.abs(far) < still) }

// Rates that differ by less than a tenth of a degree a second are the same: what is held is told again anyway.
export function lookNow({ turn, middle }, look, fastest) {
  const far = look && middle.look ? Math.hypot(look.x, look.y) : 0
  if (far < (turn ? STILL : STILL + EDGE)) return { turn: null }
  const now = rates(look.x, look.y, fastest)
  return { turn: turn && Math.hypot(now.pitch - turn.pitch, now.yaw - turn.yaw) < .1 ? turn : now }
}

export function zoomNow({ zoom, middle }, now) {
  const far = middle.zoom ? now ?? 0 : 0, same = Math.sign(far) === zoom
  return { zoom: Math.abs(far) > (same ? ZOOMS.end : ZOOMS.begin) ? Math.sign(far) : 0 }
}

export function doneSince(before, { turn, zoom }) {
  const all = []
  if (turn !== before.turn) all.push(turn ? ['turn', turn] : ['stop'])
  if (zoom !== before.zoom) all.push(['zoom', zoom])
  return all
}

// Of several gamepads the one in use stays, unless the browser knows another one and not this one: a mouse may say
// it is a gamepad. A page that may not ask has none.
export function gamepads() {
  try { return [...window.navigator.getGamepads?.() ?? []].filter(pad => pad?.connected) } catch { return [] }
}

export function padInUse(pads, used) {
  const known = pads.filter(pad => pad.mapping === 'standard'), all = known.length ? known : pads
  return all.find(pad => pad.index + ' ' + pad.id === used) ?? all[0] ?? null
}

// What to do with the main camera. What was begun is ended on the camera where it was begun.
export function doer(panel) {
  let turning = null, zooming = null
  const zoom = (main, direction) => {
    zooming?.end()
    zooming = direction && main && canZoom(main.row) ? main.row.hold('zoom_hold', 'zoom_release') : null
    zooming?.aim({ direction })
  }
  const stop = () => {
    turning?.stop()
    turning = null
  }
  const turn = (main, rates) => {
    turning = main?.turning ?? null
    turning?.turn(rates)
  }
  const press = (main, what) => {
    if (what === 'previous' || what === 'next') return panel.swap(what === 'next' ? 1 : -1)
    if (what === 'shutter' || what === 'record') return main?.[what]()
    main?.press(what)
  }
  return { turn, stop, zoom, press }
}

export function canZoom({ status }) { return !status?.can || status.can.includes('HAS_BASIC_ZOOM') }

// A window that is out of sight gets no frames, and some get none though they seem to be in front. So a timer stops
// what turns when the next frame doesn't come.
export function gamepad(panel) {
  const does = doer(panel)
  let state = AWAY, frame = 0, guard = 0, at = null, of = 0
  function step(pad) {
    const main = pad ? panel.main() : at
    if (main?.row !== at?.row || main?.turning !== at?.turning) of += 1
    at = main
    const { state: next, actions } = hands(state, { pad, of, fastest: speed(main?.zoom()) })
    state = next
    for (const [what, ...how] of actions) does[what](main, ...how)
  }
  function away() {
    window.cancelAnimationFrame(frame)
    clearTimeout(guard)
    frame = guard = 0
    step(null)
  }
  function look() {
    const pad = padInUse(gamepads(), state.pad)
    step(pad)
    clearTimeout(guard)
    guard = state.turn || state.zoom ? setTimeout(step, FRAMELESS, null) : 0
    frame = pad ? window.requestAnimationFrame(look) : 0
  }
  const begin = () => { if (!frame && !document.hidden && document.hasFocus()) look() }
  const ends = padEvents(panel, away, begin)
  begin()
  return () => away(ends())
}

// The name of a gamepad comes from its maker, and has numbers in brackets behind it.
export function padName({ id }) { return id.replace(/\s*\(.*/, '').slice(0, 40) || 'Gamepad' }

export function padEvents(panel, away, begin) {
  const gone = ({ gamepad }) => {
    panel.tell(padName(gamepad) + ' is lost')
    away()
    begin()
  }
  const came = ({ gamepad }) => {
    panel.tell(padName(gamepad) + ' is ready')
    begin()
  }
  const seen = () => document.hidden ? away() : begin()
  const all = [[window, 'gamepadconnected', came], [window, 'gamepaddisconnected', gone], [window, 'blur', away],
    [window, 'focus', begin], [window, 'pagehide', away], [document, 'visibilitychange', seen]]
  for (const [on, kind, heard] of all) on.addEventListener(kind, heard)
  return () => { for (const [on, kind, heard] of all) on.removeEventListener(kind, heard) }
}
