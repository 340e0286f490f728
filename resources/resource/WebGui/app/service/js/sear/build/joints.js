// SPDX-License-Identifier: Apache-2.0
// Joints in the SEAR panel: joining two objects by clicks or names, and the marks of joints in the views.
import * as geometry from '../shared/geometry.js'
import * as pointing from '../world/pointing.js'
import {plain} from './places.js'

export const WORLD = 'the world'
const MARK = 0x8e5bd0
const BROKEN = 0x888888
const AXIS = 0.04             // length of a joint's axis to either side, as a fraction of the camera's distance
const BALL = 0.008            // radius of a joint's mark, likewise
const NEAR = 8                // pixels around a joint's mark that still pick it
const TURN = 15               // degrees to which an axis snaps
const WITH_AXIS = ['Hinge', 'Slider']
const TAUT = 1e-3             // metres: a rope whose limit is within this of its length is taut
// The inspector's words for parameters of joints.
export const WORDS = {
    first: 'first object', second: 'second object', part: 'move with it', collide: 'they collide',
    breakingForce: 'breaks at', start: 'position at start',
    lower: 'lower limit', upper: 'upper limit', restitution: 'bounce', friction: 'dry friction', damping: 'damper',
    stiffness: 'spring rate', rest: 'spring at rest at', stallForce: 'motor force', noLoadSpeed: 'motor speed',
    gear: 'follows joint', ratio: 'gear ratio',
    endX: 'end x', endY: 'end y', endZ: 'end z'
}
export const GROUPS = [
    ['Objects', /^(first|second|part|collide|breakingForce)$/],
    ['Place', /^([xyz]|r[xyz]|end[XYZ])$/],
    ['Limits', /^(start|lower|upper|restitution)$/],
    ['Motor', /^(stallForce|noLoadSpeed|gear|ratio)$/],
    ['Spring and losses', /^(stiffness|rest|damping|friction)$/],
    ['Settings', null]
]
/** Directions of an axis by a word, as rx, ry, rz in degrees. */
export const DIRECTIONS = [['up', [0, 0, 0]], ['north', [0, 0, -90]], ['east', [90, 0, 0]]]

export function hasAxis(type) {
    return WITH_AXIS.indexOf(type) >= 0
}
/** Returns the names of all objects and robots that a joint can connect. */
export function partners(world) {
    return world ? world.objects.concat(world.robots).map(one => one.name) : []
}

/** Returns the names of the shapes of a robot that a joint within it can connect. */
export function partsOf(world, robot) {
    const found = world ? world.robots.filter(one => one.name === robot)[0] : null
    return found ? found.parts.filter(part => part.type !== 'Wheel' && part.type !== 'Led').map(part => part.name) : []
}

/** Returns the name of a robot's first joint without a motor of its own; undefined if there is none. */
export function jointToDrive(world, robot) {
    const free = (world && world.joints || []).filter(joint => joint.robot === robot && joint.numbers && !joint.command)
    return free.length ? pointing.short(free[0].name) : undefined
}

/** Returns the names of all objects and robots, and robot/part for the shapes of robots. */
export function ends(world) {
    const robots = world ? world.robots.map(one => one.name) : []
    return partners(world).concat(...robots.map(robot => partsOf(world, robot).map(part => robot + '/' + part)))
}

/** Returns the robot's name in robot/part; another name as it is. */
function wholeOf(name) {
    return name.split('/')[0]
}

/**
 * Returns the angles rx and rz, degrees, that point a y axis along a direction.
 * @param step to which they snap, 0 for none
 */
export function anglesOf(direction, step) {
    const [x, y, z] = direction.map(metres => metres / Math.hypot(...direction))
    const snapped = degrees => step ? Math.round(degrees / step) * step : degrees
    const rx = snapped(Math.asin(Math.max(-1, Math.min(1, z))) * 180 / Math.PI)
    return {rx, rz: Math.abs(rx) === 90 ? 0 : snapped(Math.atan2(-x, y) * 180 / Math.PI)}
}

