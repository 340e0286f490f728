// SPDX-License-Identifier: Apache-2.0
// The palette of the SEAR panel: all kinds of objects, placed by a click in the view.
import {mounted, tilted, withGround} from './mounting.js'
import * as making from './kinds.js'
import {plain} from './places.js'
import {besideBody, drivenWheels, wheelToTurn} from './wheels.js'
import * as pointing from '../world/pointing.js'

var GRID = 0.05             // snapping distance, metres
var STEPS = {ArrowDown: 1, ArrowRight: 1, ArrowUp: -1, ArrowLeft: -1}

/** Makes the palette of one panel. */
export function makePalette(panel, messages, world, view, edits, pointer) {
    var carried = null          // the button being dragged from
    var palette = {
        armed: null,            // what the next click makes: type or template, and fields to fill in
        snap: true,
        sought: ''              // search text
    }

    palette.build = function() {
        palette.armed = null
        view.build(!view.building)
    }
    // ---- what can be made, in groups ---------------------------------------------------------------------------------------------------
    var kinds = []              // kinds found, in the order shown
    var groups = []             // groups of the kinds found
    var made = null             // grammar and search text that these belong to
    var stop = null             // kind that the Tab key reaches: the one that the arrow keys reached last
    /** Returns the groups of kinds that match the search text: name, kinds. The same array until that text changes. */
    palette.groups = function() {
        if (made && made.grammar === edits.grammar && made.sought === palette.sought) {
            return groups
        }
        made = {grammar: edits.grammar, sought: palette.sought}
        var all = !edits.grammar ? [] : edits.grammar.types.filter(type => type.kind !== 'robot').map(making.ofType)
            .concat(edits.grammar.templates.map(making.ofTemplate))
        var wanted = palette.sought.trim().toLowerCase()
        kinds = all.filter(kind => kind.sought.indexOf(wanted) >= 0)
        groups = making.GROUPS.map(name => ({name: name, kinds: kinds.filter(kind => kind.group === name)})).filter(group => group.kinds.length)
        kinds = [].concat.apply([], groups.map(group => group.kinds))
        stop = kinds.indexOf(stop) < 0 ? kinds[0] : stop
        return groups
    }
    palette.isStop = function(kind) {
        return kind === stop
    }
    /** Arrow keys go to the next kind, Home and End to the ends. */
    palette.key = function(event) {
        var at = kinds.findIndex(kind => kind.make === event.target.getAttribute('data-make'))
        var next = event.key === 'Home' ? 0 : event.key === 'End' ? kinds.length - 1 : at + STEPS[event.key]
        if (at >= 0 && kinds[next]) {
            stop = kinds[next]
            event.currentTarget.querySelector('[data-make="' + stop.make + '"]').focus()
            event.preventDefault()
        }
    }

    palette.arm = function(type, template) {
        var name = template || type.type
        if (palette.armed && palette.armed.name === name) {
            palette.armed = null
            return
        }
        palette.armed = {name: name, type: type, template: template, fields: type ? type.parameters.filter(isAsked).map(function(parameter) {
            return {p: parameter, text: ''}
        }) : []}
        edits.select(null)
    }
    /** Whether a parameter has no initial value, so that the user must enter one. */
    function isAsked(parameter) {
        return isOfWheels(parameter) || parameter.required && parameter.initial === '' && parameter.name !== 'name'
    }
    /** Whether a parameter names wheels that a part turns. */
    function isOfWheels(parameter) {
        return parameter.list && parameter.names === 'Wheel'
    }
    /** Returns the choices of a field that is a list: the robot's driven wheels. */
    palette.choices = function(field) {
        return isOfWheels(field.p) ? drivenWheels(world.shown(), view.robot) : []
    }
    /** Without a chosen wheel, a motor turns the first wheel without a motor. @return whether there is one */
    function chooseWheel(edit) {
        var parameter = palette.armed.type.parameters.filter(isOfWheels)[0]
        if (!parameter || edit.set[parameter.name]) {
            return true
        }
        var wheel = wheelToTurn(world.shown(), edit.to)
        edit.set[parameter.name] = wheel
        if (!wheel) {
            messages.say('error', 'a ' + palette.armed.name + ' needs a driven wheel without a motor, and ' + edit.to
                + ' has none: add a Wheel first')
        }
        return Boolean(wheel)
    }
    palette.disarm = function() {
        leave()
    }
    /**
     * Ends placing. If the focus was in the bar that disappears, it moves to the view, where keys move the new object.
     */
    function leave() {
        var last = document.activeElement
        palette.armed = null
        if (last && last.closest('.sear-armed')) {
            pointer.canvas().focus({preventScroll: true})
        }
    }
    palette.isForRobots = function() {
        return Boolean(palette.armed && palette.armed.type && !palette.armed.type.environment)
    }
    palette.armedText = function() {
        var armed = palette.armed
        return !armed ? '' : palette.isForRobots() ? 'Click on a robot to mount it there' : 'Click where to place it'
    }

    /** Returns a parameter's initial number in a new object. */
    function initial(type, name) {
        var found = type.parameters.filter(parameter => parameter.name === name)[0]
        return found ? Number(found.initial || found['default']) || 0 : 0
    }
    /** Returns the height of a new object's middle above its support. */
    function lift(type) {
        return initial(type, 'height') / 2 || initial(type, 'radius')
    }

    palette.snapped = function(value, free) {
        return palette.snap && !free ? Math.round(value / GRID) * GRID : value
    }

    /**
     * Makes the armed kind.
     * @param at point [x, y, z] in the world, ground (whether that is a terrain), robot (its name, null for none),
     * local (the point in its frame), normal (of its surface, there)
     * @param free whether it does not snap @param anywhere whether the place is a default, not the user's
     */
    palette.place = function(at, free, anywhere) {
        var armed = palette.armed
        var edit = {'do': armed.template ? 'robot' : 'add', set: {}}
        armed.fields.forEach(function(field) {
            edit.set[field.p.name] = field.text
        })
        if (armed.template) {
            edit.template = armed.template
        } else {
            edit.type = armed.type.type
        }
        if (palette.isForRobots()) {
            var robot = at.robot || view.robot
            if (!robot) {
                messages.say('error', 'a ' + armed.name + ' is a robot part: place a robot first, for example Chassis from the group Robots')
                return
            }
            edit.to = robot
            angular.extend(edit.set, tilted(armed.type))
            if (!chooseWheel(edit)) {
                return
            }
            if (armed.name === 'Wheel') {
                angular.extend(edit.set, besideBody(world.shown(), robot, at.robot && !anywhere ? at.local : null,
                    {radius: initial(armed.type, 'radius'), width: initial(armed.type, 'width')}, value => palette.snapped(value, free)))
            } else if (at.robot) {
                angular.extend(edit.set, mounted(at, armed.type, free, palette.snapped))
            } else {
                put(edit.set, [0, 0.1, 0], free)
            }
        } else if (at.ground) {
            edit.set.x = plain(palette.snapped(at.point[0], free))
            edit.set.z = plain(palette.snapped(at.point[2], free))
            edit.set.onGround = 'true'
        } else {
            put(edit.set, [at.point[0], at.point[1] + (armed.type ? lift(armed.type) : 0), at.point[2]], free)
        }
        edits.edit(armed.template ? withGround(edit, world.shown()) : edit, function(answer) {
            edits.selectAfter(answer)
            if (answer.done) {
                leave()
            } else if (armed.type) {
                askFor(armed, answer.problems)
            }
        })
    }
    /** Adds a field for each invalid parameter, so that the user can enter it, for example a motor's wheel. */
    function askFor(armed, problems) {
        armed.type.parameters.forEach(function(parameter) {
            var wrong = problems.some(problem => problem.field.split(/[.#]/)[0] === parameter.name)
            var known = armed.fields.some(field => field.p.name === parameter.name)
            if (wrong && !known) {
                armed.fields.push({p: parameter, text: ''})
            }
        })
    }
    /** Keeps the point's height, rounded. */
    function put(set, point, free) {
        set.x = plain(palette.snapped(point[0], free))
        set.y = plain(point[1])
        set.z = plain(palette.snapped(point[2], free))
    }
    /** Places the kind without a mouse: where the view looks; a robot part in the middle of the robot's top. */
    palette.placeInTheMiddle = function() {
        var middle = pointer.middle()
        palette.place(palette.isForRobots() ? onTop(middle.robot || view.robot) || middle : middle, false, true)
    }
    function onTop(name) {
        var robot = world.shown().robots.filter(one => one.name === name)[0]
        var top = robot && pointing.onMap(world.shown(), robot.pose[0], robot.pose[2])
        return top && top.robot === name ? top : null
    }
    // ---- from the palette into the view ------------------------------------------------------------------------------------------------
    function grab(event) {
        carried = event.target.closest && event.button === 0 ? event.target.closest('.sear-palette [data-make]') : null
    }
    /** Stops the views from turning during a drag from the palette. */
    function carry(event) {
        if (carried) {
            event.stopPropagation()
        }
    }
    function drop(event) {
        var name = carried && carried.getAttribute('data-make')
        carried = null
        if (!name || event.target !== pointer.canvas()) {
            return
        }
        if (!palette.armed || palette.armed.name !== name) {
            var type = edits.typeOf(name)
            palette.arm(type, type ? undefined : name)
        }
        var under = pointer.under(event)
        if (under) {
            palette.place(under, event.altKey)
        }
        panel.scope.$applyAsync()
    }
    window.addEventListener('mousedown', grab, true)
    window.addEventListener('mousemove', carry, true)
    window.addEventListener('mouseup', drop, true)
    panel.scope.$on('$destroy', function() {
        window.removeEventListener('mousedown', grab, true)
        window.removeEventListener('mousemove', carry, true)
        window.removeEventListener('mouseup', drop, true)
    })
    return palette
}
