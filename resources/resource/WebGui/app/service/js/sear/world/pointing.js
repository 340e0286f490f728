// SPDX-License-Identifier: Apache-2.0
// Picking for building, the same for the 3D view and the map.
import * as geometry from '../shared/geometry.js'

const FAR = 2000              // metres: maximum distance of placed objects

export function back(pose, v) {
    return geometry.rotate([0, 0, 0, -pose[3], -pose[4], -pose[5], pose[6]], v)
}
/** Converts a point of the world to a frame. */
export function local(pose, point) {
    return back(pose, [point[0] - pose[0], point[1] - pose[1], point[2] - pose[2]])
}

/** Whether an object of a world is a joint. */
export function isJoint(object) {
    return object.second !== undefined
}

/** Returns the name of a part, sensor or joint without its robot's name. */
export function short(name) {
    return name.slice(name.indexOf('/') + 1)
}

/**
 * Returns the object of the world that a scene source belongs to: {address, robot (its name or null), object}; null for
 * none.
 */
function whose(world, source) {
    if (!source) {
        return null
    }
    if (world.objects.indexOf(source) >= 0) {
        return {address: source.name, robot: null, object: source}
    }
    if (world.sensors.indexOf(source) >= 0) {
        return {address: source.robot + '/' + short(source.name), robot: source.robot, object: source}
    }
    const robot = world.robots.filter(one => one.parts.indexOf(source) >= 0)[0]
    return robot ? {address: robot.name + '/' + source.name, robot: robot.name, object: source} : null
}

function robotNamed(world, name) {
    return world.robots.filter(robot => robot.name === name)[0] || null
}

/**
 * Finds a selection in a world: {object, robot (null for none), pose (frame in the world), parent (its parent frame)};
 * null if absent.
 */
export function find(world, address) {
    if (!world || !address) {
        return null
    }
    const slash = address.indexOf('/')
    if (slash < 0) {
        const joints = (world.joints || []).filter(joint => !joint.robot)
        const whole = world.objects.concat(world.robots, joints).filter(one => one.name === address)[0]
        return whole ? {object: whole, robot: null, pose: geometry.frame(whole.pose),
            parent: [0, 0, 0, 0, 0, 0, 1]} : null
    }
    const robot = robotNamed(world, address.slice(0, slash))
    const name = address.slice(slash + 1)
    if (!robot) {
        return null
    }
    const parent = geometry.frame(robot.pose)
    const part = robot.parts.filter(one => one.name === name)[0]
    if (part) {
        return {object: part, robot, pose: geometry.times(parent, geometry.frame(part.pose)), parent}
    }
    const other = world.sensors.concat(world.joints || [])
        .filter(one => one.robot === robot.name && short(one.name) === name)[0]
    return other ? {object: other, robot, pose: geometry.frame(other.pose), parent} : null
}

/**
 * Returns the lowest and highest corner of an object in its own frame: [[x, y, z], [x, y, z]]; for a robot, of all
 * parts.
 */
export function extent(object) {
    let points = object.corners || []
    ;(object.parts || []).forEach(part => {
        const pose = geometry.frame(part.pose)
        points = points.concat(part.corners.map(corner => {
            const at = geometry.rotate(pose, corner)
            return [at[0] + pose[0], at[1] + pose[1], at[2] + pose[2]]
        }))
    })
    if (!points.length) {
        points = [[-0.02, -0.02, -0.02], [0.02, 0.02, 0.02]]
    }
    return [Math.min, Math.max].map(which => [0, 1, 2].map(axis => which.apply(null, points.map(point => point[axis]))))
}

