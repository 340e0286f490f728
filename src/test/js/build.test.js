// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict'
import {test} from 'node:test'
import {Edits} from '../../../resources/resource/WebGui/app/service/js/sear/build/edits.js'
import {sizesOf} from '../../../resources/resource/WebGui/app/service/js/sear/build/handles.js'
import {Joining, anglesOf, ends, pick, pointed, tautened} from
    '../../../resources/resource/WebGui/app/service/js/sear/build/joints.js'
import {mounted, tilted, withGround} from '../../../resources/resource/WebGui/app/service/js/sear/build/mounting.js'
import * as places from '../../../resources/resource/WebGui/app/service/js/sear/build/places.js'
import {Drawing} from '../../../resources/resource/WebGui/app/service/js/sear/build/walls.js'
import {besideBody, drivenWheels, wheelToTurn} from
    '../../../resources/resource/WebGui/app/service/js/sear/build/wheels.js'
import {frame, rotate} from '../../../resources/resource/WebGui/app/service/js/sear/shared/geometry.js'
import {find} from '../../../resources/resource/WebGui/app/service/js/sear/world/pointing.js'
import {Listeners} from '../../../resources/resource/WebGui/app/service/js/sear/shared/listeners.js'
import {Messages} from '../../../resources/resource/WebGui/app/service/js/sear/shared/messages.js'

/** Returns the changes that an edit makes to a file with these values. */
function written(object, values, live, set) {
    return places.edit(places.of({robot: null, object}, values, live), set)
}

test('the corners of a wall snap to corners, to the grid and to straight lines', () => {
    const snapped = value => Math.round(value * 20) / 20
    const world = {objects: [{line: [[0, 0], [2, 0]], pose: [1, 0, 1, 0, 90, 0]}, {}]}
    const drawing = new Drawing()
    const snap = (point, free) => drawing.snap(world, point, free ? value => value : snapped, free).map(places.plain)
    assert.deepEqual(snap([1.1, 1.1]), ['1', '1'])
    assert.deepEqual(snap([1.02, -0.9]), ['1', '-1'])
    assert.deepEqual(snap([1.1, 1.1], true), ['1.1', '1.1'])
    drawing.click([5, 5], 0.2)
    assert.deepEqual(snap([7.01, 5.2]), ['7', '5'])
    assert.deepEqual(snap([7, 7.1]), ['7.05', '7.05'])
    assert.deepEqual(snap([7.01, 5.92]), ['7', '5.9'])
    assert.equal(drawing.isWhole(), false)
    assert.equal(drawing.click([7, 5]), false)
    assert.equal(drawing.click([7, 7]), false)
    assert.equal(drawing.click([5, 5]), true)
    drawing.takeBack()
    assert.deepEqual(drawing.values(), {x: '5', y: '0.2', z: '5', corner: [{x: '0', z: '0'}, {x: '2', z: '0'},
        {x: '2', z: '2'}]})
})

test('a place on Earth is written as such, and a height as on the ground', () => {
    const onEarth = {x: '0', y: '0', z: '0', ry: '0', placeLatitude: '5', placeLongitude: '6', placeHeading: '30'}
    const object = {pose: [1, 2, 3, 0, 60, 0]}
    assert.deepEqual(written(object, onEarth, false, {ry: '90'}), {placeHeading: '0'})
    assert.deepEqual(written(object, onEarth, false, {x: '4'}), {x: '4', z: '3', onGround: 'true'})
})

test('objects that the simulation has moved are written where they are', () => {
    assert.deepEqual(written({pose: [1, 2, 3, 0, 0, 90]}, {x: '1', y: '2', z: '0', ry: '0'}, true, {x: '4'}),
        {rx: '0', ry: '0', rz: '90', z: '3', x: '4'}, 'a crate that was tipped over and pushed')
    assert.deepEqual(written({parts: [], pose: [5, 0, 5, 0, 90, 0], start: [1, 0, 2, 0, 0, 0],
        written: [1, 0, 0, 0, 0, 0]},
        {x: '1', y: '0', z: '0', ry: '0'}, true, {z: '6'}), {x: '3', z: '6', ry: '90'},
            'a robot whose Dynamics is 2 m ahead of it')
})

test('numbers of a file are rounded to a tenth of a millimetre, angles to half a turn', () => {
    assert.deepEqual([0.1 + 0.2, -1e-9, 2].map(places.plain), ['0.3', '0', '2'])
    assert.deepEqual([190, -190, 360].map(places.wrapped), [-170, 170, 0])
})

test('a handle changes the size along its axis', () => {
    const type = names => ({parameters: names.map(name => ({name}))})
    assert.deepEqual(Object.keys(sizesOf(type(['length', 'width', 'height']))), ['x', 'z', 'y'])
    assert.deepEqual(sizesOf(type(['radius', 'height'])).x, {name: 'radius', share: 0.5})
    assert.deepEqual(sizesOf(null), {})
})

