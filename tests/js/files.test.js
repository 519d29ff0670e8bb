import test from 'node:test'
import { panel, same } from './panel.js'

const { bytes, inTurn, counted, kindOf, ending, mayOpen, dayOf, byDay, crumbs, besideOf, between, oneByOne, outcome,
  filesIn, withSubtitles } = panel

test('Sizes in words', () => {
  same([0, 999, 31415, 2718281].map(bytes), ['0 B', '999 B', '31.4 kB', '2.72 MB'])
  same(filesIn('', [{ size: 1e6 }, { size: 5e5 }]), '2 files, 1.5 MB')
  same([filesIn('', [{ size: 1 }]), filesIn('', [])], ['1 file, 1 B', '0 files'])
})

test('One after the other, and one that fails does not stop the rest', async () => {
  const told = [], add = inTurn(async what => { told.push(what + ' begins'); await null; told.push(what + ' ends'); throw new Error() })
  const first = add('a')
  add('b')
  await first
  same(await told, ['a begins', 'a ends', 'b begins', 'b ends'])
})

test('What a file is, and what may be done with it', () => {
  const kinds = ['a.JPG', 'b.mp4', 'c.dng', 'jpg'].map(name => kindOf({ name }))
  same([...kinds, kindOf({ name: 'x.mp4', folder: true })], ['picture', 'movie', 'file', 'file', 'folder'])
  same(['a.dng', 'b', 'c.<script>'].map(ending), ['DNG', 'FILE', 'FILE'])
  const notebook = { files: 1 }, page = { files: 1, photo: 1, download: 1, play: 1 }
  const all = ['folder', 'movie', 'picture', 'file']
  same(all.map(kind => mayOpen(kind, notebook)), [true, false, false, false])
  same(all.map(kind => mayOpen(kind, page)), [true, true, true, true])
})

test('Days, the newest first and folders before them', () => {
  const now = new Date(2026, 10, 24, 12).getTime(), at = (...when) => new Date(...when).getTime() / 1000
  const times = [at(2026, 10, 24, 0, 1), at(2026, 10, 23, 23, 59), at(2026, 10, 9), at(2025, 0, 1), 0, null]
  same(times.map(time => dayOf(time, now)), ['Today', 'Yesterday', 'Monday 9 November', 'Wednesday 1 January 2025',
    'Without a date', 'Without a date'])
  const entries = [{ folder: true }, { time: times[0] }, { time: times[0] - 1 }, { time: times[1] }]
  same(byDay(entries, now).map(([title, some]) => [title, some.length]), [['Folders', 1], ['Today', 2], ['Yesterday', 1]])
})

test('The list', () => {
  same(crumbs('/').map(step => step.path), ['/'])
  same(crumbs('/media/old').map(({ name, path }) => name + ' ' + path), ['Card /', 'media /media', 'old /media/old'])
  same(counted({ all: 1, entries: [1] }), '1 entry')
  same(counted({ all: 999, entries: [1, 2] }), 'The newest 2 of 999 entries')
  same(counted({ all: 0, entries: [] }), '')
})

test('Subtitles are folded into their film, and others have a tile of their own', () => {
  const named = (...names) => names.map(name => ({ name, size: 1 }))
  const found = withSubtitles({ all: 5, entries: named('VID_2.ts', 'VID_1.srt', 'VID_1.mp4', 'notes.srt', 'a.jpg') })
  same(found.entries.map(({ name, subtitles }) => name + (subtitles ? '+' + subtitles.name : '')),
    ['VID_2.ts', 'VID_1.mp4+VID_1.srt', 'notes.srt', 'a.jpg'])
  same(found.all, 4)
  same(withSubtitles({ all: 0, entries: [] }), { all: 0, entries: [] })
})

test('Arrow keys go to the tile beside, and to the nearest in the next line', () => {
  const boxes = [[0, 0], [0, 100], [0, 200], [80, 0], [200, 0], [200, 100]].map(([top, left]) => ({ top, left }))
  const from = (i, key) => besideOf(boxes, i, key)
  same([from(0, 'ArrowLeft'), from(0, 'ArrowRight'), from(2, 'Home'), from(0, 'End')], [0, 1, 0, 5])
  same([from(2, 'ArrowDown'), from(3, 'ArrowDown'), from(5, 'ArrowUp'), from(5, 'ArrowDown'), from(1, 'ArrowUp')], [3, 4, 3, 5, 1])
})

test('The shift key selects a range, in either direction', () => {
  same([between('abcd', 'b', 'd'), between('abcd', 'c', 'a'), between([...'abcd'], null, 'c')], ['bcd', 'abc', ['c']])
})

test('Files are saved one after the other; what failed is named, and the rest goes on', async () => {
  const items = ['a', 'b', 'c'].map(name => ({ entry: { name } }))
  const work = async ({ entry }) => { if (entry.name === 'b') throw new Error('no answer') }
  const found = await oneByOne(items, work, () => false)
  same(outcome(found, 3), '2 of 3 saved. Not saved: b (no answer)')
  same(outcome(await oneByOne(items.slice(0, 1), work, () => false), 1), 'Saved.')
})

test('Stopped: no further file is begun, and the one that was cut off is not a failure', async () => {
  let stopped = false
  const begun = []
  const work = async item => { begun.push(item); if (item === 2) { stopped = true; throw new Error('aborted') } }
  const found = await oneByOne([1, 2, 3], work, () => stopped)
  same([begun, found, outcome(found, 3)], [[1, 2], { done: 1, failed: [] }, '1 of 3 saved.'])
})
