// SPDX-License-Identifier: Apache-2.0
// Marks of the selected object in the SEAR panel's views: a frame around it, and handles that turn and resize it.
import * as geometry from '../shared/geometry.js'
import {hasAxis} from './joints.js'
import * as pointing from '../world/pointing.js'

const FRAME = 0xff7f0e
const EYE = 0x8e5bd0
const FAR = 1                 // length of the pyramid that shows a sensor's field of view, metres
const HANDLES = [['x', 0xd9534f], ['y', 0x5cb85c], ['z', 0x337ab7], ['turn', 0xf0ad4e],
    ['axis', 0x8e5bd0], ['end', 0x8e5bd0]]
const SIZE = 0.012            // size of a handle, as a fraction of the camera's distance
const GAP = 0.06              // distance of the turn handle from the frame, likewise
const CUBE = 1.6              // side of a resize handle, in sizes
const DISC = 1.3              // radius of the turn handle, in sizes
const ABOVE = 520             // pixels: handles on the map are as large as for a camera at this distance
const NEAR = 3                // pixels around a handle on the map that still pick it
const ALONG = 0.95            // cosine: axes nearer than this to the line of sight have no handle
const GROUND = 20             // half width of the grid, metres
const MARKER = 0.02           // radius of the ball that marks a sensor, metres

/** Returns the size parameter along each axis: {x: {name, share}, ..}; share is the parameter divided by the length. */
export function sizesOf(type) {
    const names = type ? type.parameters.map(parameter => parameter.name) : []
    function has(name) {
        return names.indexOf(name) >= 0
    }
    const sizes = {}
    if (has('length') && has('width')) {
        sizes.x = {name: 'length', share: 1}
        sizes.z = {name: 'width', share: 1}
    } else if (has('radius') && has('width')) {
        sizes.x = {name: 'width', share: 1}
        sizes.y = {name: 'radius', share: 0.5}
    } else if (has('radius')) {
        sizes.x = {name: 'radius', share: 0.5}
    }
    if (has('height')) {
        sizes.y = {name: 'height', share: 1}
    }
    return sizes
}

/**
 * Returns the handles' positions in the selection's frame, by name. Axes along the line of sight have no resize handle.
 * @param found see pointing.find @param extent its corners @param sizes see sizesOf @param eye away: its distance in
 * metres, along: its direction
 */
export function spots(found, extent, sizes, eye) {
    if (pointing.isJoint(found.object)) {
        return spotsOfJoint(found, eye)
    }
    const middle = [0, 1, 2].map(i => (extent[0][i] + extent[1][i]) / 2)
    const all = {}
    HANDLES.forEach((one, i) => {
        const name = one[0]
        const at = middle.slice()
        if (name === 'turn') {
            at[2] = extent[1][2] + GAP * eye.away
            all[name] = at
        } else if (i < at.length && sizes[name] && Math.abs(pointing.back(found.pose, eye.along)[i]) < ALONG) {
            at[i] = extent[1][i]
            all[name] = at
        }
    })
    return all
}
/** Returns the tip of a joint's axis, or the other end of a rope. */
function spotsOfJoint(found, eye) {
    return found.object.type === 'Rope' ? {end: pointing.local(found.pose, found.object.end)}
        : hasAxis(found.object.type) ? {axis: [0, 2 * GAP * eye.away, 0]} : {}
}
/** Converts a position in the selection's frame to the world. */
export function placed(found, spot) {
    const at = geometry.rotate(found.pose, spot)
    return [found.pose[0] + at[0], found.pose[1] + at[1], found.pose[2] + at[2]]
}

