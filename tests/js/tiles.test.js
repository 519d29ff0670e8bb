import assert from 'node:assert/strict'
import test from 'node:test'
import { ASK_AGAIN, AT_ONCE, KEPT, MOST_TILES, enclosing, mercator, tileAddress, tileStore, tilesInView, unmercator } from '../../UAV/manager/static/tiles.js'
import { distance, toPixel, toPlace } from '../../UAV/manager/static/map.js'
import { same } from './panel.js'

// Zoom, column and row of a tile, then its west, north, east and south, from mercantile 1.2.1 (PyPI): a town, both
// sides of the date line, Svalbard, Magellan's strait, Canberra, the equator, and the last row but a few in the north
const TILES = [[18, 137294, 91776, 8.544616699, 47.3983492, 8.54598999, 47.397419615],
  [15, 0, 17907, -180, -16.499299167, -179.989013672, -16.509832827],
  [15, 32767, 17907, 179.989013672, -16.499299167, 180, -16.509832827],
  [14, 8901, 2273, 15.578613281, 78.20207141, 15.600585938, 78.197578023],
  [16, 19861, 44236, -70.900268555, -53.159946788, -70.894775391, -53.163240271],
  [19, 479381, 317265, 149.164810181, -35.362736024, 149.165496826, -35.363295984],
  [8, 128, 128, 0, 0, 1.40625, -1.406108835],
  [12, 2332, 19, 24.9609375, 84.904958317, 25.048828125, 84.897146952]]
const SIZE = [1600, 1000], ANY = { least: 0, most: 22 }
const middle = ([, , , west, north, east, south]) => ({ lat: (north + south) / 2, lon: (west + east) / 2 })
// The scale at which a tile of this zoom is as large as `pixels`
const scaleFor = (z, { lat }, pixels = 256) => pixels * 2 ** z / (360 * 111319.49 * Math.cos(lat * Math.PI / 180))

test('A tile lies where its corners are, to a hundredth of a pixel, at all latitudes and over the date line', () => {
  for (const tile of TILES) {
    const [z, x, y, west, north, east, south] = tile, here = middle(tile)
    for (const aside of [0, .003, -.003]) {
      const view = { lat: here.lat + aside / 4, lon: here.lon + aside, scale: scaleFor(z, here) }
      const found = tilesInView(view, SIZE, ANY).filter(one => one.x === x && one.y === y)
      if (!found.length && aside && z > 15) continue                // out of sight
      same(found.map(one => one.z), [z])
      const [{ left, top, side }] = found
      const upper = toPixel({ lat: north, lon: west }, view, SIZE), lower = toPixel({ lat: south, lon: east - 1e-9 }, view, SIZE)
      const off = Math.max(...[left - upper.x, top - upper.y, left + side - lower.x, top + side - lower.y].map(Math.abs))
      assert.ok(off < .01, z + '/' + x + '/' + y + ' is off by ' + off)
    }
  }
})

test('The tiles of a view cover it without a gap, and no tile comes twice', () => {
  for (const tile of TILES) {
    for (const pixels of [181, 256, 362]) {
      const view = { ...middle(tile), scale: scaleFor(tile[0], middle(tile), pixels) }, tiles = tilesInView(view, SIZE, ANY)
      same(new Set(tiles.map(({ left, top }) => left.toFixed(2) + ' ' + top.toFixed(2))).size, tiles.length)
      for (const x of [0, 400, 1599]) {
        for (const y of [0, 999]) {
          const there = toPlace({ x, y }, view, SIZE)
          if (Math.abs(there.lat) > 85.051) continue
          const over = tiles.filter(({ left, top, side }) => left <= x && x < left + side && top <= y && y < top + side)
          same(over.length, 1)
        }
      }
    }
  }
})

test('Over the date line the columns go on from the last to the first', () => {
  const view = { lat: -16.5, lon: 180, scale: scaleFor(15, { lat: -16.5 }) }, tiles = tilesInView(view, [600, 200], ANY)
  same([...new Set(tiles.map(({ x }) => x))].sort((a, b) => a - b), [0, 1, 32766, 32767])
  const last = tiles.find(({ x }) => x === 32767), first = tiles.find(({ x, y }) => x === 0 && y === last.y)
  assert.ok(Math.abs(last.left + last.side - first.left) < 1e-6)
})

test('Beyond 85.05° there are no tiles, and at a pole nothing breaks', () => {
  for (const lat of [90, -90, 89.9, -86]) {
    const tiles = tilesInView({ lat, lon: 0, scale: 1 }, SIZE, ANY)
    same(tiles.filter(({ y, z }) => y < 0 || y >= 2 ** z), [])
    assert.ok(tiles.every(({ left, top, side }) => Number.isFinite(left + top + side)))
  }
  same(tilesInView({ lat: 86, lon: 0, scale: 1 }, SIZE, ANY), [])
})

