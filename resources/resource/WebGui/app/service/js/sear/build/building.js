// SPDX-License-Identifier: Apache-2.0
// Mouse and keyboard control that selects, places, moves, turns and resizes objects in the SEAR panel's views.
import * as balance from './balance.js'
import * as geometry from '../shared/geometry.js'
import * as handles from './handles.js'
import * as joints from './joints.js'
import {mounted} from './mounting.js'
import * as places from './places.js'
import {show} from './walls.js'
import * as pointing from '../world/pointing.js'

const CLICK = 4               // pixels: a shorter mouse movement is a click
const TAP = 12                // pixels: the same for a finger
const STEP = 0.05             // metres per arrow key; a fifth of it with the Alt key
const TURN = 15               // degrees
const SMALLEST = 0.05         // minimum of a snapped size, metres
const NEAR = 10               // pixels on the map: pick radius of a selected object without a shape or below others
const PAUSE_MILLIS = 400      // key presses within this time form one edit
const ARROWS = {ArrowLeft: [-1, 0, 0], ArrowRight: [1, 0, 0], ArrowUp: [0, 0, 1], ArrowDown: [0, 0, -1],
    PageUp: [0, 1, 0], PageDown: [0, -1, 0]}
const AXES = ['x', 'y', 'z']

/** The build controls of one panel. */
export class Building {
    constructor(panel, messages, world, view, edits, palette, pointer, picture) {
        this.panel = panel
        this.messages = messages
        this.world = world
        this.view = view
        this.edits = edits
        this.palette = palette
        this.pointer = pointer
        this.picture = picture
        this.drag = null        // the mouse's current action on the selected object
        this.grip = null        // where the mouse button went down
        this.keyed = null       // movement by keys that is not sent yet
        this.asked = 0          // number of edits without an answer
        // Pose shown until the service answers, whatever the running simulation reports. Fields: object, pose; drawn,
        // the pose set last; truth, the object's pose from the service.
        this.held = null

        edits.changed.hear(() => {
            if (this.drag && this.drag.object !== edits.selected) {
                this.drag = null         // the object was deleted, or another one was selected
                this.release(false)
            }
        })
        edits.leaving.hear(() => this.sendKeyed())
        view.overlaidBy(this)
    }

    /** Returns the selection, see pointing.find. */
    found() {
        return pointing.find(this.world.shown(), this.edits.selected)
    }

    /** Returns the ray of a pixel during a drag. */
    ray(x, y) {
        return this.pointer.ray(x, y, this.drag.from[1] + 1)
    }

    // ---- what is shown
    // -----------------------------------------------------------------------------------------------------------------
    decorate(scene, seen) {
        const selected = this.found()
        handles.showAids(scene, seen, this.view.building)
        joints.showMarks(scene, seen, this.view.building)
        show(scene, this.palette.armed && this.palette.armed.drawing)
        balance.show(scene, selected)
        handles.show(scene, selected, selected && this.extent(selected), selected && this.spots(selected))
    }

    decorateMap(shown) {
        const selected = this.found()
        const pen = shown.getContext('2d')
        const toScreen = (x, z) => this.view.toScreen(x, z)
        if (this.view.building) {
            joints.drawMarks(pen, this.world.shown(), toScreen)
            if (this.palette.armed && this.palette.armed.drawing) {
                this.palette.armed.drawing.draw(pen, toScreen)
            }
        }
        if (selected) {
            handles.draw(pen, selected, this.extent(selected), this.spots(selected), toScreen)
            balance.draw(pen, selected, toScreen)
        }
    }

    /** Returns the extent, with the size that the mouse is giving it. */
    extent(selected) {
        return this.drag && this.drag.extent || pointing.extent(selected.object)
    }

    spots(selected) {
        const scene = this.pointer.scene()
        return handles.spots(selected, this.extent(selected), selected.object.type
            ? handles.sizesOf(this.edits.typeOf(selected.object.type)) : {},
            scene ? handles.inSpace(scene, selected) : handles.above(this.view.scale))
    }

    /** Returns a handle's position in the world; null if the selection has no such handle. */
    handle(name) {
        const selected = this.found()
        const spot = selected && this.spots(selected)[name]
        return spot ? handles.placed(selected, spot) : null
    }

