import assert from 'node:assert/strict'
import test from 'node:test'
import * as map from '../../UAV/manager/static/map.js'
import { Refused } from '../../UAV/manager/static/wire.js'
import { same } from './panel.js'

const { NOWHERE, arrowPath, askingMap, bearing, bounds, distance, failedWords, fitting, gridLines, gridStep, handsOnMap, isPlace, keysOnMap,
  lookWords, lookingAt, mapParts, mapState, mapWords, metresText, middleOf, newer, niceBelow, panned, placeText, placesOf, project, refitted, scaleBar, toPixel,
  toPlace, trackPath, unproject, vehicleOf, whereText, whyNotLook, zoomed } = map
const ZURICH = { lat: 47.4, lon: 8.5 }, close = (a, b, off = 1e-6) => assert.ok(Math.abs(a - b) <= off, a + ' is not ' + b)
const feature = (kind, type, coordinates, more = {}) =>
  ({ type: 'Feature', geometry: { type, coordinates }, properties: { kind, ...more } })
const answer = (...features) => ({ type: 'FeatureCollection', features })

test('Metres to the east and to the north, and back', () => {
  const there = project({ lat: 47.401, lon: 8.501 }, ZURICH)
  close(there.y, 111.31949, .01)
  close(there.x, 111.31949 * Math.cos(47.4 * Math.PI / 180), .01)
  const back = unproject(there, ZURICH)
  close(back.lat, 47.401)
  close(back.lon, 8.501)
})

test('Across the antimeridian it is not around the world', () => {
  const east = { lat: 0, lon: 179.9995 }, west = { lat: 0, lon: -179.9995 }
  close(distance(west, east), 111.31949, .01)
  close(bearing(west, east), 90)
  close(unproject(project(west, east), east).lon, -179.9995)
})

test('At a pole all is finite', () => {
  for (const lat of [90, -90, 89.99999]) {
    const pole = { lat, lon: 12 }, { x, y } = project({ lat: lat - .0001 * Math.sign(lat), lon: -168 }, pole)
    assert.ok(Number.isFinite(x) && Number.isFinite(y))
    const back = unproject({ x: 500, y: 500 }, pole)
    assert.ok(isPlace(back), JSON.stringify(back))
  }
})

test('Sizes that are easy to read', () => {
  same([1, 9.99, 10, 37, 50, 1234, .3].map(niceBelow), [1, 5, 10, 20, 50, 1000, .2])
  same([.5, 20, 1000, 2500, 5000, 20000].map(metresText), ['0.5 m', '20 m', '1 km', '2.5 km', '5 km', '20 km'])
  same(scaleBar(2, 120), { metres: 50, pixels: 100, text: '50 m' })
  same(scaleBar(.01, 120), { metres: 10000, pixels: 100, text: '10 km' })
  for (let scale = .002; scale < 40; scale *= 1.3) {
    const { pixels } = scaleBar(scale, 120), step = gridStep(scale, 36) * scale
    assert.ok(pixels <= 120.01 && pixels > 47, scale + ': ' + pixels)
    assert.ok(step >= 35.99 && step < 91, scale + ': ' + step)
  }
})

test('Grid lines stay where they are on the ground', () => {
  same(gridLines(10, 40, 100), [10, 50, 90])
  same(gridLines(-70, 40, 100), [10, 50, 90])
  same(gridLines(1010, 40, 100), [10, 50, 90])
})

test('Bounds, without what is no number', () => {
  same(bounds([{ x: 1, y: 2 }, { x: NaN, y: 3 }, { x: -4, y: 5 }, { x: 0, y: null }]), { left: -4, right: 1, bottom: 2, top: 5 })
  same(bounds([]), null)
})

test('A track has no more points than can be seen, and always its end', () => {
  const line = Array.from({ length: 1001 }, (_, i) => ({ x: i / 100, y: 0 })), path = trackPath(line)
  assert.ok(path.length < 12, String(path.length))
  same([path[0], path.at(-1)], [[0, 0], [10, 0]])
  same(trackPath([{ x: 0, y: 0 }, { x: NaN, y: 1 }, { x: 9, y: 0 }]), [[0, 0], [9, 0]])
  same([trackPath([]), trackPath([{ x: 1, y: 1 }]), trackPath([{ x: 1, y: 1 }, { x: NaN, y: 1 }])], [[], [[1, 1]], [[1, 1]]])
})

