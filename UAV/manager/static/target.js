// A rectangle that you drag on the picture, and the one that the camera follows.
//
// With a mouse you drag on the picture. A finger that moves on the picture scrolls the page, so a finger needs the
// button *Track* first. A click still points the gimbal: only a drag that encloses something is a rectangle.
//
// Places in the picture: The picture may be narrower than its frame, or lower. Places are parts of the picture,
// from its upper left corner.

import { button, group, h, icon, say, show } from './parts.js'
import { sizeOf } from './picture.js'

export function partsOf(box, [width, height], x, y) {
  const scale = Math.min(box.width / width, box.height / height)
  const part = (at, from, extent, size) => Math.min(1, Math.max(0, .5 + (at - from - extent / 2) / (size * scale)))
  return [part(x, box.left, box.width, width), part(y, box.top, box.height, height)]
}

export function putBox(node, box, [width, height], { left, top, right, bottom }) {
  const scale = Math.min(box.width / width, box.height / height)
  const x = part => (box.width - width * scale) / 2 + part * width * scale
  const y = part => (box.height - height * scale) / 2 + part * height * scale
  const sides = { left: x(left), top: y(top), width: x(right) - x(left), height: y(bottom) - y(top) }
  for (const [side, size] of Object.entries(sides)) node.style[side] = size + 'px'
}

// Dragging.
export const SMALLEST = .02
export function dragging(node, place, allowed, moved, done) {
  let from = null, sides = null
  const between = ([x, y]) => ({ left: Math.min(x, from[0]), top: Math.min(y, from[1]),
    right: Math.max(x, from[0]), bottom: Math.max(y, from[1]) })
  const large = now => now.right - now.left > SMALLEST && now.bottom - now.top > SMALLEST
  const end = () => {
    from = sides = null
    moved(null)
  }
  node.addEventListener('pointerdown', event => {
    end()
    if (!event.button && event.isPrimary && allowed(event)) from = place(event)
  })
  node.addEventListener('pointermove', event => {
    if (!from) return
    sides = between(place(event))
    if (!large(sides)) return
    node.setPointerCapture(event.pointerId)
    moved(sides)
  })
  node.addEventListener('pointerup', () => {
    const drawn = sides && large(sides) ? sides : null
    end()
    if (drawn) done(drawn)
  })
  node.addEventListener('pointercancel', end)
}

// The target.
export function withoutClick(node) {
  let drawn = false
  node.addEventListener('pointerdown', () => { drawn = false }, true)
  node.addEventListener('click', event => { if (drawn) event.stopImmediatePropagation() }, true)
  return () => { drawn = true }
}

// The buttons: *Track* says what to do, and a second press calls it off. While a target is tracked, the gimbal can keep
// it in the middle, where the panel may turn it.
export function trackButtons(row, begin) {
  const given = { type: 'button', class: 'track', onclick: () => begin() }
  const track = h('button', given, icon('track'), h('span', {}, 'Track'))
  const stop = button(row, 'untrack', 'Stop tracking', { glyph: 'stop' })
  const follow = button(row, 'follow_target', 'Gimbal follows', {
    glyph: 'centre', args: () => ({ on: !row.status.following }),
  })
  follow.title = 'Keep the target in the middle of the picture'
  const node = group('Tracking', track, stop, follow)
  node.classList.add('tracking')
  function update({ can, target, following, can_follow }) {
    const able = can.includes('HAS_TRACKING_RECTANGLE')
    const all = [[node, able], [stop, target], [track, !target], [follow, target && can_follow]]
    for (const [part, yes] of all) show(part, yes)
    follow.setAttribute('aria-pressed', !!following)
  }
  return { node, update, track }
}

export function targetView(row, node) {
  const image = node.querySelector('img'), [target, drawn] = [0, 1].map(() => h('i', { class: 'target', hidden: true }))
  const hint = h('p', { class: 'hint', role: 'status' })
  const size = () => sizeOf(image), box = () => node.getBoundingClientRect()
  const put = (frame, sides) => {
    show(frame, !!sides && size()[0] > 0)
    if (sides) putBox(frame, box(), size(), sides)
  }
  drawn.dataset.status = 'drawn'
  const may = () => row.status.state === 'alive' && row.status.can.includes('HAS_TRACKING_RECTANGLE')
  const allowed = event => may() && (event.pointerType === 'mouse' || node.hasAttribute('data-track'))
  const noClick = withoutClick(node), buttons = trackButtons(row, begin)
  function done(sides) {
    noClick(begin(false))
    row.act('track', sides)
  }
  function begin(yes = !node.hasAttribute('data-track')) {
    node.toggleAttribute('data-track', yes)
    buttons.track.setAttribute('aria-pressed', yes)
    say(hint, yes ? 'Drag a rectangle around the target' : '')
  }
  dragging(node, e => partsOf(box(), size(), e.clientX, e.clientY), allowed, sides => put(drawn, sides), done)
  node.append(target, drawn, hint)
  function update(status) {
    const { target: now } = status
    buttons.update(status)
    if (now) target.dataset.status = now.status
    if (now) begin(false)
    put(target, now)
  }
  const toggle = () => { if (!buttons.track.matches('[hidden], [hidden] *')) begin() }
  return { node: buttons.node, update, begin, toggle }
}