const BODY = {name: 'body', type: 'Box', pose: [0, 0, 0, 0, 0, 0], corners: [[-0.1, -0.05, -0.2], [0.1, 0.05, 0.2]]}
function wheel(name, x, driven, motor) {
    return {name, type: 'Wheel', pose: [x, 0, 0, 0, 0, 0], corners: [[-0.01, -0.03, -0.03], [0.01, 0.03, 0.03]],
        driven, motor}
}
function worldOf(...wheels) {
    return {objects: [], sensors: [],
        robots: [{name: 'rover', pose: [0, 0.04, 0, 0, 0, 0], parts: [BODY].concat(wheels)}]}
}

test('new wheels go to the left, then to the right, at the height of the other wheels', () => {
    const size = {radius: 0.03, width: 0.02}
    const same = value => value
    const first = besideBody(worldOf(), 'rover', null, size, same)
    assert.deepEqual([first.x, first.z], ['0.115', '0'])
    const second = besideBody(worldOf(wheel('left', 0.115, true)), 'rover', null, size, same)
    assert.deepEqual(second, {x: '-0.115', y: '0', z: '0'})
    assert.deepEqual(besideBody(worldOf(), 'rover', [-0.1, 0, 0.15], size, same).x, '-0.115', 'where the click was')
})

test('a motor turns the first driven wheel without a motor', () => {
    const world = worldOf(wheel('left', 0.1, true, true), wheel('caster', 0, false), wheel('right', -0.1, true))
    assert.deepEqual(drivenWheels(world, 'rover'), ['left', 'right'])
    assert.equal(wheelToTurn(world, 'rover'), 'right')
    assert.equal(wheelToTurn(worldOf(), 'rover'), null)
})

test('a sensor on a side looks away from it, and a cone above the ground', () => {
    const sonar = {parameters: [{name: 'seesOwnRobot'}, {name: 'cone'}]}
    assert.deepEqual(mounted({local: [0.1, 0.05, 0.01], normal: [1, 0, 0]}, sonar, true, value => value),
        {x: '0.1', y: '0.05', z: '0.01', ry: '90'})
    assert.deepEqual([tilted(sonar), tilted({parameters: []})], [{rx: '-20'}, {}])
})

test('a robot in a world without ground comes with a floor', () => {
    const robot = {'do': 'robot', template: 'rover'}
    assert.deepEqual(withGround(robot, {objects: []}).edits.map(edit => edit['do']), ['add', 'robot'])
    assert.equal(withGround(robot, {objects: [{type: 'Floor'}]}), robot)
})

/** Returns the edits of a panel whose service gets no answers, and what the panel sends. */
function editsOf() {
    const sent = []
    const panel = {msg: {send: (...call) => sent.push(call)}, timeout: () => {}}
    const messages = new Messages()
    const edits = new Edits(panel, messages, {previewed: new Listeners(), look: () => {}}, {choose: () => {}},
        {repaint: () => {}})
    return {sent, messages, edits, last: () => sent.filter(call => call[0] === 'tryEdit').pop()[1]}
}

test('an edit sends what the user saw, and reports why it failed', () => {
    const {messages, edits, last} = editsOf()
    assert.deepEqual(edits.setting('box1', {x: '2', mass: '1'}, {x: '1'}),
        {'do': 'set', object: 'box1', set: {x: '2', mass: '1'}, was: {x: '1', mass: ''}})
    edits.edit(edits.setting('box1', {x: '2'}, {x: '1'}))
    edits.handlers.onEdit({page: last().page, done: false,
        problems: [{file: 'a.xml', field: 'x', value: '2', legal: 'a value'}]})
    assert.deepEqual([messages.last.level, messages.last.text], ['error', 'a.xml: x is "2", legal: a value'])
})

test('undo and redo follow the service, and their descriptions are reported', () => {
    const {messages, edits, last} = editsOf()
    edits.handlers.onEdits({undo: 'move crate', redo: null})
    assert.deepEqual([edits.undoable, edits.redoable], ['move crate', null])
    edits.undo()
    assert.equal(last()['do'], 'undo')
    edits.handlers.onEdit({page: last().page, done: true, words: 'move crate', undo: null, redo: 'move crate'})
    assert.deepEqual([edits.undoable, edits.redoable, messages.last.text], [null, 'move crate', 'undone: move crate'])
})

test('values set here and not answered yet are those of the file', () => {
    const {edits, last} = editsOf()
    edits.selected = 'box1'
    edits.handlers.onProjectObject({object: 'box1', values: {x: '1', z: '5'}})
    edits.edit(edits.setting('box1', {x: '2'}, edits.values()))
    assert.deepEqual(edits.values(), {x: '2', z: '5'})
    edits.handlers.onEdit({page: last().page, done: false, reason: 'no', problems: []})
    assert.deepEqual(edits.values(), {x: '1', z: '5'})
})

test('a selection that another page deletes ends with a message', () => {
    const {messages, edits} = editsOf()
    edits.select('box1')
    edits.handlers.onEdit({page: 'another', done: true, words: 'delete box1', undo: 'delete box1', redo: null})
    edits.handlers.onProjectObject({object: 'box1', gone: true})
    assert.equal(edits.selected, null)
    assert.match(messages.last.text, /box1 was deleted or renamed by another page .* delete box1/)
})

