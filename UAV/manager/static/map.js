// A map from above, drawn here without the internet: where the vehicle is and was, what the camera sees of the
// ground, and where pictures were taken.
//
// A field has no network, so there is only a grid of metres, and map tiles where somebody gave them. North is up. Over
// a few kilometres the ground counts as flat. A click points the camera at that place on the ground.

import { h, icon, name, say, show } from './parts.js'
import { Refused } from './wire.js'
import { compassLetters, compassWord, wrapped } from './instruments.js'
import { baseMap, eastward, mercator, unmercator } from './tiles.js'

// Places and metres: `project` gives metres to the east and to the north of a place, as Web Mercator has them there.
export function project(place, from) {
  const metres = eastward(from)
  return { x: wrapped(place.lon - from.lon) * metres, y: (mercator(place.lat) - mercator(from.lat)) * metres }
}

export function unproject({ x, y }, from) {
  const metres = eastward(from)
  return { lat: unmercator(mercator(from.lat) + y / metres), lon: wrapped(from.lon + x / metres) }
}

export function distance(place, from) {
  const { x, y } = project(place, from)
  return Math.hypot(x, y)
}

export function bearing(place, from) {
  const { x, y } = project(place, from)
  return Math.atan2(x, y) * 180 / Math.PI
}

export function metresText(metres) {
  if (metres < 1000) return metres.toFixed(metres < 1 ? 1 : 0) + ' m'
  return (metres / 1000).toFixed(metres < 10000 && metres % 1000 ? 1 : 0) + ' km'
}

export function placeText({ lat, lon }, digits = 5) { return lat.toFixed(digits) + ', ' + lon.toFixed(digits) }

// What the panel tells: GeoJSON has the longitude first. A place that is none is left out.
export function isPlace(place) {
  return Number.isFinite(place?.lat) && Number.isFinite(place.lon) && Math.abs(place.lat) <= 90
}

export function placesOf(coordinates) {
  const first = coordinates?.[0]
  if (first && typeof first === 'object') return coordinates.flatMap(placesOf)
  const [lon, lat] = coordinates?.length ? coordinates : []
  return isPlace({ lat, lon }) ? [{ lat, lon }] : []
}

export function mapParts(answer) {
  const parts = { track: [], vehicle: [], footprint: [], center: [], picture: [] }
  for (const feature of answer?.features ?? []) {
    const places = placesOf(feature?.geometry?.coordinates)
    if (places.length) parts[feature.properties?.kind]?.push({ ...feature.properties, places, ...places[0] })
  }
  return parts
}

// The status may know newer positions than the last answer.
export function newer(parts, vehicles = []) {
  const known = vehicles.filter(isPlace), systems = new Set(known.map(({ system }) => system))
  const others = parts.vehicle.filter(({ system }) => !systems.has(system))
  return { ...parts, vehicle: [...others, ...known.map(vehicle => ({ ...vehicle, places: [vehicle] }))] }
}

// The vehicle of a camera has the same system, and an only vehicle is the one.
export function vehicleOf({ camera }, vehicles) {
  const own = vehicles.find(({ system }) => String(camera).split('/')[0] === String(system))
  return own ?? (vehicles.length === 1 ? vehicles[0] : null)
}

// In words: For a screen reader, and the first sentence for all who wait for a position.
export const NOWHERE = 'No position yet: it comes when the autopilot has found its place (GPS)'

export function vehicleWords({ system, above, lat, lon }, many) {
  const high = Number.isFinite(above) ? Math.round(above) + ' m above home' : 'at ' + placeText({ lat, lon }, 4)
  return 'Vehicle ' + (many ? system + ' ' : '') + high.replace('-', '−')
}

export function lookWords(center, vehicle) {
  const metres = vehicle && distance(center, vehicle)
  const beside = () => metresText(metres) + ' ' + compassWord(bearing(center, vehicle)) + ' of it'
  return 'looks at ' + placeText(center, 4) + (vehicle ? ', ' + (metres < 1 ? 'right below it' : beside()) : '')
}

