// Pitch and heading as scales in the picture: a compass tape along its top, and a pitch ladder at its right edge.
//
// You look at the picture, and a glance at its edge says where it looks. The scales move under a fixed mark, as in
// an aircraft, so the number is always at the same place. They are white with a dark outline, because a picture may
// be of snow or of asphalt.
//
// All is drawn once. An update moves a few groups by their `transform`, and writes two numbers: it may come thirty
// times a second. A screen reader gets one sentence when you ask for it, and nothing that talks all the time.

import { h, name, say } from './parts.js'

// Angles and their names.
export const COMPASS = ['north', 'north-east', 'east', 'south-east', 'south', 'south-west', 'west', 'north-west']

export function wrapped(angle) { return ((angle + 180) % 360 + 360) % 360 - 180 }

export function compassWord(angle) { return COMPASS[Math.round(fromNorth(angle) / 45) % 8] }

// `NE` in place of `north-east`
export function compassLetters(angle) {
  return compassWord(angle).split('-').map(word => word[0].toUpperCase()).join('')
}

export function fromNorth(angle) { return (angle % 360 + 360) % 360 }

// A whole angle with a real minus, and a dash where it is not known.
export function angleText(angle) {
  return Number.isFinite(angle) ? String(Math.round(angle) + 0).replace('-', '−') + '°' : '–'
}

export function headingText(angle) { return String(Math.round(fromNorth(angle)) % 360).padStart(3, '0') + '°' }

// One sentence for all. The nose counts only where there is no north.
export function instrumentWords({ pitch, yaw, heading }) {
  const up = 'Pitch ' + (Number.isFinite(pitch) ? angleText(pitch) : 'unknown')
  if (Number.isFinite(heading)) {
    return up + ', heading ' + Math.round(fromNorth(heading)) % 360 + '° (' + compassLetters(heading) + ')'
  }
  if (!Number.isFinite(yaw)) return up + ', heading unknown'
  const side = Math.round(wrapped(yaw))
  return up + ', ' + (side ? Math.abs(side) + '° ' + (side > 0 ? 'right' : 'left') + ' of the nose' : 'along the nose')
}

// Scales: A mark stands at each 5°, a longer one at each 10°, and some have a text.
export const DEGREE = 4                 // pixels for one
export function scaleMarks(from, to, text) {
  const marks = []
  for (let at = from; at <= to; at += 5) marks.push({ at, long: at % 10 === 0, text: text(at) })
  return marks
}

export function compassMark(at) {
  if (at % 45 === 0) return compassLetters(at)
  return at % 30 === 0 ? String(fromNorth(at)) : ''
}

export function noseMark(at) {
  const angle = wrapped(at), names = { 0: 'nose', '-180': 'tail' }
  return names[angle] ?? (at % 30 === 0 ? String(angle).replace('-', '−') : '')
}

export function ladderMark(at) {
  const names = { 0: 'horizon', '-90': 'down', 90: 'up' }
  return names[at] ?? (at % 10 === 0 ? String(at).replace('-', '−') : '')
}

// Lines across a scale as one path: a tape has them side by side, and a ladder one below the other.
export function tapePath(marks) {
  return marks.map(({ at, long }) => 'M' + at * DEGREE + (long ? ' 16V26' : ' 20V26')).join('')
}

export function ladderPath(marks) {
  const length = ({ at, long }) => at === 0 ? 18 : long ? 12 : 7
  return marks.map(mark => 'M' + -length(mark) + ' ' + -mark.at * DEGREE + 'H0').join('')
}

// The vehicle's nose on a tape with the heading in its middle. One that is beyond an end of the tape stands at that
// end, so you know which way to turn.
export function nosePlace(yaw, half) {
  const end = half * .8
  return Math.max(-end, Math.min(end, -wrapped(yaw) * DEGREE))
}

// Where a gimbal ends, and only where it does end.
export function limitEnds(limits) {
  const known = limits?.length === 2 && limits.every(Number.isFinite) && limits[1] - limits[0] < 360
  return known ? limits : []
}

// Drawing: A line is drawn twice, the wide dark one below the white one. The style gives texts their outline.
export function svgNode(tag, given = {}, ...inside) {
  const node = document.createElementNS('http://www.w3.org/2000/svg', tag)
  for (const [key, value] of Object.entries(given)) node.setAttribute(key, value)
  node.append(...inside)
  return node
}

export function outlined(d, more = '') {
  return svgNode('g', { class: 'lines ' + more }, svgNode('path', { d, class: 'under' }), svgNode('path', { d }))
}

// What is written is compared first: most updates change one of the scales, or none.
export function putAttribute(node, key, value) { if (node.getAttribute(key) !== value) node.setAttribute(key, value) }
export function moveTo(node, x, y) { putAttribute(node, 'transform', 'translate(' + x.toFixed(1) + ' ' + y.toFixed(1) + ')') }
export function showSvg(node, yes) { if (node.hasAttribute('hidden') === !!yes) node.toggleAttribute('hidden', !yes) }

export function tapeStrip(from, to, text) {
  const marks = scaleMarks(from, to, text), cardinal = at => at % 90 === 0 ? 'cardinal' : 'small'
  const words = marks.filter(mark => mark.text)
  return svgNode('g', {}, outlined(tapePath(marks)),
    ...words.map(({ at, text }) => svgNode('text', { x: at * DEGREE, y: 11, class: cardinal(at) }, text)))
}

