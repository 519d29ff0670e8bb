import test from 'node:test'
import { panel, same } from './panel.js'

const { inPicture, condition, doing, taken, sizeOf } = panel

test("Where in the picture", () => {
  same(inPicture({ left: 10, top: 20, width: 400, height: 200 }, [50, 50], 210, 120), {"x": 0, "y": 0})
  same(inPicture({ left: 10, top: 20, width: 400, height: 200 }, [50, 50], 310, 20), {"x": 1, "y": -1})
  same(inPicture({ left: 10, top: 20, width: 400, height: 200 }, [50, 50], 50, 120), null)
  same(inPicture({ left: 10, top: 20, width: 400, height: 200 }, [400, 100], 210, 145), {"x": 0, "y": 0.5})
  same(inPicture({ left: 10, top: 20, width: 400, height: 200 }, [400, 100], 210, 30), null)
})

test("Is it live", () => {
  same(condition({"state": "alive", "age": 12.3, "picture": {"state": "running", "fps": 24.7}}), "Live 25/s")
  same(condition({"state": "alive", "age": 12.3, "picture": {"state": "waiting", "why": ""}}), "Waiting for a picture")
  same(condition({"state": "alive", "age": 12.3, "picture": {"state": "lost", "why": "the stream ended"}}), "Picture lost: the stream ended")
  same(condition({"state": "lost", "age": 12.3, "picture": {"state": "running", "fps": 24.7}}), "Lost, 12 s")
  same(doing({ recording: 65.2, here: { seconds: 3 } }), "REC 00:01:05 · HERE 00:00:03")
  same(doing({ recording: null, here: null }), "")
  same(taken({ capturing: 'interval', interval: 2, count: 1 }), "a picture every 2 s · 1 picture")
  same(taken({ capturing: '', count: null }), "")
})

test("The picture", () => {
  const image = { naturalWidth: 640, naturalHeight: 480 }, sizes = [sizeOf(image)]
  image.naturalWidth = image.naturalHeight = 0
  sizes.push(sizeOf(image), sizeOf({ naturalWidth: 0 }))
  same(sizes, [[640, 480], [640, 480], [0, 0]])
})
