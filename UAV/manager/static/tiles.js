// The ground below the map, where somebody gave the panel tiles: square pictures in Web Mercator.
//
// A field has no network, so none is there by default, and not one request goes out. The browser loads tiles of a web
// server itself, as it may have a way to the internet that the panel's computer lacks; those of a folder come from the
// panel. Without a tile, or where one is missing, the grid shows.

import { h, say, show } from './parts.js'

// Web Mercator: a place has degrees of longitude to the east, and to the north as many as make a small square as high
// as it is wide. So tiles, tracks and footprints lie on each other at every latitude. It ends at 85.05°, and at a pole
// a degree to the east is next to nothing, so it is never taken as nothing.
export const DEGREE_METRES = 111319.49
export function eastward({ lat }) { return DEGREE_METRES * Math.max(1e-5, Math.cos(lat * Math.PI / 180)) }
export function mercator(lat) { return Math.asinh(Math.tan(lat * Math.PI / 180)) * 180 / Math.PI }
export function unmercator(north) { return Math.atan(Math.sinh(north * Math.PI / 180)) * 180 / Math.PI }

// The tiles of a view, nearest to its middle first, with the place of their upper left corner and their side in pixels.
// One pixel of a tile is about one dot of the screen. A view that would need more than `MOST_TILES` has coarser ones.
export const TILE = 256, MOST_TILES = 160
export function tilesInView(view, [width, height], { least, most }, dots = 1) {
  const world = 360 * eastward(view) * view.scale
  const side = z => world / 2 ** z, many = z => (width / side(z) + 2) * (height / side(z) + 2)
  let z = Math.max(least, Math.min(most, Math.round(Math.log2(world * dots / TILE))))
  while (z > least && many(z) > MOST_TILES) z -= 1
  if (many(z) > MOST_TILES) return []
  const n = 2 ** z, x = (view.lon + 180) / 360 * n, y = (180 - mercator(view.lat)) / 360 * n, found = []
  const [across, down] = [width, height].map(length => length / 2 / side(z))
  for (let j = Math.max(0, Math.floor(y - down)); j <= Math.min(n - 1, Math.floor(y + down)); j++) {
    for (let i = Math.floor(x - across); i <= Math.floor(x + across); i++) {
      const left = width / 2 + (i - x) * side(z), top = height / 2 + (j - y) * side(z)
      found.push({ z, x: (i % n + n) % n, y: j, left, top, side: side(z) })
    }
  }
  const far = tile => Math.hypot(tile.left + tile.side / 2 - width / 2, tile.top + tile.side / 2 - height / 2)
  return found.sort((a, b) => far(a) - far(b))
}

// A tile and those that enclose it, from the finest.
export function enclosing({ z, x, y }, least = 0) {
  const up = Array.from({ length: z - least + 1 }, (_, n) => n)
  return up.map(n => ({ z: z - n, x: Math.floor(x / 2 ** n), y: Math.floor(y / 2 ** n), n }))
}

export function tileAddress(url, { z, x, y }) {
  const numbers = { z, x, y, '-y': 2 ** z - 1 - y }
  return url.replace(/\{(z|x|-?y)\}/g, (_, which) => numbers[which])
}

// Loading: at most `AT_ONCE` at a time, the nearest first; what moved out of sight meanwhile is not loaded. A tile that
// isn't there is asked for again after a minute, and until then the one that encloses it is shown, larger.
export const AT_ONCE = 6, KEPT = 320, ASK_AGAIN = 60000
export function tileStore(load, changed, now = Date.now) {
  const kept = new Map()                // the used last are at the end
  const keyOf = ({ z, x, y }) => z + '/' + x + '/' + y
  let queue = [], loading = 0
  const missing = key => kept.get(key)?.failed > now() - ASK_AGAIN
  const known = key => kept.get(key) && (kept.get(key).failed === undefined || missing(key))
  function keep(key, what) {
    kept.delete(key)
    kept.set(key, what)
    for (const old of kept.keys()) if (kept.size > KEPT && !kept.get(old).coming) kept.delete(old)
  }
  async function one(tile, key = keyOf(tile)) {
    loading += 1
    keep(key, { coming: true })
    const what = await load(tile).then(image => ({ image }), () => ({ failed: now() }))
    loading -= 1
    keep(key, what)
    changed()
    next()
  }
  function next() {
    while (loading < AT_ONCE && queue.length) one(queue.shift())
  }
  function want(tiles, least) {
    const wanted = tiles.map(tile => enclosing(tile, least).find(one => !missing(keyOf(one)))).filter(Boolean)
    queue = [...new Map(wanted.map(tile => [keyOf(tile), tile]))].filter(([key]) => !known(key)).map(([, tile]) => tile)
    next()
  }
  function best(tile, least) {
    for (const one of enclosing(tile, least)) {
      const image = kept.get(keyOf(one))?.image
      if (!image) continue
      keep(keyOf(one), { image })
      const parts = 2 ** one.n, place = [tile.x, tile.y].map(at => at % parts / parts)
      return { image, place, part: 1 / parts }
    }
  }
  return { want, best }
}

// A picture of an address. Another site is told of our origin, as some ask for, but never of the token. A server that
// doesn't answer is given up after a while: it would keep the others waiting.
export const TILE_PATIENCE = 20000
export function pictureAt(address) {
  const image = new Image(), late = setTimeout(() => image.removeAttribute('src'), TILE_PATIENCE)
  image.referrerPolicy = 'strict-origin'
  image.src = address
  return image.decode().then(() => image).finally(() => clearTimeout(late))
}

export async function tileOf(wire, { url }, tile) {
  if (url) return pictureAt(tileAddress(url, tile))
  const address = await wire.tile(tile)
  return pictureAt(address).finally(() => URL.revokeObjectURL(address))
}

// Edges are on whole dots, so that no line shows between two tiles. At night the ground is dimmed.
export function drawTiles({ context, size, view, colours }, tiles, store, least, dots) {
  const whole = at => Math.round(at * dots) / dots
  for (const tile of tiles) {
    const found = store.best(tile, least)
    if (!found) continue
    const [left, top, right, low] = [tile.left, tile.top, tile.left + tile.side, tile.top + tile.side].map(whole)
    const { image, place: [x, y], part } = found, { naturalWidth: wide, naturalHeight: high } = image
    context.drawImage(image, x * wide, y * high, part * wide, part * high, left, top, right - left, low - top)
    Object.assign(context, { fillStyle: colours.veil })
    context.fillRect(left, top, right - left, low - top)
  }
}

// The base of a map: asked for once the map is open, and drawn below all else. What the owner of the tiles wants to
// be said stands in a corner.
export function baseMap(wire, redraw) {
  const credit = h('p', { class: 'map-credit', hidden: true })
  let about, store
  async function open() {
    if (about !== undefined || !wire.tiles) return
    about = null
    const answer = await wire.tiles().catch(() => undefined)
    about = answer
    if (!about) return
    store = tileStore(tile => tileOf(wire, about, tile), redraw)
    say(credit, about.attribution)
    show(credit, !!about.attribution)
    redraw()
  }
  function draw(pen) {
    if (!about) return
    const dots = globalThis.devicePixelRatio || 1, tiles = tilesInView(pen.view, pen.size, about, dots)
    store.want(tiles, about.least)
    drawTiles(pen, tiles, store, about.least, dots)
  }
  return { node: credit, open, draw }
}