export function ladderStrip() {
  const marks = scaleMarks(-180, 180, ladderMark), words = marks.filter(mark => mark.text)
  const named = at => at % 90 === 0 ? 'cardinal' : 'small', place = at => ({ x: at ? -17 : -23, y: 4 - at * DEGREE })
  const texts = new Map(words.map(({ at, text }) => [at, svgNode('text', { ...place(at), class: named(at) }, text)]))
  let under = null
  function hide(at) {
    if (at === under) return
    for (const [angle, yes] of [[under, true], [at, false]]) if (texts.has(angle)) showSvg(texts.get(angle), yes)
    under = at
  }
  return { node: svgNode('g', {}, outlined(ladderPath(marks)), ...texts.values()), hide }
}

// The text that lies below the number at the middle is hidden, so none is cut in half.
export function textBelow(pitch) {
  const at = Math.round(pitch / 10) * 10
  return Math.abs(at - pitch) * DEGREE < 17 ? at + 0 : null
}

// An end of the gimbal is a bar in another colour across the scale.
export function endBars(d) { return [0, 1].map(() => outlined(d, 'end')) }

export function readoutBox(x, y, width, pointer) {
  const text = svgNode('text', { x: x + width / 2, y: y + 15.5, class: 'number' }, '–')
  const box = svgNode('rect', { x, y, width, height: 22, rx: 4 })
  return { node: svgNode('g', { class: 'readout' }, svgNode('path', { d: pointer }), box, text), text }
}

// The compass tape. Its bracket is as wide as the picture sees.
export function tapeView() {
  const compass = tapeStrip(-90, 450, compassMark), nose = tapeStrip(-270, 270, noseMark)
  const mark = svgNode('g', { class: 'nose' }, svgNode('path', { d: 'M0 29L7 41L0 38L-7 41Z' }))
  const stops = endBars('M0 14V28'), wide = outlined('', 'field')
  const { node: box, text } = readoutBox(-27, 35, 54, 'M0 29L6 36H-6Z')
  const moving = svgNode('svg', { x: '50%', overflow: 'visible' }, compass, nose, wide, ...stops, mark, box)
  const node = svgNode('svg', { class: 'tape', 'aria-hidden': 'true' }, moving)
  function update({ yaw, heading, hfov, limits }, half) {
    const north = Number.isFinite(heading), turned = Number.isFinite(yaw)
    for (const [part, yes] of [[node, north || turned], [compass, north], [nose, !north], [mark, north && turned]]) {
      showSvg(part, yes)
    }
    if (north) moveTo(compass, -fromNorth(heading) * DEGREE, 0)
    else if (turned) moveTo(nose, -wrapped(yaw) * DEGREE, 0)
    if (turned) moveTo(mark, nosePlace(yaw, half), 0)
    say(text, north ? headingText(heading) : angleText(turned ? wrapped(yaw) : null))
    putField(wide, hfov, x => 'M-' + x + ' 30V26H' + x + 'V30')
    putEnds(stops, turned ? limitEnds(limits?.yaw) : [], end => [(end - wrapped(yaw)) * DEGREE, 0])
  }
  return { node, update }
}

export function putField(lines, angle, path) {
  showSvg(lines, angle > 0)
  if (angle > 0) for (const line of lines.childNodes) putAttribute(line, 'd', path((angle / 2 * DEGREE).toFixed(1)))
}

export function putEnds(bars, [...all], place) {
  for (const [i, bar] of bars.entries()) {
    showSvg(bar, i < all.length)
    if (i < all.length) moveTo(bar, ...place(all[i]))
  }
}

// The pitch ladder.
export function ladderView() {
  const { node: strip, hide } = ladderStrip(), tall = outlined('', 'field'), stops = endBars('M-13 0H2')
  const { node: box, text } = readoutBox(-72, -11, 50, 'M-16 0L-23 -6V6Z')
  const moving = svgNode('svg', { x: '100%', y: '50%', overflow: 'visible' },
    svgNode('g', { transform: 'translate(-8 0)' }, strip, tall, ...stops, box))
  const node = svgNode('svg', { class: 'ladder', 'aria-hidden': 'true' }, moving)
  function update({ pitch, vfov, limits }) {
    const known = Number.isFinite(pitch)
    showSvg(strip, known)
    if (known) moveTo(strip, 0, wrapped(pitch) * DEGREE, hide(textBelow(wrapped(pitch))))
    say(text, angleText(known ? wrapped(pitch) : null))
    putField(tall, known ? vfov : 0, y => 'M0 -' + y + 'H4V' + y + 'H0')
    putEnds(stops, known ? limitEnds(limits?.pitch) : [], end => [0, (wrapped(pitch) - end) * DEGREE])
  }
  return { node, update }
}

// Both. The tape is as wide as its style says: an observer hears of it, so that no update has to measure.
export function instruments() {
  const tape = tapeView(), ladder = ladderView()
  const node = h('div', { class: 'instruments', role: 'img' }, tape.node, ladder.node)
  let half = 160, last = {}
  function update(now) {
    last = now
    for (const part of [tape, ladder]) part.update(now, half)
    name(node, instrumentWords(now))
  }
  const resized = ([{ contentRect }]) => {
    half = contentRect.width / 2 || half
    update(last)
  }
  if (globalThis.ResizeObserver) new globalThis.ResizeObserver(resized).observe(tape.node)
  update(last)
  return { node, update }
}
