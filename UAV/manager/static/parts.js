// Small functions in JavaScript that the whole panel uses: elements, words, buttons, sliders, and what is held
// down.
//
// The view of the panel is one script, for a page in a browser and for a notebook alike.
//
// Nothing is fetched from elsewhere, because a field has no network. There is no framework: the panel has some
// forty elements a camera, and they stay the same while their words change.
//
// Elements: A name or a text that comes from the air may be anything, `<script>` too. So text becomes a text node,
// and never HTML. This function makes each element of the panel, and no text is ever read as HTML.

export function h(tag, given = {}, ...inside) {
  const node = document.createElement(tag)
  for (const [name, value] of Object.entries(given)) {
    if (name.startsWith('on')) node.addEventListener(name.slice(2), value)
    else if (value === true) node.setAttribute(name, '')
    else if (value !== false && value != null) node.setAttribute(name, value)
  }
  node.append(...inside)
  return node
}

// A screen reader speaks what changes. So we write only what is new.
export function say(node, text) { if (node.textContent !== text) node.textContent = text }

export function show(node, yes) { node.hidden = !yes }
export function name(node, text) { if (node.getAttribute('aria-label') !== text) node.setAttribute('aria-label', text) }

export function group(label, ...inside) {
  return h('div', { class: 'group', role: 'group', 'aria-label': label }, ...inside)
}

// A drawing of a few lines stands beside some words. It is drawn here, because a font may lack such signs.
export const ICONS = {
  photo: 'M2 5h3l1.5-2h3L11 5h3v8H2zM8 11.500a2.500 2.500 0 1 0 0-5a2.500 2.500 0 0 0 0 5z',
  record: 'M8 12.500a4.500 4.500 0 1 0 0-9a4.500 4.500 0 0 0 0 9z', stop: 'M4 4h8v8H4z',
  series: 'M2 6h8v7H2zM5 6V3h9v7h-4',
  centre: 'M8 1v4M8 11v4M1 8h4M11 8h4M8 9.500a1.500 1.500 0 1 0 0-3a1.500 1.500 0 0 0 0 3z',
  track: 'M2 5V2h3M11 2h3v3M14 11v3h-3M5 14H2v-3M8 6.500a1.500 1.500 0 1 0 0 3a1.500 1.500 0 0 0 0-3z',
  map: 'M2 4l4-2 4 2 4-2v10l-4 2-4-2-4 2zM6 2v10M10 4v10', files: 'M2 3h5l1.500 2H14v8H2z',
  camera: 'M2 4h6M12 4h2M2 8h2M8 8h6M2 12h7M13 12h1M10 2.500v3M6 6.500v3M11 10.500v3',
  settings: 'M8 10.200a2.200 2.200 0 1 0 0-4.400a2.200 2.200 0 0 0 0 4.400zM8 1.500v2.300' +
    'M8 12.200v2.300M1.500 8h2.300M12.200 8h2.300M3.400 3.400l1.600 1.600M11 11l1.600 1.600' +
    'M3.400 12.600l1.600-1.600M11 5l1.600-1.600',
  info: 'M8 14.500a6.500 6.500 0 1 0 0-13a6.500 6.500 0 0 0 0 13zM8 7v4.500M8 4.500v.5',
  close: 'M3.500 3.500l9 9M12.500 3.500l-9 9',
  log: 'M2 3.500h12M2 8h12M2 12.500h8', keys: 'M1.500 4h13v8.500h-13zM4 6.800h.5M7 6.800h.5M10 6.800h.5M4.500 10h7',
  down: 'M8 2v9M4 7.500L8 11.500l4-4M3 14h10', retract: 'M8 14V6M4.500 9L8 5.500 11.500 9M3 2.500h10',
}

export function icon(which) {
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg')
  const path = document.createElementNS('http://www.w3.org/2000/svg', 'path')
  svg.setAttribute('viewBox', '0 0 16 16')
  svg.setAttribute('aria-hidden', 'true')
  path.setAttribute('d', ICONS[which])
  svg.append(path)
  return svg
}

export function closeButton(press) {
  return h('button', { type: 'button', class: 'close', 'aria-label': 'Close', onclick: press }, icon('close'))
}

// Words for numbers.
export function clock(seconds) {
  const two = n => String(Math.floor(n)).padStart(2, '0')
  return [seconds / 3600, seconds / 60 % 60, seconds % 60].map(two).join(':')
}

// An angle has a real minus, and a dash where it is not known.
export function degrees(angle) { return angle == null ? '–' : angle.toFixed(1).replace('-', '−') + '°' }
export function space(mib) { return mib < 1024 ? mib.toFixed(0) + ' MiB' : (mib / 1024).toFixed(1) + ' GiB' }
export function ago(seconds) { return seconds < 100 ? seconds.toFixed(0) + ' s' : (seconds / 60).toFixed(0) + ' min' }

// Buttons: A button has the state of its command. The status tells it, and the button knows its own press a moment
// earlier. So a state is painted only when the status tells a new one. What was done before the page was opened
// does not flash.
export function paint(node, state = 'READY') {
  if (state === node.told) return
  const first = node.told === undefined
  node.told = state
  node.dataset.state = first && state === 'DONE' ? 'READY' : state
}

export function paintAll(within, states) {
  for (const press of within.querySelectorAll('button[data-state]')) paint(press, states[press.dataset.do])
}

