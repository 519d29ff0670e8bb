import test from 'node:test'
import { panel, same } from './panel.js'

const { partsOf } = panel

test("Places in the picture", () => {
  same(partsOf({ left: 10, top: 0, width: 200, height: 100 }, [100, 100], 110, 25), [0.5, 0.25])
  same(partsOf({ left: 0, top: 0, width: 200, height: 100 }, [100, 100], 10, 500), [0, 1])
})
