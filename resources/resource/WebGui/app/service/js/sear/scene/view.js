// SPDX-License-Identifier: Apache-2.0
// The view of the SEAR panel: 3D if the browser supports it, else the map.
import * as geometry from '../shared/geometry.js'
import * as map from './map.js'
import {makePictures} from './pictures.js'
import {recall, remember, whenPageChanges} from '../shared/page.js'
import {Scene, isPossible} from './scene.js'

var MODE = 'sear.view'      // local storage key of the chosen view
var MOST_LISTED = 100       // objects of the world in the list; the others on request
var BENCH = 4               // size of an empty view while building, metres
var TURN = 20               // mouse movement in pixels that an arrow key corresponds to
var ARROWS = {ArrowLeft: [-TURN, 0], ArrowRight: [TURN, 0], ArrowUp: [0, TURN], ArrowDown: [0, -TURN]}

/** Makes the view of one panel. */
export function makeView(panel, messages, world, ground, picture) {
    var element = panel.element
    var overlay = null          // drawn with the world, see view.overlaidBy
    var scene = null            // made when first shown
    var fitted = {}             // by mode: whether the view is fitted to the world, or set by the user
    var pictures = makePictures(keys => panel.msg.send('getLooks', keys), picture.repaint)
    var benched = false         // whether the view shows empty ground for building
    var view = {
        x: 0, z: 0,             // centre of the map, metres
        scale: 60,              // scale of the map, pixels per metre
        fitted: false,
        chosen: false,          // whether the user has zoomed or moved
        building: false,        // whether the user is building
        listed: MOST_LISTED,
        mode: firstMode(),      // 'space' or 'map'
        noSpace: '',            // why there is no 3D view
        beams: true,
        follow: false,
        robot: null,            // the driven and followed robot
        eye: ''                 // name of the sensor to look through
    }

    function firstMode() {
        var mode = recall(MODE)
        return mode === 'map' || !isPossible(mode !== 'space') ? 'map' : 'space'
    }
    view.setMode = function(mode) {
        if (mode === 'space' && !isPossible(false)) {
            view.noSpace = 'This browser has no WebGL and shows only the map'
            return
        }
        view.mode = mode
        remember(MODE, mode, messages, 'the view')
        panel.timeout(picture.repaint)      // when the canvas exists
    }

    function canvas() {
        return element(view.mode === 'space' ? 'scene' : 'view')
    }
    /** Returns width and height of the canvas; folding adjacent parts changes them, too. */
    function sizeOf() {
        var shown = canvas()
        return shown ? shown.clientWidth + ' ' + shown.clientHeight : ''
    }

    /** Returns a ground point's position on the map. Tests use it, too. */
    view.toScreen = function(x, z) {
        return map.projection(element('view'), view)(x, z)
    }
    /** Returns the 3D view; null before it was shown. */
    view.scene = function() {
        return scene
    }
    view.zoom = function(factor) {
        if (view.mode === 'space' && scene) {
            scene.zoom(factor)
        } else {
            view.scale = Math.min(2000, Math.max(0.002, view.scale * factor))
        }
        view.chosen = true
        picture.repaint()
    }
    view.fit = function() {
        refit()
        view.chosen = false
        view.eye = ''
        picture.repaint()
    }
    view.redraw = picture.repaint
    /** Notes that the user has chosen the viewpoint. */
    view.choose = function() {
        view.chosen = true
    }
    view.build = function(on) {
        view.building = on
        if (on && world.isEmpty()) {
            view.fit()          // close enough to see a first object well, without it filling the view
        }
        picture.repaint()
    }
    view.driveRobot = function(name) {
        view.robot = name
    }
    /**
     * @param drawn hold() runs before the world is drawn, decorate(scene, world) and decorateMap(canvas) after it;
     * isBusy(): during a drag
     */
    view.overlaidBy = function(drawn) {
        overlay = drawn
    }

    /** Shows another world. The user's zoom stays while the robots are the same. */
    world.news.hear(function(shown) {
        var robots = shown.robots.map(robot => robot.name).join('\n')
        if (!shown.robots.some(isChosen)) {
            view.robot = shown.robots.length ? shown.robots[0].name : null
        }
        view.listed = MOST_LISTED
        view.chosen = Boolean(view.chosen && (view.robots === robots || view.building))
        if (!view.chosen) {
            refit()
        }
        view.robots = robots
    })
    /** Fits each view to the world when it is drawn next. */
    function refit() {
        view.fitted = false      // the shown one
        fitted = {}
        benched = false
    }

    function isChosen(robot) {
        return robot.name === view.robot
    }
    view.listAll = function() {
        view.listed = Infinity
    }

    // ---- drawing -----------------------------------------------------------------------------------------------------------------------
    function draw() {
        var shown = canvas()
        if (!picture.width()) {
            return
        }
        var seen = world.shown()
        var size = sizeOf()
        if (view.size !== size && !view.chosen) {
            refit()
        }
        view.size = size
        if (view.building && (!seen || !seen.objects.length && !seen.robots.length)) {
            benched = true
            view.x = view.z = 0
        }
        overlay.hold()
        if (view.mode === 'space') {
            drawScene(shown, seen)
        } else {
            drawMap(shown, seen)
        }
        view.fitted = Boolean(fitted[view.mode])
    }

    function followed(seen) {
        return view.follow && !overlay.isBusy() && seen.robots.length ? Math.max(0, seen.robots.findIndex(isChosen)) : -1
    }

    function drawMap(shown, seen) {
        var shapes = seen ? geometry.shapesOf(seen) : []
        if (benched && !fitted.map) {
            view.scale = Math.min(shown.clientWidth, shown.clientHeight) / BENCH
            fitted.map = true
        } else if (seen && !fitted.map) {
            geometry.fit(view, shapes, shown)
            fitted.map = true
        }
        if (seen && followed(seen) >= 0) {
            var robot = seen.robots[followed(seen)]
            view.x = robot.pose[0]
            view.z = robot.pose[2]
        }
        map.draw(shown, view, seen, ground.of(seen), shapes, pictures)
        overlay.decorateMap(shown)
    }

    function drawScene(shown, drawn) {
        if (!scene) {
            scene = new Scene(shown, function(keys) {
                panel.msg.send('getLooks', keys)
            }, picture.repaint)
        }
        var seen = drawn || {objects: [], robots: [], sensors: []}
        var terrain = ground.of(seen)
        scene.show(seen, terrain, view.beams)
        scene.showGrid(view.building)
        if (benched && !fitted.space) {
            scene.fit({x: 0, y: 0, z: 0, size: BENCH}, [])
            fitted.space = true
        } else if (!fitted.space && (seen.objects.length || seen.robots.length)) {
            var area = geometry.area(geometry.shapesOf(seen))
            if (area) {
                scene.fit({x: area.x, y: heightOf(seen, terrain, area), z: area.z, size: area.size}, geometry.corners(seen.objects))
            }
            fitted.space = true
        }
        overlay.decorate(scene, seen)
        scene.draw(eyes(seen).indexOf(view.eye), followed(seen), geometry.isLight(window.getComputedStyle(shown).color))
    }

    /** Returns the height to look at: that of the first robot, else of the ground. */
    function heightOf(seen, terrain, area) {
        return seen.robots.length ? seen.robots[0].pose[1] : terrain ? terrain.height(area.x, area.z) || 0 : 0
    }

    function eyes(seen) {
        return seen.sensors.map(sensor => sensor.name)
    }
    /** Returns the names of the sensors to look through. */
    view.eyes = function() {
        var seen = world.shown()
        return seen ? eyes(seen) : []
    }

    /** Turns or pans the 3D view. @param right pixels, likewise down */
    view.drag = function(right, down, moves) {
        if (scene) {
            scene[moves ? 'pan' : 'turn'](right, down)
            view.eye = ''
            view.chosen = true
            picture.repaint()
        }
    }
    /** Moves the map's centre to a point of the ground. */
    view.moveTo = function(x, z) {
        view.x = x
        view.z = z
        view.chosen = true
        picture.repaint()
    }
    /** Arrow keys turn the 3D view, + and - zoom. @return whether it was such a key */
    view.key = function(event) {
        if (ARROWS[event.key] && view.mode === 'space') {
            view.drag(ARROWS[event.key][0], ARROWS[event.key][1], event.shiftKey)
            event.preventDefault()
        } else if (event.key === '+' || event.key === '-') {
            view.zoom(event.key === '+' ? 1.3 : 1 / 1.3)
        } else {
            return false
        }
        return true
    }

    picture.drawnBy({canvas: canvas, draw: draw})
    whenPageChanges(panel.scope, picture.repaint)       // also digests, and so measures the layout
    panel.scope.$on('$destroy', function() {
        if (scene) {
            scene.close()
        }
    })
    panel.scope.$watch(sizeOf, function() {
        draw()
        world.look()
    })
    view.handlers = {
        onLooks: function(sent) {
            pictures.take(sent)
            if (scene) {
                scene.looks.take(sent)
            }
        }
    }
    return view
}