    // ---- moving
    // -----------------------------------------------------------------------------------------------------------------
    /** Returns the start of a movement: object, values, start (pose), place (see places.of). */
    begun(selected) {
        this.hold()
        const values = this.edits.values()
        return {object: this.edits.selected, values, start: selected && selected.object.pose.slice(),
            place: places.of(selected, values, this.panel.isSimulating() && this.world.shown() === this.world.running)}
    }

    /**
     * Shows the object at another pose until the service answers. @param shift in its parent's frame @param degrees
     * rotation about y
     */
    showMoved(start, shift, degrees) {
        const selected = this.found()
        if (!selected) {
            return
        }
        const isSensor = selected.robot && selected.robot.parts.indexOf(selected.object) < 0
        const way = isSensor ? geometry.rotate(selected.parent, shift) : shift
        const pose = start.slice()
        for (let i = 0; i < 3; i++) {
            pose[i] += way[i]
        }
        pose[4] += degrees
        this.held = this.held && this.held.object === this.edits.selected ? this.held : {object: this.edits.selected}
        this.held.pose = pose
        this.picture.repaint()
    }

    /** Whether an object is shown away from its reported pose; the view then does not follow it. */
    isBusy() {
        return this.drag !== null || this.held !== null
    }

    /** Applies the held pose. Called before the views are drawn. */
    hold() {
        const selected = this.held && pointing.find(this.world.shown(), this.held.object)
        if (selected) {
            this.held.truth = selected.object.pose === this.held.drawn ? this.held.truth : selected.object.pose
            selected.object.pose = this.held.drawn = this.held.pose
        }
    }

    /**
     * Stops holding if no drag, key or edit is pending. @param stays whether the object keeps the shown pose, else it
     * returns to its own
     */
    release(stays) {
        if (!this.held || this.drag || this.keyed || this.asked) {
            return
        }
        this.hold()
        const selected = pointing.find(this.world.shown(), this.held.object)
        if (selected && !stays) {
            selected.object.pose = this.held.truth
        }
        this.held = null
        this.picture.repaint()
    }

    /** Sends the change. If the service rejects it, the object returns to its pose. @param done see begun */
    send(done, set) {
        const isRope = this.edits.object && this.edits.object.type === 'Rope'
        const all = isRope ? joints.tautened(done.values, set) : set
        const edit = this.edits.setting(done.object, places.edit(done.place, all), done.values)
        edit.stand = done.place.stands && set.y === undefined
        this.asked++
        this.edits.edit(edit, answer => {
            this.asked--
            if (!answer.done) {
                this.messages.say('error', this.edits.refusal(answer))
                if (done.end && this.found()) {
                    this.found().object.end = done.end
                }
            }
            this.release(answer.done)
        })
    }

    /** Returns the joint at a pixel, see joints.pick. */
    jointAt(x, y) {
        const scene = this.pointer.scene()
        return this.view.building ? joints.pick(this.world.shown(), at => scene ? scene.toScreen(at[0], at[1], at[2])
            : this.view.toScreen(at[0], at[2]), x, y) : null
    }

    startDrag(event, x, y) {
        const scene = this.pointer.scene()
        const selected = this.found()
        if (!selected || !this.edits.object || this.palette.armed) {
            return null
        }
        const kind = scene ? handles.pick(scene, x, y)
            : handles.pickOnMap(selected, this.spots(selected), (north, east) => this.view.toScreen(north, east), x, y)
        const under = kind ? null : this.jointAt(x, y) || this.pointer.at(x, y)
        if (!kind && !this.isAt(selected, under, x, y)) {
            return null
        }
        this.edits.leaving.tell()
        return Object.assign(this.begun(selected), {kind: kind || 'move', pose: selected.pose, parent: selected.parent,
            from: kind ? this.handle(kind) : under.point, up: event.shiftKey && Boolean(scene), set: null,
            extent: kind && kind !== 'turn' ? pointing.extent(selected.object) : null})
    }

    /** Whether the object at a pixel is the selected one. */
    isAt(selected, under, x, y) {
        if (under && under.who && (under.who.address === this.edits.selected
            || under.who.robot === this.edits.selected)) {
            return true
        }
        const pixel = this.pointer.scene() || !selected.robot
            ? null : this.view.toScreen(selected.pose[0], selected.pose[2])
        return Boolean(pixel) && Math.abs(pixel.x - x) < NEAR && Math.abs(pixel.y - y) < NEAR
    }

