// The camera's card as a camera roll: small pictures by day, several selected and saved, recordings played.
//
// The list comes when the drawer is opened. A small picture is requested when its tile is in sight, one after the
// other, because each costs the radio a whole photo. Each tile has room for its picture from the beginning, so
// nothing moves when it arrives. Formatting the card takes two presses.

import { clock, confirmed, h, icon, letPicturesGo, say, show } from './parts.js'

export function bytes(size) {
  const units = [['B', 1], ['kB', 1e3], ['MB', 1e6], ['GB', 1e9]]
  const [unit, scale] = units.findLast(([, scale]) => size >= scale || scale === 1)
  return Number((size / scale).toPrecision(3)) + ' ' + unit
}

export function filesIn(words, entries) {
  const size = entries.reduce((sum, entry) => sum + entry.size, 0), n = entries.length
  return (words + ' ' + n + (n === 1 ? ' file' : ' files')).trim() + (n ? ', ' + bytes(size) : '')
}

// One after the other, and one that fails does not stop the rest.
export function inTurn(work) {
  const waiting = []
  let busy = false
  return async one => {
    waiting.push(one)
    if (busy) return
    busy = true
    while (waiting.length) await work(waiting.shift()).catch(() => {})
    busy = false
  }
}

// Kinds of files, by the ending of the name. A picture is shown large, a recording is played, and all else is saved.
export function kindOf({ name, folder }) {
  if (folder) return 'folder'
  if (/\.(mp4|m4v|mov|webm|mkv|avi|ts|mpe?g)$/i.test(name)) return 'movie'
  return /\.(jpe?g|png)$/i.test(name) ? 'picture' : 'file'
}

// Subtitles lie beside their film: they have no tile of their own, and come with it.
export function withSubtitles({ all, entries }) {
  const stem = ({ name }) => name.replace(/\.\w+$/, ''), isText = entry => /\.srt$/i.test(entry.name)
  const films = new Set(entries.filter(entry => kindOf(entry) === 'movie').map(stem))
  const mine = entries.filter(entry => isText(entry) && films.has(stem(entry)))
  const texts = new Map(mine.map(text => [stem(text), text]))
  const beside = entry => kindOf(entry) === 'movie' && texts.get(stem(entry))
  const shown = entries.filter(entry => !isText(entry) || texts.get(stem(entry)) !== entry)
  return { all: all - texts.size, entries: shown.map(one => beside(one) ? { ...one, subtitles: beside(one) } : one) }
}

export function ending(name) { return (name.match(/\.(\w{1,5})$/)?.[1] ?? 'file').toUpperCase() }

// A view shows what its wire can do: a notebook may have no way to save or to play.
export function mayOpen(kind, { photo, download, play }) {
  return !!{ folder: true, movie: play ?? download, picture: photo ?? download, file: download }[kind]
}

// Days: The list begins with the folders. Then come the days, each with its newest file first.
export function dayOf(time, now = Date.now()) {
  if (!(time > 0)) return 'Without a date'
  const midnight = at => new Date(at).setHours(0, 0, 0, 0), day = new Date(1000 * time)
  const back = Math.round((midnight(now) - midnight(day)) / 864e5)
  if (back === 0 || back === 1) return back ? 'Yesterday' : 'Today'
  const year = day.getFullYear() === new Date(now).getFullYear() ? {} : { year: 'numeric' }
  return day.toLocaleDateString('en-GB', { weekday: 'long', day: 'numeric', month: 'long', ...year }).replace(',', '')
}

export function timeOf(time) {
  return time > 0 ? new Date(1000 * time).toLocaleTimeString('en-GB', { hour: '2-digit', minute: '2-digit' }) : ''
}

export function byDay(entries, now) {
  const days = new Map()
  for (const entry of entries) {
    const title = entry.folder ? 'Folders' : dayOf(entry.time, now)
    days.set(title, [...days.get(title) ?? [], entry])
  }
  return [...days]
}

