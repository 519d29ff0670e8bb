// Each setting of a camera as a slider, a list, a switch or a number, as the camera declares it.
//
// The panel knows no setting by itself: it draws what the camera declares. A value that another ground station
// changes moves here as well. A setting that may not be set now is dim, and says why in words. Each line has room
// for those words from the beginning, so nothing moves when they come.
//
// Fields: Numbers come as text, so that none is rounded on its way. While you move a slider it does not follow the
// camera.

import { confirmed, following, h, latest, say, show } from './parts.js'

export function reading(number, unit) { return (Number(number.toPrecision(4)) + ' ' + unit).trim() }

export function rangeField(set, { low, high, step, unit }) {
  const input = h('input', { type: 'range', min: low, max: high, step: step ?? 'any' }), output = h('output')
  const send = latest(set), tell = number => {
    say(output, reading(number, unit))
    input.setAttribute('aria-valuetext', output.textContent)
  }
  const { touch, follow } = following(number => {
    if (number == null) return
    input.value = number
    tell(Number(number))
  })
  input.addEventListener('input', async () => {
    touch()
    tell(input.valueAsNumber)
    await send(input.valueAsNumber)
    touch()
  })
  return { input, output, update: ({ value }) => follow(value) }
}

// A choice is drawn anew only when its options change, so an open list stays open. What you chose stays until the
// camera says something else, or refuses it.
export function choiceField(set) {
  const input = h('select', { onchange: choose })
  let drawn = '', told = null
  async function choose() {
    const answer = await set(input.value)
    if (!answer.ok) input.value = told
  }
  function update({ options, value }) {
    if (JSON.stringify(options) !== drawn) input.replaceChildren(...options.map(name => h('option', {}, name)))
    if (JSON.stringify(options) !== drawn || value !== told) input.value = value
    drawn = JSON.stringify(options)
    told = value
  }
  return { input, update }
}

// Three more: a number without limits, a switch, and a text that you can only read.
export function numberField(set, { unit }) {
  const input = h('input', { type: 'number', step: 'any', onchange: () => set(input.valueAsNumber) })
  const output = unit ? h('span', { class: 'unit' }, unit) : null
  return { input, output, update: ({ value }) => { if (document.activeElement !== input) input.value = value } }
}

export function switchField(set) {
  const input = h('input', { type: 'checkbox', role: 'switch', onchange: () => set(input.checked) })
  return { input, update: ({ value }) => { input.checked = Number(value) } }
}

export function textField() {
  const input = h('output')
  return { input, update: ({ value }) => say(input, value) }
}

// A line is a label with the reason why the field is dim below it, and the field at its right. Labels and fields
// find each other by numbers, since names come from the air.
export const FIELDS = {
  range: rangeField, choice: choiceField, number: numberField, switch: switchField, text: textField,
}

export function dim(node, input, reason, why) {
  input.disabled = !!why
  node.toggleAttribute('data-why', !!why)
  say(reason, why || '')
}

export const nextId = (n => () => 'uav-setting-' + (n += 1))(0)

export function settingRow(row, given) {
  const set = value => row.act('set', { name: given.name, value }), field = FIELDS[given.field](set, given)
  const id = nextId(), label = h('label', { class: 'word', for: id }, given.label)
  const reason = h('small', { class: 'reason', id: id + '-why' })
  for (const [what, text] of [['id', id], ['aria-describedby', reason.id]]) field.input.setAttribute(what, text)
  const value = h('div', { class: 'value' }, field.input, ...(field.output ? [field.output] : []))
  const node = h('div', { class: 'setting', 'data-name': given.name, 'data-field': given.field }, label, reason, value)
  function update(now) {
    field.update(now)
    dim(node, field.input, reason, now.why)
  }
  return { node, update, label: given.label }
}