export function mapWords({ vehicle, center }) {
  if (!vehicle.length && !center.length) return NOWHERE
  const flying = vehicle.map(one => vehicleWords(one, vehicle.length > 1)), many = center.length > 1
  const called = ({ camera }) => 'camera ' + (many ? camera + ' ' : '')
  const looking = center.map(one => called(one) + lookWords(one, vehicleOf(one, vehicle)))
  const words = [...flying, ...looking].join(', ')
  return words[0].toUpperCase() + words.slice(1)
}

// Sizes: A scale bar and a grid have sizes that are easy to read.
export function niceBelow(value) {
  const ten = 10 ** Math.floor(Math.log10(value) + 1e-9)
  return [5, 2, 1].map(n => n * ten).find(size => size <= value * 1.000001)
}

export function scaleBar(scale, longest) {
  const metres = niceBelow(longest / scale)
  return { metres, pixels: metres * scale, text: metresText(metres) }
}

export function gridStep(scale, least) {
  const above = least / scale, ten = 10 ** Math.floor(Math.log10(above))
  return [1, 2, 5, 10].map(n => n * ten).find(size => size >= above * .999999)
}

// Where grid lines stand between 0 and `length`, when one of them is at `origin`.
export function gridLines(origin, step, length) {
  const first = (origin % step + step) % step
  const lines = []
  for (let at = first; at < length; at += step) lines.push(at)
  return lines
}

export function bounds(points) {
  const known = points.filter(({ x, y }) => Number.isFinite(x) && Number.isFinite(y))
  if (!known.length) return null
  const ends = axis => [Math.min, Math.max].map(f => known.map(point => point[axis]).reduce((a, b) => f(a, b)))
  const [[left, right], [bottom, top]] = [ends('x'), ends('y')]
  return { left, right, bottom, top }
}

// A track of an hour has thousands of points, and most of them on the same pixel.
export function trackPath(points, least = 1.5) {
  const path = []
  for (const { x, y } of points) {
    const [lastX, lastY] = path.at(-1) ?? []
    if (Number.isFinite(x) && Number.isFinite(y) && !(Math.hypot(x - lastX, y - lastY) < least)) path.push([x, y])
  }
  const end = points.at(-1), [lastX, lastY] = path.at(-1) ?? []
  if (path.length && Number.isFinite(end.x + end.y) && (end.x !== lastX || end.y !== lastY)) path.push([end.x, end.y])
  return path
}

// The view: a place in the middle, and pixels for each metre. While it follows, the vehicle is in the middle.
export const ZOOM = { least: .002, most: 40, step: 1.6, farthest: 3000 }
export function zoomed(view, factor, { x = 0, y = 0 } = {}) {
  const scale = Math.max(ZOOM.least, Math.min(ZOOM.most, view.scale * factor)), rest = 1 / view.scale - 1 / scale
  return { ...view, ...unproject({ x: x * rest, y: -y * rest }, view), scale }
}

export function panned(view, dx, dy) {
  return { ...view, ...unproject({ x: -dx / view.scale, y: dy / view.scale }, view) }
}

export function toPixel(place, view, [width, height]) {
  const { x, y } = project(place, view)
  return { x: width / 2 + x * view.scale, y: height / 2 - y * view.scale }
}

export function toPlace({ x, y }, view, [width, height]) {
  return unproject({ x: (x - width / 2) / view.scale, y: (height / 2 - y) / view.scale }, view)
}