export function counted({ all, entries }) {
  const shown = entries.length < all ? 'The newest ' + entries.length + ' of ' : ''
  return all ? shown + all + (all === 1 ? ' entry' : ' entries') : ''
}

// The path as steps, from the root of the card to this folder.
export function crumbs(path) {
  const parts = path.split('/').filter(Boolean), to = i => '/' + parts.slice(0, i + 1).join('/')
  return [{ name: 'Card', path: '/' }, ...parts.map((name, i) => ({ name, path: to(i) }))]
}

export function crumbsView(go) {
  const node = h('ol', { class: 'crumbs' })
  const step = ({ name, path }) => h('button', { type: 'button', onclick: () => go(path) }, name)
  function update(path) {
    const steps = crumbs(path), here = steps.pop()
    const items = [...steps.map(step), h('span', { 'aria-current': 'page' }, here.name)]
    node.replaceChildren(...items.map(item => h('li', {}, item)))
  }
  return { node: h('nav', { 'aria-label': 'Folder' }, node), update }
}

// Tiles: A name comes from the air and is text, even if it looks like HTML.
export const SIGNS = {
  folder: 'M1.500 4h4.500l1.500 1.500h7V13h-13z', movie: 'M5 3.500v9l7.500-4.500z',
  file: 'M4 1.500h5.500L12.500 4.500v10h-8.500z',
  picture: 'M1.500 3h13v10h-13zM1.500 11l4-4 3.500 3.500 2-2 3.500 3',
  again: 'M13 8a5 5 0 1 1-1.500-3.600M13.500 1.500v3.200h-3.200',
  close: 'M3.500 3.500l9 9M12.500 3.500l-9 9', before: 'M10 3L5 8l5 5', after: 'M6 3l5 5-5 5',
  save: 'M8 2v9M4 7.500l4 4 4-4M3 14h10',
}

export function sign(which) {
  const svg = icon('photo')
  svg.firstChild.setAttribute('d', SIGNS[which])
  return svg
}

export function signButton(which, label, press) {
  return h('button', { type: 'button', class: 'sign', 'aria-label': label, onclick: press }, sign(which))
}

export const VERBS = { folder: 'Open folder', movie: 'Play', picture: 'Show', file: 'Save' }

export function fileArt(entry, kind) {
  const art = h('span', { class: 'art', 'data-kind': kind })
  if (kind === 'movie') art.append(h('i', { class: 'play' }, sign('movie')), h('i', { class: 'length' }))
  else art.append(sign(kind))
  if (kind === 'movie' || kind === 'file') art.append(h('i', { class: 'ending' }, ending(entry.name)))
  return art
}

export function fileTile(row, entry, { use, pick }) {
  const kind = kindOf(entry), verb = kind === 'movie' && !row.wire.play ? 'Save' : VERBS[kind]
  const known = entry.folder ? [] : [bytes(entry.size), timeOf(entry.time), entry.subtitles && 'subtitles']
  const about = known.filter(Boolean)
  const words = h('span', { class: 'words' }, h('b', {}, entry.name), h('small', {}, about.join(' · ')))
  const press = event => event.shiftKey && item.box ? pick(item, event) : use(entry)
  const main = h('button', { type: 'button', class: 'main', onclick: press, disabled: !mayOpen(kind, row.wire) },
    h('span', { class: 'verb' }, verb + ' '), fileArt(entry, kind), words)
  const item = h('li', { class: 'entry', 'data-kind': kind }, main)
  if (!entry.folder && row.wire.download) {
    const boxed = event => pick(item, event)
    item.box = h('input', { type: 'checkbox', 'aria-label': 'Select ' + entry.name, onclick: boxed })
    item.append(h('label', { class: 'pick' }, item.box))
  }
  return Object.assign(item, { entry })
}

// The length of a recording is known once it was played.
export function tellLength(item, seconds) {
  if (seconds > 0 && seconds < 1e6) say(item.querySelector('.length'), clock(seconds).replace(/^00:0?/, ''))
}