test('Places of a feature, whatever is in it', () => {
  same(placesOf([8.5, 47.4]), [ZURICH])
  same(placesOf([[[8.5, 47.4], [null, 47], [8, NaN], [8, 91], [9, 48, 500]]]), [ZURICH, { lat: 48, lon: 9 }])
  for (const none of [null, undefined, [], [[]], [[], []], [null, null], 7, 'ab']) same(placesOf(none), [])
})

test('What is told, sorted; what cannot be shown is left out', () => {
  const parts = mapParts(answer(feature('vehicle', 'Point', [8.5, 47.4], { system: 1, heading: null }), null, {},
    feature('vehicle', 'Point', [null, null], { system: 2 }), feature('future', 'Point', [8, 47]),
    { geometry: null, properties: null },
    feature('track', 'LineString', [[8.5, 47.4], [8.6, 47.4]], { system: 1 })))
  same([parts.vehicle.length, parts.track[0].places.length, parts.footprint], [1, 2, []])
  for (const none of [null, undefined, {}, { features: [] }]) same(mapParts(none).vehicle, [])
})

test('A status may know a newer position', () => {
  const one = feature('vehicle', 'Point', [8.5, 47.4], { system: 1 }), two = feature('vehicle', 'Point', [8, 47], { system: 2 })
  const parts = mapParts(answer(one, two))
  const { vehicle } = newer(parts, [{ system: 1, lat: 47.5, lon: 8.5, heading: 90 }, { system: 2, lat: null, lon: null }])
  same(vehicle.map(({ system, lat }) => [system, lat]), [[2, 47], [1, 47.5]])
  same(newer(parts).vehicle.length, 2)
})

test('The vehicle of a camera', () => {
  const two = [{ system: 1 }, { system: 2 }]
  same([vehicleOf({ camera: '2/100' }, two), vehicleOf({ camera: '9/100' }, two), vehicleOf({ camera: 'x' }, [{ system: 4 }]),
    vehicleOf({ camera: '1/100' }, [])], [{ system: 2 }, null, { system: 4 }, null])
})

test('In words', () => {
  const vehicle = { system: 1, above: 35.4, lat: 47.3974, lon: 8.5454 }
  const there = unproject({ x: 42.4, y: 42.4 }, vehicle)
  const parts = mapParts(answer(feature('vehicle', 'Point', [8.5454, 47.3974], { system: 1, above: 35.4 }),
    feature('center', 'Point', [there.lon, there.lat], { camera: '1/100' })))
  same(mapWords(parts), 'Vehicle 35 m above home, camera looks at 47.3978, 8.5460, 60 m north-east of it')
  same(lookWords(vehicle, vehicle), 'looks at 47.3974, 8.5454, right below it')
  same(mapWords(mapParts(answer(feature('vehicle', 'Point', [8.5, 47.4], { system: 3 })))), 'Vehicle at 47.4000, 8.5000')
  same(mapWords(mapParts(answer(feature('center', 'Point', [8.5, 47.4], { camera: 'a' })))), 'Camera looks at 47.4000, 8.5000')
  same(mapWords(mapParts(null)), NOWHERE)
  same([placeText(ZURICH), whereText(null), whereText(there, vehicle, 'Looks at ')],
    ['47.40000, 8.50000', '', 'Looks at 47.39778, 8.54596 · 60 m NE'])
})

test('Pixels and places', () => {
  const view = { ...ZURICH, scale: 2 }, size = [300, 200]
  same(toPixel(ZURICH, view, size), { x: 150, y: 100 })
  const { x, y } = toPixel(unproject({ x: 10, y: 20 }, ZURICH), view, size)
  close(x, 170)
  close(y, 60)
  const back = project(toPlace({ x: 170, y: 60 }, view, size), ZURICH)
  close(back.x, 10)
  close(back.y, 20)
})

test('Zoom keeps the place below the pointer, and has two ends', () => {
  const view = { ...ZURICH, scale: 2 }, size = [300, 200], before = toPlace({ x: 200, y: 50 }, view, size)
  const at = toPixel(before, zoomed(view, 3, { x: 50, y: -50 }), size)
  close(at.x, 200, .01)
  close(at.y, 50, .01)
  same([zoomed(view, 1e9).scale, zoomed(view, 1e-9).scale, zoomed(view, 2).lat], [40, .002, 47.4])
})

