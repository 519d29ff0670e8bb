// A pad to press and hold, the arrow keys, the angles, and who has control.
//
// You look at the picture, not at the pad. So the pad is large, feels the same everywhere, and the arrow keys do
// the same. What is held is told to the panel again and again: when the page falls silent, the gimbal stops.
//
// How fast? At full zoom the picture shows a fifth of the angle, or less. What is calm without zoom would be wild
// there, so a zoomed gimbal turns slower: 30° a second at most, and 6° at full zoom.

import { ago, button, degrees, group, h, paintAll, say, show } from './parts.js'

export const FASTEST = 30
export function speed(zoom) { return FASTEST / (1 + (zoom ?? 0) / 25) }

// The farther from the middle you press, the faster it turns. Up in the picture is a higher pitch. The middle is
// still, so that a resting finger does nothing.
export const STILL = .12
export function rates(x, y, fastest) {
  const far = Math.hypot(x, y)
  if (far < STILL) return { pitch: 0, yaw: 0 }
  const along = Math.min(1, (far - STILL) / (.9 - STILL)) ** 1.5 / far * fastest
  return { pitch: -y * along, yaw: x * along }
}

// Turning: A press begins a hold, a movement changes its rates, and letting go ends it. After a refusal the hold
// is over, and moving on does not begin another: you have to press again.
export function turner(row) {
  let live = null
  const stop = () => {
    live?.end()
    live = null
  }
  const turn = ({ pitch, yaw }) => {
    live ??= row.hold('hold', 'release')
    live.aim({ pitch, yaw })
  }
  return { turn, stop }
}

// Two arrow keys held together turn it aslant, at half the speed.
export function arrows(down, fastest) {
  const axis = (more, less) => (down.has(more) - down.has(less)) * fastest / 2
  return { pitch: axis('ArrowUp', 'ArrowDown'), yaw: axis('ArrowRight', 'ArrowLeft') }
}

// The pad: The knob shows where you press, and does not leave the pad.
export function knob(node, x = 0, y = 0) {
  const short = Math.max(1, Math.hypot(x, y))
  node.style.setProperty('--x', x / short)
  node.style.setProperty('--y', y / short)
}

export function padAt(node, { clientX, clientY }) {
  const { left, top, width, height } = node.getBoundingClientRect()
  return { x: 2 * (clientX - left) / width - 1, y: 2 * (clientY - top) / height - 1 }
}

export function pad(gimbal, fastest) {
  const about = 'Turn the gimbal: press and hold, or hold the arrow keys'
  const node = h('div', { class: 'pad', tabindex: 0, role: 'application', 'aria-label': about, title: about })
  node.append(...['up', 'right', 'down', 'left'].map(side => h('i', { class: side })), h('b'))
  const aim = event => {
    const { x, y } = padAt(node, event)
    knob(node, x, y)
    gimbal.turn(rates(x, y, fastest()))
  }
  let held = null         // the newest pointer on the pad
  const letGo = ({ pointerId }) => {
    if (pointerId !== held) return
    held = null
    knob(node)
    gimbal.stop()
  }
  node.addEventListener('pointerdown', event => {
    if (event.button || node.closest('[data-lost]')) return
    held = event.pointerId
    node.setPointerCapture(held)
    node.focus({ preventScroll: true })
    aim(event)
  })
  node.addEventListener('pointermove', event => { if (event.pointerId === held) aim(event) })
  for (const kind of ['pointerup', 'pointercancel', 'lostpointercapture']) node.addEventListener(kind, letGo)
  node.addEventListener('contextmenu', event => event.preventDefault())
  return node
}

// Who has control.
export function owner(gimbal) {
  if (gimbal.ours) return 'You have control'
  const other = gimbal.owner_name ?? gimbal.owner
  return other ? other + ' has control' : 'Nobody has control'
}

// An angle is read like an instrument: its name above it, small.
export function readout(label) {
  const value = h('b', {}, '–')
  const node = h('span', {}, h('small', {}, label), ' ', value)
  return { node, tell: angle => { show(node, angle != null); say(value, degrees(angle)) } }
}

// The buttons: The view shows only the buttons that the flags of the gimbal allow.
export function gimbalButtons(row) {
  const press = (what, label, glyph, about) => button(row, what, label, { glyph, about })
  return {
    center: press('center', 'Centre', 'centre', 'Turn the gimbal to its centre'),
    down: press('down', 'Down', 'down', 'Look straight down'), retract: press('retract', 'Retract', 'retract'),
    lock: press('lock', 'Lock', null, 'Lock: keep the heading when the vehicle turns'),
    follow: press('follow', 'Follow', null, 'Follow: turn with the vehicle'),
    take: press('take', 'Take control', null, 'Take control of the gimbal'),
    give: press('give', 'Give back', null, 'Give back control of the gimbal'),
  }
}

// *Lock* keeps the heading while the vehicle turns, and *Follow* turns with the vehicle. The chosen button is
// dark.
export const NEEDS = {
  center: 'HAS_NEUTRAL', down: 'HAS_PITCH_AXIS', retract: 'HAS_RETRACT', lock: 'HAS_YAW_LOCK', follow: 'HAS_YAW_FOLLOW',
}
export function gimbalButtonsUpdate(buttons, { can, lock, ours }) {
  for (const [which, flag] of Object.entries(NEEDS)) show(buttons[which], can.includes(flag))
  buttons.lock.setAttribute('aria-pressed', lock)
  buttons.follow.setAttribute('aria-pressed', !lock)
  show(buttons.take, !ours)
  show(buttons.give, ours)
}

// All of a gimbal.
export function gimbalView(row, zoom = () => 0) {
  const turning = turner(row), stick = pad(turning, () => speed(zoom())), buttons = gimbalButtons(row)
  const { center, down, retract, lock, follow, take, give } = buttons, yaw = group('Yaw', lock, follow)
  const [called, who, wrong] = ['quiet called', 'quiet', 'wrong'].map(kind => h('p', { class: kind }))
  const angles = { pitch: readout('Pitch'), yaw: readout('Yaw'), heading: readout('Heading') }
  const table = h('p', { class: 'angles' }, ...Object.values(angles).map(angle => angle.node))
  const places = group('Places', center, down, retract, yaw), control = group('Control', who, take, give)
  const node = h('fieldset', { class: 'gimbal', 'aria-label': 'Gimbal' }, stick,
    h('div', { class: 'beside' }, called, table, places, control, wrong))
  yaw.classList.add('choice')
  function update(status) {
    const gone = status.state !== 'alive'
    node.disabled = gone
    node.toggleAttribute('data-lost', gone)
    node.toggleAttribute('data-turning', status.turning)
    say(called, status.name + (gone ? ': lost, ' + ago(status.age) : ''))
    for (const [which, angle] of Object.entries(angles)) angle.tell(status[which])
    show(stick, status.can.includes('HAS_PITCH_AXIS') || status.can.includes('HAS_YAW_AXIS'))
    gimbalButtonsUpdate(buttons, status)
    paintAll(node, status.buttons)
    say(who, owner(status))
    say(wrong, status.failures.join(', '))
    if (gone) turning.stop()
  }
  return { node, update, turning }
}
