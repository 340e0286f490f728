// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict'
import {test} from 'node:test'
import {metresBetween, offsetText, plotOf, timeText} from
    '../../../resources/resource/WebGui/app/service/js/sear/gps/track.js'
import * as plot from '../../../resources/resource/WebGui/app/service/js/sear/lidar/plot.js'
import {robotsAt, sensorsAt} from '../../../resources/resource/WebGui/app/service/js/sear/records/frames.js'
import {csv, valueAt} from '../../../resources/resource/WebGui/app/service/js/sear/records/table.js'
import {firstOf, tickTexts, titleWithin, unitOf, valuesOf} from
    '../../../resources/resource/WebGui/app/service/js/sear/records/values.js'
import {drive, isFixed} from '../../../resources/resource/WebGui/app/service/js/sear/run/steering.js'
import {Messages} from '../../../resources/resource/WebGui/app/service/js/sear/shared/messages.js'
import {count, fileName} from '../../../resources/resource/WebGui/app/service/js/sear/shared/words.js'
import {rangesOf, unpackRanges} from '../../../resources/resource/WebGui/app/service/js/sear/world/ranges.js'
import {Terrain} from '../../../resources/resource/WebGui/app/service/js/sear/world/terrain.js'

const SCAN = {angles: [0, 90, 180], metres: [null, 2.5, 1], raw: [8183, 2500, 1000], unit: 'mm', spread: 180,
    resolution: 90}

test('the plot of a scan has round rings beyond the farthest object, and shrinks only if much is empty', () => {
    assert.equal(plot.reachOf(SCAN, 0), 2.5)
    assert.equal(plot.reachOf(SCAN, 4), 4)
    assert.equal(plot.reachOf(SCAN, 8), 2.5)
    assert.deepEqual([1, 2.5, 8, 80, 500].map(plot.ringStep), [0.25, 0.5, 2, 20, 20])
})

test('0 degrees are to the right, 90 ahead, and the labels fit beside the plot', () => {
    const geometry = plot.geometryOf(600, 300, SCAN, 4)
    assert.deepEqual([geometry.x, geometry.y, geometry.reach, geometry.full], [300, 272, 4, false])
    const right = plot.point(geometry, 4, 0)
    const ahead = plot.point(geometry, 2, 90)
    assert.deepEqual([right.x, right.y], [geometry.x + geometry.radius, geometry.y])
    assert.ok(Math.abs(ahead.x - geometry.x) < 1e-9 && Math.abs(ahead.y - geometry.y + geometry.radius / 2) < 1e-9)
    const narrow = plot.geometryOf(368, 600, null, 0)
    assert.ok(narrow.x - narrow.radius > 40)
    assert.deepEqual([narrow.reach, narrow.full], [8, false])
})

test('a scan of a whole circle has its sensor in the middle', () => {
    const geometry = plot.geometryOf(600, 600, {spread: 360}, 8)
    assert.deepEqual([geometry.y, geometry.full], [300, true])
})

test('the beam at a pixel is found and described', () => {
    const geometry = plot.geometryOf(600, 300, SCAN, 4)
    const ahead = plot.point(geometry, 1, 85)
    assert.equal(plot.beamAt(geometry, SCAN, ahead.x, ahead.y), 1)
    assert.equal(plot.beamAt(geometry, SCAN, geometry.x, geometry.y + 50), null)
    assert.deepEqual([0, 1].map(i => plot.beamText(SCAN, i)), ['0°: no return (8183)', '90°: 2.5 m (2500 mm)'])
    assert.equal(plot.csv(SCAN), 'angle_deg,raw_mm,metres\r\n0,8183,\r\n90,2500,2.5\r\n180,1000,1\r\n')
})

test('positions on Earth are metres to the east and north, also over the date line', () => {
    const [east, north] = metresBetween([0, 179.9999], [0.0001, -179.9999])
    assert.ok(Math.abs(east - 22.26) < 0.01 && Math.abs(north - 11.06) < 0.01)
    assert.ok(Math.abs(metresBetween([60, 0], [60, 1])[0] - 55800) < 10)
})

test('a track is drawn to a round scale', () => {
    const drawn = plotOf([[0, 0], [3, -12]])
    assert.deepEqual(drawn, {reach: 20, points: '0.00,0.00 6.75,27.00', last: [6.75, 27]})
    assert.equal(offsetText([[0, 0], [3, -12]]), '3.00 m east, 12.00 m south')
    assert.deepEqual([offsetText([]), timeText('121530.25'), timeText(null)], ['–', '12:15:30.25 UTC', '–'])
})

