// SPDX-License-Identifier: Apache-2.0
// Ground of the 3D view while building: a metre grid, and axes with labels.

const HALF = 10               // metres to each side
const FINE = '#8a929c'
const AXES = [['x north', '#c62828', [1, 0]], ['z east', '#1565c0', [0, 1]]]
const ABOVE = 0.004           // metres; keeps the grid above a floor at height 0
const WORDS = {width: 128, height: 32}

function lines(points, color, opacity) {
    const THREE = window.THREE
    const geometry = new THREE.Geometry()
    points.forEach(point => {
        geometry.vertices.push(new THREE.Vector3(point[0], ABOVE, point[1]))
    })
    const material = new THREE.LineBasicMaterial({color, transparent: true, opacity})
    return THREE.LineSegments ? new THREE.LineSegments(geometry, material) : new THREE.Line(
    geometry, material, THREE.LinePieces)
}

/** Returns a label that faces the camera. @param size its height, metres */
function words(text, color, x, z, size) {
    const THREE = window.THREE
    const canvas = document.createElement('canvas')
    canvas.width = WORDS.width
    canvas.height = WORDS.height
    const pen = canvas.getContext('2d')
    pen.font = 'bold 24px sans-serif'
    pen.textAlign = 'center'
    pen.lineWidth = 4
    pen.strokeStyle = '#fff'
    pen.strokeText(text, WORDS.width / 2, 24)
    pen.fillStyle = color
    pen.fillText(text, WORDS.width / 2, 24)
    const texture = new THREE.Texture(canvas)
    texture.minFilter = THREE.LinearFilter
    texture.needsUpdate = true
    const sprite = new THREE.Sprite(new THREE.SpriteMaterial({map: texture, depthTest: false}))
    sprite.position.set(x, 0.02, z)
    sprite.scale.set(size * WORDS.width / WORDS.height, size, 1)
    return sprite
}

/** Returns a three.js object with grid, axes and labels. */
export function makeGrid() {
    const grid = new window.THREE.Object3D()
    const points = []
    for (let i = -HALF; i <= HALF; i++) {
        points.push([i, -HALF], [i, HALF], [-HALF, i], [HALF, i])
    }
    grid.add(lines(points, FINE, 0.55))
    AXES.forEach(axis => {
        const way = axis[2]
        grid.add(lines([[0, 0], [2 * way[0], 2 * way[1]]], axis[1], 1))
        grid.add(words(axis[0], axis[1], 2.25 * way[0], 2.25 * way[1], 0.2))
        for (let metres = 1; metres <= 5; metres += metres < 2 ? 1 : 3) {
            grid.add(words(metres + ' m', '#444', metres * way[0] + 0.12 * way[1], metres * way[1]
                + 0.12 * way[0], 0.13))
        }
    })
    return grid
}
