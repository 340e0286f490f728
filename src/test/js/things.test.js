// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict'
import {test} from 'node:test'
import {withGround} from '../../../resources/resource/WebGui/app/service/js/sear/build/mounting.js'
import {plain} from '../../../resources/resource/WebGui/app/service/js/sear/build/places.js'
import {THINGS, thingEdit} from '../../../resources/resource/WebGui/app/service/js/sear/build/things.js'

test('a thing is one step of undo, with a free name, at its place', () => {
    const edit = thingEdit('table', [1, 0.5, 2], ['table1 top', 'ball1'], plain)
    assert.equal(edit.words, 'add table2')
    assert.equal(edit.edits.length, 5)
    assert.deepEqual([edit.edits[0].name, edit.edits[0].set.x, edit.edits[0].set.y, edit.edits[0].set.z],
        ['table2 top', '1', '0.975', '2'])
    assert.equal(thingEdit('ball', [0, 0, 0], ['ball1'], plain).edits[0].name, 'ball2')
})

test('things stand on the ground, and an empty world gets a floor', () => {
    Object.keys(THINGS).forEach(thing => {
        const lowest = Math.min(...THINGS[thing].parts().filter(part => !part.set.rx)
            .map(({set}) => set.y - (set.radius && !set.height ? set.radius : set.height / 2)))
        assert.ok(Math.abs(lowest) < 1e-9, thing + ' ' + lowest)
    })
    const first = withGround(thingEdit('ball', [0, 0, 0], [], plain), {objects: []})
    assert.deepEqual(first.edits.map(edit => edit.type), ['Floor', 'Sphere'])
})