    continueDrag(event, x, y) {
        const free = event.altKey
        if (!this.found()) {
            return              // another page has deleted it
        }
        if (this.drag.kind === 'turn') {
            this.turn(x, y, free)
        } else if (this.drag.kind === 'move') {
            this.move(x, y, free)
        } else if (this.drag.kind === 'axis' || this.drag.kind === 'end') {
            this.aim(x, y, free)
        } else {
            this.size(x, y, free)
        }
        this.picture.repaint()
    }

    groundPoint(x, y) {
        return pointing.onPlane(this.ray(x, y), this.drag.from, [0, 1, 0])
    }

    move(x, y, free) {
        let shift
        if (this.slideOnBody(x, y, free)) {
            return
        }
        if (this.drag.up) {
            shift = [0, pointing.alongAxis(this.ray(x, y), this.drag.from, [0, 1, 0]), 0]
        } else {
            const point = this.groundPoint(x, y)
            if (!point) {
                return
            }
            shift = [point[0] - this.drag.from[0], 0, point[2] - this.drag.from[2]]
        }
        shift = pointing.back(this.drag.parent, shift)
        this.drag.set = {}
        AXES.forEach((axis, i) => {
            if (Math.abs(shift[i]) > 1e-6 && (this.drag.up || axis !== 'y')) {
                const value = this.palette.snapped(this.drag.place.at[i] + shift[i], free)
                shift[i] = value - this.drag.place.at[i]
                this.drag.set[axis] = places.plain(value)
            }
        })
        this.showMoved(this.drag.start, shift, 0)
    }

    /**
     * Keeps a sensor that is dragged over its robot's body on its surface. @return whether a body is under the mouse
     */
    slideOnBody(x, y, free) {
        const selected = this.found()
        const isSensor = selected && selected.robot && selected.robot.parts.indexOf(selected.object) < 0
        const slides = isSensor && !pointing.isJoint(selected.object) && this.pointer.scene() && !this.drag.up
        const under = slides ? this.pointer.at(x, y, selected.object) : null
        if (!under || under.robot !== selected.robot.name || !under.normal) {
            return false
        }
        this.drag.set = mounted(under, this.edits.typeOf(this.edits.object.type), free,
            this.palette.snapped.bind(this.palette))
        this.showMoved(this.drag.start, AXES.map((axis, i) => Number(this.drag.set[axis]) - this.drag.place.at[i]),
            this.drag.set.ry === undefined ? 0 : Number(this.drag.set.ry) - this.drag.place.ry)
        return true
    }

    turn(x, y, free) {
        const point = this.groundPoint(x, y)
        if (!point) {
            return
        }
        const angle = of => {
            const v = pointing.back(this.drag.parent, [of[0] - this.drag.pose[0], 0, of[2] - this.drag.pose[2]])
            return Math.atan2(v[0], v[2]) * 180 / Math.PI
        }
        let ry = this.drag.place.ry + angle(point) - angle(this.drag.from)
        ry = places.wrapped(this.palette.snap && !free ? Math.round(ry / TURN) * TURN : ry)
        this.drag.set = {ry: places.plain(ry)}
        this.showMoved(this.drag.start, [0, 0, 0], ry - this.drag.place.ry)
    }

    /** Points a joint's axis or ties a rope's end at the mouse, in the plane of its handle that faces the view. */
    aim(x, y, free) {
        const scene = this.pointer.scene()
        const canvas = this.pointer.canvas()
        const ahead = scene ? pointing.ray(scene, canvas.clientWidth / 2, canvas.clientHeight / 2).along : [0, 1, 0]
        const point = pointing.onPlane(this.ray(x, y), this.drag.from, ahead)
        if (!point) {
            return
        }
        if (this.drag.kind === 'axis') {
            this.drag.set = joints.pointed(this.drag.pose, point, free, this.drag.parent)
            const angles = ['rx', 'ry', 'rz'].map(angle => Number(this.drag.set[angle]))
            const turned = geometry.times(this.drag.parent, geometry.frame([0, 0, 0].concat(angles)))
            this.held = {object: this.edits.selected, pose: this.drag.start.slice(0, 3).concat(turned.slice(3))}
        } else {
            const end = pointing.local(this.drag.parent, point).map(value => this.palette.snapped(value, free))
            this.drag.end = this.drag.end || this.found().object.end
            this.found().object.end = geometry.times(this.drag.parent, end.concat([0, 0, 0, 1])).slice(0, 3)
                .concat(this.drag.end.slice(3))
            this.drag.set = {endX: places.plain(end[0]), endY: places.plain(end[1]), endZ: places.plain(end[2])}
        }
    }