/** Returns the distance of a rope's ends. @param values of its file */
function lengthOf(values) {
    return Math.hypot(...['x', 'y', 'z'].map(axis =>
        Number(values['end' + axis.toUpperCase()] || 0) - Number(values[axis] || 0)))
}

/**
 * Returns what an edit of a rope sets: a taut rope stays taut.
 * @param values of its file @param set its other changes
 */
export function tautened(values, set) {
    const isTaut = values.upper !== undefined && Math.abs(Number(values.upper) - lengthOf(values)) < TAUT
    const moves = ['x', 'y', 'z', 'endX', 'endY', 'endZ'].some(name => set[name] !== undefined)
    return isTaut && moves ? Object.assign({}, set, {upper: plain(lengthOf(Object.assign({}, values, set)))}) : set
}

/**
 * A joint being made: its objects, as clicked or chosen by name, and where they were clicked. Two parts of one robot,
 * or a robot and its part, get a joint within the robot.
 */
export class Joining {
    constructor() {
        this.first = null       // WORLD, a name, or robot/part; null until chosen
        this.second = null
        this.points = {}        // clicked points, by name
    }

    /** Returns the name of what was clicked. */
    static nameOf(at) {
        return at.who && !at.ground ? at.who.address : at.robot || WORLD
    }

    /** Takes a click. @return whether both objects are known */
    click(at) {
        const name = Joining.nameOf(at)
        this.points[name] = at.point
        if (!this.first) {
            this.first = name
        } else if (name === WORLD) {
            this.second = this.first
            this.first = WORLD
        } else {
            this.second = name
        }
        return this.isWhole()
    }

    isWhole() {
        return Boolean(this.first && this.second)
    }

    text() {
        return !this.first ? 'Click the first object; the ground stands for the world'
            : 'Click the object that it joins to ' + this.first + ', where the joint shall be'
    }

    /** Returns the name of the robot within which the joint is; null for a joint of the world. */
    robot() {
        const robot = this.isWhole() && this.second.indexOf('/') > 0 ? wholeOf(this.second) : null
        return robot === wholeOf(this.first || '') ? robot : null
    }

    /** Returns why the objects can't be joined, as text; empty if they can. */
    problem(world) {
        const isFixed = name => name === WORLD || world.objects.some(one => one.name === name && !one.loose)
        if (this.first !== this.second && this.robot()) {
            return ''
        }
        if (this.first !== this.second && wholeOf(this.first) === wholeOf(this.second)) {
            return 'a joint within ' + this.second + ' needs one of its parts as the second object'
        }
        return this.first === this.second ? 'a joint needs two objects, and both are ' + this.first
            : isFixed(this.first) && isFixed(this.second) ? 'this joint could not move: ' + this.first + ' and '
                + this.second + ' are both fixed. Give one of them a mass: select it, and enter it under Physics' : ''
    }

    /** Returns the parameters of the joint. @param snapped see palette */
    values(world, type, snapped) {
        const robot = this.robot()
        const frame = robot ? pointing.find(world, robot).pose : [0, 0, 0, 0, 0, 0, 1]
        const at = name => pointing.local(frame, this.points[name] || pointing.find(world, name).pose.slice(0, 3))
            .map(snapped)
        const end = at(this.second)
        const set = {second: robot ? pointing.short(this.second) : wholeOf(this.second)}
        if (this.first !== WORLD && this.first !== robot) {
            set.first = robot ? pointing.short(this.first) : wholeOf(this.first)
        }
        const above = this.first === WORLD && !this.points[WORLD] ? [end[0], end[1] + 1, end[2]] : null
        const from = type === 'Rope' ? above || at(this.first) : end
        from.forEach((value, i) => {
            set['xyz'[i]] = plain(value)
        })
        if (type === 'Rope') {
            end.forEach((value, i) => {
                set['end' + 'XYZ'[i]] = plain(value)
            })
            set.upper = plain(Math.max(TAUT, Math.hypot(...end.map((value, i) => value - from[i]))))
        }
        return set
    }
}

