import assert from 'node:assert/strict'
import test from 'node:test'
import { panel } from './panel.js'

const { ages } = panel

test("A picture of a video has an age, and is frozen when no other comes", () => {
  let now = 1000
  const video = { requestVideoFrameCallback(call) { this.next = call } }, { performance } = globalThis
  Object.defineProperty(globalThis, 'performance', { value: { now: () => now }, configurable: true })
  try {
    const { begin, age, frozen } = ages(video)
    begin()
    now = 1500
    assert.equal(age(), .5)
    video.next(1600, { receiveTime: 1400 })
    now = 1700
    assert.deepEqual([age(), frozen()], [.3, false])
    now = 3600
    assert.equal(frozen(), true)
    video.next(now, {})
    assert.deepEqual([age(), frozen()], [0, false])
  } finally { Object.defineProperty(globalThis, 'performance', { value: performance, configurable: true }) }
})