// So that all is seen around the middle, and no footprint at the horizon makes the rest a dot. In a corner only what
// is now counts: there the whole track would leave a few pixels for the picture.
export const SMALL_MAP = 220
export function fitting(parts, middle, [width, height]) {
  const { footprint, center, vehicle } = parts, now = [footprint, center, vehicle.slice(0, 1)]
  const places = (width > SMALL_MAP ? Object.values(parts) : now).flat().flatMap(({ places }) => places)
  const points = places.map(place => project(place, middle))
  const near = points.filter(({ x, y }) => Math.hypot(x, y) < ZOOM.farthest), all = bounds([...near, { x: 0, y: 0 }])
  const wide = Math.max(25, all.right, -all.left), high = Math.max(25, all.top, -all.bottom)
  return Math.min((width / 2 - 24) / wide, (height / 2 - 24) / high, 8)
}

// Until you zoom, all stays in sight. The scale changes in steps, so that the map is calm.
export function refitted(scale, fit) { return scale > fit || scale < fit / 2.5 ? fit * .9 : scale }

export function middleOf({ vehicle, center, track, picture }, main) {
  const own = vehicle.find(({ system }) => system === main)
  return own ?? vehicle[0] ?? center[0] ?? track[0]?.places.at(-1) ?? picture.at(-1) ?? null
}

// Drawing: `pen` has the canvas, its size, and where a place is on it. Colours come from the style, by elements that
// nobody sees: so they follow the theme.
export const MAP_COLOURS = ['ground', 'grid', 'ink', 'quiet', 'track', 'main', 'other', 'picture', 'cross', 'veil']
export const MAP_FONT = ' 11px system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif'

export function drawLine({ context }, path, colour, width, more = {}) {
  const { closed, dash = [], fill, alpha = 1 } = more
  context.beginPath()
  for (const [i, [x, y]] of path.entries()) i ? context.lineTo(x, y) : context.moveTo(x, y)
  if (closed) context.closePath()
  Object.assign(context, { strokeStyle: colour, lineWidth: width, lineJoin: 'round', lineCap: 'round' })
  context.globalAlpha = alpha
  if (fill) context.fillStyle = fill
  if (fill) context.fill()
  context.globalAlpha = 1
  context.setLineDash(dash)
  if (width) context.stroke()
  context.setLineDash([])
}

export function drawDisc({ context }, { x, y }, radius, fill, edge, width = 2) {
  context.beginPath()
  context.arc(x, y, radius, 0, 2 * Math.PI)
  Object.assign(context, { fillStyle: fill, strokeStyle: edge, lineWidth: width })
  if (fill) context.fill()
  if (edge) context.stroke()
}

// Words have an edge in the colour of the ground, so a line below them does not matter.
export function drawText({ context, colours }, text, x, y, { align = 'left', weight = 600, colour = colours.ink } = {}) {
  Object.assign(context, { font: weight + MAP_FONT, textAlign: align, textBaseline: 'middle', lineJoin: 'round' })
  Object.assign(context, { strokeStyle: colours.ground, lineWidth: 3.5, fillStyle: colour })
  context.strokeText(text, x, y)
  context.fillText(text, x, y)
}

export function drawGrid(pen, anchor) {
  const { context, size: [width, height], view, colours } = pen, step = gridStep(view.scale, 36) * view.scale
  const { x, y } = pen.at(anchor)
  const lines = [...gridLines(x, step, width).map(x => [[x, 0], [x, height]]),
    ...gridLines(y, step, height).map(y => [[0, y], [width, y]])]
  Object.assign(context, { fillStyle: colours.ground })
  context.fillRect(0, 0, width, height)
  const sharp = line => line.map(([x, y]) => [Math.round(x) + .5, Math.round(y) + .5])
  for (const line of lines) drawLine(pen, sharp(line), colours.grid, 1)
}

export function drawTracks(pen, { track }) {
  for (const { places } of track) {
    const path = trackPath(places.map(pen.at))
    drawLine(pen, path, pen.colours.ground, 5)
    drawLine(pen, path, pen.colours.track, 2)
  }
}

