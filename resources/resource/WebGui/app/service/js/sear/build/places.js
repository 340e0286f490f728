// SPDX-License-Identifier: Apache-2.0
// Where an object is, in the numbers of its file: those written there, or, once a running simulation has moved it,
// those that would start it at its present place.
import * as geometry from '../shared/geometry.js'
import {isJoint} from '../world/pointing.js'

const AXES = ['x', 'y', 'z']
const ANGLES = ['rx', 'ry', 'rz']
const MOVED = 0.01            // metres: within this distance an object is where its file says, apart from its springs
const TURNED = 1              // degrees, likewise
const FINEST = 1e4            // a tenth of a millimetre
const NORTH = 90              // degrees about y of the direction north

/** Formats a number for a file, rounded. */
export function plain(number) {
    return String(Math.round(number * FINEST) / FINEST)
}
function numbers(values, names) {
    return names.map(name => Number(values[name]) || 0)
}
/** Wraps an angle to half a turn to either side. */
export function wrapped(degrees) {
    return degrees - 360 * Math.round(degrees / 360)
}
/** Returns a frame's heading, degrees about y. */
function heading(frame) {
    const ahead = geometry.rotate(frame, [0, 0, 1])
    return Math.atan2(ahead[0], ahead[2]) * 180 / Math.PI
}
/** Returns the angle between two rotations, degrees. */
function between(a, b) {
    let cosine = 0
    for (let i = 3; i < 7; i++) {
        cosine += a[i] * b[i]
    }
    return 2 * Math.acos(Math.min(1, Math.abs(cosine))) * 180 / Math.PI
}

/**
 * Returns where an object is.
 * @param selected see pointing.find @param values of its file @param live whether a running simulation moves it
 * @return at [x, y, z] and ry in degrees, as its file has them or should have them; strayed: what the file must also
 * set when the object is moved; onGround, onEarth, headed: how its file gives its place; moves: whether a running
 * simulation moves it; stands: whether its height comes from what is below it
 */
export function of(selected, values, live) {
    const headed = values.placeHeading !== undefined
    const onEarth = values.placeLatitude !== undefined
    const place = {at: numbers(values, AXES), ry: headed ? NORTH - Number(values.placeHeading) : Number(values.ry) || 0,
        strayed: {}, headed,
        onEarth, onGround: onEarth || values.onGround === 'true', stands: false,
        moves: Boolean(live && selected && !selected.robot && !isJoint(selected.object))}
    if (place.moves) {
        (selected.object.parts ? robot : thing)(place, selected.object, values)
    } else if (selected && onEarth) {
        stray(place, selected.object.pose)
    }
    return place
}
/** Records that the object is not where its file says. */
function stray(place, at) {
    AXES.forEach((axis, i) => {
        const fixed = axis === 'y' && (place.onGround || place.stands)
        if (!fixed && (place.onEarth || Math.abs(at[i] - place.at[i]) > MOVED)) {
            place.strayed[axis] = plain(at[i])
        }
    })
    place.at = at.slice(0, 3)
}
function thing(place, object, values) {
    const file = [0, 0, 0].concat(numbers(values, ANGLES))
    if (between(geometry.frame(file), geometry.frame(object.pose)) > TURNED) {
        ANGLES.forEach((angle, i) => {
            place.strayed[angle] = plain(object.pose[3 + i])
        })
        place.ry = object.pose[4]
    }
    stray(place, object.pose)
}
/**
 * Adds the movement and rotation since the start to the robot's start values, because its Dynamics may shift the start
 * pose.
 */
function robot(place, object) {
    const start = geometry.frame(object.start)
    const now = geometry.frame(object.pose)
    const turned = wrapped(heading(now) - heading(start))
    const ry = wrapped(place.headed ? heading(now) : object.written[4] + turned)
    const apart = geometry.rotate(geometry.frame([0, 0, 0, 0, turned, 0]),
        AXES.map((axis, i) => place.onGround ? 0 : object.written[i] - start[i]))
    place.stands = true
    stray(place, apart.map((value, i) => value + now[i]))
    if (Math.abs(wrapped(ry - place.ry)) > TURNED) {
        place.ry = ry
        place.strayed[place.headed ? 'placeHeading' : 'ry'] = plain(place.headed ? wrapped(NORTH - ry) : ry)
    }
}

/** Returns the values that an edit sets. @param place see of @param set the user's changes: x, y, z, ry, sizes */
export function edit(place, set) {
    const stays = !place.moves && AXES.every(axis => set[axis] === undefined)
    const all = Object.assign({}, stays ? {} : place.strayed, set)
    if (set.ry !== undefined && place.headed) {
        delete all.ry
        all.placeHeading = plain(wrapped(NORTH - Number(set.ry)))
    }
    if (place.onEarth && all.x !== undefined && all.y === undefined) {
        all.onGround = 'true'
    }
    return all
}
