// What shows which object is selected in the view in space of the SEAR panel: a frame around it, and handles that turn it and change its size.
(function() {
    var geometry = window.SEARPanel.geometry
    var pointing = window.SEARPanel.pointing
    var FRAME = 0xff7f0e
    var EYE = 0x8e5bd0
    var FAR = 1                 // metres from a sensor to the far end of what one sees through its eye
    var HANDLES = [['x', 0xd9534f], ['y', 0x5cb85c], ['z', 0x337ab7], ['turn', 0xf0ad4e]]
    var SIZE = 0.012            // of a handle, as a share of the camera's distance
    var GAP = 0.06              // between the frame and the handle that turns, likewise
    var GROUND = 20             // metres that the grid is wide, to either side
    var MARKER = 0.02           // radius in metres of what stands for a sensor, which has no shape

    /** Which parameter is how long along which axis, for the handles: {x: {name, share}, ..}; share is how much of the length it is. */
    function sizesOf(type) {
        var names = type ? type.parameters.map(function(parameter) {
            return parameter.name
        }) : []
        function has(name) {
            return names.indexOf(name) >= 0
        }
        var sizes = {}
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

    function lines(points, color) {
        var THREE = window.THREE
        var shape = new THREE.Geometry()
        points.forEach(function(point) {
            shape.vertices.push(new THREE.Vector3(point[0], point[1], point[2]))
        })
        var material = new THREE.LineBasicMaterial({color: color})
        return THREE.LineSegments ? new THREE.LineSegments(shape, material) : new THREE.Line(shape, material, THREE.LinePieces)
    }
    /** The twelve edges of a cube of side 1. */
    function edges() {
        var points = []
        for (var axis = 0; axis < 3; axis++) {
            for (var corner = 0; corner < 4; corner++) {
                [-0.5, 0.5].forEach(function(end) {
                    var point = [0, 0, 0]
                    point[axis] = end
                    point[(axis + 1) % 3] = corner & 1 ? 0.5 : -0.5
                    point[(axis + 2) % 3] = corner & 2 ? 0.5 : -0.5
                    points.push(point)
                })
            }
        }
        return points
    }

    /** What is seen from the origin: four edges and the far end of a pyramid that is 2 wide, 2 high and 1 long, along z. */
    function pyramid() {
        var corners = [[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]]
        var points = []
        corners.forEach(function(corner, i) {
            points.push([0, 0, 0], corner, corner, corners[(i + 1) % 4])
        })
        return points
    }

    function make(scene) {
        var THREE = window.THREE
        var group = new THREE.Object3D()
        group.frame = lines(edges(), FRAME)
        group.add(group.frame)
        group.eye = lines(pyramid(), EYE)
        group.add(group.eye)
        group.knobs = {}
        HANDLES.forEach(function(one) {
            var shape = one[0] === 'turn' ? new THREE.CylinderGeometry(1.3, 1.3, 0.5, 20) : new THREE.BoxGeometry(1.6, 1.6, 1.6)
            var knob = new THREE.Mesh(shape, new THREE.MeshBasicMaterial({color: one[1], depthTest: false, transparent: true}))
            knob.renderOrder = 10
            knob.handle = one[0]
            group.knobs[one[0]] = knob
            group.add(knob)
        })
        scene.scene.add(group)
        return group
    }

    /** Shows what is selected. @param found see pointing.find, null for nothing @param extent its corners @param sizes see sizesOf */
    function show(scene, found, extent, sizes) {
        if (!scene.handles) {
            if (!found) {
                return
            }
            scene.handles = make(scene)
        }
        var group = scene.handles
        group.visible = Boolean(found)
        if (!found) {
            return
        }
        var pose = found.pose
        group.position.set(pose[0], pose[1], pose[2])
        group.quaternion.set(pose[3], pose[4], pose[5], pose[6])
        var low = extent[0]
        var high = extent[1]
        var middle = [0, 1, 2].map(function(i) {
            return (low[i] + high[i]) / 2
        })
        group.frame.position.fromArray(middle)
        group.frame.scale.set(high[0] - low[0], Math.max(1e-3, high[1] - low[1]), high[2] - low[2])
        var from = scene.camera.position
        var away = Math.sqrt(Math.pow(from.x - pose[0], 2) + Math.pow(from.y - pose[1], 2) + Math.pow(from.z - pose[2], 2))
        HANDLES.forEach(function(one, i) {
            var knob = group.knobs[one[0]]
            var at = middle.slice()
            if (one[0] === 'turn') {
                at[2] = high[2] + GAP * away
            } else {
                at[i] = high[i]
            }
            knob.visible = one[0] === 'turn' || Boolean(sizes[one[0]])
            knob.position.fromArray(at)
            knob.scale.set(SIZE * away, SIZE * away, SIZE * away)
        })
        showEye(scene, group.eye, found)
        group.updateMatrixWorld(true)
    }
    /** Of a sensor, what the view shows when one looks through its eye. */
    function showEye(scene, eye, found) {
        var up = Math.tan(scene.eyeField * Math.PI / 360)
        eye.visible = Boolean(found.robot) && found.robot.parts.indexOf(found.object) < 0
        eye.scale.set(FAR * up * scene.camera.aspect, FAR * up, FAR)
    }

    /** The handle under a pixel: 'x', 'y', 'z' or 'turn'; null for none. */
    function pick(scene, x, y) {
        if (!scene.handles || !scene.handles.visible) {
            return null
        }
        var knobs = HANDLES.map(function(one) {
            return scene.handles.knobs[one[0]]
        }).filter(function(knob) {
            return knob.visible
        })
        var hit = pointing.ray(scene, x, y).caster.intersectObjects(knobs, false)[0]
        return hit ? hit.object.handle : null
    }
    /** Where a handle is in the world. */
    function place(scene, handle) {
        return scene.handles ? new window.THREE.Vector3().setFromMatrixPosition(scene.handles.knobs[handle].matrixWorld).toArray() : null
    }

    /** While one builds: a grid on the ground, and something to click on for each sensor. */
    function showAids(scene, world, building) {
        var THREE = window.THREE
        if (building && !scene.grid) {
            var points = []
            for (var i = -GROUND; i <= GROUND; i++) {
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
        world.sensors.forEach(function(sensor, k) {
            var item = scene.sensors[k]
            if (building && item && !item.marker) {
                item.marker = new THREE.Object3D()
                var ball = new THREE.Mesh(new THREE.SphereGeometry(MARKER, 12, 8), new THREE.MeshLambertMaterial({color: FRAME}))
                ball.named = sensor
                item.marker.add(ball)
                scene.scene.add(item.marker)
            }
            if (item && item.marker) {
                var pose = geometry.frame(sensor.pose)
                item.marker.position.set(pose[0], pose[1], pose[2])
                item.marker.visible = building
            }
        })
    }

    window.SEARPanel.handles = {show: show, pick: pick, place: place, showAids: showAids, sizesOf: sizesOf}
})()