export function drawFootprints(pen, { footprint }, main) {
  for (const { camera, places } of footprint.filter(({ places }) => places.length > 2)) {
    const path = places.map(pen.at).map(({ x, y }) => [x, y]), colour = pen.colours[camera === main ? 'main' : 'other']
    drawLine(pen, path, colour, 1.5, { closed: true, fill: colour, alpha: .2 })
  }
}

// From the vehicle to the middle of the picture runs a dashed line, to a mark with a hole.
export function drawSights(pen, { center, vehicle, footprint }, main) {
  for (const one of center) {
    const from = vehicleOf(one, vehicle), at = pen.at(one), colour = pen.colours[one.camera === main ? 'main' : 'other']
    const line = from && [pen.at(from), at].map(({ x, y }) => [x, y])
    if (line) drawLine(pen, line, colour, 1.5, { dash: [2, 5] })
    drawDisc(pen, at, 5, null, pen.colours.ground, 4)
    drawDisc(pen, at, 5, null, colour, 2)
    drawDisc(pen, at, 1.5, colour)
    if (center.length > 1 && pen.size[0] > SMALL_MAP) drawText(pen, String(one.camera), at.x + 9, at.y, { colour })
  }
}

// Each picture has its number, if there is room for it. The newest has its number first.
export function drawPictures(pen, { picture, vehicle }) {
  const room = vehicle.map(pen.at).map(({ x, y }) => ({ x, y: y + 22 }))
  for (const place of picture) drawDisc(pen, pen.at(place), 3.5, pen.colours.picture, pen.colours.ground, 1.5)
  for (const { n, ...place } of [...picture].reverse()) {
    const { x, y } = pen.at(place)
    if (room.some(taken => Math.abs(taken.x - x) < 26 && Math.abs(taken.y + 6 - y) < 13)) continue
    room.push({ x, y: y - 6 })
    drawText(pen, String(n), x + 6, y - 6, { colour: pen.colours.picture })
  }
}

export function arrowPath({ x, y }, heading, size = 1) {
  const turn = heading * Math.PI / 180, [sin, cos] = [Math.sin(turn), Math.cos(turn)]
  const corners = [[0, -13], [8.5, 9], [0, 4.5], [-8.5, 9]]
  return corners.map(([right, down]) => [x + (right * cos - down * sin) * size, y + (right * sin + down * cos) * size])
}

// An old position is pale. A vehicle without a heading is a disc.
export const STALE = 5
export function drawVehicles(pen, { vehicle }) {
  const large = pen.size[0] > SMALL_MAP
  for (const { system, heading, above, age, ...place } of vehicle) {
    const at = pen.at(place), { ink, ground, quiet } = pen.colours, fill = age > STALE ? quiet : ink
    if (Number.isFinite(heading)) {
      const path = arrowPath(at, heading, large ? 1 : .75)
      drawLine(pen, path, ground, 5, { closed: true })
      drawLine(pen, path, fill, 0, { closed: true, fill })
    } else drawDisc(pen, at, 7, fill, ground, 2.5)
    const high = Number.isFinite(above) && metresText(Math.round(above)).replace('-', '−')
    const words = [vehicle.length > 1 && system, high].filter(Boolean).join(' · ')
    if (large) drawText(pen, words, at.x, at.y + 22, { align: 'center', weight: 700 })
  }
}

export function drawScale(pen) {
  const { size: [width, height], view, colours } = pen, [left, low] = [10.5, height - 10.5]
  const { pixels, text } = scaleBar(view.scale, Math.min(120, width * .4)), right = left + pixels
  const path = [[left, low - 5], [left, low], [right, low], [right, low - 5]]
  drawLine(pen, path, colours.ground, 5)
  drawLine(pen, path, colours.ink, 1.5)
  drawText(pen, text, left + pixels / 2, low - 9, { align: 'center' })
}

