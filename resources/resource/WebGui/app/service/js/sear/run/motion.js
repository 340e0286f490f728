// SPDX-License-Identifier: Apache-2.0
// Motion that a shared run adds to its record: wheel and servo rotations and sensor readings, in the form of the Java
// class RecordMotion.
import * as geometry from '../shared/geometry.js'

var NOTHING = 65535         // a beam without a hit
var CENTIMETRES = 100

function unpacked(text) {
    var bytes = window.atob(text)
    var ranges = []
    for (var i = 0; i < bytes.length; i += 2) {
        var range = bytes.charCodeAt(i) + 256 * bytes.charCodeAt(i + 1)
        ranges.push(range === NOTHING ? null : range / CENTIMETRES)
    }
    return ranges
}
/** Interpolates poses between two frames; null without poses. */
function between(a, b, share, seconds) {
    return a && a.map((pose, i) => geometry.between(geometry.frame(pose), geometry.frame(b[i]), share, seconds))
}

/** @param sent as the service sends it @param world whose robots move, and which gets the sensors */
export function makeMotion(sent, world) {
    var robots = sent.robots.map(name => world.robots.filter(robot => robot.name === name)[0])
    var shown = -1

    world.sensors = sent.sensors.map(function(sensor, i) {
        var own = Object.assign({}, sensor)
        if (sent.frames.some(frame => frame.hits[i])) {
            own.hit = null
        }
        if (own.fan) {
            own.ranges = []
        }
        return own
    })
    /** Shows all as at a time. */
    function show(time) {
        var at = 0
        while (at < sent.frames.length - 1 && sent.frames[at + 1].time <= time) {
            at++
        }
        var now = sent.frames[at]
        var next = sent.frames[Math.min(sent.frames.length - 1, at + 1)]
        var seconds = next.time - now.time
        var share = seconds > 0 ? Math.max(0, Math.min(1, (time - now.time) / seconds)) : 0
        robots.forEach(function(robot, i) {
            if (robot) {
                robot.wheels = between(now.wheels[i], next.wheels[i], share, seconds)
                robot.turned = between(now.turned[i], next.turned[i], share, seconds)
                robot.turnedLeds = between(now.leds[i], next.leds[i], share, seconds)
            }
        })
        var poses = between(now.poses, next.poses, share, seconds)
        world.sensors.forEach(function(sensor, i) {
            sensor.pose = poses[i]
            if (sensor.hit !== undefined) {
                sensor.hit = now.hits[i]
            }
            if (sensor.fan && shown !== at) {
                sensor.ranges = unpacked(now.ranges[i])
            }
        })
        shown = at
    }
    return {show}
}
