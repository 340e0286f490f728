// The values of a world that can be plotted, by name, and their units.
import {frame, rotate} from '../shared/geometry.js'

var PARTS = {x: 'm', y: 'm', z: 'm', heading: 'deg', speed: 'm/s', turnRate: 'rad/s'}
var ENDINGS = [[/ (speed|left|right) wanted$/, 'm/s'], [/ radius wanted$/, 'm'], [/ (received|sent)$/, 'bytes']]
/** What is measured so, for the title of an axis. */
var QUANTITIES = {'m': 'length', 'm/s': 'speed', 'deg': 'angle', 'rad/s': 'turning', 'm/s2': 'acceleration', 'bytes': 'serial port'}

/** All values of a world by their names. */
export function valuesOf(world) {
    var values = Object.create(null)    // sensors may be called as what every object has, constructor
    world.robots.forEach(function(robot) {
        var ahead = rotate(frame(robot.pose), [0, 0, 1])
        values[robot.name + '.x'] = robot.pose[0]
        values[robot.name + '.y'] = robot.pose[1]
        values[robot.name + '.z'] = robot.pose[2]
        values[robot.name + '.heading'] = Math.atan2(ahead[2], ahead[0]) * 180 / Math.PI
        values[robot.name + '.speed'] = robot.speed
        values[robot.name + '.turnRate'] = robot.turnRate
    })
    world.sensors.forEach(function(sensor) {
        sensor.names.forEach(function(name, i) {
            values[sensor.name + name] = sensor.numbers[i]
        })
    })
    return values
}

/** The unit of a sensor's number; a GPS has one for each. */
function unitOfNumber(sensor, i) {
    var units = (sensor.unit || '').split(', ')
    return units.length > 1 ? units[i] || '' : units[0]
}
/** The unit of a value, which may be a record's. @param world null for none; empty if it has none */
export function unitOf(name, world) {
    var unit
    angular.forEach(world && world.sensors, function(sensor) {
        var i = sensor.names.findIndex(ending => sensor.name + ending === name)
        unit = i >= 0 ? unitOfNumber(sensor, i) : unit
    })
    var ending = ENDINGS.filter(one => one[0].test(name))[0]
    return unit === undefined ? ending ? ending[1] : PARTS[name.slice(name.lastIndexOf('.') + 1)] || '' : unit
}
/** What stands beside an axis. @param names of what is drawn along it */
export function titleOf(names, unit) {
    var title = names.length === 1 ? names[0] : QUANTITIES[unit] || ''
    return title && unit ? title + ' (' + unit + ')' : title || unit
}

/** The same, no longer than there is room: names are cut in their middle, units are not. @param room pixels @param length of a text in pixels */
export function titleWithin(names, unit, room, length) {
    var title = titleOf(names, unit)
    for (var kept = names.length === 1 ? names[0].length - 1 : 0; kept > 1 && length(title) > room; kept--) {
        var first = Math.ceil(kept / 2)
        title = titleOf([names[0].slice(0, first) + '…' + names[0].slice(names[0].length - kept + first)], unit)
    }
    return title
}

/** With what a plot begins: the first robot's speed and its first sensor. @param names of what there is */
export function firstOf(world, names) {
    var robot = world && world.robots[0]
    var sensor = robot && world.sensors.filter(one => one.robot === robot.name && one.names.length)[0]
    return [robot && robot.name + '.speed', sensor && sensor.name + sensor.names[0]].filter(name => names.indexOf(name) >= 0)
}