export function drawNorth(pen) {
  const { colours } = pen, at = { x: 17, y: 18 }
  drawDisc(pen, { x: 17, y: 22 }, 12, colours.ground, colours.grid, 1)
  drawLine(pen, [[17, 12], [20.500, 18.500], [13.500, 18.500]], colours.cross, 0, { closed: true, fill: colours.cross })
  drawText(pen, 'N', at.x, at.y + 9, { align: 'center', weight: 700 })
}

export function drawCross(pen, place) {
  if (!place) return
  const { x, y } = pen.at(place), arms = [[0, -1], [1, 0], [0, 1], [-1, 0]]
  for (const [colour, width] of [[pen.colours.ground, 5], [pen.colours.cross, 2]]) {
    for (const [dx, dy] of arms) drawLine(pen, [[x + 4 * dx, y + 4 * dy], [x + 13 * dx, y + 13 * dy]], colour, width)
  }
}

// Where you clicked on the picture.
export function drawSpot(pen, spot) {
  if (!spot) return
  const { x, y } = pen.at(spot), shape = [[0, 0], [-6, -11], [-6, -17], [0, -21], [6, -17], [6, -11]]
  const pin = shape.map(([right, down]) => [x + right, y + down])
  drawLine(pen, pin, pen.colours.ground, 4, { closed: true })
  drawLine(pen, pin, pen.colours.cross, 1, { closed: true, fill: pen.colours.cross })
  drawDisc(pen, { x, y: y - 14 }, 2.5, pen.colours.ground)
}

export function drawMap(pen, parts, { main, anchor, cross, aim, base, spot }) {
  drawGrid(pen, anchor)
  base.draw(pen)
  drawFootprints(pen, parts, main)
  drawTracks(pen, parts)
  drawSights(pen, parts, main)
  drawPictures(pen, parts)
  drawVehicles(pen, parts)
  drawSpot(pen, spot)
  drawCross(pen, cross)
  if (aim) drawCross(pen, pen.view)
  drawScale(pen)
  drawNorth(pen)
}

// The canvas has as many dots as the screen has for it. It is drawn at most once for each frame of the screen.
export function canvasView(draw) {
  const canvas = h('canvas', { role: 'img', 'aria-label': NOWHERE })
  const inks = MAP_COLOURS.map(which => h('i', { class: 'map-ink', 'data-ink': which, hidden: true }))
  const node = h('div', { class: 'map-field' }, canvas, ...inks)
  let asked = false
  const size = () => [node.clientWidth, node.clientHeight]
  function fit([width, height]) {
    const dots = globalThis.devicePixelRatio || 1, wanted = [width, height].map(length => Math.round(length * dots))
    if (canvas.width !== wanted[0]) canvas.width = wanted[0]
    if (canvas.height !== wanted[1]) canvas.height = wanted[1]
    const context = canvas.getContext('2d')
    context.setTransform(dots, 0, 0, dots, 0, 0)
    return context
  }
  function now() {
    asked = false
    const [width, height] = size()
    if (!width || !height) return
    const colours = Object.fromEntries(inks.map(ink => [ink.dataset.ink, globalThis.getComputedStyle(ink).color]))
    draw({ context: fit([width, height]), size: [width, height], colours })
  }
  function redraw() {
    if (!asked) asked = !!globalThis.requestAnimationFrame(now)
  }
  return { node, canvas, size, redraw }
}

// Hands: One finger or the mouse drags, two fingers and the wheel zoom, and what did not move is a click.
export const STEADY = { mouse: 4, touch: 10 }
export function placeOn(node, { clientX, clientY }) {
  const { left, top } = node.getBoundingClientRect()
  return { x: clientX - left, y: clientY - top }
}