// A press runs an action of its row. `row.act` always gives an answer. A key may press a button too, but not one
// that is hidden or disabled.
export function button(row, what, label, { args = () => ({}), glyph, about } = {}) {
  const text = h('span', {}, label)
  const named = about?.toLowerCase().includes(label.toLowerCase()) ? about : null     // who says the word finds it
  const given = { type: 'button', 'data-do': what, 'data-state': 'READY', title: about, 'aria-label': named }
  const node = h('button', given, ...(glyph ? [icon(glyph)] : []), text)
  node.label = words => say(text, words)
  node.press = async () => {
    if (node.matches(':disabled, [hidden], [hidden] *')) return
    node.dataset.state = 'RUNNING'
    const answer = await row.act(what, args())
    node.dataset.state = answer.ok ? 'DONE' : 'FAILED'
  }
  pressedBy(node, node.press)
  return node
}

// A browser makes a click of the first finger only. So while one finger holds the pad, another one presses a button
// when it is lifted from it.
export function pressedBy(node, press) {
  let lifted = -1e9
  node.addEventListener('pointerup', event => {
    if (event.pointerType !== 'touch' || event.isPrimary) return
    if (!node.contains(document.elementFromPoint(event.clientX, event.clientY))) return
    lifted = event.timeStamp
    press()
  })
  node.addEventListener('click', event => { if (!(event.timeStamp - lifted < 500)) press() })
}

// Sliders: You drag a slider from 10 to 90, and the page hears of it eighty times. A zoom lens takes a second for
// one. So one question is under way at a time, and after it only the newest is asked.
export function latest(send) {
  let next, busy = false
  return async value => {
    next = { value }
    if (busy) return
    busy = true
    while (next) {
      const { value } = next
      next = null
      await send(value)
    }
    busy = false
  }
}

// A slider shows what the camera tells. While you move it, and for one and a half seconds after, it stays where
// you put it, because the camera still tells of where it was. Then it goes back to what the camera tells: a lens
// that cannot go there must not seem to.
export const UNTOUCHED = 1500
export function following(put) {
  let reported = null, touched = null
  const back = () => {
    touched = null
    put(reported)
  }
  const touch = () => {
    clearTimeout(touched)
    touched = setTimeout(back, UNTOUCHED)
  }
  const follow = value => {
    reported = value
    if (!touched) back()
  }
  return { touch, follow }
}

export function slider(row, what, label) {
  const input = h('input', { type: 'range', min: 0, max: 100, step: 1, 'data-do': what, 'aria-label': label })
  const value = h('output'), send = latest(percent => row.act(what, { percent }))
  const tell = percent => {
    say(value, percent == null ? '–' : Math.round(percent) + ' %')
    input.setAttribute('aria-valuetext', value.textContent)
  }
  const { touch, follow } = following(percent => {
    if (percent != null) input.value = percent
    tell(percent)
  })
  input.addEventListener('input', async () => {
    touch()
    tell(input.valueAsNumber)
    await send(input.valueAsNumber)
    touch()
  })
  return { input, value, follow }
}

// What is held down: A gimbal turns while you hold a key, and must stop when you let go. But the letting go may
// never be seen: the window loses the focus, the tab is hidden, the computer sleeps. So it is the other way round.
// While you hold, the page says so every 150 ms, with a number that grows. The panel stops by itself when it has
// not heard it for 0.45 s.
//
// When two such messages have no answer yet, no third is sent: on a slow link they would arrive late and all at
// once. And a refusal ends it: when another client has the gimbal, you hear it once.
export const REFRESH = 150
export function holding(send, release, refused = () => {}) {
  const hold = Math.random().toString(36).slice(2)
  let n = 0, waiting = 0, args = null, timer = null
  async function refresh() {
    if (waiting > 1) return
    waiting += 1
    n += 1
    const answer = await send({ ...args, hold, n })
    waiting -= 1
    if (!answer.ok && timer) refused(answer.text, end())
  }
  function aim(now) {
    if (args && !timer) return
    args = now
    if (timer) return
    timer = setInterval(refresh, REFRESH)
    refresh()
  }
  function end() {
    if (!timer) return
    clearInterval(timer)
    timer = null
    release({ hold })
  }
  return { aim, end }
}

// The buttons beside the zoom know both: a tap is one step, and a press of 0.3 s zooms until you let go. The
// keyboard makes steps.
export const TAP = 300
export function stepper(row, direction, label, glyph) {
  const node = h('button', { type: 'button', class: 'step', 'data-do': 'zoom_step', 'aria-label': label }, glyph)
  const step = () => row.act('zoom_step', { step: direction })
  let timer = null, live = null
  const start = () => {
    live = row.hold('zoom_hold', 'zoom_release')
    live.aim({ direction })
  }
  const stop = () => {
    clearTimeout(timer)
    live?.end()
    timer = live = null
  }
  node.addEventListener('pointerdown', event => {
    if (event.button) return
    stop()
    node.setPointerCapture(event.pointerId)
    timer = setTimeout(start, TAP)
  })
  node.addEventListener('pointerup', () => { if (timer && !live) step(); stop() })
  for (const kind of ['pointercancel', 'lostpointercapture', 'blur']) node.addEventListener(kind, stop)
  node.addEventListener('contextmenu', event => event.preventDefault())
  node.addEventListener('click', event => { if (!event.detail) step() })
  return node
}

// Twice, to be sure: What cannot be taken back is pressed twice within three seconds. The first press says what
// the second one does.
export function confirmed(label, again, press) {
  const node = h('button', { type: 'button', class: 'confirmed' }, label)
  let timer = null
  const calm = () => {
    clearTimeout(timer)
    timer = null
    say(node, label)
  }
  node.addEventListener('click', () => {
    if (timer) return press(calm())
    say(node, again)
    timer = setTimeout(calm, 3000)
  })
  return node
}

// The browser keeps a picture that has an address, until we let it go.
export function letPicturesGo(node) { for (const image of node.querySelectorAll('img')) URL.revokeObjectURL(image.src) }
