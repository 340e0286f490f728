// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict'
import {readFileSync} from 'node:fs'
import {test} from 'node:test'
import {area, between, frame, isLight, onGround, shapesOf, times} from
    '../../../resources/resource/WebGui/app/service/js/sear/shared/geometry.js'
import {alongAxis, contains, extent, find, onMap, onPlane} from
    '../../../resources/resource/WebGui/app/service/js/sear/world/pointing.js'

const CUBE = [-1, 1].flatMap(x => [-1, 1].flatMap(y => [-1, 1].map(z => [x, y, z])))
const WORLD = {
    objects: [{name: 'floor', type: 'Floor', pose: [0, -1, 0, 0, 0, 0],
        corners: CUBE.map(([x, y, z]) => [9 * x, y, 9 * z])},
        {name: 'crate', type: 'Box', color: 'red', pose: [3, 1, 0, 0, 45, 0], corners: CUBE}],
    robots: [{name: 'rover', pose: [-3, 0, 2, 0, 90, 0], radius: 0.5,
        parts: [{name: 'body', type: 'Box', pose: [0, 0.5, 0, 0, 0, 0], corners: CUBE}]}],
    sensors: [{name: 'rover/ping', robot: 'rover', pose: [-3, 0, 3, 0, 0, 0]}]
}

function same(actual, wanted, tolerance = 1e-9) {
    assert.equal(actual.length, wanted.length)
    actual.forEach((value, i) => assert.ok(Math.abs(value - wanted[i]) <= tolerance, actual + ' instead of ' + wanted))
}

test('frames, products and interpolated poses are those of the Java classes Pose and Movement', () => {
    const all = JSON.parse(readFileSync(new URL('../resources/poses.json', import.meta.url)))
    assert.ok(all.length >= 20)
    all.forEach(one => {
        const a = frame(one.a)
        const b = frame(one.b)
        same(a, one.frame, 1e-12)
        same(times(a, b), one.times, 1e-12)
        same(between(a, b, one.share, one.seconds), one.between, 1e-12)
    })
})

test('a turned cube has a turned outline, and floors lie below all other shapes', () => {
    const shapes = shapesOf(WORLD)
    assert.deepEqual(shapes.map(shape => Boolean(shape.ground)), [true, false, false])
    same(shapes[1].outline.map(point => point[0]).sort((a, b) => a - b), [3 - Math.SQRT2, 3, 3, 3 + Math.SQRT2])
    const all = area(shapes)
    same([all.north, all.east], [4 + 3 + Math.SQRT2, 3 + Math.SQRT2])
    assert.equal(area([]), null)
})

test('walls cover only their areas', () => {
    const strip = side => [[-2, 1, side], [2, 1, side], [2, 1, side + 0.1], [-2, 1, side + 0.1]]
    const walls = {name: 'maze', type: 'Maze', pose: [0, 0, 0, 0, 90, 0], areas: [strip(-2), strip(1.9)],
        corners: CUBE.map(([x, y, z]) => [2 * x, y, 2 * z])}
    const world = {objects: [walls], robots: []}
    assert.equal(onMap(world, 0, 0).who, null)
    assert.equal(onMap(world, 1.95, 0).who.address, 'maze')
    assert.equal(onMap(world, 0, 1.95).who, null)
})

test('a point ahead of a robot that faces east is east of it', () => {
    same(onGround(frame([1, 0, 2, 0, 0, 0]), [0, 0, 3]), [1, 5])
    same(onGround(frame([1, 0, 2, 0, 90, 0]), [0, 0, 3]), [4, 2])
})

test('a light text colour means a dark theme', () => {
    assert.deepEqual(['rgb(51, 51, 51)', 'rgb(230, 230, 230)', 'none'].map(isLight), [false, true, false])
})

test('rays meet planes ahead of them only', () => {
    same(onPlane({from: [0, 2, 0], along: [0, -1, 0]}, [5, 1, 5], [0, 1, 0]), [0, 1, 0])
    assert.equal(onPlane({from: [0, 2, 0], along: [0, 1, 0]}, [5, 1, 5], [0, 1, 0]), null)
    assert.equal(alongAxis({from: [2, 5, 0], along: [0, -1, 0]}, [0, 0, 0], [1, 0, 0]), 2)
})

test('an outline contains the points inside it', () => {
    const square = [[0, 0], [2, 0], [2, 2], [0, 2]]
    assert.deepEqual([contains(square, 1, 1), contains(square, 3, 1), contains(square, 1, -1)], [true, false, false])
})

test('selections are found by their address', () => {
    assert.equal(find(WORLD, 'crate').object.name, 'crate')
    same(find(WORLD, 'rover/body').pose.slice(0, 3), [-3, 0.5, 2])
    assert.equal(find(WORLD, 'rover/ping').robot.name, 'rover')
    assert.deepEqual([find(WORLD, 'rover/none'), find(WORLD, 'none'), find(null, 'crate')], [null, null, null])
})

test('a click on the map hits a robot, else the highest object, else the ground', () => {
    assert.equal(onMap(WORLD, -3, 2.1).robot, 'rover')
    assert.deepEqual([onMap(WORLD, 3, 0).who.address, onMap(WORLD, 3, 0).point], ['crate', [3, 2, 0]])
    assert.equal(onMap(WORLD, 0, -5).who.address, 'floor')
    assert.equal(onMap(WORLD, 50, 0).who, null)
})

test('the extent of a robot is that of all its parts; of an object without shape, a few centimetres', () => {
    assert.deepEqual(extent(WORLD.robots[0]), [[-1, -0.5, -1], [1, 1.5, 1]])
    assert.deepEqual(extent({}), [[-0.02, -0.02, -0.02], [0.02, 0.02, 0.02]])
})
