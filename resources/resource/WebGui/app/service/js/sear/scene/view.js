// SPDX-License-Identifier: Apache-2.0
// The view of the SEAR panel: 3D if the browser supports it, else the map.
import * as geometry from '../shared/geometry.js'
import * as map from './map.js'
import {Pictures} from './pictures.js'
import {recall, remember, whenPageChanges} from '../shared/page.js'
import {Scene, isPossible} from './scene.js'

const MODE = 'sear.view'      // local storage key of the chosen view
const MOST_LISTED = 100       // objects of the world in the list; the others on request
const BENCH = 4               // size of an empty view while building, metres
const TURN = 20               // mouse movement in pixels that an arrow key corresponds to
const ARROWS = {ArrowLeft: [-TURN, 0], ArrowRight: [TURN, 0], ArrowUp: [0, TURN], ArrowDown: [0, -TURN]}

/** The view of one panel. */
export class View {
    constructor(panel, messages, world, ground, picture) {
        this.panel = panel
        this.messages = messages
        this.world = world
        this.ground = ground
        this.picture = picture
        this.overlay = null     // drawn with the world, see view.overlaidBy
        this.space = null       // made when first shown
        this.fits = {}          // by mode: whether the view is fitted to the world, or set by the user
        this.pictures = new Pictures(keys => panel.msg.send('getLooks', keys), picture.repaint)
        this.benched = false    // whether the view shows empty ground for building
        this.x = 0
        this.z = 0              // centre of the map, metres
        this.scale = 60         // scale of the map, pixels per metre
        this.fitted = false
        this.chosen = false     // whether the user has zoomed or moved
        this.building = false   // whether the user is building
        this.listed = MOST_LISTED
        this.mode = this.firstMode() // 'space' or 'map'
        this.noSpace = ''       // why there is no 3D view
        this.beams = true
        this.follow = false
        this.robot = null       // the driven and followed robot
        this.eye = ''           // name of the sensor to look through
        this.redraw = picture.repaint

        /** Shows another world. The user's zoom stays while the robots are the same. */
        world.news.hear(shown => {
            const robots = shown.robots.map(robot => robot.name).join('\n')
            if (!shown.robots.some(robot => this.isChosen(robot))) {
                this.robot = shown.robots.length ? shown.robots[0].name : null
            }
            this.listed = MOST_LISTED
            this.chosen = Boolean(this.chosen && (this.robots === robots || this.building))
            if (!this.chosen) {
                this.refit()
            }
            this.robots = robots
        })

        picture.drawnBy({canvas: () => this.canvas(), draw: () => this.draw()})
        whenPageChanges(panel.scope, picture.repaint)       // also digests, and so measures the layout
        panel.scope.$on('$destroy', () => {
            if (this.space) {
                this.space.close()
            }
        })
        panel.scope.$watch(() => this.sizeOf(), () => {
            this.draw()
            world.look()
        })
        this.handlers = {
            onLooks: sent => {
                this.pictures.take(sent)
                if (this.space) {
                    this.space.looks.take(sent)
                }
            }
        }
    }

    firstMode() {
        const mode = recall(MODE)
        return mode === 'map' || !isPossible(mode !== 'space') ? 'map' : 'space'
    }

    /** Shows the 3D view if the browser has one, unless the user has chosen the map. */
    showSpace() {
        if (recall(MODE) !== 'map' && isPossible(false)) {
            this.mode = 'space'
            this.panel.timeout(this.picture.repaint)
        }
    }

    setMode(mode) {
        if (mode === 'space' && !isPossible(false)) {
            this.noSpace = 'This browser has no WebGL and shows only the map'
            return
        }
        this.mode = mode
        remember(MODE, mode, this.messages, 'the view')
        this.panel.timeout(this.picture.repaint)      // when the canvas exists
    }

    canvas() {
        return this.panel.element(this.mode === 'space' ? 'scene' : 'view')
    }

    /** Returns width and height of the canvas; folding adjacent parts changes them, too. */
    sizeOf() {
        const shown = this.canvas()
        return shown ? shown.clientWidth + ' ' + shown.clientHeight : ''
    }

    /** Returns a ground point's position on the map. Tests use it, too. */
    toScreen(x, z) {
        return map.projection(this.panel.element('view'), this)(x, z)
    }

    /** Returns the 3D view; null before it was shown. */
    scene() {
        return this.space
    }

    zoom(factor) {
        if (this.mode === 'space' && this.space) {
            this.space.zoom(factor)
        } else {
            this.scale = Math.min(2000, Math.max(0.002, this.scale * factor))
        }
        this.chosen = true
        this.picture.repaint()
    }

    fit() {
        this.refit()
        this.chosen = false
        this.eye = ''
        this.picture.repaint()
    }

    /** Notes that the user has chosen the viewpoint. */
    choose() {
        this.chosen = true
    }

