// A camera with its gimbal is a card: its picture, and its controls over it.
//
// Cameras come, are lost, come back, and others join them. The card of a camera stays the same while its words
// change, so no button moves away under your finger.
//
// Rows: The parts ask a row: `act` presses a button and always gives an answer, `hold` holds something down. What
// failed stands over the picture for eight seconds, and the log keeps it.

import { ago, closeButton, h, icon, letPicturesGo, name, paintAll, say, show } from './parts.js'
import { gimbalView } from './gimbal.js'
import { pictureView } from './picture.js'
import { instruments } from './instruments.js'
import { settingsView } from './settings.js'
import { filesView } from './files.js'
import { mapView } from './map.js'
import { targetView } from './target.js'
import {
  about, focusGroup, hereGroup, lastPicture, modeGroup, room, seriesGroup, shutterView, streamChoice, zoomGroup
} from './camera.js'

export function noteOf() {
  const note = h('p', { class: 'note', role: 'status' })
  let timer
  const tell = text => {
    clearTimeout(timer)
    timer = setTimeout(say, 8000, note, '')
    say(note, text)
  }
  return { note, tell }
}

export function rowOf(panel, of) {
  const { note, tell } = noteOf(), ask = what => args => panel.act(what, of, args)
  async function act(what, args = {}) {
    const answer = await panel.act(what, of, args)
    if (!answer.ok) tell(answer.text || 'refused')
    return answer
  }
  const hold = (what, ended) => panel.hold(ask(what), ask(ended), tell)
  return { of, note, tell, act, hold, thumbnail: key => panel.wire.thumbnail(of, key), wire: panel.wire }
}

// A camera: What is lost says since when.
export function whereabouts(of, { state, age }) { return state === 'alive' ? of : 'lost, ' + ago(age) }

export function heading(of, ...more) {
  const places = [h('h2'), h('span', { class: 'state' }), h('p', { class: 'quiet' })]
  function update(status, vehicle) {
    const all = [status.name, whereabouts(of, status), room(status, vehicle)]
    for (const [i, words] of all.entries()) say(places[i], words)
  }
  return { node: h('header', {}, ...places, ...more), update }
}

export function card(of, head, ...inside) {
  const node = h('article', { class: 'card', 'data-id': of }, head.node, ...inside)
  function update(status, vehicle) {
    node.dataset.state = status.state
    name(node, status.name)
    head.update(status, vehicle)
  }
  return { node, update }
}

// The drawer: What a flight rarely needs lies in a drawer at the side, one thing at a time. The picture makes room for
// it, so that you see what a setting does.
export function rail(parts, toggle) {
  const press = which => ({ onclick: () => toggle(which), 'aria-expanded': 'false', 'data-open': which })
  const make = ({ which, label }) => h('button', { type: 'button', ...press(which) }, icon(which), h('span', {}, label))
  const presses = new Map(parts.map(part => [part.which, make(part)]))
  const node = h('div', { class: 'rail', role: 'toolbar', 'aria-label': 'More' }, ...presses.values())
  const tell = open => { for (const [which, press] of presses) press.setAttribute('aria-expanded', which === open) }
  return { node, tell, press: which => presses.get(which) }
}

export function drawersOf(parts) {
  const title = h('h3'), place = h('fieldset', { class: 'inside' })
  const close = closeButton(() => toggle(open))
  const node = h('aside', { class: 'drawer', hidden: true }, h('header', {}, title, close), place)
  const side = rail(parts, which => toggle(which)), part = which => parts.find(one => one.which === which)
  let open = null
  function toggle(which) {
    const old = open
    part(open)?.view.stop?.()
    open = which === open ? null : which
    say(title, part(open)?.label ?? '')
    name(node, title.textContent)
    place.replaceChildren(...(open ? [part(open).view.node] : []))
    node.parentElement?.toggleAttribute('data-drawer', !!open)
    side.tell(open, show(node, !!open))
    part(open)?.view.open?.()
    if (old && !open) side.press(old).focus({ preventScroll: true })
  }
  function update(status, vehicle) {
    const all = { ...status, vehicles: vehicle ? [vehicle] : [] }
    for (const { which, view, able } of parts) show(side.press(which), !able || able(status), view.update(all))
    if (open && side.press(open).hidden) toggle(open)
    place.disabled = status.state !== 'alive'
    paintAll(place, status.buttons)
  }
  const may = which => part(which) && !side.press(which).hidden
  const toggleIf = which => { if (may(which)) toggle(which) }
  return { node, rail: side.node, update, toggle: toggleIf, close: () => toggleIf(open) }
}

// Focus, stream, a series and the recording on this computer are one drawer.
export function shootingView(row) {
  const parts = [focusGroup, seriesGroup, streamChoice, hereGroup].map(make => make(row))
  const node = h('div', { class: 'shooting' }, ...parts.map(part => part.node))
  return { node, update: status => { for (const part of parts) part.update(status) } }
}

