// SPDX-License-Identifier: Apache-2.0
// Walls drawn in the SEAR panel: one click per corner.
import * as geometry from '../shared/geometry.js'
import {plain} from './places.js'

const NEAR = 0.25             // metres: within this distance a corner snaps to a corner of another wall
const STRAIGHT = 10           // degrees: a piece this near to a multiple of 45 degrees snaps to it
const STEP = 45
const SAME = 0.001            // metres: corners this near to each other are one
const COLOR = '#e67e22'
const SHOWN = 0.02            // metres above the ground

function away(a, b) {
    return Math.hypot(a[0] - b[0], a[1] - b[1])
}

/** Returns the corners [x, z] of a world's walls. */
function cornersOf(world) {
    const walls = (world && world.objects || []).filter(object => object.line)
    return [].concat.apply([], walls.map(wall => wall.line.map(corner => geometry.onGround(geometry.frame(wall.pose),
        [corner[0], 0, corner[1]]))))
}

/** A wall that is being drawn. */
export class Drawing {
    constructor() {
        this.corners = []       // [x, z] in the world, metres
        this.height = 0         // of the ground below the first corner, metres
        this.next = null        // where the next click would put a corner
    }

    isWhole() {
        return this.corners.length > 1
    }

    text() {
        return !this.corners.length ? 'Click the first corner of the wall' : !this.isWhole() ? 'Click the next corner'
            : 'Click the next corner; Enter, Done, or a click on the last or the first corner ends the wall'
    }

    /**
     * Returns the place of a corner for a point of the ground: a corner near it, or a place in a straight direction.
     * @param snapped rounds metres to the grid @param free whether it does not snap
     */
    snap(world, point, snapped, free) {
        if (free) {
            return point
        }
        const near = cornersOf(world).concat(this.corners).map(corner => ({corner, away: away(corner, point)}))
            .sort((a, b) => a.away - b.away)[0]
        if (near && near.away < NEAR) {
            return near.corner
        }
        const last = this.corners[this.corners.length - 1]
        const rounded = point.map(snapped)
        if (!last || snapped(SAME) === SAME) {
            return rounded
        }
        const angle = Math.atan2(point[1] - last[1], point[0] - last[0]) * 180 / Math.PI
        const straight = STEP * Math.round(angle / STEP)
        if (Math.abs(angle - straight) > STRAIGHT) {
            return rounded
        }
        const along = [Math.round(Math.cos(straight * Math.PI / 180)), Math.round(Math.sin(straight * Math.PI / 180))]
        const length = snapped(((point[0] - last[0]) * along[0] + (point[1] - last[1]) * along[1])
            / (along[0] * along[0] + along[1] * along[1]))
        return along.map((step, i) => last[i] + length * step)
    }

    /** Adds a corner. @return whether it ends the wall */
    click(corner, height) {
        const last = this.corners[this.corners.length - 1]
        if (last && away(last, corner) < SAME) {
            return this.isWhole()
        }
        this.height = last ? this.height : height
        this.corners.push(corner)
        return this.corners.length > 3 && away(this.corners[0], corner) < SAME
    }

    /** Removes the last corner. */
    takeBack() {
        this.corners.pop()
        this.next = null
    }

    /** Returns the parameters of the wall: its origin is the first corner. */
    values() {
        const first = this.corners[0]
        return {x: plain(first[0]), y: plain(this.height), z: plain(first[1]),
            corner: this.corners.map(corner => ({x: plain(corner[0] - first[0]), z: plain(corner[1] - first[1])}))}
    }

    /** Returns the corners with the next one. */
    line() {
        return this.next ? this.corners.concat([this.next]) : this.corners
    }

    /** Draws the line on the map. @param at maps a ground point to pixels */
    draw(pen, at) {
        const pixels = this.line().map(corner => at(corner[0], corner[1]))
        pen.strokeStyle = pen.fillStyle = COLOR
        pen.lineWidth = 3
        pen.beginPath()
        pixels.forEach(pixel => pen.lineTo(pixel.x, pixel.y))
        pen.stroke()
        pen.lineWidth = 1
        pixels.forEach(pixel => pen.fillRect(pixel.x - 3, pixel.y - 3, 6, 6))
    }
}

/** Shows the wall that is being drawn in the 3D view. @param drawing null for none */
export function show(scene, drawing) {
    const THREE = window.THREE
    if (scene.wallLine) {
        scene.scene.remove(scene.wallLine)
        scene.wallLine.geometry.dispose()
        scene.wallLine = null
    }
    if (drawing) {
        const line = new THREE.Geometry()
        drawing.line().forEach(corner => line.vertices.push(new THREE.Vector3(corner[0], drawing.height + SHOWN,
            corner[1])))
        scene.wallLine = new THREE.Line(line, new THREE.LineBasicMaterial({color: COLOR, depthTest: false,
            transparent: true}))
        scene.wallLine.renderOrder = 9
        scene.scene.add(scene.wallLine)
    }
}
