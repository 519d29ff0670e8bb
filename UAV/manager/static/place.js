// The place on the ground below the pointer, in the picture.
//
// With each picture comes where it was taken from and how the camera was held: by the video itself (KLV), or by gimbal
// and vehicle. So the words follow the pointer at once, however slow the radio is, and belong to the picture shown.

import { h, say } from './parts.js'
import { metresText, placeText, unproject } from './map.js'

// The ground is flat. Above the horizon is no place, and none where it could be anywhere: when its error is as large as
// its distance. `x` and `y` run from −1 to 1, to the right and down.
export const EARTH_RADIUS = 6371e3
export function whereIs(sight, x, y) {
  if (!sight) return null
  const [lat, lon, height, w, i, j, k, hfov, vfov, position, high, attitude] = sight
  const right = x * Math.tan(hfov * Math.PI / 360), low = y * Math.tan(vfov * Math.PI / 360)
  const north = 1 - 2 * (j * j + k * k) + 2 * (i * j - w * k) * right + 2 * (i * k + w * j) * low
  const east = 2 * (i * j + w * k) + (1 - 2 * (i * i + k * k)) * right + 2 * (j * k - w * i) * low
  const down = 2 * (i * k - w * j) + 2 * (j * k + w * i) * right + (1 - 2 * (i * i + j * j)) * low
  const level = Math.hypot(north, east) * height / down, horizon = Math.sqrt(2 * EARTH_RADIUS * height)
  if (!(down > 0 && height > 0 && level <= horizon)) return null
  const away = Math.hypot(level, height), turn = attitude * Math.PI / 180
  const error = Math.hypot(turn * away ** 2 / height, turn * away, high * level / height, position)
  if (!(error < away)) return null
  const there = unproject({ x: east * height / down, y: north * height / down }, { lat, lon })
  return { ...there, error, distance: away }
}

export function aboutPlace(place) {
  if (!place) return ''
  return placeText(place, 6) + ' ±' + metresText(place.error) + ' · ' + metresText(place.distance) + ' away'
}

// Below the pointer, and the place of the last click while no pointer is there. The map shows the latter, too.
//
// A video by WebRTC has no numbers with its pictures. So while the pointer is over one, they are asked for a few times
// a second, for the picture that is `age` seconds old; `age` is null where JPEGs are shown.
export const SIGHT_EVERY = 300
export function placeView(row, age = () => null) {
  const node = h('span', { class: 'pill where' })
  let sight = null, over = null, timer = null, asking = false
  function update() {
    const here = over && aboutPlace(whereIs(sight, over.x, over.y))
    say(node, here ?? (row.spot ? 'Clicked ' + aboutPlace(row.spot) : ''))
  }
  const take = now => update(sight = now ?? null)
  async function ask() {
    if (asking || age() == null || !row.wire.sight) return
    asking = true
    const now = await row.wire.sight(row.of, age()).catch(() => null)
    asking = false
    if (age() != null) take(now)
  }
  function hover(at) {
    over = at
    if (!at) clearInterval(timer)
    if (!at) timer = null
    else timer ??= setInterval(ask, SIGHT_EVERY, ask())
    update()
  }
  function click({ x, y }) {
    row.spot = whereIs(sight, x, y)
    update()
    return row.spot
  }
  return { node, take, hover, click }
}