test('clicks choose the objects of a joint, and the ground is the world', () => {
    const world = {objects: [{name: 'door', pose: [1, 1, 0, 0, 0, 0], loose: true},
        {name: 'wall', pose: [0, 1, 0, 0, 0, 0]}], robots: []}
    const on = (name, ...point) => ({who: name && {address: name, object: {name}}, ground: !name, robot: null, point})
    const joining = new Joining()
    assert.equal(joining.click(on('door', 1, 1, 0.5)), false)
    assert.equal(joining.click(on('', 3, 0, 0)), true)
    assert.equal(joining.problem(world), '')
    assert.deepEqual(joining.values(world, 'Hinge', value => value), {second: 'door', x: '1', y: '1', z: '0.5'})
    assert.deepEqual(joining.values(world, 'Rope', value => value), {second: 'door', x: '3', y: '0', z: '0',
        endX: '1', endY: '1', endZ: '0.5', upper: '2.2913'})
    joining.second = 'wall'
    assert.match(joining.problem(world), /the world and wall are both fixed. Give one of them a mass/)
    assert.match(Object.assign(joining, {first: 'wall'}).problem(world), /needs two objects, and both are wall/)
})

test('two parts of one robot get a joint within it', () => {
    const part = name => ({name, type: 'Box', pose: [0, 0.5, 0, 0, 0, 0], corners: []})
    const robot = {name: 'rover', pose: [2, 0, 0, 0, 90, 0], parts: [part('body'), part('arm'),
        {name: 'left', type: 'Wheel'}]}
    const world = {objects: [], sensors: [], robots: [robot, {name: 'cart', pose: [0, 0, 0, 0, 0, 0], parts: []}],
        joints: [{name: 'elbow', robot: 'rover', second: 'arm', pose: [2, 1, 0, 0, 0, 0], end: [2, 1, 0, 0, 0, 0]}]}
    const on = (name, ...point) => ({who: {address: 'rover/' + name, robot: 'rover', object: {name}}, robot: 'rover',
        point})
    const joining = new Joining()
    assert.equal(joining.click(on('body', 2, 0.1, 0)), false)
    assert.equal(joining.click(on('arm', 3, 0.5, 0)), true)
    assert.equal(joining.problem(world), '')
    assert.equal(joining.robot(), 'rover')
    assert.deepEqual(joining.values(world, 'Hinge', value => value), {first: 'body', second: 'arm', x: '0', y: '0.5',
        z: '1'}, 'in the frame of the robot, which heads north')
    Object.assign(joining, {first: 'rover', points: {}})
    assert.deepEqual(joining.values(world, 'Slider', value => value), {second: 'arm', x: '0', y: '0.5', z: '0'})
    assert.match(Object.assign(joining, {second: 'rover', first: 'rover/arm'}).problem(world), /one of its parts/)
    assert.match(Object.assign(joining, {second: 'rover/arm'}).problem(world), /needs two objects/)
    Object.assign(joining, {first: 'cart', second: 'rover/arm'})
    assert.equal(joining.robot(), null)
    assert.deepEqual(joining.values(world, 'Hinge', value => value).second, 'rover')
    assert.deepEqual(ends(world), ['rover', 'cart', 'rover/body', 'rover/arm'])
    assert.deepEqual(pick(world, at => ({x: at[0], y: at[2]}), 2, 0).who.address, 'rover/elbow')
    assert.equal(find(world, 'rover/elbow').robot, robot)
    assert.equal(find(world, 'elbow'), null)
    const way = pointed([2, 1, 0, 0, 0, 0, 1], [3, 1, 0], false, find(world, 'rover').pose)
    assert.deepEqual(way, {rx: '90', ry: '0', rz: '0'}, 'forward')
})

test('an axis points where its handle is dragged, and a taut rope stays taut', () => {
    assert.deepEqual(anglesOf([0, 2, 0], 15), {rx: 0, rz: -0})
    assert.deepEqual(anglesOf([0, 0.1, 3], 15), {rx: 90, rz: 0})
    assert.deepEqual(anglesOf([1, 0.02, 0], 15), {rx: 0, rz: -90})
    const angles = anglesOf([0.2, 0.5, -0.4], 0)
    const tip = rotate(frame([0, 0, 0, angles.rx, 0, angles.rz]), [0, Math.hypot(0.2, 0.5, 0.4), 0])
    assert.deepEqual(tip.map(value => Number(value.toFixed(9))), [0.2, 0.5, -0.4])
    const rope = {x: '0', y: '2', z: '0', endX: '0', endY: '1', endZ: '0', upper: '1'}
    assert.deepEqual(tautened(rope, {endY: '0.5'}), {endY: '0.5', upper: '1.5'})
    assert.deepEqual(tautened(Object.assign({}, rope, {upper: '3'}), {endY: '0.5'}), {endY: '0.5'})
})