// A picture is drawn while its tile is in sight. A tile that is gone by then costs nothing.
export function sights(row) {
  const draw = inTurn(async item => {
    item.waits = false
    if (!item.near || !item.isConnected || item.querySelector('img')) return
    watch.unobserve(item)
    const src = await row.wire.photo(row.of, item.entry.path)
    if (item.isConnected) item.querySelector('.art').append(h('img', { src, alt: '' }))
    else URL.revokeObjectURL(src)
  })
  const watch = new IntersectionObserver(changes => {
    for (const { target, isIntersecting } of changes) {
      target.near = isIntersecting
      if (!isIntersecting || target.waits) continue
      target.waits = true
      draw(target)
    }
  })
  const see = item => { if (row.wire.photo && kindOf(item.entry) === 'picture') watch.observe(item) }
  return { see, stop: () => watch.disconnect() }
}

// Arrow keys: to the tile beside, or to the nearest in the next line. `boxes` are rectangles in the order of tiles.
export function besideOf(boxes, i, key) {
  const beside = { ArrowLeft: i - 1, ArrowRight: i + 1, Home: 0, End: boxes.length - 1 }
  if (key in beside) return Math.max(0, Math.min(boxes.length - 1, beside[key]))
  const way = { ArrowUp: -1, ArrowDown: 1 }[key], far = box => way * (box.top - boxes[i].top)
  const lines = boxes.map(far).filter(distance => distance > 1), next = Math.min(...lines)
  const line = boxes.filter(box => Math.abs(far(box) - next) <= 1), off = box => Math.abs(box.left - boxes[i].left)
  return line.length ? boxes.indexOf(line.reduce((best, box) => off(box) < off(best) ? box : best)) : i
}

export function arrowKeys(node) {
  node.addEventListener('keydown', event => {
    if (!/^(Arrow|Home$|End$)/.test(event.key) || !event.target.matches('.main')) return
    event.preventDefault(event.stopPropagation())
    const all = [...node.querySelectorAll('.main')], boxes = all.map(one => one.getBoundingClientRect())
    all[besideOf(boxes, all.indexOf(event.target), event.key)].focus()
  })
}

// Selection: a box on each tile. With the shift key you select all from the last one to this one.
export function between(order, from, to) {
  const [a, b] = [order.indexOf(from), order.indexOf(to)].sort((a, b) => a - b)
  return a < 0 ? [to] : order.slice(a, b + 1)
}

export function selection(changed) {
  let order = [], last = null
  const chosen = () => order.filter(item => item.box.checked)
  function mark(items, on) {
    for (const item of items) {
      item.box.checked = on
      item.toggleAttribute('data-chosen', on)
    }
    changed(chosen(), order)
  }
  function pick(item, { shiftKey, target }) {
    const on = target === item.box ? item.box.checked : !item.box.checked
    mark(shiftKey ? between(order, last, item) : [item], on)
    last = item
  }
  function offer(items) {
    order = items.filter(item => item.box)
    changed(chosen(), order)
  }
  return { chosen, mark, pick, offer, markAll: on => mark(order, on) }
}

// Saving: a link that nobody sees is pressed, and the browser saves the file.
export function saveAs(href, download) {
  h('a', { href, download }).click()
  setTimeout(URL.revokeObjectURL, 60000, href)
}

export async function savedBy(row, entry) {
  saveAs(await row.wire.download(row.of, entry.path), entry.name)
  if (entry.subtitles) await savedBy(row, entry.subtitles)
}

// Several files come one after the other, since they share one radio: each is read to its end, then saved. One that
// is too large for that is left to the browser, which writes it to the disk as it comes.
export const READ_AT_MOST = 2 ** 28

export async function readAll(answer, tell) {
  const reader = answer.body.getReader(), parts = []
  let have = 0
  for (let next = await reader.read(); !next.done; next = await reader.read()) {
    parts.push(next.value)
    tell(have += next.value.length)
  }
  return new Blob(parts)
}

