// SPDX-License-Identifier: Apache-2.0
// Poses and outlines of a world's objects, as pure functions. Metres; degrees at the interfaces.
const GROUND = 'rgba(128, 128, 128, 0.12)'
const ROBOT = 'rgba(51, 122, 183, 0.55)'
const FAR = 1                 // metres: a step longer than this and faster than FASTEST is a teleport
const FASTEST = 60            // m/s

/**
 * Converts a pose [x, y, z, rx, ry, rz] in metres and degrees to a frame [x, y, z, qx, qy, qz, qw], rotated like jME's
 * Quaternion.fromAngles. Returns a frame unchanged.
 */
export function frame(pose) {
    if (pose.length === 7) {
        return pose
    }
    const a = [3, 4, 5].map(i => pose[i] * Math.PI / 360)
    const s = a.map(Math.sin)
    const c = a.map(Math.cos)
    return [pose[0], pose[1], pose[2], c[1] * c[2] * s[0] + s[1] * s[2] * c[0], s[1] * c[2] * c[0] + c[1] * s[2] * s[0],
        c[1] * s[2] * c[0] - s[1] * c[2] * s[0], c[1] * c[2] * c[0] - s[1] * s[2] * s[0]]
}

function cross(a, b) {
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

export function rotate(pose, v) {
    const q = [pose[3], pose[4], pose[5]]
    const t = cross(q, v).map(value => 2 * value)
    const u = cross(q, t)
    return [v[0] + pose[6] * t[0] + u[0], v[1] + pose[6] * t[1] + u[1], v[2] + pose[6] * t[2] + u[2]]
}

export function times(outer, inner) {
    const p = rotate(outer, inner)
    const a = outer.slice(3)
    const b = inner.slice(3)
    return [outer[0] + p[0], outer[1] + p[1], outer[2] + p[2],
        a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
        a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]]
}

/**
 * Interpolates between two frames, by the rule of the Java class Movement: linear in position, the shorter way in
 * rotation. Teleports are not interpolated.
 *
 * @param share fraction of the path, 0 to 1
 * @param seconds simulated time of the whole path
 */
export function between(a, b, share, seconds) {
    if (share >= 1 || Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]) > Math.max(FAR, FASTEST * seconds)) {
        return b
    }
    const sign = a[3] * b[3] + a[4] * b[4] + a[5] * b[5] + a[6] * b[6] < 0 ? -share : share
    const rotation = [3, 4, 5, 6].map(i => a[i] * (1 - share) + b[i] * sign)
    const length = Math.hypot.apply(null, rotation)
    return [0, 1, 2].map(i => a[i] + (b[i] - a[i]) * share).concat(rotation.map(value => value / length))
}

/** Returns the current pose of a part in its robot's body, with wheel and servo rotations. @param i its number */
export function placeOf(robot, i) {
    const part = robot.parts[i]
    if (part.type === 'Wheel' && robot.wheels) {
        return robot.wheels[i - robot.parts.length + robot.wheels.length]
    }
    return robot.turned && robot.turned[i] || part.pose
}

/** Returns the ground position [x, z] of a point fixed to an object. */
export function onGround(pose, point) {
    const at = rotate(pose, point)
    return [pose[0] + at[0], pose[2] + at[2]]
}

/** Returns the convex outline on the ground: [x, z] points in order. */
function outline(object, pose) {
    const points = object.corners.map(corner => onGround(pose, corner)).sort((a, b) => a[0] - b[0] || a[1] - b[1])
    return halfHull(points).concat(halfHull(points.reverse()))
}

/** Returns the areas of an object that its outline does not show, on the ground; null without any. */
function areas(object) {
    const pose = frame(object.pose)
    return object.areas ? object.areas.map(ring => ring.map(corner => onGround(pose, corner))) : null
}

function halfHull(points) {
    const hull = []
    points.forEach(p => {
        while (hull.length > 1 && turn(hull[hull.length - 2], hull[hull.length - 1], p) <= 0) {
            hull.pop()
        }
        hull.push(p)
    })
    hull.pop()
    return hull
}

function turn(a, b, c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/** Returns the shapes of a world with their outlines on the ground; floors and terrains first, below all others. */
export function shapesOf(world) {
    let all = world.objects.map(shapeOf)
    world.robots.forEach(robot => {
        const body = frame(robot.pose)
        robot.parts.forEach((part, i) => {
            all.push({color: colorOf(part, ROBOT), ground: false, robot: true,
                outline: outline(part, times(body, frame(placeOf(robot, i))))})
        })
    })
    all = all.filter(shape => shape.outline.length > 2)
    return all.filter(isGround).concat(all.filter(isNoGround))
}
/** Returns an environment object's shape, cached until the object moves. */
function shapeOf(object) {
    if (!object.$shape || object.$shape.pose !== object.pose) {
        const ground = object.type === 'Floor' || object.type === 'Terrain' || object.terrain
        object.$shape = {color: object.ground ? 'transparent' : colorOf(object, ground ? GROUND : object.color), ground,
            robot: false,
            pose: object.pose, outline: outline(object, frame(object.pose)), areas: areas(object)}
    }
    return object.$shape
}
/** Returns an object's own colour, else another one. */
function colorOf(object, other) {
    return object.colored ? object.color : other
}
function isGround(shape) {
    return shape.ground
}
function isNoGround(shape) {
    return !shape.ground
}

/**
 * Returns the centre and size of everything but the ground; with the ground if there are only robots; null for an empty
 * world.
 */
export function area(shapes) {
    const things = shapes.filter(isNoGround)
    const points = [].concat.apply([], (things.some(isNoRobot) ? things : shapes).map(shape => shape.outline))
    if (!points.length) {
        return null
    }
    const x = extent(points, 0)
    const z = extent(points, 1)
    return {x: x.middle, z: z.middle, north: x.length, east: z.length, size: Math.max(x.length, z.length)}
}
/** Returns the corners of objects in the world, without the ground. */
export function corners(objects) {
    return [].concat.apply([], objects.filter(object => !shapeOf(object).ground).map(object => {
        const at = frame(object.pose)
        return (object.corners || []).map(corner => rotate(at, corner).map((metres, i) => metres + at[i]))
    }))
}
/** Fits a map to the shapes. */
export function fit(view, shapes, element) {
    const all = area(shapes)
    if (all) {
        view.x = all.x
        view.z = all.z
        view.scale = 0.92 * Math.min(element.clientHeight / all.north, element.clientWidth / all.east)
    }
}
function isNoRobot(shape) {
    return !shape.robot
}
function extent(points, axis) {
    let low = Infinity
    let high = -Infinity
    points.forEach(point => {
        low = Math.min(low, point[axis])
        high = Math.max(high, point[axis])
    })
    return {middle: (low + high) / 2, length: Math.max(0.1, high - low)}
}

/** Whether a CSS colour is light: a light text colour means a dark theme. */
export function isLight(color) {
    const parts = (color.match(/[\d.]+/g) || [0, 0, 0]).map(Number)
    return parts[0] + parts[1] + parts[2] > 384
}