export function handsOnMap(node, { pan, zoom, click }) {
  const down = new Map()
  let begin = null, far = 0, many = false
  const place = event => placeOn(node, event)
  const middle = ([a, b]) => ({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 })
  const apart = ([a, b]) => Math.hypot(a.x - b.x, a.y - b.y)
  node.addEventListener('pointerdown', event => {
    if (event.button) return
    many = down.size > 0
    if (!many) far = 0
    if (!many) begin = place(event)
    down.set(event.pointerId, place(event))
    node.setPointerCapture(event.pointerId)
  })
  node.addEventListener('pointermove', event => {
    if (!down.has(event.pointerId)) return
    const before = [...down.values()], old = down.get(event.pointerId), now = place(event)
    down.set(event.pointerId, now)
    const after = [...down.values()], steady = STEADY[event.pointerType] ?? STEADY.touch
    far = Math.max(far, apart([begin, now]))
    if (after.length === 2) {
      const [from, to] = [before, after].map(middle)
      pan(to.x - from.x, to.y - from.y)
      zoom(apart(after) / Math.max(1, apart(before)), to)
    } else if (far > steady) pan(now.x - old.x, now.y - old.y)
  })
  const up = event => {
    if (!down.delete(event.pointerId) || event.type !== 'pointerup' || many) return
    if (far <= (STEADY[event.pointerType] ?? STEADY.touch)) click(place(event))
  }
  for (const kind of ['pointerup', 'pointercancel', 'lostpointercapture']) node.addEventListener(kind, up)
  node.addEventListener('wheel', event => {
    event.preventDefault()
    zoom(Math.exp(-event.deltaY * (event.deltaMode ? .05 : .0015)), place(event))
  }, { passive: false })
}

// Keys do the same. What the map takes is not for the panel: an arrow key turns a gimbal there.
export function keysOnMap(node, { pan, zoom, click, size }) {
  const pans = { ArrowUp: [0, 1], ArrowDown: [0, -1], ArrowLeft: [1, 0], ArrowRight: [-1, 0] }
  const zooms = { '+': ZOOM.step, '=': ZOOM.step, '-': 1 / ZOOM.step, '−': 1 / ZOOM.step }
  node.addEventListener('keydown', event => {
    const { key, repeat, ctrlKey, altKey, metaKey } = event, [width, height] = size()
    if (ctrlKey || altKey || metaKey || event.target !== node) return
    if (pans[key]) pan(...pans[key].map(part => part * Math.min(width, height) / 8))
    else if (zooms[key]) zoom(zooms[key])
    else if (key === 'Enter' && !repeat) click({ x: width / 2, y: height / 2 })
    else return
    event.preventDefault()
    event.stopPropagation()
  })
}

// Asking: Once a second, while somebody can see it, and never twice at a time.
export const MAP_EVERY = 1000
export function askingMap(wire, node, take, fail) {
  let opened = false, sighted = true, asking = false, timer = null
  const seen = entries => { sighted = entries.at(-1).isIntersecting }
  const watch = globalThis.IntersectionObserver && new IntersectionObserver(seen)
  async function ask() {
    if (!opened || !sighted || asking || document.hidden) return
    asking = true
    const coming = wire.map?.() ?? Promise.reject(new Refused('This panel has no map'))
    const answer = await coming.then(answer => () => take(answer), error => () => fail(error))
    asking = false
    if (opened) answer()
  }
  watch?.observe(node)
  function open(yes) {
    if (yes === opened) return
    opened = yes
    clearInterval(timer)
    if (yes) timer = setInterval(ask, MAP_EVERY, ask())
  }
  return { open, stop: () => open(false, watch?.disconnect()) }
}

export function failedWords(error) {
  return error instanceof Refused ? error.message : 'No answer: the map is not up to date'
}

export function whyNotLook({ state, can_look, why_look }, parts) {
  if (can_look) return ''
  if (why_look) return why_look
  if (state && state !== 'alive') return 'The camera is lost, so it cannot be pointed'
  return parts.vehicle.length ? 'This camera cannot be pointed from the map' : NOWHERE
}

// The browser saves what it has: the last answer, as it came.
export function saveText(text, file, type) {
  const url = URL.createObjectURL(new Blob([text], { type }))
  h('a', { href: url, download: file }).click()
  setTimeout(() => URL.revokeObjectURL(url), 1000)
}

