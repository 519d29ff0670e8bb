import test from 'node:test'
import { panel, same } from './panel.js'

const { GAMEPAD, KEYBOARD, TOUCH, turnKeys, keyOf, namesOf, shortcuts, typing, zoomKeys } = panel

// A page with a panel in it, and what its listeners hear
function page({ notebook = false } = {}) {
  const heard = new Map(), on = (kind, f) => heard.set(kind, f), off = kind => heard.delete(kind)
  const listen = { addEventListener: on, removeEventListener: off }
  const element = (tagName, more = {}) => {
    const one = { tagName, closest: () => null, getAttribute: () => more.role ?? null, type: '', ...more }
    one.contains = target => target === one || !!target.inside
    return one
  }
  const body = element('BODY')
  globalThis.document = { ...listen, body, hidden: false }
  globalThis.window = listen
  const node = element('MAIN', { parentElement: notebook ? null : body })
  const places = {
    node, body, picture: element('DIV', { role: 'application', inside: true }), button: element('BUTTON', { inside: true }),
    number: element('INPUT', { type: 'number', inside: true }), range: element('INPUT', { type: 'range', inside: true }),
    select: element('SELECT', { inside: true }), note: element('P', { isContentEditable: true, inside: true }),
    area: element('TEXTAREA', { inside: true }), cell: element('DIV'),
    close: element('BUTTON', { inside: true, closest: what => what === 'dialog' }),
  }
  const happen = (kind, more = {}) => {
    const event = { shiftKey: false, target: body, preventDefault: () => { event.defaultPrevented = true }, ...more }
    heard.get(kind)(event)
    return event
  }
  const press = (key, at = 'body', more = {}) => happen('keydown', { key, target: places[at], ...more })
  const release = (key, more = {}) => happen('keyup', { key, ...more })
  return { ...places, heard, happen, press, release }
}

function counting(setting) {
  const view = page(setting), done = []
  const map = { ' ': () => done.push('shutter'), r: () => done.push('r'), Escape: () => done.push('escape'),
    '?': () => done.push('help'), 3: () => done.push('3'), '+': { down: () => done.push('in'), up: () => done.push('end') },
    ArrowUp: { down: () => done.push('up'), up: () => done.push('still') } }
  const end = shortcuts(view.node, map)
  const taken = () => done.splice(0)
  return { ...view, end, taken }
}

test('A key is heard wherever the focus is, but not in a field', () => {
  const { press, taken } = counting()
  const at = ['body', 'node', 'picture', 'button', 'range', 'number', 'select', 'area', 'note', 'cell', 'close']
  same(at.filter(place => { press('r', place); return taken().length }), ['body', 'node', 'picture', 'button', 'range'])
})

test('The space bar and the arrows count on the picture and where nothing has the focus', () => {
  const { press, taken } = counting()
  const at = ['body', 'node', 'picture', 'button', 'range', 'number', 'select', 'close']
  for (const key of [' ', 'ArrowUp'])
    same(at.filter(place => { press(key, place); return taken().length }), ['body', 'node', 'picture'])
})

test('Escape counts in a field, too, and not in a list or a dialog that it closes', () => {
  const { press, taken } = counting()
  const at = ['body', 'number', 'area', 'select', 'close']
  same(at.filter(place => { press('Escape', place); return taken().length }), ['body', 'number', 'area'])
})

test('In a notebook only keys inside the panel count', () => {
  const { press, taken } = counting({ notebook: true })
  for (const place of ['body', 'cell', 'picture', 'button']) press('r', place)
  same(taken(), ['r', 'r'])
})

test('Modifiers, repeats and keys that someone else has taken do nothing', () => {
  const { press, taken } = counting()
  for (const more of ['ctrlKey', 'altKey', 'metaKey', 'repeat', 'defaultPrevented', 'isComposing', 'shiftKey'])
    press('r', 'body', { [more]: true })
  press('ArrowUp', 'body', { shiftKey: true })
  same([!!press('constructor').defaultPrevented, taken()], [false, []])
  same(['ctrlKey', 'repeat'].map(more => !!press(' ', 'body', { [more]: true }).defaultPrevented), [false, true])
})