export async function fetchFile(row, entry, signal, tell) {
  const url = await row.wire.download(row.of, entry.path)
  if (signal.aborted) return
  if (entry.size > READ_AT_MOST) return saveAs(url, entry.name)
  const answer = await fetch(url, { signal })
  if (!answer.ok) throw new Error(await answer.text())
  saveAs(URL.createObjectURL(await readAll(answer, tell)), entry.name)
  URL.revokeObjectURL(url)
}

// A file that fails does not stop the others. `stopped` ends it between two files.
export async function oneByOne(items, work, stopped) {
  const failed = []
  let done = 0
  for (const item of items) {
    if (stopped()) break
    try {
      await work(item, done)
      if (!stopped()) done += 1
    } catch (error) { if (!stopped()) failed.push({ item, why: error.message }) }
  }
  return { done, failed }
}

export function outcome({ done, failed }, all) {
  const saved = done === all ? (all === 1 ? 'Saved.' : 'All ' + all + ' saved.') : done + ' of ' + all + ' saved.'
  const names = failed.slice(0, 3).map(({ item, why }) => item.entry.name + ' (' + why + ')')
  const more = failed.length > 3 ? ' and ' + (failed.length - 3) + ' more' : ''
  return failed.length ? saved + ' Not saved: ' + names.join(', ') + more : saved
}

// The bar at the bottom: how many are selected, and what is on its way. A file that was saved is no longer selected,
// so what remains selected is what failed or was left, and the same button tries again.
export function fetchBar(row, picks) {
  const said = h('p', { class: 'told', role: 'status' })
  const progress = h('progress', { max: 1, 'aria-label': 'Files saved' })
  const all = h('input', { type: 'checkbox', onclick: () => picks().markAll(all.checked) })
  const fetchThem = h('button', { type: 'button', class: 'fetch', onclick: run }), count = h('span', { class: 'sum' })
  const stop = h('button', { type: 'button', class: 'stop', onclick: () => ended.abort() }, 'Stop')
  const idle = h('div', { class: 'line' }, h('label', { class: 'every' }, all, 'Select all'), count, fetchThem)
  const busy = h('div', { class: 'line', hidden: true }, progress, stop)
  let ended = null, can = true
  function shown(running) {
    show(idle, !running)
    show(busy, running)
    node.toggleAttribute('data-busy', running)
  }
  async function run() {
    const items = picks().chosen(), total = items.reduce((sum, { entry }) => sum + entry.size, 0) || 1
    let before = 0
    ended = new AbortController()
    shown(true)
    stop.focus()
    async function one(item, n) {
      say(said, 'Fetching ' + (items.indexOf(item) + 1) + ' of ' + items.length + ': ' + item.entry.name)
      await fetchFile(row, item.entry, ended.signal, have => { progress.value = (before + have) / total })
      progress.value = (before += item.entry.size) / total
      if (item.entry.subtitles) await fetchFile(row, item.entry.subtitles, ended.signal, () => {})
      if (!ended.signal.aborted) picks().mark([item], false, item.toggleAttribute('data-saved', true))
    }
    progress.value = 0
    const found = await oneByOne(items, one, () => ended.signal.aborted)
    shown(false)
    say(said, outcome(found, items.length))
    node.toggleAttribute('data-failed', found.failed.length)
    for (const next of [all, fetchThem]) next.focus()
  }
  function alive(yes) {
    can = yes
    fetchThem.disabled = !can || !picks().chosen().length
  }
  function chosen(items, order) {
    const n = items.length
    all.checked = n > 0 && n === order.length
    all.indeterminate = n > 0 && n < order.length
    say(count, n ? filesIn('', items.map(item => item.entry)) : '')
    say(fetchThem, n ? 'Fetch ' + n + (n === 1 ? ' file' : ' files') : 'Fetch files')
    alive(can)
    show(node, order.length && row.wire.download)
  }
  const node = h('div', { class: 'bar', role: 'group', 'aria-label': 'Selected files', hidden: true }, said, idle, busy)
  return { node, chosen, alive }
}

