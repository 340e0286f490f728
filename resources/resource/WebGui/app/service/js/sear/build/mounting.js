// Where parts of robots and whole robots are put.
import {plain} from './places.js'

var FLOOR = '20'            // metres: side of the floor that a robot gets where there is no ground
var UPRIGHT = 0.7           // a surface whose normal is less steep than this is a side
var TURN = 15               // degrees
var TILT = '-20'            // degrees about x, upwards: the widest beam that comes with SEAR sees no ground then, but what is ahead

/** The edit that makes a robot, and ground for it in a world that has none. */
export function withGround(edit, world) {
    var ground = world && world.objects.some(object => object.type === 'Floor' || object.ground || object.terrain)
    return ground ? edit : {'do': 'all', edits: [{'do': 'add', type: 'Floor', set: {length: FLOOR, width: FLOOR}}, edit]}
}
/**
 * Where a part of a robot is put: at a point of its body, snapped along the surface only; what has beams looks away from a side.
 * @param at what was met, see pointing @param type its class @param free whether it does not snap @param snapped see palette
 */
export function mounted(at, type, free, snapped) {
    var set = {}
    ;['x', 'y', 'z'].forEach(function(axis, i) {
        var along = axis !== 'y' && !(at.normal && Math.abs(at.normal[i]) > UPRIGHT / 2)
        set[axis] = plain(along ? snapped(at.local[i], free) : at.local[i])
    })
    if (at.normal && Math.abs(at.normal[1]) < UPRIGHT && hasBeams(type)) {
        var degrees = Math.atan2(at.normal[0], at.normal[2]) * 180 / Math.PI
        set.ry = plain(free ? degrees : Math.round(degrees / TURN) * TURN)
    }
    return set
}
/** What has cones looks over the ground, for else it would tell of nothing but that. */
export function tilted(type) {
    return hasBeams(type) && type.parameters.some(parameter => parameter.name === 'cone') ? {rx: TILT} : {}
}
function hasBeams(type) {
    return Boolean(type) && type.parameters.some(parameter => parameter.name === 'seesOwnRobot')
}
