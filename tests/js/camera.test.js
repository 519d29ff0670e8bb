import test from 'node:test'
import { panel, same } from './panel.js'

const { mayTake, mayRecord, leading, facts, room } = panel

test("Pictures and videos", () => {
  same(mayTake({ can: [], mode: 'video' }), false)
  same(mayTake({ can: ['CAN_CAPTURE_IMAGE_IN_VIDEO_MODE'], mode: 'video' }), true)
  same(mayTake({ can: [], mode: 'image' }), true)
  same([mayRecord({ can: [], mode: 'image' }), mayRecord({ can: [], mode: null })], [false, true])
})

test("The shutter does what the mode says, as far as the camera can", () => {
  const both = ['CAPTURE_IMAGE', 'CAPTURE_VIDEO']
  same(['image', 'video', null].map(mode => leading({ can: both, mode })), ['photo', 'record', 'photo'])
  same([leading({ can: ['CAPTURE_VIDEO'], mode: null }), leading({ can: ['CAPTURE_IMAGE'], mode: 'video' })], ['record', 'photo'])
})

test("What it tells of itself", () => {
  same(facts({ info: { lens: '4 mm', firmware: '' }, vendor: 'Sim', battery: 87 }), [["vendor", "Sim"], ["lens", "4 mm"], ["battery", "87 %"]])
  same(room({ storage: { free: 3271, total: 8000, text: "3.2 GiB of 7.8 GiB free" }, battery: 87 }), "3.2 GiB free · camera battery 87 %")
  same(room({ storage: null, link: 98.4 }, { battery: 76 }), "link 98 % · battery 76 %")
  same(room({ storage: { free: 0, total: 0, text: "no card" }, battery: null }), "no card")
  same(room({ storage: null, battery: null }), "")
})
