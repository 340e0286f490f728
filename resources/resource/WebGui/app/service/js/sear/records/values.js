// SPDX-License-Identifier: Apache-2.0
// Plottable values of a world, by name, and their units.
import {frame, rotate} from '../shared/geometry.js'

const PARTS = {x: 'm', y: 'm', z: 'm', heading: 'deg', speed: 'm/s', turnRate: 'rad/s'}
const ENDINGS = [[/ (speed|left|right) wanted$/, 'm/s'], [/ radius wanted$/, 'm'], [/ (received|sent)$/, 'bytes']]
/** Quantity of each unit, for axis titles. */
const QUANTITIES = {'m': 'length', 'm/s': 'speed', 'deg': 'angle', 'rad/s': 'turning', 'm/s2': 'acceleration',
    'bytes': 'serial port'}

// ticks of an axis outside of these have an exponent
const LARGEST_PLAIN = 1e6
const SMALLEST_PLAIN = 1e-3
const MOST_DECIMALS = 4

/** Returns everything in a world that has a reading: sensors and joints. */
function read(world) {
    return world.sensors.concat((world.joints || []).filter(joint => joint.numbers))
}

/** Returns all values of a world by name. */
export function valuesOf(world) {
    // a sensor may be named like a member of every object, for example constructor
    const values = Object.create(null)
    world.robots.forEach(robot => {
        const ahead = rotate(frame(robot.pose), [0, 0, 1])
        values[robot.name + '.x'] = robot.pose[0]
        values[robot.name + '.y'] = robot.pose[1]
        values[robot.name + '.z'] = robot.pose[2]
        values[robot.name + '.heading'] = Math.atan2(ahead[2], ahead[0]) * 180 / Math.PI
        values[robot.name + '.speed'] = robot.speed
        values[robot.name + '.turnRate'] = robot.turnRate
    })
    read(world).forEach(sensor => {
        sensor.names.forEach((name, i) => {
            values[sensor.name + name] = sensor.numbers[i]
        })
    })
    return values
}

/** Returns the unit of a sensor's n-th number; a GPS has one per number. */
function unitOfNumber(sensor, i) {
    const units = (sensor.unit || '').split(', ')
    return units.length > 1 ? units[i] || '' : units[0]
}
/** Returns the unit of a value, possibly of a record; empty if it has none. @param world null for none */
export function unitOf(name, world) {
    let unit
    ;(world ? read(world) : []).forEach(sensor => {
        const i = sensor.names.findIndex(ending => sensor.name + ending === name)
        unit = i >= 0 ? unitOfNumber(sensor, i) : unit
    })
    const ending = ENDINGS.filter(one => one[0].test(name))[0]
    return unit === undefined ? ending ? ending[1] : PARTS[name.slice(name.lastIndexOf('.') + 1)] || '' : unit
}
/** Returns an axis title. @param names of the lines on that axis */
export function titleOf(names, unit) {
    const title = names.length === 1 ? names[0] : QUANTITIES[unit] || ''
    return title && unit ? title + ' (' + unit + ')' : title || unit
}

/**
 * Returns an axis title no longer than the available length. Names are shortened in the middle, units are not.
 * @param room available pixels @param length returns a text's length in pixels
 */
export function titleWithin(names, unit, room, length) {
    let title = titleOf(names, unit)
    for (let kept = names.length === 1 ? names[0].length - 1 : 0; kept > 1 && length(title) > room; kept--) {
        const first = Math.ceil(kept / 2)
        title = titleOf([names[0].slice(0, first) + '…' + names[0].slice(names[0].length - kept + first)], unit)
    }
    return title
}

/**
 * Returns the first values of a new plot: the first robot's speed and its first sensor.
 * @param names available names
 */
export function firstOf(world, names) {
    const robot = world && world.robots[0]
    const sensor = robot && world.sensors.filter(one => one.robot === robot.name && one.names.length)[0]
    return [robot && robot.name + '.speed', sensor && sensor.name + sensor.names[0]]
    .filter(name => names.indexOf(name) >= 0)
}

/** Returns the number of decimals of a step between ticks: 2 for 0.25, -2 for 500. */
function decimals(step) {
    let count = -Math.floor(Math.log10(step))
    while (Math.abs(step * Math.pow(10, count) - Math.round(step * Math.pow(10, count))) > 1e-6) {
        count++
    }
    return count
}

/** Returns the texts of an axis' ticks, which all differ. @param step between ticks */
export function tickTexts(ticks, step) {
    const most = Math.max(...ticks.map(Math.abs))
    const count = decimals(step)
    if (most < LARGEST_PLAIN && (count <= MOST_DECIMALS || most >= SMALLEST_PLAIN)) {
        return ticks.map(tick => (tick === 0 ? 0 : tick).toFixed(Math.max(0, count)))
    }
    return ticks.map(tick => {
        const exponent = Number(tick.toExponential().split('e')[1])
        return tick === 0 ? '0' : tick.toExponential(Math.max(0, count + exponent))
    })
}