// ---- marks in the views
// ------------------------------------------------------------------------------------------------
function makeMark(joint) {
    const THREE = window.THREE
    const mark = new THREE.Object3D()
    mark.joint = joint
    mark.material = new THREE.MeshBasicMaterial({color: MARK, depthTest: false, transparent: true})
    mark.ball = new THREE.Mesh(joint.type === 'FixedJoint' ? new THREE.BoxGeometry(2, 2, 2)
        : new THREE.SphereGeometry(1, 12, 8), mark.material)
    mark.add(mark.ball)
    const line = new THREE.Geometry()
    line.vertices.push(new THREE.Vector3(), new THREE.Vector3())
    mark.line = new THREE.Line(line, new THREE.LineBasicMaterial({color: MARK, depthTest: false, transparent: true}))
    mark.line.frustumCulled = false
    mark.line.renderOrder = mark.ball.renderOrder = 9
    mark.add(mark.line)
    return mark
}

/** Shows the joints' anchors, axes and ropes in the 3D view while building. */
export function showMarks(scene, world, building) {
    const joints = building && world.joints || []
    scene.jointMarks = scene.jointMarks || []
    if (scene.jointMarks.length !== joints.length || scene.jointMarks.some((mark, i) => mark.joint !== joints[i])) {
        scene.jointMarks.forEach(mark => scene.scene.remove(mark))
        scene.jointMarks = joints.map(makeMark)
        scene.jointMarks.forEach(mark => scene.scene.add(mark))
    }
    scene.jointMarks.forEach(mark => {
        const pose = geometry.frame(mark.joint.pose)
        const end = geometry.frame(mark.joint.end)
        const away = scene.camera.position.distanceTo(new window.THREE.Vector3(pose[0], pose[1], pose[2]))
        mark.ball.position.set(pose[0], pose[1], pose[2])
        mark.ball.scale.set(BALL * away, BALL * away, BALL * away)
        mark.material.color.set(mark.joint.broken ? BROKEN : MARK)
        const along = hasAxis(mark.joint.type) ? geometry.rotate(pose, [0, AXIS * away, 0]) : [0, 0, 0]
        const line = mark.joint.type === 'Rope' ? [pose, end] : [-1, 1].map(side =>
            along.map((metres, i) => pose[i] + side * metres))
        line.forEach((point, i) => mark.line.geometry.vertices[i].set(point[0], point[1], point[2]))
        mark.line.geometry.verticesNeedUpdate = true
    })
}

/** Draws the joints on the map. @param at maps a ground point to pixels */
export function drawMarks(pen, world, at) {
    (world && world.joints || []).forEach(joint => {
        const from = at(joint.pose[0], joint.pose[2])
        const to = at(joint.end[0], joint.end[2])
        pen.strokeStyle = pen.fillStyle = '#' + (joint.broken ? BROKEN : MARK).toString(16)
        pen.beginPath()
        pen.moveTo(from.x, from.y)
        pen.lineTo(to.x, to.y)
        pen.stroke()
        pen.beginPath()
        pen.arc(from.x, from.y, NEAR / 2, 0, 2 * Math.PI)
        pen.fill()
    })
}

/**
 * Returns the joint whose mark is at a pixel, as pointing does; null for none.
 * @param toScreen converts a point of the world to pixels
 */
export function pick(world, toScreen, x, y) {
    const near = (world && world.joints || []).map(joint => {
        const seen = toScreen(joint.pose)
        return {joint, away: seen.seen === false ? Infinity : Math.hypot(seen.x - x, seen.y - y)}
    }).sort((a, b) => a.away - b.away)[0]
    const robot = near && near.joint.robot
    const address = robot ? robot + '/' + pointing.short(near.joint.name) : near && near.joint.name
    return near && near.away < NEAR ? {who: {address, robot: robot || null, object: near.joint},
        point: near.joint.pose.slice(0, 3), ground: false, robot: null, local: null, normal: null} : null
}

/**
 * Returns the direction in which an axis handle points, from a joint's anchor to a point, as parameters.
 * @param parent frame in which they are
 */
export function pointed(pose, point, free, parent) {
    const way = pointing.back(parent, point.map((metres, i) => metres - pose[i]))
    const angles = anglesOf(way, free ? 0 : TURN)
    return {rx: plain(angles.rx), ry: '0', rz: plain(angles.rz)}
}
