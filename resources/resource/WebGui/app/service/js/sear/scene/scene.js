// SPDX-License-Identifier: Apache-2.0
// The SEAR panel's 3D view, with MyRobotLab's three.js (release 73; 71 works, too). World frame: x north, y up, z east.
import {show as showBeams} from './beams.js'
import * as geometry from '../shared/geometry.js'
import {makeGrid} from './grid.js'
import * as shapes from './shapes.js'
import {Item} from './item.js'
import {Looks} from './looks.js'

const FIELD_OF_VIEW = 50      // degrees, of the free camera
const EYE_FIELD = 75          // degrees, through a sensor
const NEAREST = 0.05          // metres between the camera and its target
const FARTHEST = 20000
const LOWEST = 0.02          // minimum height of the camera above the ground, metres
const STEEPEST = 1.55         // radians: the map is the view straight down
const SLOWEST_MILLIS = 250    // longer pauses between two states are not smoothed
const SUN = [-0.35, 1, -0.25]
const SHADOW_PIXELS = 2048
const SKY = {light: ['#7fb2e5', '#e8f1fa', '#cfd3c8', '#b9bdb0'], dark: ['#0d1b2f', '#33475f', '#2c2f2b', '#20231f']}
const BY_PROCESSOR = /swiftshader|llvmpipe|softpipe|software|basic render/i
// A software renderer uses one shadow sample per pixel and no antialiasing, which would double the drawing time.
// Instead:
const COARSE = [1, 0.7, 0.5]  // resolution per axis relative to the page, for moving scenes: as high as time permits
const SLOW = 28               // frame time in milliseconds above which the resolution decreases
const FAST = 19               // and below which it increases
// resolution per axis relative to the page, for resting scenes: the browser averages pixels
const FINE = 1.5
const FINEST = 2e6            // maximum pixels of a frame that is finer than the page
const STILL_MILLIS = 300      // pause before a scene is drawn at full resolution
// between two software-rendered frames of a moving scene: some 30 frames per second are enough
const PAUSE_MILLIS = 15
const PATH = '#337ab7'

/** Whether the browser can draw 3D. @param fast only with a graphics card */
export function isPossible(fast) {
    try {
        const canvas = document.createElement('canvas')
        const gl = window.THREE && (canvas.getContext('webgl') || canvas.getContext('experimental-webgl'))
        return Boolean(gl) && !(fast && isByProcessor(gl))
    } catch (e) {
        return false
    }
}
function isByProcessor(gl) {
    const about = gl.getExtension('WEBGL_debug_renderer_info')
    return Boolean(about) && BY_PROCESSOR.test(gl.getParameter(about.UNMASKED_RENDERER_WEBGL))
}

/**
 * @param canvas to draw on
 * @param ask requests looks and pictures by their keys
 * @param repaint has the panel draw again
 */
