import test from 'node:test'
import { panel, same } from './panel.js'

const { clock, degrees, space, ago, paint, latest, holding } = panel

test("Words for numbers", () => {
  same([0, 59.9, 61, 3725, 360000].map(clock), ["00:00:00", "00:00:59", "00:01:01", "01:02:05", "100:00:00"])
  same([-12.34, 0, null].map(degrees), ["−12.3°", "0.0°", "–"])
  same([12.4, 3271].map(space), ["12 MiB", "3.2 GiB"])
  same([12.2, 240].map(ago), ["12 s", "4 min"])
})

test("A state is painted when the status tells a new one", () => {
  const told = []
  const node = { dataset: {} }
  function tell(state) { paint(node, state); told.push(node.dataset.state) }
  tell('DONE'); tell('RUNNING'); tell('DONE')
  same(told, ["READY", "RUNNING", "DONE"])
})

test("An old state does not repaint a button that has failed", () => {
  const told = []
  const node = { dataset: {} }
  function tell(state) { paint(node, state); told.push(node.dataset.state) }
  tell('READY'); node.dataset.state = 'FAILED'; tell('READY')
  same(told, ["READY", "FAILED"])
})

test("A button without a state is ready", () => {
  const told = []
  const node = { dataset: {} }
  function tell(state) { paint(node, state); told.push(node.dataset.state) }
  tell(undefined)
  same(told, ["READY"])
})

test("A slider sends the newest value only", async () => {
  const sent = [], answers = []
  const send = latest(value => { sent.push(value); return new Promise(answer => answers.push(answer)) })
  for (const value of [10, 11, 12, 90]) send(value)
  answers[0]()
  await new Promise(setImmediate)
  same(await sent, [10, 90])
})

function held(ok = true) {
  const sent = [], refusals = []
  let enough
  const third = new Promise(resolve => { enough = resolve })
  const send = async args => {
    sent.push(args)
    if (sent.length === 3) enough()
    return { ok, text: '255/191 has control' }
  }
  const live = holding(send, args => sent.push(args), text => refusals.push(text))
  return { sent, refusals, third, live }
}

test('What is held says so again and again, with a number that grows, and ends once', async () => {
  const { sent, live, third } = held()
  live.aim({ yaw: 9 })
  await third
  live.end()
  live.end()
  same(sent.map(args => [args.yaw ?? null, args.n ?? null]), [[9, 1], [9, 2], [9, 3], [null, null]])
})

test('What is held changes its rates, and stays one hold', async () => {
  const { sent, live, third } = held()
  live.aim({ yaw: 9 })
  live.aim({ yaw: 5 })
  await third
  live.end()
  same(sent.map(args => args.yaw ?? null), [9, 5, 5, null])
  same(new Set(sent.map(args => args.hold)).size, 1)
})

test('A refusal ends what is held, and is told once', async () => {
  const { sent, refusals, live } = held(false)
  live.aim({ yaw: 9 })
  await null
  await null
  live.aim({ yaw: 8 })
  same([sent.length, refusals], [2, ['255/191 has control']])
})

test('Nothing was held', () => {
  const { sent, live } = held()
  live.end()
  same(sent, [])
})
