// SPDX-License-Identifier: Apache-2.0
// Shapes made by the SEAR panel's 3D view: the ground from its elevation, and boxes around objects without a model.
const MOST_POSTS = 255        // maximum grid posts per side of the terrain: indices have 16 bits

export function ground(terrain) {
    const THREE = window.THREE
    const sent = terrain.sent
    const rows = Math.min(MOST_POSTS, sent.rows)
    const columns = Math.min(MOST_POSTS, sent.columns)
    const positions = new window.Float32Array(3 * rows * columns)
    const places = new window.Float32Array(2 * rows * columns)
    for (let i = 0; i < rows * columns; i++) {
        const north = Math.floor(i / columns) / (rows - 1)
        const east = i % columns / (columns - 1)
        const x = sent.south + (sent.north - sent.south) * north
        const z = sent.west + (sent.east - sent.west) * east
        positions.set([x, terrain.height(x, z) || 0, z], 3 * i)
        places.set([east, north], 2 * i)
    }
    const corners = new window.Uint16Array(6 * (rows - 1) * (columns - 1))
    let at = 0
    for (let row = 0; row < rows - 1; row++) {
        for (let column = 0; column < columns - 1; column++) {
            const a = row * columns + column
            corners.set([a, a + 1, a + columns, a + 1, a + columns + 1, a + columns], at)
            at += 6
        }
    }
    const made = new THREE.BufferGeometry()
    const index = new THREE.BufferAttribute(corners, 1)
    if (made.setIndex) {
        made.setIndex(index)
    } else {
        made.addAttribute('index', index)
    }
    made.addAttribute('position', new THREE.BufferAttribute(positions, 3))
    made.addAttribute('uv', new THREE.BufferAttribute(places, 2))
    return made
}

/** Returns the box around an object without a model. */
export function boxAround(corners) {
    const low = [Infinity, Infinity, Infinity]
    const high = [-Infinity, -Infinity, -Infinity]
    corners.forEach(point => {
        for (let i = 0; i < 3; i++) {
            low[i] = Math.min(low[i], point[i])
            high[i] = Math.max(high[i], point[i])
        }
    })
    const box = new window.THREE.BoxGeometry(high[0] - low[0], high[1] - low[1], high[2] - low[2])
    box.applyMatrix(new window.THREE.Matrix4().makeTranslation((low[0] + high[0]) / 2, (low[1] + high[1]) / 2,
        (low[2] + high[2]) / 2))
    return box
}
