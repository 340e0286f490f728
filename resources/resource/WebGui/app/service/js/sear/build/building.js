// SPDX-License-Identifier: Apache-2.0
// Mouse and keyboard control that selects, places, moves, turns and resizes objects in the SEAR panel's views.
import * as balance from './balance.js'
import * as geometry from '../shared/geometry.js'
import * as handles from './handles.js'
import {mounted} from './mounting.js'
import * as places from './places.js'
import * as pointing from '../world/pointing.js'

var CLICK = 4               // pixels: a shorter mouse movement is a click
var STEP = 0.05             // metres per arrow key; a fifth of it with the Alt key
var TURN = 15               // degrees
var SMALLEST = 0.05         // minimum of a snapped size, metres
var NEAR = 10               // pixels on the map: pick radius of a selected object without a shape or below others
var PAUSE_MILLIS = 400      // key presses within this time form one edit
var ARROWS = {ArrowLeft: [-1, 0, 0], ArrowRight: [1, 0, 0], ArrowUp: [0, 0, 1], ArrowDown: [0, 0, -1], PageUp: [0, 1, 0], PageDown: [0, -1, 0]}
var AXES = ['x', 'y', 'z']

/** Makes the build controls of one panel. */
export function makeBuilding(panel, messages, world, view, edits, palette, pointer, picture) {
    var building = {found: found}
    var drag = null             // the mouse's current action on the selected object
    var grip = null             // where the mouse button went down
    var keyed = null            // movement by keys that is not sent yet
    var asked = 0               // number of edits without an answer
    // Pose shown until the service answers, whatever the running simulation reports. Fields: object, pose; drawn, the
    // pose set last; truth, the object's pose from the service.
    var held = null

    edits.changed.hear(function() {
        if (drag && drag.object !== edits.selected) {
            drag = null         // the object was deleted, or another one was selected
            release(false)
        }
    })
    /** Returns the selection, see pointing.find. */
    function found() {
        return pointing.find(world.shown(), edits.selected)
    }
    /** Returns the ray of a pixel during a drag. */
    function ray(x, y) {
        return pointer.ray(x, y, drag.from[1] + 1)
    }

    // ---- what is shown -----------------------------------------------------------------------------------------------------------------
    building.decorate = function(scene, seen) {
        var selected = found()
        handles.showAids(scene, seen, view.building)
        balance.show(scene, selected)
        handles.show(scene, selected, selected && extent(selected), selected && spots(selected))
    }
    building.decorateMap = function(shown) {
        var selected = found()
        if (selected) {
            var pen = shown.getContext('2d')
            handles.draw(pen, selected, extent(selected), spots(selected), view.toScreen)
            balance.draw(pen, selected, view.toScreen)
        }
    }
    /** Returns the extent, with the size that the mouse is giving it. */
    function extent(selected) {
        return drag && drag.extent || pointing.extent(selected.object)
    }
    function spots(selected) {
        var scene = pointer.scene()
        return handles.spots(selected, extent(selected), selected.object.type ? handles.sizesOf(edits.typeOf(selected.object.type)) : {},
            scene ? handles.inSpace(scene, selected) : handles.above(view.scale))
    }
    /** Returns a handle's position in the world; null if the selection has no such handle. */
    building.handle = function(name) {
        var selected = found()
        var spot = selected && spots(selected)[name]
        return spot ? handles.placed(selected, spot) : null
    }

    // ---- moving ------------------------------------------------------------------------------------------------------------------------
    /** Returns the start of a movement: object, values, start (pose), place (see places.of). */
    function begun(selected) {
        building.hold()
        var values = edits.values()
        return {object: edits.selected, values: values, start: selected && selected.object.pose.slice(),
            place: places.of(selected, values, panel.isSimulating() && world.shown() === world.running)}
    }
    /**
     * Shows the object at another pose until the service answers. @param shift in its parent's frame @param degrees
     * rotation about y
     */
    function showMoved(start, shift, degrees) {
        var selected = found()
        if (!selected) {
            return
        }
        var isSensor = selected.robot && selected.robot.parts.indexOf(selected.object) < 0
        var way = isSensor ? geometry.rotate(selected.parent, shift) : shift
        var pose = start.slice()
        for (var i = 0; i < 3; i++) {
            pose[i] += way[i]
        }
        pose[4] += degrees
        held = held && held.object === edits.selected ? held : {object: edits.selected}
        held.pose = pose
        picture.repaint()
    }
    /** Whether an object is shown away from its reported pose; the view then does not follow it. */
    building.isBusy = () => drag !== null || held !== null
    /** Applies the held pose. Called before the views are drawn. */
    building.hold = function() {
        var selected = held && pointing.find(world.shown(), held.object)
        if (selected) {
            held.truth = selected.object.pose === held.drawn ? held.truth : selected.object.pose
            selected.object.pose = held.drawn = held.pose
        }
    }
    /**
     * Stops holding if no drag, key or edit is pending. @param stays whether the object keeps the shown pose, else it
     * returns to its own
     */
    function release(stays) {
        if (!held || drag || keyed || asked) {
            return
        }
        building.hold()
        var selected = pointing.find(world.shown(), held.object)
        if (selected && !stays) {
            selected.object.pose = held.truth
        }
        held = null
        picture.repaint()
    }
    /** Sends the change. If the service rejects it, the object returns to its pose. @param done see begun */
    function send(done, set) {
        var edit = edits.setting(done.object, places.edit(done.place, set), done.values)
        edit.stand = done.place.stands && set.y === undefined
        asked++
        edits.edit(edit, function(answer) {
            asked--
            if (!answer.done) {
                messages.say('error', edits.refusal(answer))
            }
            release(answer.done)
        })
    }

    function startDrag(event, x, y) {
        var scene = pointer.scene()
        var selected = found()
        if (!selected || !edits.object || palette.armed) {
            return null
        }
        var kind = scene ? handles.pick(scene, x, y) : handles.pickOnMap(selected, spots(selected), view.toScreen, x, y)
        var under = kind ? null : pointer.at(x, y)
        if (!kind && !isAt(selected, under, x, y)) {
            return null
        }
        edits.leaving.tell()
        return angular.extend(begun(selected), {kind: kind || 'move', pose: selected.pose, parent: selected.parent,
            from: kind ? building.handle(kind) : under.point, up: event.shiftKey && Boolean(scene), set: null,
            extent: kind && kind !== 'turn' ? pointing.extent(selected.object) : null})
    }
    /** Whether the object at a pixel is the selected one. */
    function isAt(selected, under, x, y) {
        if (under && under.who && (under.who.address === edits.selected || under.who.robot === edits.selected)) {
            return true
        }
        var pixel = pointer.scene() || !selected.robot ? null : view.toScreen(selected.pose[0], selected.pose[2])
        return Boolean(pixel) && Math.abs(pixel.x - x) < NEAR && Math.abs(pixel.y - y) < NEAR
    }
    function continueDrag(event, x, y) {
        var free = event.altKey
        if (!found()) {
            return              // another page has deleted it
        }
        if (drag.kind === 'turn') {
            turn(x, y, free)
        } else if (drag.kind === 'move') {
            move(x, y, free)
        } else {
            size(x, y, free)
        }
        picture.repaint()
    }
    function groundPoint(x, y) {
        return pointing.onPlane(ray(x, y), drag.from, [0, 1, 0])
    }
    function move(x, y, free) {
        var shift
        if (slideOnBody(x, y, free)) {
            return
        }
        if (drag.up) {
            shift = [0, pointing.alongAxis(ray(x, y), drag.from, [0, 1, 0]), 0]
        } else {
            var point = groundPoint(x, y)
            if (!point) {
                return
            }
            shift = [point[0] - drag.from[0], 0, point[2] - drag.from[2]]
        }
        shift = pointing.back(drag.parent, shift)
        drag.set = {}
        AXES.forEach(function(axis, i) {
            if (Math.abs(shift[i]) > 1e-6 && (drag.up || axis !== 'y')) {
                var value = palette.snapped(drag.place.at[i] + shift[i], free)
                shift[i] = value - drag.place.at[i]
                drag.set[axis] = places.plain(value)
            }
        })
        showMoved(drag.start, shift, 0)
    }
    /**
     * Keeps a sensor that is dragged over its robot's body on its surface. @return whether a body is under the mouse
     */
    function slideOnBody(x, y, free) {
        var selected = found()
        var isSensor = selected && selected.robot && selected.robot.parts.indexOf(selected.object) < 0
        var under = isSensor && pointer.scene() && !drag.up ? pointer.at(x, y, selected.object) : null
        if (!under || under.robot !== selected.robot.name || !under.normal) {
            return false
        }
        drag.set = mounted(under, edits.typeOf(edits.object.type), free, palette.snapped)
        showMoved(drag.start, AXES.map(function(axis, i) {
            return Number(drag.set[axis]) - drag.place.at[i]
        }), drag.set.ry === undefined ? 0 : Number(drag.set.ry) - drag.place.ry)
        return true
    }
    function turn(x, y, free) {
        var point = groundPoint(x, y)
        if (!point) {
            return
        }
        function angle(of) {
            var v = pointing.back(drag.parent, [of[0] - drag.pose[0], 0, of[2] - drag.pose[2]])
            return Math.atan2(v[0], v[2]) * 180 / Math.PI
        }
        var ry = drag.place.ry + angle(point) - angle(drag.from)
        ry = places.wrapped(palette.snap && !free ? Math.round(ry / TURN) * TURN : ry)
        drag.set = {ry: places.plain(ry)}
        showMoved(drag.start, [0, 0, 0], ry - drag.place.ry)
    }
    /** Resizes the object; the side opposite to the handle stays in place. */
    function size(x, y, free) {
        var i = AXES.indexOf(drag.kind)
        var what = handles.sizesOf(edits.typeOf(edits.object.type))[drag.kind]
        var values = drag.values
        var scale = Number(values['scale' + 'XYZ'[i]]) || 1
        var unit = [0, 0, 0]
        unit[i] = 1
        var along = pointing.alongAxis(ray(x, y), drag.from, geometry.rotate(drag.pose, unit))
        var old = Number(values[what.name])
        var wanted = old + along / scale
        var value = palette.snap && !free ? Math.max(SMALLEST, palette.snapped(wanted, false)) : Math.max(1e-3, wanted)
        var grown = (value - old) * scale
        drag.set = {}
        drag.set[what.name] = places.plain(value)
        drag.extent = pointing.extent(found().object)
        drag.extent[1][i] += grown
        if (what.share !== 1) {
            drag.extent[0][i] -= grown
        } else {
            keepOpposite(geometry.rotate(geometry.frame(drag.start), unit), grown / 2)
        }
    }
    function keepOpposite(axis, shift) {
        AXES.forEach(function(name, i) {
            var stands = name === 'y' && drag.values.onGround === 'true'
            if (Math.abs(axis[i] * shift) > 1e-6 && !stands) {
                drag.set[name] = places.plain(drag.place.at[i] + axis[i] * shift)
            }
        })
    }
    function endDrag() {
        var done = drag
        drag = null
        if (done.set && Object.keys(done.set).length) {
            send(done, done.set)
        } else {
            release(false)
        }
        picture.repaint()
    }

    // ---- clicks ------------------------------------------------------------------------------------------------------------------------
    function click(event, x, y) {
        var under = pointer.at(x, y)
        if (palette.armed) {
            if (under) {
                palette.place(under, event.altKey)
            }
        } else {
            edits.select(choice(under && under.who))
        }
        panel.scope.$applyAsync()
    }
    /** Selects a robot first; its parts once the robot is selected. */
    function choice(who) {
        if (!who) {
            return null
        }
        var selected = edits.selected || ''
        var inside = who.robot && (selected === who.robot || selected.indexOf(who.robot + '/') === 0)
        return who.robot && !inside && !(who.object.cones || who.object.ranges) ? who.robot : who.address
    }

    function down(event) {
        if (event.button !== 0 || event.target !== pointer.canvas()) {
            return
        }
        var p = pointer.position(event)
        grip = {x: event.clientX, y: event.clientY, moved: false}
        drag = startDrag(event, p[0], p[1])
        if (drag) {
            event.stopPropagation()
        }
    }
    function moved(event) {
        if (grip && Math.abs(event.clientX - grip.x) + Math.abs(event.clientY - grip.y) >= CLICK) {
            grip.moved = true
        }
        if (drag) {
            event.stopPropagation()
            if (grip.moved) {
                var p = pointer.position(event)
                continueDrag(event, p[0], p[1])
            }
        }
    }
    function up(event) {
        var was = grip
        grip = null
        if (was && drag) {
            endDrag()
        }
        if (was && !was.moved && event.target === pointer.canvas()) {
            var p = pointer.position(event)
            click(event, p[0], p[1])
        }
    }
    /** Adds the listeners once the canvases exist. They run before those that turn and move the views. */
    building.listen = function() {
        panel.element('view').parentNode.addEventListener('mousedown', down, true)
        window.addEventListener('mousemove', moved, true)
        window.addEventListener('mouseup', up, true)
        window.addEventListener('beforeunload', sendKeyed)
        panel.scope.$on('$destroy', function() {
            window.removeEventListener('mousemove', moved, true)
            window.removeEventListener('mouseup', up, true)
            window.removeEventListener('beforeunload', sendKeyed)
        })
    }

    // ---- keys --------------------------------------------------------------------------------------------------------------------------
    /** Maps an arrow key to the world axis nearest to its direction as seen. */
    function direction(arrow) {
        var scene = pointer.scene()
        if (!scene || arrow[1]) {
            return scene || arrow[1] ? arrow : [arrow[2], 0, arrow[0]]
        }
        var azimuth = Math.round(scene.orbit.azimuth / (Math.PI / 2)) * Math.PI / 2
        var forth = [-Math.cos(azimuth), -Math.sin(azimuth)]
        return [forth[0] * arrow[2] - forth[1] * arrow[0], 0, forth[1] * arrow[2] + forth[0] * arrow[0]]
    }
    /** Adds up key presses. They are sent after a pause, or before any other edit. */
    function byKey(selected, shift, degrees) {
        keyed = keyed || angular.extend(begun(selected), {shift: [0, 0, 0], by: 0})
        clearTimeout(keyed.timer)
        keyed.shift = keyed.shift.map((metres, i) => metres + shift[i])
        keyed.by += degrees
        if (selected) {
            showMoved(keyed.start, keyed.shift, keyed.by)
        }
        keyed.timer = setTimeout(sendKeyed, PAUSE_MILLIS)
    }
    function nudge(arrow, fine) {
        var selected = found()
        if (selected && edits.object) {
            byKey(selected, pointing.back(selected.parent, direction(arrow)).map(way => way * (fine ? STEP / 5 : STEP)), 0)
        }
    }
    function turnBy(degrees) {
        if (edits.object && edits.object.values.ry !== undefined) {
            byKey(found(), [0, 0, 0], degrees)
        }
    }
    function sendKeyed() {
        if (!keyed) {
            return
        }
        var done = keyed
        keyed = null
        clearTimeout(done.timer)
        var set = {}
        AXES.forEach(function(axis, i) {
            if (Math.abs(done.shift[i]) > 1e-6) {
                set[axis] = places.plain(done.place.at[i] + done.shift[i])
            }
        })
        if (done.by % 360) {
            set.ry = places.plain(places.wrapped(done.place.ry + done.by))
        }
        if (Object.keys(set).length) {
            send(done, set)
        } else {
            release(false)
        }
    }
    edits.leaving.hear(sendKeyed)
    /** Handles a key. @return whether it was a build key */
    building.key = function(event) {
        var command = event.ctrlKey || event.metaKey
        var key = event.key.length === 1 ? event.key.toLowerCase() : event.key
        if (command && (key === 'z' || key === 'y')) {
            (key === 'y' || event.shiftKey ? edits.redo : edits.undo)()
        } else if (key === 'Escape' && (palette.armed || edits.selected)) {
            palette.disarm()
            edits.select(null)
        } else if (!edits.selected) {
            return false
        } else if (ARROWS[key] && !command) {
            nudge(ARROWS[key], event.altKey)
        } else if (key === '[' || key === ']') {
            turnBy(key === '[' ? TURN : -TURN)
        } else if (key === 'Delete') {
            edits.remove()
        } else if (command && key === 'd') {
            edits.duplicate()
        } else {
            return false
        }
        event.preventDefault()
        return true
    }
    view.overlaidBy(building)
    return building
}
