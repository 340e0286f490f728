// SPDX-License-Identifier: Apache-2.0
// The palette of the SEAR panel: all kinds of objects, placed by a click in the view.
import {mounted, tilted, withGround} from './mounting.js'
import {Joining, WORLD, ends, jointToDrive} from './joints.js'
import * as making from './kinds.js'
import {plain} from './places.js'
import {THINGS, isThing, thingEdit} from './things.js'
import {Drawing} from './walls.js'
import {besideBody, drivenWheels, wheelToTurn} from './wheels.js'
import * as pointing from '../world/pointing.js'

const GRID = 0.05             // snapping distance, metres
const STEPS = {ArrowDown: 1, ArrowRight: 1, ArrowUp: -1, ArrowLeft: -1}

/** The palette of one panel. */
export class Palette {
    constructor(panel, messages, world, view, edits, pointer) {
        this.panel = panel
        this.messages = messages
        this.world = world
        this.view = view
        this.edits = edits
        this.pointer = pointer
        this.carried = null     // the button being dragged from
        this.armed = null       // what the next click makes: type or template, and fields to fill in
        this.snap = true
        this.sought = ''        // search text
        this.kinds = []         // kinds found, in the order shown
        this.shownGroups = []   // groups of the kinds found
        this.made = null        // grammar and search text that these belong to
        this.stop = null        // kind that the Tab key reaches: the one that the arrow keys reached last
        panel.listen(window, {mousedown: event => this.grab(event), mouseup: event => this.drop(event)}, true)
    }

    build() {
        this.armed = null
        this.view.build(!this.view.building)
    }

    /** Returns the groups of kinds that match the search text: name, kinds. The same array until that text changes. */
    groups() {
        if (this.made && this.made.grammar === this.edits.grammar && this.made.sought === this.sought) {
            return this.shownGroups
        }
        this.made = {grammar: this.edits.grammar, sought: this.sought}
        const all = !this.edits.grammar ? [] : this.edits.grammar.types.filter(type => type.kind !== 'robot')
            .map(making.ofType)
            .concat(this.edits.grammar.templates.map(making.ofTemplate), Object.keys(THINGS).map(making.ofThing))
        const wanted = this.sought.trim().toLowerCase()
        this.kinds = all.filter(kind => kind.sought.indexOf(wanted) >= 0)
        this.shownGroups = making.GROUPS.map(name => ({name, kinds: this.kinds.filter(kind => kind.group === name)}))
            .filter(group => group.kinds.length)
        this.kinds = [].concat.apply([], this.shownGroups.map(group => group.kinds))
        this.stop = this.kinds.indexOf(this.stop) < 0 ? this.kinds[0] : this.stop
        return this.shownGroups
    }

    isStop(kind) {
        return kind === this.stop
    }

    /** Arrow keys go to the next kind, Home and End to the ends. */
    key(event) {
        const at = this.kinds.findIndex(kind => kind.make === event.target.getAttribute('data-make'))
        const next = event.key === 'Home' ? 0 : event.key === 'End' ? this.kinds.length - 1 : at + STEPS[event.key]
        if (at >= 0 && this.kinds[next]) {
            this.stop = this.kinds[next]
            event.currentTarget.querySelector('[data-make="' + this.stop.make + '"]').focus()
            event.preventDefault()
        }
    }

    arm(type, template) {
        const name = template || type.type
        if (this.armed && this.armed.name === name) {
            this.armed = null
            return
        }
        const asked = type && type.kind !== 'joint' ? type.parameters.filter(parameter => this.isAsked(parameter)) : []
        this.armed = {name, type, template, fields: asked.map(parameter => ({p: parameter, text: ''})),
            joining: type && type.kind === 'joint' ? new Joining() : null,
            drawing: type && type.type === 'Wall' ? new Drawing() : null}
        this.edits.select(null)
    }

    /** Whether a parameter has no initial value, so that the user must enter one. */
    isAsked(parameter) {
        return this.isOfWheels(parameter) || parameter.required && parameter.initial === '' && parameter.name !== 'name'
    }

    /** Whether a parameter names wheels that a part turns. */
    isOfWheels(parameter) {
        return parameter.list && parameter.names === 'Wheel'
    }

    /** Returns the choices of a field that is a list: the robot's driven wheels. */
    choices(field) {
        return this.isOfWheels(field.p) ? drivenWheels(this.world.shown(), this.view.robot) : []
    }