// Large: A window over the page with one picture or one recording. The arrow keys, or a finger that wipes, go to the
// one before and after. It stands outside of the drawer, whose buttons are off while the camera is lost.
export const SWIPE = 60
export const CANNOT_PLAY = 'This browser cannot play this recording. Save it, and open it in a player.'
export const CANNOT_SHOW = 'This browser cannot show the full picture. Save it, and open it in a viewer.'

// What is on its way to a picture or a video ends when it is put away.
export function putAway(place) {
  for (const one of place.querySelectorAll('img:not(.rough), video')) {
    URL.revokeObjectURL(one.src)
    one.removeAttribute('src')
  }
  for (const video of place.querySelectorAll('video')) video.load()
  place.replaceChildren()
}

export function largeView(row) {
  const title = h('h2'), which = h('span', { class: 'quiet' }), said = h('p', { class: 'told', role: 'status' })
  const place = h('div', { class: 'stage' }), sorry = error => say(said, error.message)
  const saves = () => savedBy(row, now.entry).catch(sorry)
  const save = h('button', { type: 'button', class: 'save', onclick: saves }, sign('save'), 'Save')
  const close = signButton('close', 'Close', () => node.close()), steps = [-1, 1].map(way =>
    signButton(way < 0 ? 'before' : 'after', way < 0 ? 'Previous' : 'Next', () => step(way)))
  const node = h('dialog', { class: 'large', 'aria-label': 'One file', onclose: away },
    h('header', {}, title, which, ...steps, save, close), place, said)
  let now = null, list = [], from = 0
  close.toggleAttribute('autofocus', true)
  function away() {
    now = null
    putAway(place)
    node.remove()
  }
  const step = way => put(list[(list.indexOf(now) + way + list.length) % list.length])
  async function play(item) {
    const video = h('video', { controls: true, autoplay: true, playsinline: true, 'aria-label': item.entry.name })
    video.addEventListener('loadedmetadata', () => { tellLength(item, video.duration); say(said, '') })
    video.addEventListener('error', () => { if (video.getAttribute('src')) say(said, CANNOT_PLAY) })
    place.replaceChildren(video)
    const src = await row.wire.play(row.of, item.entry.path)
    if (now === item) video.src = src
  }
  async function look(item) {
    const small = item.querySelector('img')?.src
    const rough = small ? [h('img', { class: 'rough', src: small, alt: '', draggable: 'false' })] : []
    const full = h('img', { alt: item.entry.name, hidden: true, draggable: 'false' })
    full.addEventListener('load', () => { show(full, true); rough[0]?.remove(); say(said, '') })
    full.addEventListener('error', () => { if (full.getAttribute('src')) say(said, CANNOT_SHOW) })
    place.replaceChildren(...rough, full)
    const { download, photo } = row.wire, src = await (download ?? photo)(row.of, item.entry.path)
    if (now === item) full.src = src
    else URL.revokeObjectURL(src)
  }
  function put(item) {
    putAway(place)
    now = item
    say(title, item.entry.name)
    say(which, list.indexOf(item) + 1 + ' of ' + list.length + ' · ' + bytes(item.entry.size))
    say(said, 'Asking the camera …')
    const fill = kindOf(item.entry) === 'movie' ? play : look
    fill(item).catch(error => { if (now === item) say(said, error.message) })
  }
  place.addEventListener('pointerdown', event => { from = event.clientX })
  place.addEventListener('pointerup', ({ clientX, target }) => {
    const far = clientX - from
    if (Math.abs(far) > SWIPE && list.length > 1 && target.tagName !== 'VIDEO') step(far < 0 ? 1 : -1)
  })
  node.addEventListener('keydown', event => {
    event.stopPropagation()
    const way = { ArrowLeft: -1, ArrowRight: 1 }[event.key]
    if (way && event.target.tagName !== 'VIDEO') step(way, event.preventDefault())
  })
  function open(item, items) {
    list = items
    for (const press of steps) show(press, items.length > 1)
    show(save, row.wire.download)
    item.closest('.uav-panel').append(node)
    node.showModal(put(item))
  }
  return { node, open, close: () => node.open && node.close() }
}