export class Scene {
    constructor(canvas, ask, repaint) {
        const THREE = window.THREE
        this.canvas = canvas
        this.repaint = repaint
        this.byProcessor = !isPossible(true)
        this.renderer = new THREE.WebGLRenderer({canvas, antialias: !this.byProcessor, alpha: true})
        this.renderer.setClearColor(0x000000, 0)
        if (this.renderer.shadowMap) {
            this.renderer.shadowMap.enabled = true
            this.renderer.shadowMap.autoUpdate = false
            this.renderer.shadowMap.type = this.byProcessor ? THREE.BasicShadowMap : THREE.PCFShadowMap
        } else {
            this.renderer.shadowMapEnabled = true
        }
        this.scene = new THREE.Scene()
        this.scene.add(new THREE.HemisphereLight(0xffffff, 0x9a958a, 0.75))
        this.camera = new THREE.PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 1000)
        this.orbit = {target: new THREE.Vector3(), distance: 5, azimuth: Math.PI, elevation: 0.6}
        this.eyeField = EYE_FIELD
        this.objects = []           // in the order of the world's lists
        this.robots = []
        this.sensors = []
        this.looks = new Looks(ask, repaint, this.renderer.getMaxAnisotropy ? this.renderer.getMaxAnisotropy() : 1)
        this.ground = null
        this.land = null            // terrain, for its elevation; null without one
        this.time = 0               // simulated time shown, seconds
        this.seconds = 0            // simulated time since the state shown before
        this.arrived = 0
        this.period = 100
        this.coarse = 1             // index of the current resolution in COARSE
        this.millis = (SLOW + FAST) / 2     // smoothed frame time of moving scenes, at least PAUSE_MILLIS
        this.movedAt = 0
        this.unshaded = true        // whether the shadows are outdated
        this.pictures = 0           // frames drawn, and frames with new shadows
        this.shadings = 0
        this.light(10)
    }

    // ---- content
    // -----------------------------------------------------------------------------------------------------------------
    /** Adds a sun whose shadow covers an area around the camera's target. @param reach metres */
    light(reach) {
        const THREE = window.THREE
        if (this.sun) {
            this.scene.remove(this.sun)
        }
        const sun = new THREE.DirectionalLight(0xffffff, 0.55)
        sun.castShadow = true
        sun.shadowMapWidth = sun.shadowMapHeight = SHADOW_PIXELS
        sun.shadowCameraLeft = sun.shadowCameraBottom = -reach
        sun.shadowCameraRight = sun.shadowCameraTop = reach
        sun.shadowCameraNear = 0.1
        sun.shadowCameraFar = 8 * reach
        sun.shadowBias = -0.0005
        sun.shadowDarkness = 0.35
        sun.reach = reach
        this.scene.add(sun)
        this.scene.add(sun.target)
        this.sun = sun
        this.unshaded = true
    }

    /**
     * Updates the scene to a world message. @param terrain null without one @param beams whether to show sensor beams
     */
    show(world, terrain, beams) {
        const now = Date.now()
        if (this.time !== world.time) {
            const passed = now - this.arrived
            this.period = passed < SLOWEST_MILLIS ? 0.8 * this.period + 0.2 * passed : this.period
            this.arrived = now
            this.seconds = world.time - Math.max(this.time, Math.min(world.time, world.restedUntil || 0))
            this.time = world.time
        } else {
            this.seconds = 0
        }
        this.keep('objects', world.objects, this.scene)
        this.keep('robots', world.robots, this.scene)
        this.keep('sensors', world.sensors, this.scene)
        world.objects.forEach((object, i) => {
            this.objects[i].goTo(object.pose, now, this.seconds)
            this.dress(this.objects[i], object)
        })
        world.robots.forEach((robot, i) => {
            this.showRobot(this.robots[i], robot, now)
        })
        world.sensors.forEach((sensor, i) => {
            this.sensors[i].goTo(sensor.pose, now, this.seconds)
            showBeams(this, this.sensors[i], sensor, beams)
        })
        this.land = terrain
        this.showGround(terrain)
        this.looks.want()
    }

    /** Keeps one item for each element of a list; removes items of another world. */
    keep(list, sources, parent) {
        const items = this[list]
        for (let i = 0; i < Math.max(items.length, sources.length); i++) {
            if (items[i] && items[i].source !== sources[i]) {
                items[i].parent.remove(items[i].holder)
                this.scene.remove(items[i].extra)
                this.scene.remove(items[i].marker)
                items[i] = null
                this.unshaded = true
            }
            if (!items[i] && i < sources.length) {
                items[i] = new Item(parent, sources[i])
            }
        }
        items.length = sources.length
    }

    /** Gives an item its surface once that is loaded. */
    dress(item, object) {
        if (item.dressed) {
            return
        }
        if (object.look === undefined || object.ground) {
            item.dressed = true
            return
        }
        const parts = object.look ? this.looks.look(object.look) : object.corners.length
            ? [shapes.boxAround(object.corners)] : []
        const texture = object.picture ? this.looks.texture(object.picture) : null
        if (!parts || texture === undefined) {
            return
        }
        item.dressed = true
        this.unshaded = true
        const material = new window.THREE.MeshLambertMaterial({color: texture ? 0xffffff : object.color, map: texture,
            side: object.type === 'Model' ? window.THREE.DoubleSide : window.THREE.FrontSide})
        parts.forEach(part => {
            const mesh = new window.THREE.Mesh(part, material)
            mesh.castShadow = object.type !== 'Floor'
            mesh.receiveShadow = true
            mesh.named = object
            item.holder.add(mesh)
        })
    }

    showRobot(item, robot, now) {
        item.goTo(robot.pose, now, this.seconds)
        item.parts = item.parts || robot.parts.map(part => new Item(item.holder, part))
        robot.parts.forEach((part, i) => {
            item.parts[i].goTo(geometry.placeOf(robot, i), now, this.seconds)
            this.dress(item.parts[i], part)
        })
        this.showLights(item, robot, now)
        this.showPath(item, robot)
    }

    /** Shows lights, lit or dark. */
    showLights(item, robot, now) {
        const THREE = window.THREE
        item.lights = item.lights || (robot.leds || []).map(led => {
            const light = new Item(item.holder, led)
            light.bulb = new THREE.Mesh(new THREE.SphereGeometry(led.size / 2, 12, 8), new THREE.MeshBasicMaterial())
            light.holder.add(light.bulb)
            return light
        })
        item.lights.forEach((light, i) => {
            light.goTo(robot.turnedLeds ? robot.turnedLeds[i] : light.source.pose, now, this.seconds)
            light.bulb.material.color.set(light.source.dark)
            .lerp(new THREE.Color(light.source.color), robot.lights[i] || 0)
        })
    }

    showPath(item, robot) {
        const last = robot.path[robot.path.length - 1]
        if (item.pathEnd === last) {
            return
        }
        item.pathEnd = last
        const THREE = window.THREE
        if (item.extra) {
            this.scene.remove(item.extra)
            item.extra.geometry.dispose()
        }
        const line = new THREE.Geometry()
        robot.path.forEach(point => {
            line.vertices.push(new THREE.Vector3(point[0], robot.pose[1] + 0.005, point[1]))
        })
        item.extra = new THREE.Line(line, new THREE.LineBasicMaterial({color: PATH}))
        this.scene.add(item.extra)
    }

    // ---- the ground
    // -----------------------------------------------------------------------------------------------------------------
    showGround(terrain) {
        const stamp = terrain ? terrain.sent.stamp : null
        const picture = terrain && terrain.picture.complete && terrain.picture.naturalWidth > 0
        if (this.ground && this.ground.stamp !== stamp) {
            this.scene.remove(this.ground)
            this.ground = null
        }
        if (!terrain || this.ground || !picture) {
            return
        }
        const THREE = window.THREE
        const texture = new THREE.Texture(terrain.picture)
        texture.minFilter = THREE.LinearFilter
        texture.needsUpdate = true
        this.ground = new THREE.Mesh(shapes.ground(terrain),
            new THREE.MeshBasicMaterial({map: texture, side: THREE.DoubleSide}))
        this.ground.stamp = stamp
        this.scene.add(this.ground)
    }

    /** Shows or hides the metre grid with the axes. */
    showGrid(on) {
        if (on && !this.grid) {
            this.grid = makeGrid()
            this.scene.add(this.grid)
        }
        if (this.grid) {
            this.grid.visible = on
        }
    }

    // Fits the camera to everything but the ground. @param area see geometry.area @param points further points that
    // must be visible
    /**
     * Has the camera show everything but the ground.
     * @param area see geometry.area @param points that have to be seen, too, whatever the area says
     */
    fit(area, points) {
        this.orbit.target.set(area.x, area.y, area.z)
        this.orbit.distance = Math.min(
        FARTHEST, Math.max(1, 1.15 * area.size / Math.tan(FIELD_OF_VIEW * Math.PI / 360) / 2))
        this.orbit.azimuth = Math.PI * 0.92
        this.orbit.elevation = 0.65
        while (this.orbit.distance < FARTHEST && !this.sees(points)) {
            this.orbit.distance *= 1.05
        }
    }

    /** Whether points [x, y, z] are all visible to the free camera. */
    sees(points) {
        this.aim(-1)
        return points.every(([x, y, z]) => new window.THREE.Vector3(x, y, z).project(this.camera).toArray()
            .every(at => Math.abs(at) <= 1))
    }

    zoom(factor) {
        this.orbit.distance = Math.min(FARTHEST, Math.max(NEAREST, this.orbit.distance / factor))
        this.stayAbove()
    }

    /** Returns the camera's position. */
    position() {
        const orbit = this.orbit
        const flat = orbit.distance * Math.cos(orbit.elevation)
        return new window.THREE.Vector3(orbit.target.x + flat * Math.cos(orbit.azimuth), orbit.target.y
            + orbit.distance * Math.sin(orbit.elevation),
            orbit.target.z + flat * Math.sin(orbit.azimuth))
    }

    /**
     * Keeps the camera above the ground: above the terrain, else above height 0, or above its target if that is lower.
     */
    stayAbove() {
        const orbit = this.orbit
        const at = this.position()
        const height = this.land ? this.land.height(at.x, at.z) : null
        const least = (height === null ? Math.min(0, orbit.target.y) : height) + LOWEST
        const sine = (least - orbit.target.y) / orbit.distance
        if (at.y < least && sine < 1) {
            orbit.elevation = Math.asin(Math.max(-1, sine))
        }
    }

    /** Turns the camera. @param right mouse movement in pixels, likewise down */
    turn(right, down) {
        this.orbit.azimuth += right * 0.008
        this.orbit.elevation = Math.max(-STEEPEST, Math.min(STEEPEST, this.orbit.elevation + down * 0.008))
        this.stayAbove()
    }

    /** Moves the camera parallel to its image plane, so that the point under the mouse stays there. */
    pan(right, down) {
        const metres = 2 * this.orbit.distance * Math.tan(FIELD_OF_VIEW * Math.PI / 360) / Math.max(
            1, this.canvas.clientHeight)
        const e = this.camera.matrixWorld.elements
        const least = Math.min(0, this.orbit.target.y)
        for (let i = 0; i < 3; i++) {
            this.orbit.target.setComponent(i, this.orbit.target.getComponent(i) - e[i] * right * metres
                + e[4 + i] * down * metres)
        }
        if (!this.land) {
            this.orbit.target.y = Math.max(least, this.orbit.target.y)
        }
        this.stayAbove()
    }

    follow(robot) {
        const at = this.robots[robot] && this.robots[robot].shown
        if (at) {
            this.orbit.target.set(at[0], at[1], at[2])
        }
    }

    /** Aims the camera. @param sensor number of the sensor to look through; -1 for the free camera */
    aim(sensor) {
        const camera = this.camera
        const orbit = this.orbit
        const eye = this.sensors[sensor] && this.sensors[sensor].shown
        camera.aspect = this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight)
        camera.fov = eye ? EYE_FIELD : FIELD_OF_VIEW
        camera.near = eye ? 0.02 : Math.max(0.01, orbit.distance / 200)
        camera.far = Math.max(500, 60 * orbit.distance)
        camera.updateProjectionMatrix()
        if (eye) {
            camera.position.set(eye[0], eye[1], eye[2])
            const at = geometry.rotate(eye, [0, 0, 1])
            const up = geometry.rotate(eye, [0, 1, 0])
            camera.up.set(up[0], up[1], up[2])
            camera.lookAt(new window.THREE.Vector3(eye[0] + at[0], eye[1] + at[1], eye[2] + at[2]))
        } else {
            camera.position.copy(this.position())
            camera.up.set(0, 1, 0)
            camera.lookAt(orbit.target)
        }
        camera.updateMatrixWorld(true)
    }

    // ---- drawing
    // -----------------------------------------------------------------------------------------------------------------
    /**
     * Draws.
     * @param sensor see {@link aim} @param followed number of the robot in the middle, -1 for none @param dark the
     * theme
     */
    draw(sensor, followed, dark) {
        const now = Date.now()
        let moving = false
        const move = item => {
            const before = item.shown
            moving = item.move(now, this.period) || moving
            this.unshaded = this.unshaded || item.shown !== before
        }
        this.objects.forEach(move)
        this.sensors.forEach(move)
        this.robots.forEach(robot => {
            move(robot)
            robot.parts.forEach(move)
            robot.lights.forEach(move)
        })
        this.follow(followed)
        this.aim(sensor)
        this.shade()
        this.paintSky(dark)
        const width = this.canvas.clientWidth
        const height = this.canvas.clientHeight
        const ratio = this.ratio(width * height, moving, now)
        if (this.size !== width + ' ' + height + ' ' + ratio) {
            this.size = width + ' ' + height + ' ' + ratio
            this.renderer.setPixelRatio(ratio)
            this.renderer.setSize(width, height, false)
        }
        if (this.renderer.shadowMap) {
            this.renderer.shadowMap.needsUpdate = this.unshaded
        }
        this.pictures++
        this.shadings += this.unshaded ? 1 : 0
        this.unshaded = false
        this.renderer.render(this.scene, this.camera)
        if (moving && this.byProcessor) {
            window.setTimeout(() => {
                this.took(Date.now() - now)
                this.repaint()
            }, PAUSE_MILLIS)
        } else if (moving) {
            this.repaint()
        }
    }

    /** Returns the resolution per axis relative to the page. @param area pixels of the page */
    ratio(area, moving, now) {
        const plain = Math.min(2, window.devicePixelRatio || 1)
        if (!this.byProcessor) {
            return plain
        }
        return this.isCoarse(moving, now) ? COARSE[this.coarse] * plain
            : Math.max(plain, Math.min(FINE * plain, Math.sqrt(FINEST / Math.max(1, area))))
    }

    /** Adapts the resolution to the time of a software-rendered frame. */
    took(millis) {
        this.millis = 0.9 * this.millis + 0.1 * Math.min(4 * SLOW, millis)
        const other = this.coarse + (this.millis > SLOW ? 1 : this.millis < FAST ? -1 : 0)
        if (other !== this.coarse && COARSE[other]) {
            this.coarse = other
            this.millis = (SLOW + FAST) / 2
        }
    }

    /** Whether the resolution is reduced, because the scene moves or did so just now; schedules a sharp frame. */
    isCoarse(moving, now) {
        const seenFrom = this.camera.matrixWorld.elements.join(' ')
        this.movedAt = moving || this.seenFrom && this.seenFrom !== seenFrom ? now : this.movedAt
        this.seenFrom = seenFrom
        const coarse = now - this.movedAt < STILL_MILLIS
        if (coarse && !moving) {
            window.clearTimeout(this.sharpening)
            this.sharpening = window.setTimeout(this.repaint, STILL_MILLIS)
        }
        return coarse
    }

    /** Moves the shadow to the camera's target. */
    shade() {
        const reach = Math.min(200, Math.max(2, 1.5 * this.orbit.distance))
        if (reach > 1.5 * this.sun.reach || reach < this.sun.reach / 1.5) {
            this.light(reach)
        }
        const target = this.orbit.target
        this.unshaded = this.unshaded || !this.sun.target.position.equals(target)
        this.sun.target.position.copy(target)
        this.sun.position.set(target.x + SUN[0] * 3 * reach, target.y + SUN[1] * 3 * reach,
            target.z + SUN[2] * 3 * reach)
        this.sun.target.updateMatrixWorld()
    }

    /** Paints the background behind the canvas: sky above the horizon, haze below. */
    paintSky(dark) {
        const forward = this.camera.getWorldDirection
            ? this.camera.getWorldDirection() : new window.THREE.Vector3(0, 0, -1)
        const pitch = Math.asin(Math.max(-1, Math.min(1, forward.y)))
        let horizon = 50 + 50 * Math.tan(Math.max(-1.4, Math.min(1.4, pitch))) / Math.tan(
        this.camera.fov * Math.PI / 360)
        horizon = Math.max(-400, Math.min(500, horizon))
        const colors = SKY[dark ? 'dark' : 'light']
        const style = 'linear-gradient(' + colors[0] + ' ' + (horizon - 120) + '%, ' + colors[1] + ' ' + horizon + '%, '
        + colors[2] + ' ' + horizon
            + '%, ' + colors[3] + ' ' + (horizon + 100) + '%)'
        if (this.sky !== style) {
            this.sky = style
            this.canvas.style.background = style
        }
    }

    // ---- picking
    // -----------------------------------------------------------------------------------------------------------------
    /** Returns the canvas position of a point of the world, in pixels. */
    toScreen(x, y, z) {
        const at = new window.THREE.Vector3(x, y, z).project(this.camera)
        return {x: (at.x + 1) / 2 * this.canvas.clientWidth, y: (1 - at.y) / 2 * this.canvas.clientHeight,
            seen: Math.abs(at.z) < 1}
    }

    /**
     * Finds what is under a point of the canvas: object or part, the point, and the surface's normal there, in the
     * world; null for none.
     * @param without an object to ignore
     */
    pick(x, y, without) {
        const THREE = window.THREE
        const caster = new THREE.Raycaster()
        caster.setFromCamera(new THREE.Vector2(2 * x / this.canvas.clientWidth - 1,
            1 - 2 * y / this.canvas.clientHeight), this.camera)
        const found = caster.intersectObjects(this.scene.children, true)
            .filter(one => one.object.named ? one.object.named !== without : one.object === this.ground)[0]
        return found ? {object: found.object.named || null, point: found.point.toArray(),
            normal: found.face ? found.face.normal.clone().transformDirection(found.object.matrixWorld)
                .toArray() : null} : null
    }

    close() {
        if (this.renderer.forceContextLoss) {
            this.renderer.forceContextLoss()
        }
    }
}