// ---- on the map
// ---------------------------------------------------------------------------------------------------------------------
/** Returns the map's eye, for a scale in pixels per metre. */
export function above(scale) {
    return {away: ABOVE / scale, along: [0, -1, 0]}
}
function css(color) {
    return '#' + ('00000' + color.toString(16)).slice(-6)
}
/** Draws frame and handles on the map. @param all see spots @param at maps a ground point to pixels */
export function draw(pen, found, extent, all, at) {
    function pixel(spot) {
        const point = geometry.onGround(found.pose, spot)
        return at(point[0], point[1])
    }
    pen.beginPath()
    ;[[0, 0], [1, 0], [1, 1], [0, 1]].forEach(corner => {
        const point = pixel([extent[corner[0]][0], 0, extent[corner[1]][2]])
        pen.lineTo(point.x, point.y)
    })
    pen.closePath()
    pen.strokeStyle = css(FRAME)
    pen.lineWidth = 2
    pen.stroke()
    pen.lineWidth = 1
    HANDLES.forEach(one => {
        if (all[one[0]]) {
            const point = pixel(all[one[0]])
            const half = CUBE / 2 * SIZE * ABOVE
            pen.beginPath()
            if (one[0] === 'turn') {
                pen.arc(point.x, point.y, DISC * SIZE * ABOVE, 0, 2 * Math.PI)
            } else {
                pen.rect(point.x - half, point.y - half, 2 * half, 2 * half)
            }
            pen.fillStyle = css(one[1])
            pen.fill()
            pen.strokeStyle = '#ffffff'
            pen.stroke()
        }
    })
}
/** Returns the handle under a pixel of the map; null for none. */
export function pickOnMap(found, all, at, x, y) {
    let nearest = null
    let least = DISC * SIZE * ABOVE + NEAR
    HANDLES.forEach(one => {
        if (all[one[0]]) {
            const point = geometry.onGround(found.pose, all[one[0]])
            const pixel = at(point[0], point[1])
            const away = Math.sqrt(Math.pow(pixel.x - x, 2) + Math.pow(pixel.y - y, 2))
            if (away < least) {
                least = away
                nearest = one[0]
            }
        }
    })
    return nearest
}

// ---- in space
// ---------------------------------------------------------------------------------------------------------------------
/** Returns the 3D view's eye. */
export function inSpace(scene, found) {
    const from = scene.camera.position
    const way = [found.pose[0] - from.x, found.pose[1] - from.y, found.pose[2] - from.z]
    const away = Math.sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2])
    return {away, along: way.map(metres => metres / away)}
}
function lines(points, color) {
    const THREE = window.THREE
    const shape = new THREE.Geometry()
    points.forEach(point => {
        shape.vertices.push(new THREE.Vector3(point[0], point[1], point[2]))
    })
    const material = new THREE.LineBasicMaterial({color})
    return THREE.LineSegments ? new THREE.LineSegments(shape, material) : new THREE.Line(
    shape, material, THREE.LinePieces)
}
/** Returns the twelve edges of a unit cube. */
function edges() {
    const points = []
    for (let axis = 0; axis < 3; axis++) {
        for (let corner = 0; corner < 4; corner++) {
            [-0.5, 0.5].forEach(end => {
                const point = [0, 0, 0]
                point[axis] = end
                point[(axis + 1) % 3] = corner & 1 ? 0.5 : -0.5
                point[(axis + 2) % 3] = corner & 2 ? 0.5 : -0.5
                points.push(point)
            })
        }
    }
    return points
}

/** Returns the edges of a field of view from the origin: a pyramid 2 wide, 2 high and 1 long, along z. */
function pyramid() {
    const corners = [[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]]
    const points = []
    corners.forEach((corner, i) => {
        points.push([0, 0, 0], corner, corner, corners[(i + 1) % 4])
    })
    return points
}