test('robots are driven according to their steering', () => {
    const turning = {name: 'a', turns: true}
    assert.deepEqual(drive(turning, [1, 0], 0.2), [['driveStraight', 'a', 0.2]])
    assert.deepEqual(drive(turning, [0, 1], 0.2), [['drive', 'a', 0.2, 0]])
    assert.deepEqual(drive(turning, [1, -1], 0.2), [['drive', 'a', 0.2, -0.3]])
    const car = {name: 'c', steered: {straight: 0, left: 30, right: -25}}
    assert.deepEqual(drive(car, [1, -1], 0.2), [['setSteering', 'c', -25], ['driveStraight', 'c', 0.2]])
    car.steered.servo = 's'
    assert.deepEqual(drive(car, [0, 0.5], 0.2)[0], ['setServo', 's', 15])
    assert.ok(isFixed({name: 'm'}) && !isFixed(car))
    assert.deepEqual(drive({name: 'm'}, [1, 1], 0.2), [['driveStraight', 'm', 0.2]])
})

const WORLD = {
    robots: [{name: 'rover', pose: [1, 0, 2, 0, 90, 0], speed: 0.2, turnRate: 0}],
    sensors: [{name: 'ping', robot: 'rover', names: ['.distance'], numbers: [1.5], unit: 'm'},
        {name: 'gps', robot: 'rover', names: ['.latitude', '.altitude'], numbers: [50, 100], unit: 'deg, m'}]
}

test('values of a world have names and units', () => {
    const values = valuesOf(WORLD)
    assert.deepEqual([values['rover.z'], values['ping.distance'], values['gps.altitude']], [2, 1.5, 100])
    assert.ok(Math.abs(values['rover.heading']) < 1e-9)
    assert.deepEqual(['gps.altitude', 'rover.speed', 'port sent', 'other'].map(name => unitOf(name, WORLD)),
        ['m', 'm/s', 'bytes', ''])
    assert.equal(unitOf('rover.x', null), 'm')
    assert.deepEqual(firstOf(WORLD, Object.keys(values)), ['rover.speed', 'ping.distance'])
    assert.deepEqual(firstOf(null, []), [])
})

test('a long name leaves its unit beside the axis', () => {
    const length = text => text.length
    assert.equal(titleWithin(['a.speed'], 'm/s', 30, length), 'a.speed (m/s)')
    const title = titleWithin(['the vacuum cleaner of the living room upstairs.speed'], 'm/s', 30, length)
    assert.ok(title.length <= 30 && title.startsWith('the v') && title.endsWith('.speed (m/s)')
        && title.includes('…'), title)
    assert.equal(titleWithin(['a', 'b'], 'm/s', 30, length), 'speed (m/s)')
})

test('plotted lines are a table in which equal times are one column', () => {
    const times = [0, 1]
    assert.equal(csv([{name: 'a', unit: 'm', times, values: [1, 2]}, {name: 'b,c', times, values: [3]},
        {name: 'a', source: 'r', times: [0], values: [null]}]),
            'time (s),a (m),"b,c",time (s) r,a r\n0,1,3,0,\n1,2,,,\n')
    assert.deepEqual([-1, 0, 0.5, 9].map(time => valueAt({times, values: [1, 2]}, time)), [undefined, 1, 1, 2])
})

test('a frame of a record sets poses, paths and readings', () => {
    const record = {robots: ['rover'], robotPoses: [[[0, 0, 0]], [[1, 0, 2]]], speeds: [[[0, 0]], [[0.2, 1]]],
        lights: [[0, 1]],
        brightness: [[0], [1]], sensors: ['ping'], words: [['near'], ['far']]}
    const rover = {lights: [0, 0]}
    robotsAt({rover}, record, 1)
    assert.deepEqual([rover.speed, rover.path, rover.lights], [0.2, [[0, 0], [1, 2]], [0, 1]])
    assert.deepEqual(sensorsAt([{name: 'ping'}, {name: 'gps'}], record, 1).map(sensor => sensor.words),
        ['far', 'not in the record'])
})

function packed(...numbers) {
    return btoa(String.fromCharCode(...new Uint8Array(Uint16Array.from(numbers).buffer)))
}