export function mapDrawer(row) {
  const map = mapView(row), { node, update } = map
  return { node, update, open: () => map.open(true), stop: () => map.open(false) }
}

export function cameraDrawers(row) {
  const images = ({ can }) => !!row.wire.files && can.includes('CAPTURE_IMAGE')
  return drawersOf([
    { which: 'map', label: 'Map', view: mapDrawer(row), able: () => !!row.wire.map },
    { which: 'files', label: 'Files', view: filesView(row), able: images },
    { which: 'camera', label: 'Camera', view: shootingView(row) },
    { which: 'settings', label: 'Settings', view: settingsView(row), able: status => status.has_settings },
    { which: 'info', label: 'Info', view: about(row) },
  ])
}

// Over the picture: the shutter with the last picture and the mode at the right, the zoom above it.
export function cameraViews(row, picture, openFiles) {
  const shutter = shutterView(row), target = targetView(row, picture)
  const shots = [lastPicture(row, openFiles), shutter, modeGroup(row)], looks = [target, zoomGroup(row)]
  const place = (kind, about, parts) => h('fieldset', { class: kind, 'aria-label': about }, ...parts.map(p => p.node))
  const nodes = [place('looks', 'Target and zoom', looks), place('shots', 'Shutter', shots)]
  function update(status) {
    for (const part of [...looks, ...shots]) part.update(status)
    for (const node of nodes) {
      node.disabled = status.state !== 'alive'
      paintAll(node, status.buttons)
    }
  }
  return { nodes, update, shutter, target }
}

// The gimbal of a camera may come later, go, or be another one.
export function nowTurning(view) {
  return { turn: rates => view()?.turning.turn(rates), stop: () => view()?.turning.stop() }
}

export function gimbalOf(panel, camera, place) {
  const zoom = () => camera.status.zoom
  let view = null, of = null
  function put(gimbal) {
    view?.turning.stop()
    of = gimbal?.id
    const row = rowOf(panel, of)
    view = gimbal ? gimbalView(row, zoom) : null
    place.replaceChildren(...(view ? [view.node, row.note] : []))
  }
  function update(gimbal) {
    if (gimbal?.id !== of) put(gimbal)
    view?.update(gimbal)
  }
  return { update, turning: nowTurning(() => view), there: () => !!view }
}

// One camera fills the window, and the others are small pictures in it. A click on a small one swaps them. Only the
// large one has controls.
export function swapButton(panel, of) {
  return h('button', { type: 'button', class: 'swap', onclick: () => panel.choose(of) })
}

// What a gamepad and the keys of the page use of a camera.
export function handsOf(row, gimbal, views, drawers) {
  const press = what => row.card.querySelector('button[data-do="' + what + '"]')?.press?.()
  return {
    row, press, shutter: views.shutter.press, record: views.shutter.record, zoom: () => row.status?.zoom,
    get turning() { return gimbal.there() ? gimbal.turning : null },
    toggle: drawers.toggle, close: drawers.close, track: views.target.toggle,
    escape: () => { views.target.begin(false); drawers.close() },
  }
}

export function cameraCard(panel, of) {
  const row = rowOf(panel, of), gauges = instruments(), picture = pictureView(row, gauges.node)
  const drawers = cameraDrawers(row), views = cameraViews(row, picture.node, () => drawers.toggle('files'))
  const turned = h('div', { class: 'turned' }), gimbal = gimbalOf(panel, row, turned)
  const swap = swapButton(panel, of), parts = [turned, ...views.nodes, row.note, swap]
  const all = card(of, heading(of), picture.node, drawers.rail, ...parts, drawers.node)
  const hands = handsOf(row, gimbal, views, drawers)
  row.card = all.node
  function update(status, turns, vehicle) {
    row.status = status
    for (const part of [all, picture, views, drawers]) part.update(status, vehicle)
    gimbal.update(turns)
    gauges.update(turns ?? {})
    name(swap, 'Show ' + status.name)
  }
  function lead(main) {
    picture.node.inert = !main
    picture.live.lead(main)
    if (main) return
    gimbal.turning.stop()
    hands.escape()
  }
  return { node: all.node, update, picture, lead, hands }
}

// A gimbal without a camera.
export function gimbalCard(panel, of) {
  const row = rowOf(panel, of), view = gimbalView(row), swap = swapButton(panel, of)
  const all = card(of, heading(of), h('div', { class: 'turned' }, view.node), row.note, swap)
  all.node.classList.add('alone')
  function update(status, turns, vehicle) {
    for (const part of [all, view]) part.update(status, vehicle)
    name(swap, 'Show ' + status.name)
  }
  const press = what => view.node.querySelector('button[data-do="' + what + '"]')?.press()
  const none = () => {}, others = { shutter: none, record: none, toggle: none, close: none, track: none, escape: none }
  const hands = { row, press, zoom: () => null, turning: view.turning, ...others }
  return { node: all.node, update, hands, lead: main => { if (!main) view.turning.stop() } }
}