test('A drag takes the ground along', () => {
  const view = { ...ZURICH, scale: 2 }, size = [300, 200]
  const { x, y } = toPixel(ZURICH, panned(view, 30, -20), size)
  close(x, 180, .01)
  close(y, 80, .01)
})

test('All fits around the vehicle, but not the horizon', () => {
  const point = (x, y) => ({ places: [unproject({ x, y }, ZURICH)] }), size = [400, 300]
  const parts = { vehicle: [point(0, 0)], track: [point(-80, 10)], footprint: [point(0, 900000)], center: [], picture: [] }
  close(fitting(parts, ZURICH, size), 176 / 80, .01)
  close(fitting(parts, ZURICH, [160, 130]), 41 / 25, .01)          // a corner: the track does not count
  assert.ok(fitting({ ...mapParts(null), vehicle: [point(0, 0)] }, ZURICH, size) <= 8)
  same([refitted(2, 3), refitted(4, 2), refitted(1, 5)], [2, 1.8, 4.5])
})

test('The middle: the vehicle of the camera, or another, or what is known', () => {
  const one = feature('vehicle', 'Point', [8, 47], { system: 1 }), two = feature('vehicle', 'Point', [9, 48], { system: 2 })
  const parts = mapParts(answer(one, two))
  same([middleOf(parts, 2).lat, middleOf(parts).lat, middleOf(mapParts(null))], [48, 47, null])
  same(middleOf(mapParts(answer(feature('track', 'LineString', [[8, 47], [9, 48]])))).lat, 48)
})

test('A view follows its vehicle, and forgets nothing without one', () => {
  const state = mapState({ of: '1/100' }), size = [400, 300]
  const at = (lon, lat) => mapParts(answer(feature('vehicle', 'Point', [lon, lat])))
  same([state.settle(size), state.view], [false, null])
  state.told = at(8, 47)
  same([state.settle(size), state.view.lat], [true, 47])
  state.told = at(8, 47.001)
  same([state.settle(size), state.view.lat, state.anchor.lat], [true, 47.001, 47])
  state.follow = false
  state.told = at(8, 47.002)
  same([state.settle(size), state.view.lat], [true, 47.001])
  state.told = mapParts(null)
  same(state.settle(size), true)
})

test('An arrow points where the vehicle goes', () => {
  const [[x, y]] = arrowPath({ x: 100, y: 100 }, 90)
  close(x, 113)
  close(y, 100)
})

test('Why a click does not point', () => {
  const flying = mapParts(answer(feature('vehicle', 'Point', [8, 47]))), why = status => whyNotLook(status, flying)
  same([why({ can_look: true }), why({ why_look: 'Mount locked' })], ['', 'Mount locked'])
  same(why({ can_look: false, state: 'lost' }), 'The camera is lost, so it cannot be pointed')
  same(whyNotLook({}, mapParts(null)), NOWHERE)
  same(failedWords(new Refused('too many')), 'too many')
  same(failedWords(new Error('x')), 'No answer: the map is not up to date')
})

test('A click asks to look there; its cross stays until the answer, and a refusal is told', async () => {
  const asked = [], told = [], answers = []
  const row = { of: 'a', act: (...what) => new Promise(done => { asked.push(what); answers.push(done) }) }
  const state = mapState(row), look = lookingAt(row, state, { tell: text => told.push(text) }, () => {})
  await look({ lat: 47.4, lon: 8.5 })
  same([asked.length, told.pop()], [0, NOWHERE])
  state.status = { can_look: true }
  const first = look({ lat: 47.40000001234, lon: 8.5 })
  same([asked, state.cross], [[['look_at', { lat: 47.4, lon: 8.5 }]], { lat: 47.4, lon: 8.5 }])
  const second = look({ lat: 48, lon: 8.5 })
  answers[0]({ ok: true })
  await first
  same(state.cross.lat, 48)                                        // the cross of the newer one stays
  answers[1]({ ok: false, text: 'out of reach' })
  await second
  same([state.cross, told.at(-1)], [null, 'out of reach'])
})