export function mapPress(label, glyph, press) {
  return h('button', { type: 'button', class: 'map-press', title: label, 'aria-label': label, onclick: press }, glyph)
}

// What the map shows now, and where it looks from. The place of the view is found when there is a position and a
// size; until then a sentence stands there.
export function mapState(row) {
  const state = { told: mapParts(null), answer: null, status: {}, cross: null }
  Object.assign(state, { view: null, anchor: null, follow: true, auto: true })
  state.parts = () => newer(state.told, state.status.vehicles)
  state.middle = () => middleOf(state.parts(), state.status.vehicle)
  state.center = () => {
    const { center } = state.parts()
    return center.find(({ camera }) => camera === row.of) ?? center[0]
  }
  state.settle = size => {
    const middle = state.middle()
    if (!middle) return !!state.view
    const { lat, lon } = middle
    state.anchor ??= { lat, lon }
    state.view ??= { lat, lon, scale: 1 }
    if (state.follow) state.view = { ...state.view, lat, lon }
    if (state.auto) state.view.scale = refitted(state.view.scale, fitting(state.parts(), middle, size))
    return true
  }
  return state
}

// Where it looks, or what is below the pointer.
export function whereText(place, vehicle, before = '') {
  if (!place) return ''
  const away = () => metresText(Math.round(distance(place, vehicle))) + ' ' + compassLetters(bearing(place, vehicle))
  return [before + placeText(place), vehicle && away()].filter(Boolean).join(' · ')
}

export function mapNote() {
  const node = h('p', { class: 'map-note', role: 'status' })
  let timer = null, word = '', fault = ''
  const write = () => say(node, word || fault)
  const tell = text => {
    clearTimeout(timer)
    word = text
    timer = setTimeout(tell, 8000, '')
    if (!text) clearTimeout(timer)
    write()
  }
  const failed = text => { fault = text; write() }
  return { node, tell, failed }
}

// A click asks the camera to look there. The cross stays until the answer.
export function lookingAt(row, state, note, redraw) {
  return async at => {
    const why = at ? whyNotLook(state.status, state.parts()) : NOWHERE
    if (why) return note.tell(why)
    const place = state.cross = { lat: +at.lat.toFixed(7), lon: +at.lon.toFixed(7) }
    redraw(note.tell(''))
    const answer = await row.act('look_at', place)
    if (state.cross === place) state.cross = null
    redraw(answer.ok || note.tell(answer.text || 'The camera refused to look there'))
  }
}

// The hands and the buttons change the view. Who drags it away stops following. The button *Centre* follows again,
// and pressed once more it shows all.
export function mapMoves(state, size, look, redraw) {
  const change = view => redraw(state.view = view), ready = f => (...args) => state.view && f(...args)
  const fromMiddle = ({ x, y }) => ({ x: x - size()[0] / 2, y: y - size()[1] / 2 })
  const pan = ready((dx, dy) => {
    state.follow = state.auto = false
    change(panned(state.view, dx, dy))
  })
  const zoom = ready((factor, at) => {
    state.auto = false
    change(zoomed(state.view, factor, at && !state.follow ? fromMiddle(at) : {}))
  })
  const centre = ready(() => {
    state.auto ||= state.follow
    state.follow = true
    redraw()
  })
  const click = at => look(state.view ? toPlace(at, state.view, size()) : null)
  return { pan, zoom, centre, click, size }
}

// Buttons lie over the map, and below it stands a line of words.
export function mapPresses({ zoom, centre }) {
  const follow = mapPress('Centre on the vehicle', icon('centre'), centre)
  const [closer, farther] = [['Zoom in', '+', ZOOM.step], ['Zoom out', '−', 1 / ZOOM.step]]
    .map(([label, glyph, factor]) => mapPress(label, glyph, () => zoom(factor)))
  const node = h('div', { class: 'map-presses' }, closer, farther, follow)
  return { node, update: yes => follow.setAttribute('aria-pressed', yes) }
}