// Sections: Settings that depend on each other stand together, as the camera declares them. A heading is found by the
// words of their labels; what has none comes last.
export const HEADINGS = [
  ['Exposure', /exposure|\biso\b|shutter|aperture|\biris\b|\bgain\b|\bev\b|metering/i],
  ['Colour', /white balance|colou?r|saturation|\bhue\b|palette|\btint\b/i],
  ['Focus and zoom', /focus|zoom/i], ['Thermal', /thermal|temperature|emissivity|isotherm/i],
  ['Video', /video|bit ?rate|frame rate|\bfps\b|codec|encod|stream/i],
  ['Photo', /photo|jpe?g|picture|image|sharpness|contrast|brightness/i],
]

export function headingOf(label) { return HEADINGS.find(([, words]) => words.test(label))?.[0] }

// The last group has those that depend on no other one, so each of them goes where it belongs.
export function sectionsOf(groups) {
  const sections = new Map()
  for (const [i, group] of groups.entries()) {
    const alone = i === groups.length - 1, whole = group.map(one => headingOf(one.label)).find(Boolean)
    for (const one of group) {
      const title = (alone ? headingOf(one.label) : whole) ?? 'More'
      sections.set(title, [...sections.get(title) ?? [], one])
    }
  }
  return [...sections].sort(([a], [b]) => (a === 'More') - (b === 'More'))
}

export function groupsOf(row, place) {
  const fields = new Map(), shape = s => [s.name, s.field, s.label, s.low, s.high, s.step, s.unit]
  let drawn = ''
  function draw(groups) {
    fields.clear()
    for (const one of groups.flat()) fields.set(one.name, settingRow(row, one))
    const sections = sectionsOf(groups), headed = sections.length > 1
    place.replaceChildren(...sections.map(([title, some]) => h('section', { 'aria-label': title },
      ...(headed ? [h('h3', {}, title)] : []), ...some.map(one => fields.get(one.name).node))))
  }
  function update(groups) {
    const now = JSON.stringify(groups.map(group => group.map(shape))), anew = now !== drawn
    if (anew) draw(groups, drawn = now)
    for (const one of groups.flat()) fields.get(one.name).update(one)
    return anew
  }
  return { update, fields }
}

// Search: with more than a dozen settings you type a part of the name.
export const MANY = 12

export function searchFor(place, fields) {
  const words = 'Find a setting'
  const input = h('input', { type: 'search', placeholder: words, 'aria-label': words, oninput: find })
  const none = h('p', { class: 'none', role: 'status' })
  function find() {
    const words = input.value.trim().toLowerCase()
    let n = 0
    for (const { node, label } of fields.values()) show(node, label.toLowerCase().includes(words) && (n += 1))
    for (const section of place.children) show(section, section.querySelector('.setting:not([hidden])'))
    say(none, n || !fields.size ? '' : 'No setting has that in its name.')
  }
  function update(anew) {
    show(input, fields.size > MANY)
    if (anew) find(input.value = fields.size > MANY ? input.value : '')
  }
  return { input, none, update }
}

// All of them: The camera is asked for its settings when they are opened for the first time.
export function settingsView(row) {
  const place = h('fieldset', { class: 'settings', 'aria-label': 'Settings' }), groups = groupsOf(row, place)
  const said = h('p', { class: 'told', role: 'status' }), search = searchFor(place, groups.fields)
  const again = h('button', { type: 'button', hidden: true, onclick: open }, 'Ask again')
  const reset = confirmed('Reset all', 'Press again: all settings are lost', () => row.act('reset_settings'))
  const node = h('div', { class: 'settings-view' }, said, again, search.input, place, search.none,
    h('div', { class: 'resets' }, reset))
  let known = null, has = true
  async function open() {
    if (!has || known) return
    show(again, false)
    say(said, 'Asking the camera …')
    const { ok, text } = await row.act('settings')
    if (ok || known) return
    say(said, text || 'The camera does not answer.')
    show(again, true)
  }
  function update({ settings, has_settings, state }) {
    known = has_settings ? settings : null
    has = has_settings
    place.disabled = state !== 'alive'
    show(reset, known?.length, reset.disabled = state !== 'alive')
    search.update(groups.update(known ?? []))
    if (has && !known) return
    show(again, false)
    say(said, known?.length ? '' : 'This camera has no settings to change.')
  }
  return { node, update, open }
}