// All cards: A card far out of sight, on a phone for example, asks for no pictures.
export function inSight() {
  const hidden = new Set()
  const watch = new IntersectionObserver(changes => {
    for (const { target, isIntersecting } of changes) hidden[isIntersecting ? 'delete' : 'add'](target)
  }, { rootMargin: '50%' })
  return { watch, seen: node => !hidden.has(node), forget: node => hidden.delete(node, watch.unobserve(node)) }
}

export function cardsShown(panel, place) {
  const cards = new Map(), { watch, seen, forget } = inSight()
  function card(id, make) {
    if (cards.has(id)) return cards.get(id)
    const made = make(panel, id)
    cards.set(id, made)
    place.append(made.node)
    watch.observe(made.node)
    return made
  }
  function keep(ids) {
    for (const [id, { node, picture }] of cards) {
      if (ids.has(id)) continue
      picture?.live.stop()
      for (const part of [forget, letPicturesGo]) part(node)
      node.remove()
      cards.delete(id)
    }
  }
  const pictures = () => [...cards].filter(([, { node, picture }]) => picture && seen(node))
  function stop() {
    watch.disconnect()
    for (const { picture } of cards.values()) picture?.live.stop()
  }
  return { cards, card, keep, pictures, stop }
}

export function picturesOf(cards, pictures) {
  const still = () => pictures().filter(([, { picture }]) => !picture.live.on())
  const after = () => Object.fromEntries(still().map(([id, { picture }]) => [id, picture.number()]))
  const take = shown => Promise.all(Object.entries(shown).map(([id, one]) => cards.get(id)?.picture?.take(one)))
  const forget = () => { for (const { picture } of cards.values()) picture?.forget() }
  return { after, take, forget }
}

// Nothing there yet: which links the panel listens on, what came there, and how to start a simulated camera.
export function firstRun() {
  const list = h('ul'), node = h('div', { class: 'empty' }, h('h2', {}, 'No camera yet'), list,
    h('p', {}, 'A camera appears here with its first heartbeat. To try the panel without one, simulate a vehicle:'),
    h('p', {}, h('code', {}, 'uav-camera-server --gimbal sim --autopilot')))
  function update(links = []) {
    const words = links.map(({ name, heard }) => name + ': ' + (heard.join(', ') || 'nothing received yet'))
    if (JSON.stringify(words) === list.told) return
    list.told = JSON.stringify(words)
    list.replaceChildren(...words.map(text => h('li', {}, text)))
  }
  return { node, update }
}

// Which one is large: the one that you chose while it is there, else the first.
export function cardsView(panel) {
  const empty = firstRun(), node = h('div', { class: 'cards' }, empty.node)
  const { cards, card, keep, pictures, stop } = cardsShown(panel, node)
  let chosen = null
  const main = () => cards.has(chosen) ? chosen : cards.keys().next().value
  function lead() {
    for (const [id, one] of cards) {
      const large = id === main()
      if (one.node.hasAttribute('data-main') === large && one.led) continue
      one.led = true
      one.node.toggleAttribute('data-main', large)
      one.lead(large)
    }
  }
  function choose(id) {
    chosen = id
    lead()
    cards.get(id)?.picture?.node.focus({ preventScroll: true })
  }
  function next(by) {
    const ids = [...cards.keys()]
    if (ids.length > 1) choose(ids[(ids.indexOf(main()) + by + ids.length) % ids.length])
  }
  function update({ cameras, gimbals, vehicles = [], links }) {
    const turned = new Set(cameras.map(camera => camera.gimbal)), alone = gimbals.filter(one => !turned.has(one.id))
    const of = camera => gimbals.find(one => one.id === camera.gimbal)
    const vehicle = ({ id }) => vehicles.find(one => one.system === Number(id.split('/')[0]))
    keep(new Set([...cameras, ...alone].map(row => row.id)))
    for (const camera of cameras) card(camera.id, cameraCard).update(camera, of(camera), vehicle(camera))
    for (const gimbal of alone) card(gimbal.id, gimbalCard).update(gimbal, null, vehicle(gimbal))
    node.dataset.count = cards.size
    lead(show(empty.node, !cards.size))
    empty.update(links)
  }
  const nth = n => { if (n < cards.size) choose([...cards.keys()][n]) }
  const hands = () => cards.get(main())?.hands
  return { node, update, stop, choose, next, nth, hands, ...picturesOf(cards, pictures) }
}
