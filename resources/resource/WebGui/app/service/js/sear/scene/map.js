// SPDX-License-Identifier: Apache-2.0
// The SEAR panel's map, from above: north (+x) up, east (+z) to the right. It works without WebGL.
import * as geometry from '../shared/geometry.js'
import {penOf} from '../shared/page.js'
import {lay} from './pictures.js'

const PATH = '#337ab7'
const EYE = '#2e9bd6'
// for light and dark ground
const AXES = [['x north', ['#c62828', '#ff8a80'], [1, 0]], ['z east', ['#1565c0', '#7ab8ff'], [0, 1]]]
const AXIS = 1.5              // length of the axes, metres: less than an empty map shows
const SMALLEST_ROBOT = 4      // pixels: a smaller robot is drawn as a dot

/** Returns a function from metres on the ground to pixels of a canvas. */
export function projection(element, view) {
    const x0 = element.clientWidth / 2
    const y0 = element.clientHeight / 2
    return (x, z) => ({x: x0 + (z - view.z) * view.scale, y: y0 - (x - view.x) * view.scale})
}

/** Draws the map. @param world may be null @param terrain null without one @param pictures see Pictures */
export function draw(element, view, world, terrain, shapes, pictures) {
    const pen = penOf(element)
    const at = projection(element, view)
    const ink = window.getComputedStyle(element).color
    if (terrain) {
        terrain.draw(pen, at, areaOf(element, view), view.scale, geometry.isLight(ink))
    }
    drawGrid(pen, at, ink, element, view)
    shapes.filter(shape => shape.ground).forEach(shape => {
        drawShape(pen, at, ink, shape)
    })
    angular.forEach(world && world.objects, object => {
        const image = object.tile !== undefined && object.picture ? pictures.of(object.picture) : null
        if (image) {
            lay(pen, at, object, image, geometry.isLight(ink))
        }
    })
    if (view.building) {
        drawAxes(pen, at, geometry.isLight(ink))
    }
    if (!world) {
        return
    }
    shapes.filter(shape => !shape.ground).forEach(shape => {
        drawShape(pen, at, ink, shape)
    })
    world.robots.forEach(robot => {
        trace(pen, robot.path.map(point => at(point[0], point[1])))
        pen.strokeStyle = PATH
        pen.stroke()
    })
    if (view.beams) {
        world.sensors.forEach(sensor => {
            drawBeams(pen, at, sensor)
        })
    }
    world.robots.forEach(robot => {
        drawHeading(pen, at, ink, robot)
    })
}

/** Returns the area that a canvas shows: its edges in metres. */
function areaOf(element, view) {
    const up = element.clientHeight / 2 / view.scale
    const across = element.clientWidth / 2 / view.scale
    return {south: view.x - up, north: view.x + up, west: view.z - across, east: view.z + across}
}

/** Makes points, in pixels, the current path. */
function trace(pen, points) {
    pen.beginPath()
    points.forEach(point => {
        pen.lineTo(point.x, point.y)
    })
}

function drawGrid(pen, at, ink, element, view) {
    let step = 1
    while (step * view.scale < 40) {
        step *= String(step).charAt(0) === '2' ? 2.5 : 2      // 1, 2, 5, 10, ..
    }
    const across = element.clientWidth / 2 / view.scale
    const up = element.clientHeight / 2 / view.scale
    pen.beginPath()
    for (let z = Math.ceil((view.z - across) / step) * step; z <= view.z + across; z += step) {
        pen.moveTo(at(0, z).x, 0)
        pen.lineTo(at(0, z).x, element.clientHeight)
    }
    for (let x = Math.ceil((view.x - up) / step) * step; x <= view.x + up; x += step) {
        pen.moveTo(0, at(x, 0).y)
        pen.lineTo(element.clientWidth, at(x, 0).y)
    }
    pen.globalAlpha = 0.12
    pen.strokeStyle = ink
    pen.stroke()
    pen.globalAlpha = 0.8
    pen.fillStyle = ink
    pen.font = '12px sans-serif'
    pen.textAlign = 'right'
    pen.fillText('N ↑   grid ' + step + ' m', element.clientWidth - 10, element.clientHeight - 10)
    pen.textAlign = 'left'
    pen.globalAlpha = 1
}

/** Draws the axes while building, as in the 3D view. */
function drawAxes(pen, at, dark) {
    pen.lineWidth = 2
    AXES.forEach(axis => {
        const end = at(AXIS * axis[2][0], AXIS * axis[2][1])
        trace(pen, [at(0, 0), end])
        pen.strokeStyle = pen.fillStyle = axis[1][dark ? 1 : 0]
        pen.stroke()
        pen.textAlign = axis[2][0] ? 'center' : 'left'
        pen.fillText(axis[0], end.x + 6 * axis[2][1], end.y - 6 * axis[2][0] + 4 * axis[2][1])
    })
    pen.textAlign = 'left'
    pen.lineWidth = 1
}