test('The map is asked for once a second while it is open and seen, and never twice at a time', async t => {
  t.mock.timers.enable({ apis: ['setInterval'] })
  globalThis.document = { hidden: false }
  const asked = [], taken = [], failed = [], settled = () => new Promise(done => setImmediate(done))
  const wire = { map: () => new Promise((take, fail) => asked.push({ take, fail })) }
  const { open, stop } = askingMap(wire, null, answer => taken.push(answer), error => failed.push(error.message))
  t.mock.timers.tick(5000)
  same(asked.length, 0)
  open(true)
  open(true)
  t.mock.timers.tick(5000)
  same(asked.length, 1)
  asked[0].take('a')
  await settled()
  t.mock.timers.tick(1000)
  asked[1].fail(new Error('no'))
  await settled()
  same([taken, failed], [['a'], ['no']])
  document.hidden = true
  t.mock.timers.tick(3000)
  same(asked.length, 2)
  document.hidden = false
  t.mock.timers.tick(1000)
  same(asked.length, 3)
  asked[2].take('late')
  stop()
  await settled()
  t.mock.timers.tick(9000)
  same([asked.length, taken], [3, ['a']])                          // nothing comes after its end
})

// An element that only hears
function ear() {
  const heard = new Map(), node = { addEventListener: (kind, f) => heard.set(kind, f), setPointerCapture() {},
    getBoundingClientRect: () => ({ left: 10, top: 20 }) }
  const fire = (type, more) => {
    const event = { type, target: node, button: 0, pointerType: 'mouse', pointerId: 1, stopped: 0, ...more,
      preventDefault() { this.stopped += 1 }, stopPropagation() { this.stopped += 1 } }
    heard.get(type)(event)
    return event.stopped
  }
  const done = [], note = what => (...args) => done.push([what, ...args])
  const hands = { pan: note('pan'), zoom: note('zoom'), click: note('click'), size: () => [400, 200] }
  return { node, fire, hands, done, at: (x, y) => ({ clientX: x + 10, clientY: y + 20 }) }
}

test('What does not move is a click, what moves is a drag and no click', () => {
  const { node, fire, hands, done, at } = ear()
  handsOnMap(node, hands)
  fire('pointerdown', at(50, 60))
  fire('pointermove', at(52, 61))
  fire('pointerup', at(52, 61))
  same(done.splice(0), [['click', { x: 52, y: 61 }]])
  fire('pointermove', at(80, 80))
  fire('pointerdown', { ...at(50, 60), button: 2 })
  fire('pointerup', at(50, 60))
  same(done, [])
  fire('pointerdown', at(50, 60))
  fire('pointermove', at(70, 60))
  fire('pointermove', at(51, 60))
  fire('pointerup', at(51, 60))
  fire('lostpointercapture', at(51, 60))
  same(done, [['pan', 20, 0], ['pan', -19, 0]])
})

test('Two fingers zoom around their middle, and are no click; a cancelled one is none either', () => {
  const { node, fire, hands, done, at } = ear(), finger = pointerId => ({ pointerId, pointerType: 'touch' })
  handsOnMap(node, hands)
  fire('pointerdown', { ...finger(1), ...at(100, 100) })
  fire('pointerdown', { ...finger(2), ...at(200, 100) })
  fire('pointermove', { ...finger(2), ...at(300, 100) })
  same(done.splice(0), [['pan', 50, 0], ['zoom', 2, { x: 200, y: 100 }]])
  fire('pointerup', { ...finger(1), ...at(100, 100) })
  fire('pointerup', { ...finger(2), ...at(300, 100) })
  fire('pointerdown', { ...finger(3), ...at(100, 100) })
  fire('pointercancel', { ...finger(3), ...at(100, 100) })
  same(done, [])
  fire('wheel', { ...at(5, 6), deltaY: -100, deltaMode: 0 })
  same([done[0][0], done[0][1] > 1, done[0][2]], ['zoom', true, { x: 5, y: 6 }])
})

test('Keys of the map stay in the map, and no others', () => {
  const { node, fire, hands, done } = ear()
  keysOnMap(node, hands)
  same(['ArrowUp', 'ArrowRight', '+', '-', 'Enter'].map(key => fire('keydown', { key })), [2, 2, 2, 2, 2])
  same(done.splice(0), [['pan', 0, 25], ['pan', -25, 0], ['zoom', 1.6], ['zoom', .625], ['click', { x: 200, y: 100 }]])
  const others = [{ key: 'r' }, { key: '+', ctrlKey: true }, { key: 'Enter', repeat: true }, { key: 'Enter', target: null }]
  same(others.map(more => fire('keydown', more)), [0, 0, 0, 0])
  same(done, [])
})
