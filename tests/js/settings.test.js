import test from 'node:test'
import { panel, same } from './panel.js'

const { reading, headingOf, sectionsOf } = panel

test('Fields', () => {
  same([reading(.1 + .2, 'EV'), reading(1234567, ''), reading(0, '%')], ['0.3 EV', '1235000', '0 %'])
})

test('Headings by the words of the labels', () => {
  same(['ISO sensitivity', 'White balance', 'JPEG quality of a photo', 'Video bit rate', 'Isolation', 'Palette'].map(headingOf),
    ['Exposure', 'Colour', 'Photo', 'Video', null, 'Colour'])
})

test('What depends on each other stays together, and what has no heading comes last', () => {
  const of = (...labels) => labels.map(label => ({ label }))
  const groups = [of('Exposure mode', 'Night light'), of('Beeper', 'White balance', 'ISO limit')]
  const found = sectionsOf(groups).map(([title, some]) => [title, some.map(one => one.label)])
  same(found, [['Exposure', ['Exposure mode', 'Night light', 'ISO limit']], ['Colour', ['White balance']], ['More', ['Beeper']]])
  same(sectionsOf([]), [])
})