    /**
     * Without a chosen wheel, a motor turns the first wheel without a motor, or drives a joint.
     * @return whether there is one
     */
    chooseWheel(edit) {
        const parameter = this.armed.type.parameters.filter(one => this.isOfWheels(one))[0]
        if (!parameter || edit.set[parameter.name]) {
            return true
        }
        const wheel = wheelToTurn(this.world.shown(), edit.to)
        const joint = jointToDrive(this.world.shown(), edit.to)
        if (!wheel && joint) {
            edit.set.joint = joint
            return true
        }
        edit.set[parameter.name] = wheel
        if (!wheel) {
            this.messages.say('error', 'a ' + this.armed.name + ' needs a driven wheel without a motor, and ' + edit.to
                + ' has none: add a Wheel or a joint first')
        }
        return Boolean(wheel)
    }

    disarm() {
        this.leave()
    }

    /**
     * Ends placing. If the focus was in the bar that disappears, it moves to the view, where keys move the new object.
     */
    leave() {
        const last = document.activeElement
        this.armed = null
        if (last && last.closest('.sear-armed')) {
            this.pointer.canvas().focus({preventScroll: true})
        }
    }

    isForRobots() {
        return Boolean(this.armed && this.armed.type && !this.armed.type.environment)
    }

    armedText() {
        const armed = this.armed
        return !armed ? '' : armed.joining ? armed.joining.text() : armed.drawing ? armed.drawing.text()
            : this.isForRobots() ? 'Click on a robot to mount it there' : 'Click where to place it'
    }

    /** Returns the names that a joint's object may have; only the first one may be the world. */
    partners(isFirst) {
        return (isFirst ? [WORLD] : []).concat(ends(this.world.shown()))
    }

    /** Makes the joint whose two objects are chosen. @param free whether it does not snap */
    join(free) {
        const {type, joining} = this.armed
        const problem = joining.problem(this.world.shown())
        if (problem) {
            this.messages.say('error', problem)
            this.armed.joining = new Joining()
            return
        }
        const set = joining.values(this.world.shown(), type.type, value => this.snapped(value, free))
        const edit = {'do': 'add', type: type.type, set}
        if (joining.robot()) {
            edit.to = joining.robot()
        }
        this.edits.edit(edit, answer => {
            this.edits.selectAfter(answer)
            if (answer.done) {
                this.leave()
            } else {
                this.armed.joining = new Joining()
            }
        })
    }

    /** Follows the mouse while a wall is drawn. @param under what is there @return whether one is drawn */
    hover(under, free) {
        const drawing = this.armed && this.armed.drawing
        if (drawing) {
            drawing.next = under && drawing.corners.length ? this.corner(under, free) : null
        }
        return Boolean(drawing)
    }

    /** Returns where a wall's corner goes. */
    corner(under, free) {
        return this.armed.drawing.snap(this.world.shown(), [under.point[0], under.point[2]],
            value => this.snapped(value, free), free)
    }

    /** Makes the wall that is drawn. */
    endWall() {
        const drawing = this.armed && this.armed.drawing
        if (drawing && drawing.isWhole()) {
            this.edits.edit({'do': 'add', type: 'Wall', set: drawing.values()}, answer => {
                this.edits.selectAfter(answer)
                if (answer.done) {
                    this.leave()
                }
            })
        }
    }

    /** Handles a key while a wall is drawn. @return whether it did */
    wallKey(key) {
        const drawing = this.armed && this.armed.drawing
        if (drawing && key === 'Enter') {
            this.endWall()
        } else if (drawing && key === 'Backspace') {
            drawing.takeBack()
        } else {
            return false
        }
        return true
    }

    /** Returns a parameter's initial number in a new object. */
    initial(type, name) {
        const found = type.parameters.filter(parameter => parameter.name === name)[0]
        return found ? Number(found.initial || found['default']) || 0 : 0
    }

    /** Returns the height of a new object's middle above its support. */
    lift(type) {
        return this.initial(type, 'height') / 2 || this.initial(type, 'radius')
    }

    snapped(value, free) {
        return this.snap && !free ? Math.round(value / GRID) * GRID : value
    }