    /** Resizes the object; the side opposite to the handle stays in place. */
    size(x, y, free) {
        const i = AXES.indexOf(this.drag.kind)
        const what = handles.sizesOf(this.edits.typeOf(this.edits.object.type))[this.drag.kind]
        const values = this.drag.values
        const scale = Number(values['scale' + 'XYZ'[i]]) || 1
        const unit = [0, 0, 0]
        unit[i] = 1
        const along = pointing.alongAxis(this.ray(x, y), this.drag.from, geometry.rotate(this.drag.pose, unit))
        const old = Number(values[what.name])
        const wanted = old + along / scale
        const value = this.palette.snap && !free ? Math.max(SMALLEST, this.palette.snapped(wanted, false)) : Math.max(
        1e-3, wanted)
        const grown = (value - old) * scale
        this.drag.set = {}
        this.drag.set[what.name] = places.plain(value)
        this.drag.extent = pointing.extent(this.found().object)
        this.drag.extent[1][i] += grown
        if (what.share !== 1) {
            this.drag.extent[0][i] -= grown
        } else {
            this.keepOpposite(geometry.rotate(geometry.frame(this.drag.start), unit), grown / 2)
        }
    }

    keepOpposite(axis, shift) {
        AXES.forEach((name, i) => {
            const stands = name === 'y' && this.drag.values.onGround === 'true'
            if (Math.abs(axis[i] * shift) > 1e-6 && !stands) {
                this.drag.set[name] = places.plain(this.drag.place.at[i] + axis[i] * shift)
            }
        })
    }

    endDrag() {
        const done = this.drag
        this.drag = null
        if (done.set && Object.keys(done.set).length) {
            this.send(done, done.set)
        } else {
            this.release(false)
        }
        this.picture.repaint()
    }

    // ---- clicks
    // -----------------------------------------------------------------------------------------------------------------
    click(event, x, y) {
        const under = !this.palette.armed && this.jointAt(x, y) || this.pointer.at(x, y)
        if (this.palette.armed) {
            if (under) {
                this.palette.place(under, event.altKey)
                this.picture.repaint()
            }
        } else {
            this.edits.select(this.choice(under && under.who))
        }
        this.panel.scope.$applyAsync()
    }

    /** Selects a robot first; its parts once the robot is selected. */
    choice(who) {
        if (!who) {
            return null
        }
        const selected = this.edits.selected || ''
        const inside = who.robot && (selected === who.robot || selected.indexOf(who.robot + '/') === 0)
        return who.robot && !inside && !(who.object.cones || who.object.ranges) ? who.robot : who.address
    }

    down(event) {
        if (!event.isPrimary && this.grip) {
            this.grip.moved = true      // two fingers zoom and move the view
        }
        if (!event.isPrimary || event.button !== 0 || event.target !== this.pointer.canvas()) {
            return
        }
        const p = this.pointer.position(event)
        this.grip = {x: event.clientX, y: event.clientY, moved: false}
        this.drag = this.startDrag(event, p[0], p[1])
        if (this.drag) {
            event.stopPropagation()
        }
    }

    moved(event) {
        if (!event.isPrimary) {
            return
        }
        const shortest = event.pointerType === 'touch' ? TAP : CLICK
        if (this.grip && Math.abs(event.clientX - this.grip.x) + Math.abs(event.clientY - this.grip.y) >= shortest) {
            this.grip.moved = true
        }
        if (!this.grip && event.target === this.pointer.canvas()
            && this.palette.hover(this.pointer.under(event), event.altKey)) {
            this.picture.repaint()
        }
        if (this.drag) {
            event.stopPropagation()
            if (this.grip.moved) {
                const p = this.pointer.position(event)
                this.continueDrag(event, p[0], p[1])
            }
        }
    }