test('As sharp as the screen, but no finer than there is, and not too many', () => {
  const here = { lat: 47.4, lon: 8.5 }, zoom = (scale, range, dots) => tilesInView({ ...here, scale }, SIZE, range, dots)[0]?.z
  const scale = scaleFor(15, here)
  same([zoom(scale, ANY), zoom(scale, ANY, 2), zoom(scale, { least: 0, most: 14 }), zoom(40, { least: 0, most: 19 })], [15, 16, 14, 19])
  for (const dots of [1, 2, 3]) {
    for (let scale = .002; scale < 40; scale *= 1.3) {
      const count = tilesInView({ ...here, scale }, [3840, 2160], { least: 0, most: 19 }, dots).length
      assert.ok(count > 0 && count <= MOST_TILES, String(count))
    }
  }
  same(tilesInView({ ...here, scale: .002 }, SIZE, { least: 14, most: 17 }), [])          // too fine for that view
})

test('Distances stay those on the ground', () => {
  for (const lat of [0, 47.4, -78.2, 84.9, 89.9]) {
    const north = distance({ lat: lat + .001, lon: 8 }, { lat, lon: 8 }), east = distance({ lat, lon: 8.001 }, { lat, lon: 8 })
    assert.ok(Math.abs(north / 111.31949 - 1) < .01, lat + ': ' + north)
    assert.ok(Math.abs(east / 111.31949 / Math.cos(lat * Math.PI / 180) - 1) < 1e-6)
    assert.ok(Math.abs(unmercator(mercator(lat)) - lat) < 1e-9)
  }
})

test('Addresses, rows from the north or the south', () => {
  const tile = { z: 3, x: 5, y: 2 }
  same(tileAddress('https://a.b/{z}/{x}/{y}.png?k={z}', tile), 'https://a.b/3/5/2.png?k=3')
  same(tileAddress('https://a.b/{z}/{x}/{-y}.png', tile), 'https://a.b/3/5/5.png')
  same(enclosing(tile, 1).map(({ z, x, y }) => [z, x, y]), [[3, 5, 2], [2, 2, 1], [1, 1, 0]])
})

// A store with a server that answers when we say so
function storeOf() {
  const asked = [], time = { now: 0 }, changes = []
  const load = tile => new Promise((take, fail) => asked.push({ ...tile, take, fail }))
  const store = tileStore(load, () => changes.push(1), () => time.now)
  const settled = () => new Promise(done => setImmediate(done))
  const answer = async (yes, some = asked.splice(0)) => {
    for (const one of some) yes(one) ? one.take({ name: one.z + '/' + one.x + '/' + one.y }) : one.fail(new Error('404'))
    await settled()
    return some.map(({ z, x, y }) => [z, x, y].join('/'))
  }
  return { store, asked, time, changes, answer }
}

test('A few at a time, each once, and what is out of sight is not loaded', async () => {
  const { store, asked, answer, changes } = storeOf()
  const row = Array.from({ length: 20 }, (_, x) => ({ z: 9, x, y: 3 }))
  store.want(row, 0)
  store.want(row, 0)
  same(asked.length, AT_ONCE)
  store.want(row.slice(15), 0)                      // the view has moved on
  const first = await answer(() => true), later = await answer(() => true)
  same([first.length, later], [AT_ONCE, ['9/15/3', '9/16/3', '9/17/3', '9/18/3', '9/19/3']])
  store.want(row.slice(15), 0)
  same([asked.length, changes.length], [0, AT_ONCE + 5])
})

test('A missing tile: the enclosing one is shown, a part of it, and the missing one asked for again after a minute', async () => {
  const { store, time, answer } = storeOf(), tile = { z: 9, x: 5, y: 3 }, ask = () => store.want([tile], 6)
  ask()
  same(await answer(() => false), ['9/5/3'])
  ask()
  same(await answer(() => false), ['8/2/1'])
  ask()
  same(await answer(() => true), ['7/1/0'])
  ask()
  same(await answer(() => true), [])
  const { image, place, part } = store.best(tile, 6)
  same([image.name, place, part], ['7/1/0', [.25, .75], .25])
  time.now = ASK_AGAIN
  ask()
  same(await answer(() => true), ['9/5/3'])
  same([store.best(tile, 6).image.name, store.best({ z: 9, x: 400, y: 3 }, 6)], ['9/5/3', null])
})

test('Where nothing is, it ends with the coarsest zoom, and asks no more', async () => {
  const { store, answer } = storeOf(), all = []
  for (let i = 0; i < 9; i++) {
    store.want([{ z: 9, x: 5, y: 3 }], 7)
    all.push(...await answer(() => false))
  }
  same(all, ['9/5/3', '8/2/1', '7/1/0'])
})

test('What was used long ago is let go', async () => {
  const { store, asked, answer } = storeOf()
  for (let x = 0; x < KEPT + 10; x++) {
    store.want([{ z: 12, x, y: 0 }], 12)
    await answer(() => true)
    store.best({ z: 12, x: 0, y: 0 }, 12)            // this one is in use
  }
  same([store.best({ z: 12, x: 0, y: 0 }, 12).part, store.best({ z: 12, x: 1, y: 0 }, 12)], [1, null])
  store.want([{ z: 12, x: 1, y: 0 }], 12)
  same(asked.length, 1)
})
