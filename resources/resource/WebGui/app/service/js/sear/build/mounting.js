// SPDX-License-Identifier: Apache-2.0
// Initial positions of robots and their parts.
import {plain} from './places.js'

const FLOOR = '20'            // side of the floor added to a world without ground, metres
const UPRIGHT = 0.7           // a surface whose normal has a smaller vertical component is a side
const TURN = 15               // degrees
const TILT = '-20'            // degrees about x, upwards: SEAR's widest beam then sees obstacles ahead, but no ground

/** Returns the edit that makes a robot or a thing; in a world without ground it also adds a floor. */
export function withGround(edit, world) {
    const ground = world && world.objects.some(object => object.type === 'Floor' || object.ground || object.terrain)
    return ground ? edit : {'do': 'all',
        edits: [{'do': 'add', type: 'Floor', set: {length: FLOOR, width: FLOOR}}].concat(edit.edits || edit)}
}
/**
 * Returns the mounting position of a robot's part at a point of its body, snapped along the surface only. A part with
 * beams faces away from a side.
 * @param at see pointing @param type its class @param free whether it does not snap @param snapped see palette
 */
export function mounted(at, type, free, snapped) {
    const set = {}
    ;['x', 'y', 'z'].forEach((axis, i) => {
        const along = axis !== 'y' && !(at.normal && Math.abs(at.normal[i]) > UPRIGHT / 2)
        set[axis] = plain(along ? snapped(at.local[i], free) : at.local[i])
    })
    if (at.normal && Math.abs(at.normal[1]) < UPRIGHT && hasBeams(type)) {
        const degrees = Math.atan2(at.normal[0], at.normal[2]) * 180 / Math.PI
        set.ry = plain(free ? degrees : Math.round(degrees / TURN) * TURN)
    }
    return set
}
/** Returns the tilt of a part: cones look above the ground, as they would otherwise detect only the ground. */
export function tilted(type) {
    return hasBeams(type) && type.parameters.some(parameter => parameter.name === 'cone') ? {rx: TILT} : {}
}
function hasBeams(type) {
    return Boolean(type) && type.parameters.some(parameter => parameter.name === 'seesOwnRobot')
}