test('Caps Lock and other keyboards', () => {
  const { press, taken } = counting()
  press('R')
  press('?', 'body', { shiftKey: true })
  press('3', 'body', { shiftKey: true })
  same(taken(), ['r', 'help', '3'])
  same([{ key: 'R', shiftKey: true }, { key: 'Escape' }].map(keyOf), ['R', 'Escape'])
})

test('What lasts while a key is down ends when it goes up, even under another name', () => {
  const { press, release, taken } = counting()
  press('+', 'body', { code: 'Equal', shiftKey: true })
  press('+', 'body', { code: 'Equal', shiftKey: true, repeat: true })
  release('=', { code: 'Equal' })
  release('=', { code: 'Equal' })
  same(taken(), ['in', 'end'])
})

test('What lasts ends when the letting go may never be seen', () => {
  const ways = {
    blur: view => view.happen('blur'), pagehide: view => view.happen('pagehide'), menu: view => view.happen('contextmenu'),
    hidden: view => { document.hidden = true; view.happen('visibilitychange') }, end: view => view.end(),
    shortcut: view => view.press('Meta', 'body', { metaKey: true }),
  }
  for (const [how, away] of Object.entries(ways)) {
    const view = counting()
    view.press('+', 'body', { code: 'NumpadAdd' })
    away(view)
    same([how, view.taken()], [how, ['in', 'end']])
  }
  const view = counting()
  view.end()
  same(view.heard.size, 0)
})

test('A tap zooms a step, and a longer press until you let go', t => {
  t.mock.timers.enable({ apis: ['setTimeout'] })
  const told = [], row = {
    act: (what, { step }) => told.push([what, step]),
    hold: (what, ended) => ({ aim: ({ direction }) => told.push([what, direction]), end: () => told.push([ended]) }),
  }
  const keys = zoomKeys(() => ({ row })), none = zoomKeys(() => null)
  keys['+'].down(); keys['+'].up()
  same(told.splice(0), [['zoom_step', 1]])
  keys['-'].down(); t.mock.timers.tick(300); keys['-'].up(); keys['-'].up()
  same(told.splice(0), [['zoom_hold', -1], ['zoom_release']])
  none['+'].down(); t.mock.timers.tick(300); none['+'].up()
  same(told, [])
})

test('Arrows turn the gimbal of the main camera, two of them aslant, and stop it where it was begun', () => {
  const told = [], camera = called => ({ zoom: () => 100, turning: {
    turn: ({ pitch, yaw }) => told.push([called, pitch, yaw]), stop: () => told.push([called]) } })
  let now = camera('A')
  const keys = turnKeys(() => now)
  keys.ArrowUp.down(); keys.ArrowRight.down(); keys.ArrowUp.up(); keys.ArrowRight.up()
  same(told.splice(0), [['A', 3, 0], ['A', 3, 3], ['A', 0, 3], ['A']])
  keys.ArrowLeft.down()
  now = camera('B')
  keys.ArrowUp.down(); keys.ArrowUp.up(); keys.ArrowLeft.up()
  same(told.splice(0), [['A', 0, -3], ['A']])
  for (const none of [null, { turning: null, zoom: () => null }]) {
    now = none
    keys.ArrowUp.down(); keys.ArrowUp.up()
  }
  same(told, [])
})

test('Fields, names, and a help without a line twice', () => {
  same(['text', 'number', 'range', 'checkbox'].map(type => typing({ tagName: 'INPUT', type })), [true, true, false, false])
  same(['Arrow keys', '+ −', '1 … 9', 'R', ['Esc']].map(namesOf), [['Arrow keys'], ['+', '−'], ['1', '…', '9'], ['R'], ['Esc']])
  for (const table of [KEYBOARD, GAMEPAD, TOUCH]) same(new Set(table.map(String)).size, table.length)
})
