// SPDX-License-Identifier: Apache-2.0
// Motion that a shared run adds to its record: wheel and servo rotations and sensor readings, in the form of the Java
// class RecordMotion.
import * as geometry from '../shared/geometry.js'

const NOTHING = 65535         // a beam without a hit
const CENTIMETRES = 100

function unpacked(text) {
    const bytes = atob(text)
    const ranges = []
    for (let i = 0; i < bytes.length; i += 2) {
        const range = bytes.charCodeAt(i) + 256 * bytes.charCodeAt(i + 1)
        ranges.push(range === NOTHING ? null : range / CENTIMETRES)
    }
    return ranges
}
/** Interpolates poses between two frames; null without poses. */
function between(a, b, share, seconds) {
    return a && a.map((pose, i) => geometry.between(geometry.frame(pose), geometry.frame(b[i]), share, seconds))
}

/** Motion of the robots and sensors of one world. */
export class Motion {
    /** @param sent as the service sends it @param world whose robots move, and which gets the sensors */
    constructor(sent, world) {
        this.sent = sent
        this.robots = sent.robots.map(name => world.robots.filter(robot => robot.name === name)[0])
        this.shown = -1         // index of the frame
        this.sensors = world.sensors = sent.sensors.map((sensor, i) => {
            const own = Object.assign({}, sensor)
            if (sent.frames.some(frame => frame.hits[i])) {
                own.hit = null
            }
            if (own.fan) {
                own.ranges = []
            }
            return own
        })
    }

    /** Shows all as at a time. */
    show(time) {
        const frames = this.sent.frames
        let at = 0
        while (at < frames.length - 1 && frames[at + 1].time <= time) {
            at++
        }
        const now = frames[at]
        const next = frames[Math.min(frames.length - 1, at + 1)]
        const seconds = next.time - now.time
        const share = seconds > 0 ? Math.max(0, Math.min(1, (time - now.time) / seconds)) : 0
        this.robots.forEach((robot, i) => {
            if (robot) {
                robot.wheels = between(now.wheels[i], next.wheels[i], share, seconds)
                robot.turned = between(now.turned[i], next.turned[i], share, seconds)
                robot.turnedLeds = between(now.leds[i], next.leds[i], share, seconds)
            }
        })
        const poses = between(now.poses, next.poses, share, seconds)
        this.sensors.forEach((sensor, i) => {
            sensor.pose = poses[i]
            if (sensor.hit !== undefined) {
                sensor.hit = now.hits[i]
            }
            if (sensor.fan && this.shown !== at) {
                sensor.ranges = unpacked(now.ranges[i])
            }
        })
        this.shown = at
    }
}
