// The newest picture and nothing older, words that say how old it is, and the place where you click.
//
// The picture is what a pilot looks at, and the largest part of the panel.
//
// Where in the picture? The picture may have bars beside or above it. A click has a place in the picture, from −1
// to 1, to the right and down. A click on a bar is none.

import { ago, clock, h, latest, name, say, show } from './parts.js'
import { aboutPlace, placeView } from './place.js'
import { liveVideo } from './live.js'

export function inPicture(box, [width, height], x, y) {
  const scale = Math.min(box.width / width, box.height / height)
  const right = 2 * (x - box.left - box.width / 2) / (width * scale)
  const below = 2 * (y - box.top - box.height / 2) / (height * scale)
  return Math.abs(right) <= 1 && Math.abs(below) <= 1 ? { x: right, y: below } : null
}

// Is it live? An old picture looks like a new one, so words say which it is.
export const WORDS = {
  waiting: 'Waiting for a picture', idle: 'No new picture', lost: 'Picture lost', none: 'No live picture',
}
export function condition({ state, age, picture }) {
  if (state !== 'alive') return 'Lost, ' + ago(age)
  if (picture.state === 'running') return picture.fps == null ? 'Live' : 'Live ' + picture.fps.toFixed(0) + '/s'
  return [WORDS[picture.state], picture.why].filter(Boolean).join(': ')
}

// At the other corners stands what is recorded, and what was taken.
export function doing({ recording, here }) {
  const both = [recording != null && 'REC ' + clock(recording), here && 'HERE ' + clock(here.seconds)]
  return both.filter(Boolean).join(' · ')
}

export function taken({ capturing, interval, count }) {
  const now = { interval: 'a picture every ' + interval + ' s', single: 'taking a picture' }[capturing]
  return [now, count != null && count + (count === 1 ? ' picture' : ' pictures')].filter(Boolean).join(' · ')
}

// The picture: A picture comes as a JPEG with a number. It counts as shown when the browser has decoded it, and
// the next is asked for after that. So a slow browser gets fewer pictures, and never old ones. The browser keeps
// what has an address until we let go of it.
//
// While the browser decodes the next picture, it may say that an image is 0 pixels wide, now and then. A click or
// a drag in that moment would have no place. So the last size counts until there is another one.
export function sizeOf(image) {
  if (image.naturalWidth) image.size = [image.naturalWidth, image.naturalHeight]
  return image.size ?? [0, 0]
}

export function frame(row) {
  const image = h('img', { alt: 'Live picture', draggable: 'false', hidden: true })
  let url = null, number = -1
  async function take(picture) {
    const old = url
    url = URL.createObjectURL(picture.blob)
    image.src = url
    show(image, true)
    await image.decode().catch(() => {})
    sizeOf(image)
    number = picture.number
    if (old) URL.revokeObjectURL(old)
  }
  const forget = () => { number = -1 }
  function clear(size) {
    URL.revokeObjectURL(url)
    url = null
    image.removeAttribute('src')
    image.size = size
    show(image, false)
    forget()
  }
  return { image, take, forget, clear, number: () => number }
}

export function pictureUpdate(node, status) {
  const { picture, can_point, why_not } = status
  const how = can_point ? 'Click to point the gimbal, arrow keys turn it' : why_not
  name(node, 'Picture of ' + status.name + '. ' + how)
  node.title = how
  node.toggleAttribute('data-point', can_point)
  node.dataset.picture = status.state === 'alive' ? picture.state : 'lost'
  node.toggleAttribute('data-lost', status.state !== 'alive')
  if (picture.size) node.parentElement?.style.setProperty('--ratio', picture.size[0] / picture.size[1])
}

// Where a click will look: a cross at that place, which stays for a moment after the gimbal has its command, and what
// the panel has worked out beside it. Without a gimbal it says which place that is.
const LINGERS = 2500
export function markView(row) {
  const words = h('span'), node = h('i', { class: 'mark', hidden: true }, words)
  let timer
  function put({ offsetX, offsetY }, width, text) {
    clearTimeout(timer)
    for (const [side, place] of [['left', offsetX], ['top', offsetY]]) node.style.setProperty(side, place + 'px')
    node.toggleAttribute('data-left', offsetX > width / 2)
    say(words, text)
    show(node, true)
  }
  const hide = milliseconds => { timer = setTimeout(show, milliseconds, node, false) }
  async function point(event, width, at) {
    put(event, width, '')
    const answer = await row.act('point', at)
    say(words, answer.ok ? answer.text : '')
    hide(answer.ok ? LINGERS : 0)
  }
  function tell(event, width, text) {
    put(event, width, text)
    hide(LINGERS)
  }
  return { node, point, tell }
}

// The wheel over the picture zooms, a step at a time. In a notebook it does so while the picture has the focus, since
// the wheel scrolls the page there.
export function wheelZoom(row, node) {
  const step = latest(step => row.act('zoom_step', { step }))
  node.addEventListener('wheel', event => {
    const page = node.closest('body > .uav-panel') || document.activeElement === node
    if (!page || !event.deltaY || event.ctrlKey || !row.status.can.includes('HAS_BASIC_ZOOM')) return
    event.preventDefault()
    if (!node.closest('[data-lost]')) step(event.deltaY < 0 ? 1 : -1)
  }, { passive: false })
}

export function pictureView(row, ...upon) {
  const shown = frame(row), mark = markView(row), live = liveVideo(row, shown)
  const place = placeView(row, () => live.on() ? live.age() : null)
  const [words, busy, count] = ['live', 'busy', 'count'].map(which => h('span', { class: 'pill ' + which }))
  const pills = h('div', { class: 'pills' }, words, busy, count, place.node)
  const parts = [shown.image, live.node, ...upon, mark.node, pills]
  const node = h('div', { class: 'picture', tabindex: 0, role: 'application' }, ...parts)
  wheelZoom(row, node)
  const under = ({ clientX, clientY }) =>
    inPicture(node.getBoundingClientRect(), sizeOf(shown.image), clientX, clientY)
  for (const kind of ['pointermove', 'pointerdown']) node.addEventListener(kind, event => place.hover(under(event)))
  node.addEventListener('pointerleave', () => place.hover(null))
  node.addEventListener('click', event => {
    const at = under(event), { width } = node.getBoundingClientRect()
    if (!at || node.closest('[data-lost]')) return
    const there = place.click(at)
    if (row.status.can_point) mark.point(event, width, { ...at, ...which() })
    else if (there) mark.tell(event, width, aboutPlace(there))
  })
  const which = () => live.on() ? { number: null, age: live.age() } : { number: shown.number() }
  async function take(picture) {
    if (live.on()) return
    await shown.take(picture)
    place.take(picture.sight)
  }
  function update(status) {
    pictureUpdate(node, status)
    live.update(status)
    say(words, condition(status))
    say(busy, doing(status))
    say(count, taken(status))
  }
  return { node, update, live, take, forget: shown.forget, number: shown.number }
}