    /**
     * Makes the armed kind.
     * @param at point [x, y, z] in the world, ground (whether that is a terrain), robot (its name, null for none),
     * local (the point in its frame), normal (of its surface, there)
     * @param free whether it does not snap @param anywhere whether the place is a default, not the user's
     */
    place(at, free, anywhere) {
        const armed = this.armed
        if (armed.joining) {
            if (armed.joining.click(at)) {
                this.join(free)
            }
            return
        }
        if (armed.drawing) {
            if (armed.drawing.click(this.corner(at, free), at.point[1])) {
                this.endWall()
            }
            return
        }
        const edit = {'do': armed.template ? 'robot' : 'add', set: {}}
        armed.fields.forEach(field => {
            edit.set[field.p.name] = field.text
        })
        if (armed.template) {
            edit.template = armed.template
        } else {
            edit.type = armed.type.type
        }
        if (this.isForRobots()) {
            const robot = at.robot || this.view.robot
            if (!robot) {
                this.messages.say('error', 'a ' + armed.name + ' is a robot part: place a robot first, for example '
                    + 'Chassis from the group Robots')
                return
            }
            edit.to = robot
            Object.assign(edit.set, tilted(armed.type))
            if (!this.chooseWheel(edit)) {
                return
            }
            if (armed.name === 'Wheel') {
                Object.assign(edit.set, besideBody(this.world.shown(), robot, at.robot && !anywhere ? at.local : null,
                    {radius: this.initial(armed.type, 'radius'), width: this.initial(armed.type, 'width')},
                        value => this.snapped(value, free)))
            } else if (at.robot) {
                Object.assign(edit.set, mounted(at, armed.type, free, this.snapped.bind(this)))
            } else {
                this.put(edit.set, [0, 0.1, 0], free)
            }
        } else if (at.ground) {
            edit.set.x = plain(this.snapped(at.point[0], free))
            edit.set.z = plain(this.snapped(at.point[2], free))
            edit.set.onGround = 'true'
        } else {
            this.put(edit.set, [at.point[0], at.point[1] + (armed.type ? this.lift(armed.type) : 0), at.point[2]], free)
        }
        const made = isThing(armed.template) ? this.thing(armed.template, at, free) : edit
        this.edits.edit(armed.template ? withGround(made, this.world.shown()) : made, answer => {
            this.edits.selectAfter(answer)
            if (answer.done) {
                this.leave()
            } else if (armed.type) {
                this.askFor(armed, answer.problems)
            }
        })
    }

    /** Returns the edit that makes a thing of several objects. */
    thing(name, at, free) {
        const taken = (this.world.shown() || {objects: []}).objects.map(object => object.name)
        const place = [this.snapped(at.point[0], free), at.point[1], this.snapped(at.point[2], free)]
        return thingEdit(name, place, taken, plain)
    }

    /** Adds a field for each invalid parameter, so that the user can enter it, for example a motor's wheel. */
    askFor(armed, problems) {
        armed.type.parameters.forEach(parameter => {
            const wrong = problems.some(problem => problem.field.split(/[.#]/)[0] === parameter.name)
            const known = armed.fields.some(field => field.p.name === parameter.name)
            if (wrong && !known) {
                armed.fields.push({p: parameter, text: ''})
            }
        })
    }

    /** Keeps the point's height, rounded. */
    put(set, point, free) {
        set.x = plain(this.snapped(point[0], free))
        set.y = plain(point[1])
        set.z = plain(this.snapped(point[2], free))
    }

    /** Places the kind without a mouse: where the view looks; a robot part in the middle of the robot's top. */
    placeInTheMiddle() {
        const middle = this.pointer.middle()
        this.place(this.isForRobots() ? this.onTop(middle.robot || this.view.robot) || middle : middle, false, true)
    }

    onTop(name) {
        const robot = this.world.shown().robots.filter(one => one.name === name)[0]
        const top = robot && pointing.onMap(this.world.shown(), robot.pose[0], robot.pose[2])
        return top && top.robot === name ? top : null
    }

    // ---- from the palette into the view
    // ------------------------------------------------------------------------------------------------
    grab(event) {
        this.carried = event.target.closest && event.button === 0
            ? event.target.closest('.sear-palette [data-make]') : null
    }

    drop(event) {
        const name = this.carried && this.carried.getAttribute('data-make')
        this.carried = null
        if (!name || event.target !== this.pointer.canvas()) {
            return
        }
        if (!this.armed || this.armed.name !== name) {
            const type = this.edits.typeOf(name)
            this.arm(type, type ? undefined : name)
        }
        const under = this.pointer.under(event)
        if (under) {
            this.place(under, event.altKey)
        }
        this.panel.scope.$applyAsync()
    }
}