/** Returns the ray of a pixel of the 3D view: {from, along}. */
export function ray(scene, x, y) {
    const THREE = window.THREE
    const caster = new THREE.Raycaster()
    caster.setFromCamera(new THREE.Vector2(2 * x / scene.canvas.clientWidth - 1, 1 - 2 * y / scene.canvas.clientHeight),
        scene.camera)
    return {from: caster.ray.origin.toArray(), along: caster.ray.direction.toArray(), caster}
}
/** Returns the downward ray of a point of the map. */
export function down(x, z, height) {
    return {from: [x, height, z], along: [0, -1, 0]}
}
/** Intersects a ray with a plane through a point; null if too far or behind. */
export function onPlane(line, point, normal) {
    const nearer = line.along[0] * normal[0] + line.along[1] * normal[1] + line.along[2] * normal[2]
    let far = 0
    for (let i = 0; i < 3; i++) {
        far += (point[i] - line.from[i]) * normal[i]
    }
    far /= nearer
    return far > 0 && far < FAR ? line.from.map((from, k) => from + far * line.along[k]) : null
}
/** Returns the distance along an axis through a point at which it is nearest to a ray, metres. */
export function alongAxis(line, point, axis) {
    const between = point.map((value, i) => value - line.from[i])
    function dot(a, b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    }
    const b = dot(axis, line.along)
    return (b * dot(line.along, between) - dot(axis, between)) / Math.max(1e-6, 1 - b * b)
}

/** @param normal of the surface in the world; null if unknown */
function met(world, who, point, ground, normal) {
    const robot = who && who.robot ? robotNamed(world, who.robot) : null
    const frame = robot ? geometry.frame(robot.pose) : null
    return {who, point, ground, robot: robot ? robot.name : null, local: robot ? local(frame, point) : null,
        normal: robot && normal ? back(frame, normal) : null}
}
/**
 * Finds what is under a pixel of the 3D view; the plane at height 0 if nothing is there; null above the horizon.
 * @param without object to ignore
 */
export function inSpace(scene, world, x, y, without) {
    const found = scene.pick(x, y, without)
    if (found) {
        return met(world, whose(world, found.object), found.point, !found.object || Boolean(found.object.ground),
            found.normal)
    }
    const point = onPlane(ray(scene, x, y), [0, 0, 0], [0, 1, 0])
    return point ? met(world, null, point, false) : null
}

/** Whether an outline contains a point of the ground. */
export function contains(outline, x, z) {
    let inside = false
    for (let i = 0, k = outline.length - 1; i < outline.length; k = i++) {
        const a = outline[i]
        const b = outline[k]
        if (a[1] > z !== b[1] > z && x < (b[0] - a[0]) * (z - a[1]) / (b[1] - a[1]) + a[0]) {
            inside = !inside
        }
    }
    return inside
}
/** Whether an object is above a point of the ground. */
export function covers(object, x, z) {
    const shape = object.$shape
    return contains(shape.outline, x, z) && (!shape.areas || shape.areas.some(area => contains(area, x, z)))
}
/** Returns the height of an object's highest point, in the world. */
export function top(object) {
    const pose = geometry.frame(object.pose)
    return Math.max.apply(null, object.corners.map(corner => pose[1] + geometry.rotate(pose, corner)[1]))
}
/** Returns the height of the highest point of a robot's part, in the world. */
function topOf(robot, part) {
    const pose = geometry.times(geometry.frame(robot.pose), geometry.frame(part.pose))
    return Math.max.apply(null, part.corners.map(corner => pose[1] + geometry.rotate(pose, corner)[1]))
}
/** Finds what is at a point of the map: a robot, else the highest object there, else the height 0. */
export function onMap(world, x, z) {
    const robot = world.robots.filter(one => Math.sqrt(Math.pow(one.pose[0] - x, 2) + Math.pow(one.pose[2] - z, 2))
        < Math.max(one.radius, 0.1))[0]
    if (robot) {
        const body = robot.parts.filter(part => part.type !== 'Wheel')[0]
        return met(world, {address: robot.name + (body ? '/' + body.name : ''), robot: robot.name,
            object: body || robot},
            [x, body ? topOf(robot, body) : robot.pose[1], z], false)
    }
    geometry.shapesOf(world)
    const below = world.objects.filter(object => covers(object, x, z))
        .sort((a, b) => top(b) - top(a))[0]
    return below ? met(world, whose(world, below), [x, top(below), z], Boolean(below.ground)) : met(
    world, null, [x, 0, z], false)
}
