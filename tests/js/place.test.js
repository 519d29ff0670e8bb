import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import test from 'node:test'
import { distance } from '../../UAV/manager/static/map.js'
import { aboutPlace, whereIs } from '../../UAV/manager/static/place.js'
import { same } from './panel.js'

// Written and checked by nbs/api/manager/05_map.ipynb: sight, x, y, and latitude, longitude, error and distance
const CASES = JSON.parse(readFileSync(new URL('places.json', import.meta.url), 'utf8'))

test('The place of a pixel is the one that Python finds', () => {
  let sky = 0
  for (const [sight, x, y, expected] of CASES) {
    const found = whereIs(sight, x, y)
    if (!expected) sky += 1
    same([found === null, sight, x, y], [expected === null, sight, x, y])
    if (!expected) continue
    const [lat, lon, error, away] = expected, off = distance(found, { lat, lon })
    assert.ok(off < .1 + away * 1e-4, JSON.stringify([sight, x, y]) + ' is off by ' + off)
    assert.ok(Math.abs(found.error / error - 1) < 1e-4 && Math.abs(found.distance / away - 1) < 1e-4)
  }
  assert.ok(sky > 2 && sky < CASES.length / 2, String(sky))
})

test('Straight down it is the place below, and a wrong number gives none', () => {
  const down = [47.4, 8.5, 30, Math.SQRT1_2, 0, -Math.SQRT1_2, 0, 60, 40, 3, 2, 2]
  const { lat, lon, distance: away, error } = whereIs(down, 0, 0)
  assert.ok(Math.abs(lat - 47.4) < 1e-9 && Math.abs(lon - 8.5) < 1e-9 && Math.abs(away - 30) < 1e-9)
  assert.ok(Math.abs(error - Math.hypot(3, Math.SQRT2 * 30 * Math.PI / 90)) < 1e-9)
  for (const at of [2, 3, 7, 9]) same(whereIs(down.map((n, i) => i === at ? NaN : n), .5, .5), null)
  same([whereIs(null, 0, 0), whereIs(undefined, 0, 0), whereIs([], 0, 0)], [null, null, null])
})

test('In words', () => {
  const place = { lat: 47.3977123, lon: 8.5456, error: 2.6, distance: 84.7 }
  same([aboutPlace(place), aboutPlace({ ...place, error: .44 }), aboutPlace(null)],
    ['47.397712, 8.545600 ±3 m · 85 m away', '47.397712, 8.545600 ±0.4 m · 85 m away', ''])
})
