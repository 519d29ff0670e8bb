// The shutter, zoom and focus, the last picture, and what the camera tells of itself.
//
// A camera tells what it can do in flags, and the panel shows that and no more. It also tells what it does: the
// panel shows what the camera tells, not what you have pressed. So a second tab and another ground station do not
// disagree.
//
// Pictures and videos: Some cameras take no picture in video mode, and no video in photo mode. Flags say which.

import { button, group, h, name, say, show, slider, space, stepper } from './parts.js'

export function mayTake({ can, mode }) { return mode !== 'video' || can.includes('CAN_CAPTURE_IMAGE_IN_VIDEO_MODE') }

export function mayRecord({ can, mode }) {
  return mode == null || mode === 'video' || can.includes('CAN_CAPTURE_VIDEO_IN_IMAGE_MODE')
}

// A camera has one shutter: a large round button that takes a photo in photo mode and starts a video in video mode.
// When the camera can do the other one as well, a small round button beside it does that. While a series runs, the
// shutter stops it. All three lie in places of their own, so nothing moves when one of them is hidden.
export function toggle(row, what, label, stop) {
  let on = false
  const node = button(row, what, label, { glyph: 'record', args: () => ({ on: !on }), about: label })
  node.follow = now => {
    on = now
    node.label(on ? stop : label)
    name(node, on ? stop : label)
    node.setAttribute('aria-pressed', on)
    node.toggleAttribute('data-on', on)
  }
  return node
}

export function leading({ can, mode }) {
  if (!can.includes('CAPTURE_IMAGE')) return 'record'
  return mode === 'video' && can.includes('CAPTURE_VIDEO') ? 'record' : 'photo'
}

export function shutterUpdate({ node, snapshot, stop, record }, status) {
  const { can, capturing, recording } = status, series = capturing === 'interval', first = leading(status)
  node.dataset.leads = first
  show(snapshot, can.includes('CAPTURE_IMAGE') && !series)
  show(stop, series)
  show(record, can.includes('CAPTURE_VIDEO'))
  snapshot.disabled = !mayTake(status)
  record.disabled = recording == null && !mayRecord(status)
  record.follow(recording != null)
}

export function shutterView(row) {
  const snapshot = button(row, 'snapshot', 'Take a photo', { glyph: 'photo', about: 'Take a photo' })
  const stop = button(row, 'stop_capture', 'Stop the series', { glyph: 'stop', about: 'Stop the series' })
  const record = toggle(row, 'record', 'Record a video', 'Stop the video')
  const node = h('div', { class: 'shutter', role: 'group', 'aria-label': 'Shutter' }, snapshot, stop, record)
  const update = status => shutterUpdate({ node, snapshot, stop, record }, status)
  const press = () => (node.dataset.leads === 'record' ? record : stop.hidden ? snapshot : stop).press()
  return { node, update, press, photo: snapshot.press, record: record.press }
}

// A series takes a picture every so many seconds.
export function seriesGroup(row) {
  const every = h('input', { type: 'number', min: .1, step: .1, value: 2, 'aria-label': 'Seconds between pictures' })
  const args = () => ({ seconds: every.valueAsNumber })
  const start = button(row, 'interval', 'Start', { args, about: 'Start a series' })
  const node = sliding('Series', h('label', { class: 'seconds' }, 'every ', every, ' s'), start)
  function update(status) {
    show(node, status.can.includes('CAPTURE_IMAGE'))
    start.disabled = !mayTake(status) || status.capturing === 'interval'
  }
  return { node, update }
}

// The stream that arrives may be recorded here as well, on the disk of the computer that runs the panel.
export function hereGroup(row) {
  const here = toggle(row, 'record_here', 'Record the stream here', 'Stop recording here')
  const file = h('p', { class: 'quiet file' })
  const node = group('This computer', here, file)
  function update(status) {
    here.follow(!!status.here)
    show(node, status.picture.state !== 'none')
    say(file, status.here ? 'to ' + status.here.file : '')
  }
  return { node, update }
}

// Modes, lens, streams.
export const MODES = { image: 'Photo', video: 'Video', image_survey: 'Survey' }

export function modeGroup(row) {
  const presses = Object.entries(MODES).map(([mode, label]) =>
    h('button', { type: 'button', 'data-mode': mode, onclick: () => row.act('mode', { mode }) }, label))
  const node = group('Mode', ...presses)
  node.classList.add('choice')
  function update({ can, modes, mode }) {
    show(node, can.includes('HAS_MODES'))
    for (const press of presses) {
      show(press, modes.includes(press.dataset.mode))
      press.setAttribute('aria-pressed', press.dataset.mode === mode)
    }
  }
  return { node, update }
}