export function mapFoot(state, hands, toPlaceNow) {
  const where = h('span', { class: 'map-where' })
  const save = h('button', { type: 'button', class: 'map-save', disabled: true }, 'Save GeoJSON')
  let over = null
  function update() {
    const center = state.center(), vehicles = state.parts().vehicle
    const looks = () => whereText(center, center && vehicleOf(center, vehicles), 'Looks at ')
    say(where, over && state.view ? whereText(toPlaceNow(over), vehicles[0]) : looks())
    save.disabled = !state.answer
  }
  const hover = at => update(over = at)
  for (const kind of ['pointermove', 'pointerdown']) hands.addEventListener(kind, event => hover(placeOn(hands, event)))
  hands.addEventListener('pointerleave', () => hover(null))
  save.addEventListener('click', () => saveText(JSON.stringify(state.answer), 'track.geojson', 'application/geo+json'))
  return { node: h('footer', { class: 'map-foot' }, where, save), update }
}

// What changes around it: its size, and the theme.
export function whenItChanges(node, redraw) {
  const resized = globalThis.ResizeObserver && new globalThis.ResizeObserver(redraw)
  const theme = globalThis.matchMedia?.('(prefers-color-scheme: dark)')
  resized?.observe(node)
  theme?.addEventListener('change', redraw)
  return () => {
    resized?.disconnect()
    theme?.removeEventListener('change', redraw)
  }
}

export const HINT = 'Map: arrow keys pan, + and − zoom, Enter points the camera at the middle'

// A map in a drawer, or in a corner of the picture: the style makes it as large as its place.
//
// `update` takes the status of the camera that a click points, which may have the panel's `vehicles` in it.
export function mapView(row) {
  const state = mapState(row), note = mapNote(), empty = h('p', { class: 'map-empty' }, NOWHERE)
  const hands = h('div', { class: 'map-hands', role: 'application', tabindex: 0, 'aria-label': HINT })
  const { node: field, canvas, size, redraw } = canvasView(pen => drawState(pen, row, state, hands, presses, base))
  const base = baseMap(row.wire, redraw)
  const moves = mapMoves(state, size, lookingAt(row, state, note, redraw), redraw), presses = mapPresses(moves)
  const foot = mapFoot(state, hands, at => toPlace(at, state.view, size())), still = whenItChanges(field, redraw)
  hands.append(field)
  show(presses.node, false)
  const body = h('div', { class: 'map-body' }, hands, empty, presses.node, base.node, note.node)
  const node = h('section', { class: 'map', 'aria-label': 'Map' }, body, foot.node)
  for (const listen of [handsOnMap, keysOnMap]) listen(hands, moves)
  for (const kind of ['focus', 'blur']) hands.addEventListener(kind, redraw)
  function changed() {
    for (const [part, yes] of [[empty, !state.middle()], [presses.node, state.middle()]]) show(part, yes)
    name(canvas, mapWords(state.parts()))
    hands.toggleAttribute('data-look', !!state.status.can_look)
    foot.update(redraw())
  }
  const take = answer => changed(Object.assign(state, { answer, told: mapParts(answer) }), note.failed(''), base.open())
  const asking = askingMap(row.wire, node, take, error => note.failed(failedWords(error)))
  return { node, update: status => changed(state.status = status), open: asking.open, stop: () => asking.stop(still()) }
}

export function drawState(pen, { of, spot }, state, hands, presses, base) {
  presses.update(state.follow)
  if (!state.settle(pen.size)) return
  const { view, anchor, cross } = state, aim = hands.matches(':focus-visible')
  const at = place => toPixel(place, view, pen.size)
  drawMap({ ...pen, view, at }, state.parts(), { main: of, anchor, cross, aim, base, spot })
}
