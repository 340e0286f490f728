// SPDX-License-Identifier: Apache-2.0
// Sensor beams in the SEAR panel's 3D view: scan planes of LIDARs, cones and hits of distance sensors, fields of view
// of cameras.
const HIT = '#d9534f'
const BEAM = '#f0ad4e'
const CONE = '#d9534f'
const EYE = '#2e9bd6'        // as in the Java window
const CORNERS = 4

function seeThrough(color, opacity) {
    return new window.THREE.MeshBasicMaterial(
        {color, transparent: true, opacity, side: window.THREE.DoubleSide, depthWrite: false})
}

/** Shows a sensor's beams in an item of a scene. @param beams whether to show them */
export function show(scene, item, sensor, beams) {
    const THREE = window.THREE
    if (!item.dressed) {
        item.dressed = true
        angular.forEach(sensor.cones, cone => {
            item.holder.add(coneOf(cone))
        })
        if (sensor.eye) {
            item.holder.add(eyeOf(sensor.eye.edge))
        }
        if (sensor.ranges) {
            item.fan = new THREE.Mesh(new THREE.BufferGeometry(), seeThrough(BEAM, 0.22))
            item.fan.frustumCulled = false
            item.holder.add(item.fan)
        }
        if (sensor.hit !== undefined) {
            item.hit = new THREE.Mesh(new THREE.SphereGeometry(1, 8, 6), new THREE.MeshBasicMaterial({color: HIT}))
            scene.scene.add(item.hit)
            item.extra = item.hit
        }
    }
    item.holder.visible = beams
    if (item.hit) {
        item.hit.visible = Boolean(beams && sensor.hit)
        if (sensor.hit) {
            item.hit.position.set(sensor.hit[0], sensor.hit[1], sensor.hit[2])
            const size = 0.006 * Math.max(0.5, scene.orbit.distance)
            item.hit.scale.set(size, size, size)
        }
    }
    if (item.fan && item.ranges !== sensor.ranges) {
        item.ranges = sensor.ranges
        spreadFan(item.fan, sensor)
    }
}

/** Returns a cone around the forward axis, +z, turned left by its yaw. */
function coneOf(cone) {
    const THREE = window.THREE
    const radius = Math.max(0.003, Math.tan(cone.halfAngle * Math.PI / 180) * cone.range)
    const shape = new THREE.CylinderGeometry(0, radius, cone.range, 24, 1, true)
    shape.applyMatrix(new THREE.Matrix4().makeTranslation(0, -cone.range / 2, 0))
    shape.applyMatrix(new THREE.Matrix4().makeRotationX(-Math.PI / 2))
    const mesh = new THREE.Mesh(shape, seeThrough(CONE, 0.13))
    mesh.rotation.y = (cone.yaw || 0) * Math.PI / 180
    return mesh
}

/**
 * Returns the outline of a camera's field of view.
 * @param edge x, y, z of points around its picture, the same number per side
 */
function eyeOf(edge) {
    const THREE = window.THREE
    const count = edge.length / 3
    const points = []
    function point(i) {
        points.push(edge[3 * (i % count)], edge[3 * (i % count) + 1], edge[3 * (i % count) + 2])
    }
    for (let i = 0; i < count; i++) {
        point(i)
        point(i + 1)
    }
    for (let side = 0; side < CORNERS; side++) {
        points.push(0, 0, 0)
        point(side * count / CORNERS)
    }
    const shape = new THREE.BufferGeometry()
    shape.addAttribute('position', new THREE.BufferAttribute(new window.Float32Array(points), 3))
    const material = new THREE.LineBasicMaterial({color: EYE})
    return THREE.LineSegments ? new THREE.LineSegments(shape, material) : new THREE.Line(
    shape, material, THREE.LinePieces)
}

/** Draws a triangle for each two adjacent beams with hits; a beam without a hit leaves a gap. */
function spreadFan(fan, sensor) {
    const THREE = window.THREE
    const count = Math.max(0, sensor.ranges.length - 1)
    const held = fan.geometry.attributes.position
    const points = held && held.array.length === 9 * count ? held.array : new window.Float32Array(9 * count)
    for (let i = 0; i < count; i++) {
        const a = sensor.ranges[i]
        const b = sensor.ranges[i + 1]
        const shown = a !== null && b !== null
        corner(points, 9 * i + 3, sensor, i, shown ? a : 0)
        corner(points, 9 * i + 6, sensor, i + 1, shown ? b : 0)
    }
    if (held && held.array === points) {
        held.needsUpdate = true
    } else {
        fan.geometry.dispose()
        fan.geometry = new THREE.BufferGeometry()
        fan.geometry.addAttribute('position', new THREE.BufferAttribute(points, 3))
    }
}
function corner(points, at, sensor, beam, metres) {
    for (let i = 0; i < 3; i++) {
        points[at + i] = sensor.fan[beam][i] * metres
    }
}