function make(scene) {
    const THREE = window.THREE
    const group = new THREE.Object3D()
    group.frame = lines(edges(), FRAME)
    group.add(group.frame)
    group.eye = lines(pyramid(), EYE)
    group.add(group.eye)
    group.knobs = {}
    HANDLES.forEach(one => {
        const shape = one[0] === 'turn' ? new THREE.CylinderGeometry(DISC, DISC, 0.5, 20)
            : one[0] === 'axis' ? new THREE.CylinderGeometry(0, DISC, 2 * DISC, 16)
                : new THREE.BoxGeometry(CUBE, CUBE, CUBE)
        const knob = new THREE.Mesh(shape,
            new THREE.MeshBasicMaterial({color: one[1], depthTest: false, transparent: true}))
        knob.renderOrder = 10
        knob.handle = one[0]
        group.knobs[one[0]] = knob
        group.add(knob)
    })
    scene.scene.add(group)
    return group
}

/**
 * Shows the selection's frame and handles.
 * @param found see pointing.find; null for none @param extent its corners @param all see spots
 */
export function show(scene, found, extent, all) {
    if (!scene.handles) {
        if (!found) {
            return
        }
        scene.handles = make(scene)
    }
    const group = scene.handles
    group.visible = Boolean(found)
    if (!found) {
        return
    }
    const pose = found.pose
    group.position.set(pose[0], pose[1], pose[2])
    group.quaternion.set(pose[3], pose[4], pose[5], pose[6])
    const low = extent[0]
    const high = extent[1]
    group.frame.position.set((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2)
    group.frame.scale.set(high[0] - low[0], Math.max(1e-3, high[1] - low[1]), high[2] - low[2])
    const size = SIZE * inSpace(scene, found).away
    HANDLES.forEach(one => {
        const knob = group.knobs[one[0]]
        knob.visible = Boolean(all[one[0]])
        if (knob.visible) {
            knob.position.fromArray(all[one[0]])
            knob.scale.set(size, size, size)
        }
    })
    showEye(scene, group.eye, found)
    group.updateMatrixWorld(true)
}
/** Shows what the view would show through a selected sensor's eye. */
function showEye(scene, eye, found) {
    const up = Math.tan(scene.eyeField * Math.PI / 360)
    eye.visible = Boolean(found.robot) && !pointing.isJoint(found.object) && found.robot.parts.indexOf(found.object) < 0
    eye.scale.set(FAR * up * scene.camera.aspect, FAR * up, FAR)
}

/** Returns the handle under a pixel: 'x', 'y', 'z' or 'turn'; null for none. */
export function pick(scene, x, y) {
    if (!scene.handles || !scene.handles.visible) {
        return null
    }
    const knobs = HANDLES.map(one => scene.handles.knobs[one[0]]).filter(knob => knob.visible)
    const hit = pointing.ray(scene, x, y).caster.intersectObjects(knobs, false)[0]
    return hit ? hit.object.handle : null
}

/** Shows the build aids: a grid on the ground, and a clickable ball for each sensor. */
export function showAids(scene, world, building) {
    const THREE = window.THREE
    if (building && !scene.grid) {
        const points = []
        for (let i = -GROUND; i <= GROUND; i++) {
            points.push([i, 0.002, -GROUND], [i, 0.002, GROUND], [-GROUND, 0.002, i], [GROUND, 0.002, i])
        }
        scene.grid = lines(points, 0x888888)
        scene.grid.material.transparent = true
        scene.grid.material.opacity = 0.35
        scene.scene.add(scene.grid)
    }
    if (scene.grid) {
        scene.grid.visible = building
    }
    world.sensors.forEach((sensor, k) => {
        const item = scene.sensors[k]
        if (building && item && !item.marker) {
            item.marker = new THREE.Object3D()
            const ball = new THREE.Mesh(new THREE.SphereGeometry(MARKER, 12, 8),
                new THREE.MeshLambertMaterial({color: FRAME}))
            ball.named = sensor
            item.marker.add(ball)
            scene.scene.add(item.marker)
        }
        if (item && item.marker) {
            const pose = geometry.frame(sensor.pose)
            item.marker.position.set(pose[0], pose[1], pose[2])
            item.marker.visible = building
        }
    })
}
