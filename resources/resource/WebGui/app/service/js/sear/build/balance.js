// SPDX-License-Identifier: Apache-2.0
// Centre of mass and support polygon of the selected robot in the SEAR panel's views. The world message contains the
// numbers.
import * as geometry from '../shared/geometry.js'

const SAFE = '#5cb85c'
const CRITICAL = '#d9534f'
const SIZE = 0.035            // size of the mark, as a fraction of the camera's distance
const RADIUS = 7              // radius of the mark on the map, pixels
const ABOVE = 0.004           // height of the drawn polygon above the ground, metres

/** Returns the selected robot, or the robot whose part is selected; null for none. @param found see pointing.find */
export function robotOf(found) {
    const robot = found && (found.robot || found.object)
    return robot && robot.balance ? robot : null
}
function color(balance) {
    return balance.critical ? CRITICAL : SAFE
}
/** Draws the usual symbol of a centre of mass: a circle of black and white quarters. */
function mark(pen, x, y, radius) {
    for (let i = 0; i < 4; i++) {
        pen.beginPath()
        pen.moveTo(x, y)
        pen.arc(x, y, radius, i * Math.PI / 2, (i + 1) * Math.PI / 2)
        pen.closePath()
        pen.fillStyle = i % 2 ? '#ffffff' : '#000000'
        pen.fill()
    }
    pen.beginPath()
    pen.arc(x, y, radius, 0, 2 * Math.PI)
    pen.strokeStyle = '#000000'
    pen.stroke()
}

function lineOf(points, ink) {
    const THREE = window.THREE
    const shape = new THREE.Geometry()
    points.forEach(point => {
        shape.vertices.push(new THREE.Vector3(point[0], point[1] + ABOVE, point[2]))
    })
    const line = new THREE.Line(shape,
        new THREE.LineBasicMaterial({color: ink, depthTest: false, transparent: true, linewidth: 2}))
    line.renderOrder = 11
    return line
}
function spriteOf() {
    const THREE = window.THREE
    const picture = document.createElement('canvas')
    picture.width = picture.height = 64
    mark(picture.getContext('2d'), 32, 32, 30)
    const texture = new THREE.Texture(picture)
    texture.needsUpdate = true
    const sprite = new THREE.Sprite(new THREE.SpriteMaterial({map: texture, depthTest: false}))
    sprite.renderOrder = 12
    return sprite
}

/** Returns the lower end of the plumb line from the centre of mass, in the body's frame. */
function plumb(balance) {
    const sum = balance.support.reduce((height, corner) => height + corner[1], 0)
    return [balance.centre[0], balance.support.length ? sum / balance.support.length : 0, balance.centre[2]]
}
function make(scene, balance) {
    const group = new window.THREE.Object3D()
    group.balance = balance
    group.mark = spriteOf()
    group.mark.position.fromArray(balance.centre)
    group.add(group.mark)
    if (balance.support.length) {
        group.add(lineOf(balance.support.concat([balance.support[0]]), color(balance)))
        group.add(lineOf([balance.centre, plumb(balance)], color(balance)))
    }
    scene.scene.add(group)
    return group
}

/** Shows the balance in the 3D view. @param found the selection; null for none */
export function show(scene, found) {
    const robot = robotOf(found)
    if (scene.balance && (!robot || scene.balance.balance !== robot.balance)) {
        scene.scene.remove(scene.balance)
        scene.balance = null
    }
    if (robot) {
        const group = scene.balance = scene.balance || make(scene, robot.balance)
        const pose = geometry.frame(robot.pose)
        group.position.set(pose[0], pose[1], pose[2])
        group.quaternion.set(pose[3], pose[4], pose[5], pose[6])
        group.updateMatrixWorld(true)
        const size = SIZE * scene.camera.position.distanceTo(group.position)
        group.mark.scale.set(size, size, size)
    }
}

/** Draws the balance on the map. @param at maps a ground point to pixels */
export function draw(pen, found, at) {
    const robot = robotOf(found)
    if (!robot) {
        return
    }
    const pose = geometry.frame(robot.pose)
    function pixel(point) {
        const ground = geometry.onGround(pose, point)
        return at(ground[0], ground[1])
    }
    pen.beginPath()
    robot.balance.support.forEach(corner => {
        pen.lineTo(pixel(corner).x, pixel(corner).y)
    })
    pen.closePath()
    pen.strokeStyle = color(robot.balance)
    pen.lineWidth = 2
    pen.stroke()
    pen.lineWidth = 1
    mark(pen, pixel(robot.balance.centre).x, pixel(robot.balance.centre).y, RADIUS)
}