// A slider has its name at its left and what it says at its right.
export function sliding(label, ...inside) {
  const node = group(label, h('span', { class: 'word' }, label), ...inside)
  node.classList.add('sliding')
  return node
}

export function zoomGroup(row) {
  const { input, value, follow } = slider(row, 'zoom', 'Zoom')
  const node = sliding('Zoom', stepper(row, -1, 'Zoom out', '−'), input, stepper(row, 1, 'Zoom in', '+'), value)
  function update({ can, zoom }) {
    show(node, can.includes('HAS_BASIC_ZOOM'))
    follow(zoom)
  }
  return { node, update }
}

export function focusGroup(row) {
  const { input, value, follow } = slider(row, 'focus', 'Focus')
  const node = sliding('Focus', input, button(row, 'autofocus', 'Auto', { about: 'Auto focus' }), value)
  function update({ can, focus }) {
    show(node, can.includes('HAS_BASIC_FOCUS'))
    follow(focus)
  }
  return { node, update }
}

// When there is more than one stream, you choose. The text of a stream comes from the camera.
export function streamChoice(row) {
  const select = h('select', { 'aria-label': 'Stream', onchange: () => row.act('stream', { id: chosen() }) })
  const node = h('label', { class: 'group' }, h('span', { class: 'word' }, 'Stream'), select)
  let streams = []
  const chosen = () => streams[select.selectedIndex].id
  function update({ streams: now, stream }) {
    show(node, now.length > 1)
    if (JSON.stringify(now) !== JSON.stringify(streams)) {
      select.replaceChildren(...now.map(s => h('option', {}, s.text)))
      streams = now
    }
    if (document.activeElement !== select) select.selectedIndex = streams.findIndex(s => s.id === stream)
  }
  return { node, update }
}

// The last picture lies beside the shutter, small, and opens the files. Its place is kept before the first one.
export function lastPicture(row, open) {
  const image = h('img', { alt: '', hidden: true }), number = h('span')
  const node = h('button', { type: 'button', class: 'last', 'data-open': 'files', onclick: open }, image, number)
  let shown = null
  async function draw(key) {
    const src = key < 0 ? null : await row.thumbnail(key).catch(() => null)
    if (image.src) URL.revokeObjectURL(image.src)
    if (src) image.src = src
    else image.removeAttribute('src')
    show(image, !!src)
  }
  function update({ pictures, can }) {
    const last = pictures[pictures.length - 1], now = last && last.n + ' ' + last.key + ' ' + last.name
    show(node, can.includes('CAPTURE_IMAGE'))
    name(node, last ? 'Last picture #' + last.n + ', ' + last.name + ': open the files' : 'Open the files')
    say(number, last ? '#' + last.n : '')
    if (now === shown) return
    shown = now
    draw(last ? last.key : -1)
  }
  return { node, update }
}

// What it tells of itself.
export function facts({ info, vendor, model, storage, battery }) {
  const all = { vendor, model, ...info, storage: storage?.text, battery: battery == null ? null : battery + ' %' }
  return Object.entries(all).filter(([, text]) => text)
}

export function about(row) {
  const table = h('table'), said = h('ul', { class: 'notices', 'aria-label': 'Messages of the camera' })
  const node = h('div', { class: 'about' }, table, said)
  let told
  function update(status) {
    const rows = facts(status), notices = status.notices.map(n => n.at + ' ' + n.severity + ': ' + n.text)
    if (JSON.stringify([rows, notices]) === told) return
    told = JSON.stringify([rows, notices])
    const line = ([what, text]) => h('tr', {}, h('th', { scope: 'row' }, what), h('td', {}, text))
    table.replaceChildren(...rows.map(line))
    said.replaceChildren(...notices.map(text => h('li', {}, text)))
  }
  return { node, update }
}

// Beside the name stand the free space, the link and the batteries. A camera without a card says so: its total is 0.
export function room({ storage, battery, link }, vehicle) {
  const card = storage?.total ? space(storage.free) + ' free' : storage?.text
  const percent = (what, number) => number != null && what + ' ' + number.toFixed(0) + ' %'
  const all = [card, percent('link', link), percent('camera battery', battery), percent('battery', vehicle?.battery)]
  return all.filter(Boolean).join(' · ')
}
