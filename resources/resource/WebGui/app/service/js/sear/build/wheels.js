// SPDX-License-Identifier: Apache-2.0
// Positions of new wheels on robots, and which wheels motors can turn.
import {covers, extent, top} from '../world/pointing.js'
import {plain} from './places.js'

const GAP = 0.005             // metres between a wheel and the body
const HANGING = 0.018         // metres that an axle hangs below its file position, with the springs of new robots
const CLEARANCE = 0.04        // height of a body above the ground, where no ground is found, metres
const FARTHEST = 0.5          // maximum height of a body above its ground, metres
// Sides of a body in the order in which wheels get a default place: left, right, behind, front.
const SIDES = [[0, 1], [0, -1], [2, -1], [2, 1]]

function named(world, robot) {
    return world && world.robots.filter(one => one.name === robot)[0]
}
function isWheel(part) {
    return part.type === 'Wheel'
}

/** Returns the names of a robot's driven wheels. */
export function drivenWheels(world, robot) {
    const found = named(world, robot)
    return found ? found.parts.filter(part => part.driven).map(part => part.name) : []
}
/** Returns the first driven wheel without a motor; null if there is none. */
export function wheelToTurn(world, robot) {
    const found = named(world, robot)
    const free = found && found.parts.filter(part => part.driven && !part.motor)[0]
    return free ? free.name : null
}

/** Returns the height of the ground below a robot, in the world; null where none is found. */
function ground(world, robot) {
    const pose = robot.pose
    const below = world.objects.filter(object => !object.ground && object.$shape
        && covers(object, pose[0], pose[2])).map(top)
        .filter(height => height < pose[1] && height > pose[1] - FARTHEST)
    return below.length ? Math.max.apply(null, below) : null
}
/** Returns the lowest point of wheels in the robot's frame: that of its other wheels, else the ground. */
function lowest(world, robot, body) {
    const wheels = robot.parts.filter(isWheel)
    if (wheels.length) {
        return extent({parts: wheels})[0][1]
    }
    const below = ground(world, robot)
    return below === null ? body[0][1] - CLEARANCE : below - robot.pose[1] + HANGING
}

/**
 * Returns the place of a new wheel: beside the body's side nearest to a point, on the ground.
 * @param near a point in the robot's frame; null for the first side without a wheel @param size its radius and width,
 * metres
 * @param snapped see palette
 */
export function besideBody(world, name, near, size, snapped) {
    const robot = named(world, name)
    const parts = robot.parts.filter(part => !isWheel(part))
    const body = extent({parts: parts.length ? parts : robot.parts})
    function edge(side) {
        return body[side[1] > 0 ? 1 : 0][side[0]]
    }
    function placed(side, along) {
        const other = 2 - side[0]
        const at = [0, lowest(world, robot, body) + size.radius, 0]
        at[side[0]] = edge(side) + side[1] * (GAP + (side[0] === 0 ? size.width / 2 : size.radius))
        at[other] = Math.max(body[0][other], Math.min(body[1][other], along))
        return at
    }
    function isFree(at) {
        return robot.parts.filter(isWheel)
            .every(wheel => Math.hypot(wheel.pose[0] - at[0], wheel.pose[2] - at[2]) > 2 * size.radius)
    }
    let at
    if (near) {
        const nearest = SIDES.slice().sort((a, b) => Math.abs(edge(a) - near[a[0]]) - Math.abs(edge(b) - near[b[0]]))[0]
        at = placed(nearest, snapped(near[2 - nearest[0]]))
    } else {
        const all = SIDES.map(side => placed(side, 0))
        at = all.filter(isFree)[0] || all[0]
    }
    return {x: plain(at[0]), y: plain(at[1]), z: plain(at[2])}
}
