import assert from 'node:assert/strict'
import test from 'node:test'
import * as instruments from '../../UAV/manager/static/instruments.js'
import { same } from './panel.js'

const { angleText, compassLetters, compassMark, compassWord, headingText, instrumentWords, ladderMark, limitEnds, noseMark,
  nosePlace, scaleMarks, tapePath, ladderPath, textBelow, wrapped, DEGREE } = instruments

test('An angle is between −180 and 180', () => {
  same([0, 179, 180, 181, 360, -181, 725].map(wrapped), [0, 179, -180, -179, 0, 179, 5])
})

test('Points of the compass', () => {
  same([0, 22, 23, 87, 181, 337, 338, 360, -45].map(compassLetters), ['N', 'N', 'NE', 'E', 'S', 'NW', 'N', 'N', 'NW'])
  same(compassWord(44), 'north-east')
})

test('Angles as text: a real minus, no minus zero, and a dash for what is unknown', () => {
  same([-20.4, -.4, 12, null, undefined, NaN].map(angleText), ['−20°', '0°', '12°', '–', '–', '–'])
  same([0, 7.2, 87, 359.6, -1, 360].map(headingText), ['000°', '007°', '087°', '000°', '359°', '000°'])
})

test('One sentence for a screen reader', () => {
  same(instrumentWords({ pitch: -20, yaw: 3, heading: 87.4 }), 'Pitch −20°, heading 87° (E)')
  same(instrumentWords({ pitch: 0, yaw: 3, heading: 359.7 }), 'Pitch 0°, heading 0° (N)')
  same(instrumentWords({ pitch: null, yaw: -12, heading: null }), 'Pitch unknown, 12° left of the nose')
  same(instrumentWords({ pitch: 5, yaw: .2 }), 'Pitch 5°, along the nose')
  same(instrumentWords({}), 'Pitch unknown, heading unknown')
})

test('Marks of the scales', () => {
  same([0, 15, 30, 45, 60, 90, 390, 405, -90].map(compassMark), ['N', '', '30', 'NE', '60', 'E', '30', 'NE', 'W'])
  same([0, 30, -30, 180, 270, 45].map(noseMark), ['nose', '30', '−30', 'tail', '−90', ''])
  same([0, -90, 90, -20, 5].map(ladderMark), ['horizon', 'down', 'up', '−20', ''])
  same(scaleMarks(-5, 10, at => 'x' + at), [{ at: -5, long: false, text: 'x-5' }, { at: 0, long: true, text: 'x0' },
    { at: 5, long: false, text: 'x5' }, { at: 10, long: true, text: 'x10' }])
})

test('A tape runs to the right, and a ladder up', () => {
  const marks = scaleMarks(0, 10, () => '')
  same(tapePath(marks), 'M0 16V26M20 20V26M40 16V26')
  same(ladderPath(marks), 'M-18 0H0M-7 -20H0M-12 -40H0')
})

test('The nose stands left of the middle when the camera looks right of it, and never off the tape', () => {
  same([0, 20, -20, 170, -170, 540].map(yaw => nosePlace(yaw, 200)), [0, -20 * DEGREE, 20 * DEGREE, -160, 160, 160])
})

test('A gimbal that turns all around has no ends', () => {
  same([[-90, 30], [-180, 180], [null, 30], undefined, null, []].map(limitEnds), [[-90, 30], [], [], [], [], []])
})

test('No text is cut in half by the number at the middle', () => {
  same([-20.3, -25, 3, 5, -.1].map(textBelow), [-20, null, 0, null, 0])
})

// A document of the few things that a drawing needs; it counts what is made and written
function fakeDocument() {
  const count = { made: 0, written: 0 }
  class Node {
    constructor(tag) { Object.assign(this, { tag, attributes: new Map(), childNodes: [], text: '' }); count.made += 1 }
    getAttribute(key) { return this.attributes.get(key) ?? null }
    setAttribute(key, value) { this.attributes.set(key, String(value)); count.written += 1 }
    hasAttribute(key) { return this.attributes.has(key) }
    toggleAttribute(key, yes) { yes ? this.setAttribute(key, '') : this.attributes.delete(key) }
    append(...inside) { this.childNodes.push(...inside) }
    get textContent() { return this.childNodes.map(node => node.textContent ?? node).join('') }
    set textContent(text) { this.childNodes = [text]; count.written += 1 }
    all(f) { return [...(f(this) ? [this] : []), ...this.childNodes.flatMap(node => node.all?.(f) ?? [])] }
    of(which) { return this.all(node => node.getAttribute('class')?.split(' ').includes(which))[0] }
  }
  globalThis.document = { createElement: tag => new Node(tag), createElementNS: (_, tag) => new Node(tag) }
  return count
}

test('All is drawn once; an update makes no element, and writes only what is new', () => {
  const count = fakeDocument(), { node, update } = instruments.instruments()
  update({ pitch: -20, yaw: 25, heading: 87, hfov: 60, vfov: 36, limits: { pitch: [-90, 30], yaw: null } })
  const made = count.made, now = { pitch: -21, yaw: 26, heading: 88, hfov: 60, vfov: 36, limits: { pitch: [-90, 30], yaw: null } }
  const before = count.written
  update(now)
  assert.equal(count.made, made)
  assert.ok(count.written > before && count.written - before <= 10, String(count.written - before))
  const after = count.written
  update({ ...now })
  assert.equal(count.written, after)
  same(node.getAttribute('aria-label'), 'Pitch −21°, heading 88° (E)')
  same([node.getAttribute('role'), node.getAttribute('aria-live')], ['img', null])
})

test('What is not known: the nose in place of north, and no tape at all', () => {
  fakeDocument()
  const { node, update } = instruments.instruments(), tape = node.of('tape'), ladder = node.of('ladder')
  const hidden = part => part.hasAttribute('hidden'), number = part => part.of('number').textContent
  update({ pitch: -20, yaw: 25, heading: 87 })
  same([hidden(tape), hidden(tape.of('nose')), number(tape), number(ladder)], [false, false, '087°', '−20°'])
  update({ pitch: -20, yaw: 25, heading: null })
  same([hidden(tape), hidden(tape.of('nose')), number(tape)], [false, true, '25°'])
  update({ pitch: null, yaw: null, heading: null })
  same([hidden(tape), number(ladder)], [true, '–'])
})