    build(on) {
        this.building = on
        if (on && this.world.isEmpty()) {
            this.fit()          // close enough to see a first object well, without it filling the view
        }
        this.picture.repaint()
    }

    driveRobot(name) {
        this.robot = name
    }

    /**
     * @param drawn hold() runs before the world is drawn, decorate(scene, world) and decorateMap(canvas) after it;
     * isBusy(): during a drag
     */
    overlaidBy(drawn) {
        this.overlay = drawn
    }

    /** Fits each view to the world when it is drawn next. */
    refit() {
        this.fitted = false      // the shown one
        this.fits = {}
        this.benched = false
    }

    isChosen(robot) {
        return robot.name === this.robot
    }

    listAll() {
        this.listed = Infinity
    }

    // ---- drawing
    // -----------------------------------------------------------------------------------------------------------------
    draw() {
        const shown = this.canvas()
        if (!this.picture.width()) {
            return
        }
        const seen = this.world.shown()
        const size = this.sizeOf()
        if (this.size !== size && !this.chosen) {
            this.refit()
        }
        this.size = size
        if (this.building && (!seen || !seen.objects.length && !seen.robots.length)) {
            this.benched = true
            this.x = this.z = 0
        }
        this.overlay.hold()
        if (this.mode === 'space') {
            this.drawScene(shown, seen)
        } else {
            this.drawMap(shown, seen)
        }
        this.fitted = Boolean(this.fits[this.mode])
    }

    followed(seen) {
        return this.follow && !this.overlay.isBusy() && seen.robots.length
            ? Math.max(0, seen.robots.findIndex(robot => this.isChosen(robot))) : -1
    }

    drawMap(shown, seen) {
        const shapes = seen ? geometry.shapesOf(seen) : []
        if (this.benched && !this.fits.map) {
            this.scale = Math.min(shown.clientWidth, shown.clientHeight) / BENCH
            this.fits.map = true
        } else if (seen && !this.fits.map) {
            geometry.fit(this, shapes, shown)
            this.fits.map = true
        }
        if (seen && this.followed(seen) >= 0) {
            const robot = seen.robots[this.followed(seen)]
            this.x = robot.pose[0]
            this.z = robot.pose[2]
        }
        map.draw(shown, this, seen, this.ground.of(seen), shapes, this.pictures)
        this.overlay.decorateMap(shown)
    }

    drawScene(shown, drawn) {
        if (!this.space) {
            this.space = new Scene(shown, keys => {
                this.panel.msg.send('getLooks', keys)
            }, this.picture.repaint)
        }
        const seen = drawn || {objects: [], robots: [], sensors: []}
        const terrain = this.ground.of(seen)
        this.space.show(seen, terrain, this.beams)
        this.space.showGrid(this.building)
        if (this.benched && !this.fits.space) {
            this.space.fit({x: 0, y: 0, z: 0, size: BENCH}, [])
            this.fits.space = true
        } else if (!this.fits.space && (seen.objects.length || seen.robots.length)) {
            const area = geometry.area(geometry.shapesOf(seen))
            if (area) {
                this.space.fit({x: area.x, y: this.heightOf(seen, terrain, area), z: area.z, size: area.size},
                    geometry.corners(seen.objects))
            }
            this.fits.space = true
        }
        this.overlay.decorate(this.space, seen)
        this.space.draw(this.sensorsOf(seen).indexOf(this.eye), this.followed(seen),
            geometry.isLight(window.getComputedStyle(shown).color))
    }

    /** Returns the height to look at: that of the first robot, else of the ground. */
    heightOf(seen, terrain, area) {
        return seen.robots.length ? seen.robots[0].pose[1] : terrain ? terrain.height(area.x, area.z) || 0 : 0
    }

    sensorsOf(seen) {
        return seen.sensors.map(sensor => sensor.name)
    }

    /** Returns the names of the sensors to look through. */
    eyes() {
        const seen = this.world.shown()
        return seen ? this.sensorsOf(seen) : []
    }

    /** Turns or pans the 3D view. @param right pixels, likewise down */
    drag(right, down, moves) {
        if (this.space) {
            this.space[moves ? 'pan' : 'turn'](right, down)
            this.eye = ''
            this.chosen = true
            this.picture.repaint()
        }
    }

    /** Moves the map's centre to a point of the ground. */
    moveTo(x, z) {
        this.x = x
        this.z = z
        this.chosen = true
        this.picture.repaint()
    }

    /** Arrow keys turn the 3D view, + and - zoom. @return whether it was such a key */
    key(event) {
        if (ARROWS[event.key] && this.mode === 'space') {
            this.drag(ARROWS[event.key][0], ARROWS[event.key][1], event.shiftKey)
            event.preventDefault()
        } else if (event.key === '+' || event.key === '-') {
            this.zoom(event.key === '+' ? 1.3 : 1 / 1.3)
        } else {
            return false
        }
        return true
    }
}