function drawShape(pen, at, ink, shape) {
    if (shape.areas) {
        drawAreas(pen, at, shape)
        return
    }
    trace(pen, shape.outline.map(point => at(point[0], point[1])))
    pen.closePath()
    pen.fillStyle = shape.color
    pen.fill()
    pen.globalAlpha = 0.6
    pen.strokeStyle = ink
    pen.stroke()
    pen.globalAlpha = 1
}

function drawAreas(pen, at, shape) {
    pen.beginPath()
    shape.areas.forEach(area => {
        const corners = area.map(point => at(point[0], point[1]))
        pen.moveTo(corners[0].x, corners[0].y)
        corners.slice(1).forEach(corner => pen.lineTo(corner.x, corner.y))
        pen.closePath()
    })
    pen.fillStyle = pen.strokeStyle = shape.color
    pen.fill()
    pen.stroke()
}

function drawBeams(pen, at, sensor) {
    const pose = geometry.frame(sensor.pose)
    if (sensor.ranges) {
        drawScan(pen, at, pose, sensor)
    }
    angular.forEach(sensor.cones, cone => {
        drawCone(pen, at, pose, cone)
    })
    if (sensor.eye) {
        drawEye(pen, at, pose, sensor.eye.edge)
    }
    if (sensor.hit) {
        const hit = at(sensor.hit[0], sensor.hit[2])
        pen.fillStyle = '#d9534f'
        pen.fillRect(hit.x - 2.5, hit.y - 2.5, 5, 5)
    }
}

/** Returns the end of a beam, in pixels. @param direction unit vector in the sensor's frame */
function beamEnd(at, pose, direction, metres) {
    const end = geometry.onGround(pose, direction.map(part => part * metres))
    return at(end[0], end[1])
}

/** Draws the beams with hits; beams without a hit leave a gap. */
function drawScan(pen, at, pose, sensor) {
    const from = at(pose[0], pose[2])
    const ends = sensor.ranges.map((metres, i) => metres === null ? null : beamEnd(at, pose, sensor.fan[i], metres))
    trace(pen, [from].concat(ends.map(end => end || from)))
    pen.closePath()
    pen.fillStyle = 'rgba(240, 173, 78, 0.18)'
    pen.fill()
    pen.fillStyle = '#f0ad4e'
    ends.forEach(end => {
        if (end) {
            pen.fillRect(end.x - 1.5, end.y - 1.5, 3, 3)
        }
    })
}

/** Draws a sonar's cone; one without width is a line. */
function drawCone(pen, at, pose, cone) {
    const points = [at(pose[0], pose[2])]
    for (let i = -6; i <= 6; i++) {
        const angle = ((cone.yaw || 0) + cone.halfAngle * i / 6) * Math.PI / 180
        points.push(beamEnd(at, pose, [Math.sin(angle), 0, Math.cos(angle)], cone.range))
    }
    trace(pen, points)
    pen.closePath()
    pen.fillStyle = 'rgba(217, 83, 79, 0.12)'
    pen.fill()
    pen.strokeStyle = 'rgba(217, 83, 79, 0.25)'
    pen.stroke()
}

/** Draws a camera's field of view between its left and right edges. @param edge x, y, z of points around its picture */
function drawEye(pen, at, pose, edge) {
    const half = edge.length / 6
    const points = [at(pose[0], pose[2])]
    for (let i = 0; i <= half / 2; i++) {       // along the upper side
        const end = geometry.onGround(pose, [edge[3 * i], 0, edge[3 * i + 2]])
        points.push(at(end[0], end[1]))
    }
    trace(pen, points)
    pen.closePath()
    pen.strokeStyle = EYE
    pen.stroke()
}

function drawHeading(pen, at, ink, robot) {
    const ahead = geometry.onGround(geometry.frame(robot.pose), [0, 0, 0.3])
    const from = at(robot.pose[0], robot.pose[2])
    const end = at(ahead[0], ahead[1])
    if (Math.abs(end.x - from.x) + Math.abs(end.y - from.y) < SMALLEST_ROBOT) {
        pen.beginPath()
        pen.arc(from.x, from.y, SMALLEST_ROBOT, 0, 2 * Math.PI)
        pen.fillStyle = PATH
        pen.fill()
    }
    trace(pen, [from, end])
    pen.strokeStyle = ink
    pen.lineWidth = 2
    pen.stroke()
    pen.lineWidth = 1
    pen.fillStyle = ink
    pen.fillText(robot.name, from.x + 8, from.y - 8)
}
