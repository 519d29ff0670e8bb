import test from 'node:test'
import { panel, same } from './panel.js'

const { speed, rates, turner, arrows, owner } = panel

test("How fast", () => {
  same([0, 25, 100, null].map(speed), [30, 15, 6, 30])
  same(rates(0, -1, 30), {"pitch": 30, "yaw": 0})
  same(rates(1, 0, 30).yaw, 30)
  same(rates(-7, 0, 30).yaw, -30)
  same(rates(.1, -.05, 30), {"pitch": 0, "yaw": 0})
  same([.2, .4, .6, .8].map(x => Math.round(rates(x, 0, 30).yaw)), [1, 6, 14, 24])
  same(arrows(new Set(['ArrowUp', 'ArrowLeft']), 30), {"pitch": 15, "yaw": -15})
  same(arrows(new Set(['ArrowRight', 'ArrowLeft']), 30), {"pitch": 0, "yaw": 0})
})

test("Turning", () => {
  const said = [], hold = (...how) => ({ aim: rates => said.push(rates), end: () => said.push(how) })
  const { turn, stop } = turner({ hold })
  turn({ pitch: 1, yaw: 2 }); turn({ pitch: 3, yaw: 2 }); stop(); stop()
  same(said, [{"pitch": 1, "yaw": 2}, {"pitch": 3, "yaw": 2}, ["hold", "release"]])
})

test("Who has control", () => {
  same(owner({ ours: true, owner: '255/190' }), "You have control")
  same(owner({ ours: false, owner: '255/191' }), "255/191 has control")
  same(owner({ ours: false, owner: null }), "Nobody has control")
  same(owner({ ours: false, owner: '255/190', owner_name: 'QGroundControl (255/190)' }), "QGroundControl (255/190) has control")
})