test('ranges are multiples of the first number; the largest is no return', () => {
    const ranges = rangesOf(packed(20, 100, 65535))
    assert.ok(Math.abs(ranges[0] - 0.2) < 1e-12)
    assert.equal(ranges[1], null)
    const changes = {3: {ranges: packed(10000, 2)}, 4: {}}
    unpackRanges(changes)
    assert.deepEqual(changes, {3: {ranges: [2]}, 4: {}})
})

test('repeated messages are counted, and repetitions of a failed call are dropped', () => {
    const messages = new Messages()
    messages.say('info', 'a')
    messages.say('info', 'a')
    assert.deepEqual([messages.list.length, messages.list[0].times, messages.unread], [1, 2, 1])
    messages.take({level: 'error', key: 'no such port'})
    messages.take({level: 'error', key: 'could not invoke connect'})
    assert.equal(messages.last.text, 'no such port')
    messages.take({level: 'error', key: 'could not invoke connect'})
    assert.equal(messages.last.text, 'could not invoke connect')
    messages.settle(messages.last)
    assert.equal(messages.last, null)
    for (let i = 0; i < 200; i++) {
        messages.say('info', 'message ' + i)
    }
    assert.deepEqual([messages.list.length, messages.unread], [100, 100])
})

test('words', () => {
    assert.deepEqual([count(1, 'problem'), count(2, 'problem'), fileName('a/b\\c.sear')],
        ['1 problem', '2 problems', 'c.sear'])
})

/** Returns a slope that rises by 10 m per 100 m to the north, 100 m wide. */
function slope() {
    globalThis.window = {Image: class { }}
    return new Terrain({rows: 3, columns: 3, south: -50, north: 50, west: -50, east: 50, lowest: 0, highest: 10,
        altitude: 200,
        heights: packed(0, 0, 0, 32768, 32768, 32768, 65535, 65535, 65535)}, () => {})
}

test('the ground has its heights, and none outside its area', () => {
    const ground = slope()
    assert.ok(Math.abs(ground.height(25, 0) - 7.5) < 1e-3)
    assert.equal(ground.height(51, 0), null)
    assert.equal(ground.words(51, 0), '')
    assert.equal(ground.words(0, 0), 'here 5.0 m')
})

test('contour lines have round heights at every zoom, and lie where the ground has them', () => {
    const ground = slope()
    for (const scale of [0.5, 2, 8, 40]) {
        const half = 50 / Math.max(1, scale / 4)
        const {interval, lines} = ground.contours({south: -half, north: half, west: -half, east: half}, scale)
        assert.ok(lines.length > 10)
        const digit = interval / Math.pow(10, Math.floor(Math.log10(interval) + 1e-9))
        assert.ok([1, 2, 5].some(round => Math.abs(digit - round) < 1e-6), 'interval ' + interval)
        lines.forEach(line => assert.ok(Math.abs(ground.height(line[1], line[2]) + 200 - line[0] * interval) < 0.02))
    }
})

test('the labels of an axis never repeat, however small its steps', () => {
    assert.deepEqual(tickTexts([-0.5, 0, 0.25], 0.25), ['-0.50', '0.00', '0.25'])
    assert.deepEqual(tickTexts([0, 500, 1000], 500), ['0', '500', '1000'])
    assert.deepEqual(tickTexts([0.5, 0.5001, 0.5002], 1e-4), ['0.5000', '0.5001', '0.5002'])
    assert.deepEqual(tickTexts([-2e-6, 0, 2e-6], 2e-6), ['-2e-6', '0', '2e-6'])
    assert.deepEqual(tickTexts([7.5e-6, 1e-5, 1.25e-5], 2.5e-6), ['7.5e-6', '1.00e-5', '1.25e-5'])
    assert.deepEqual(tickTexts([0, 5e6, 1.5e7], 5e6), ['0', '5e+6', '1.5e+7'])
    for (let exponent = -9; exponent < 9; exponent++) {
        [1, 2, 2.5, 5].map(part => part * Math.pow(10, exponent)).forEach(step => [0, 3, 1000].forEach(from => {
            const texts = tickTexts([0, 1, 2, 3, 4].map(i => (from + i) * step), step)
            assert.equal(new Set(texts).size, texts.length, texts.join(' '))
        }))
    }
})