// The list. Tiles of files that are still there stay, with their pictures. Folders that you open fast one after the
// other may answer in another order: the list shows the one that you wanted last.
export function tilesOf(row, given) {
  const node = h('div', { class: 'files' }), { see, stop } = sights(row)
  let tiles = new Map()
  arrowKeys(node)
  function update(entries) {
    const key = entry => JSON.stringify(entry), old = tiles
    tiles = new Map(entries.map(entry => [key(entry), old.get(key(entry)) ?? fileTile(row, entry, given)]))
    for (const [id, item] of old) if (!tiles.has(id)) letPicturesGo(item)
    const day = ([title, some]) => h('section', { 'aria-label': title }, h('h3', {}, title),
      h('ul', {}, ...some.map(entry => tiles.get(key(entry)))))
    node.replaceChildren(...byDay(entries).map(day))
    for (const item of tiles.values()) if (!item.querySelector('img')) see(item)
    return [...tiles.values()]
  }
  return { node, update, stop: () => { stop(); update([]) } }
}

export const NO_FILES = 'No files here yet. A photo or a recording that is stored on the camera appears here.'

export function filesView(row) {
  const said = h('p', { class: 'told', role: 'status' }), none = h('p', { class: 'none', hidden: true }, NO_FILES)
  const again = signButton('again', 'Look again', () => open())
  const wipe = confirmed('Format card', 'Press again: all pictures are lost', async () => {
    const { ok, text } = await row.act('format')
    await open()
    if (!ok) say(said, text)
  })
  const picks = selection((...now) => bar.chosen(...now)), bar = fetchBar(row, () => picks), large = largeView(row)
  const steps = crumbsView(path => open(path)), tiles = tilesOf(row, { use, pick: picks.pick })
  const top = h('header', {}, h('div', { class: 'line' }, steps.node, again), h('div', { class: 'line' }, said, wipe))
  const node = h('div', { class: 'files-view' }, top, tiles.node, none, bar.node)
  let at = '/media', items = [], asked = 0, newest = null, seen = null
  const shows = ({ entry }) => {
    const kind = kindOf(entry)
    return kind === 'movie' ? row.wire.play : kind === 'picture' && mayOpen(kind, row.wire)
  }
  function use(entry) {
    const item = items.find(one => one.entry.path === entry.path)
    if (entry.folder) open(entry.path)
    else if (shows(item)) large.open(item, items.filter(shows))
    else savedBy(row, entry).catch(error => say(said, error.message))
  }
  function put(found) {
    const shown = withSubtitles(found)
    items = tiles.update(shown.entries)
    picks.offer(items)
    say(said, counted(shown))
    show(none, !found.entries.length)
  }
  async function open(path = at) {
    const turn = asked += 1
    if (path !== at) put({ all: 0, entries: [] })
    at = path
    steps.update(path)
    show(none, false)
    say(said, 'Asking the camera …')
    seen = newest
    again.removeAttribute('data-news')
    try {
      const found = await row.wire.files(row.of, path)
      if (turn === asked) put(found)
    } catch (error) { if (turn === asked) say(said, error.message) }
  }
  function stop() {
    asked += 1
    large.close()
    tiles.stop()
    picks.offer(items = [])
  }
  function update({ can, state, pictures = [] }) {
    show(node, row.wire.files && can.some(one => one.startsWith('CAPTURE_')))
    for (const press of [again, wipe]) press.disabled = state !== 'alive'
    bar.alive(state === 'alive')
    newest = JSON.stringify(pictures.map(({ n }) => n))
    again.toggleAttribute('data-news', seen != null && newest !== seen)
  }
  return { node, update, open, stop }
}