    up(event) {
        if (!event.isPrimary) {
            return
        }
        const was = this.grip
        this.grip = null
        if (was && this.drag) {
            this.endDrag()
        }
        if (was && !was.moved && event.target === this.pointer.canvas()) {
            const p = this.pointer.position(event)
            this.click(event, p[0], p[1])
        }
    }

    /** Forgets a drag that the browser has taken over. */
    cancel() {
        this.grip = null
        if (this.drag) {
            this.drag = null
            this.release(false)
        }
    }

    /** Adds the listeners once the canvases exist. They run before those that turn and move the views. */
    listen() {
        this.panel.element('view').parentNode.addEventListener('pointerdown', event => this.down(event), true)
        this.panel.listen(window, {pointermove: event => this.moved(event), pointerup: event => this.up(event),
            pointercancel: () => this.cancel(), beforeunload: () => this.sendKeyed()}, true)
    }

    // ---- keys
    // -----------------------------------------------------------------------------------------------------------------
    /** Maps an arrow key to the world axis nearest to its direction as seen. */
    direction(arrow) {
        const scene = this.pointer.scene()
        if (!scene || arrow[1]) {
            return scene || arrow[1] ? arrow : [arrow[2], 0, arrow[0]]
        }
        const azimuth = Math.round(scene.orbit.azimuth / (Math.PI / 2)) * Math.PI / 2
        const forth = [-Math.cos(azimuth), -Math.sin(azimuth)]
        return [forth[0] * arrow[2] - forth[1] * arrow[0], 0, forth[1] * arrow[2] + forth[0] * arrow[0]]
    }

    /** Adds up key presses. They are sent after a pause, or before any other edit. */
    byKey(selected, shift, degrees) {
        this.keyed = this.keyed || Object.assign(this.begun(selected), {shift: [0, 0, 0], by: 0})
        clearTimeout(this.keyed.timer)
        this.keyed.shift = this.keyed.shift.map((metres, i) => metres + shift[i])
        this.keyed.by += degrees
        if (selected) {
            this.showMoved(this.keyed.start, this.keyed.shift, this.keyed.by)
        }
        this.keyed.timer = setTimeout(() => this.sendKeyed(), PAUSE_MILLIS)
    }

    nudge(arrow, fine) {
        const selected = this.found()
        if (selected && this.edits.object) {
            this.byKey(selected, pointing.back(selected.parent, this.direction(arrow))
                .map(way => way * (fine ? STEP / 5 : STEP)), 0)
        }
    }

    turnBy(degrees) {
        if (this.edits.object && this.edits.object.values.ry !== undefined) {
            this.byKey(this.found(), [0, 0, 0], degrees)
        }
    }

    sendKeyed() {
        if (!this.keyed) {
            return
        }
        const done = this.keyed
        this.keyed = null
        clearTimeout(done.timer)
        const set = {}
        AXES.forEach((axis, i) => {
            if (Math.abs(done.shift[i]) > 1e-6) {
                set[axis] = places.plain(done.place.at[i] + done.shift[i])
            }
        })
        if (done.by % 360) {
            set.ry = places.plain(places.wrapped(done.place.ry + done.by))
        }
        if (Object.keys(set).length) {
            this.send(done, set)
        } else {
            this.release(false)
        }
    }

    /** Handles a key. @return whether it was a build key */
    key(event) {
        const command = event.ctrlKey || event.metaKey
        const key = event.key.length === 1 ? event.key.toLowerCase() : event.key
        if (command && (key === 'z' || key === 'y')) {
            this.edits.takeBack(key === 'y' || event.shiftKey ? 'redo' : 'undo')
        } else if (!command && this.palette.wallKey(key)) {
            this.picture.repaint()
        } else if (key === 'Escape' && (this.palette.armed || this.edits.selected)) {
            this.palette.disarm()
            this.edits.select(null)
        } else if (!this.edits.selected) {
            return false
        } else if (ARROWS[key] && !command) {
            this.nudge(ARROWS[key], event.altKey)
        } else if (key === '[' || key === ']') {
            this.turnBy(key === '[' ? TURN : -TURN)
        } else if (key === 'Delete') {
            this.edits.remove()
        } else if (command && key === 'd') {
            this.edits.duplicate()
        } else {
            return false
        }
        event.preventDefault()
        return true
    }
}
