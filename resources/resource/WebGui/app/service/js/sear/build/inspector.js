// SPDX-License-Identifier: Apache-2.0
// The inspector of the SEAR panel: each parameter of the selected object with its unit, valid values and meaning from
// the grammar.
import {robotOf} from './balance.js'
import {sizesOf} from './handles.js'
import * as places from './places.js'
import {drivenWheels} from './wheels.js'
import {find} from '../world/pointing.js'

var PARTS = ['component', 'wheel']              // parameters of a robot that other edits handle
// Groups of parameters, in the order shown, with a pattern of their names. All other parameters are in the group OWN.
var GROUPS = [
    ['Size', /^(length|width|height|radius|scale[XYZ]|size)$/],
    ['Place', /^([xyz]|r[xyz]|onGround)$/],
    ['Settings', null],
    ['Look', /^(color|image|imageSize)$/],
    ['Physics', /^(mass|friction|rollingFriction|restitution|(velocity|spin)[XYZ])$/],
    ['Earth', /^place[A-Z]/]
]
var OWN = 'Settings'
// Numbers with a decimal comma or a unit, and each unit's factor to SEAR's unit.
var WRITTEN = /^([+-]?\d*[.,]?\d+)\s*([a-z°]*)$/i
var UNITS = {m: {mm: 0.001, cm: 0.01, dm: 0.1, m: 1, km: 1000}, kg: {g: 0.001, kg: 1, t: 1000}, deg: {deg: 1, '°': 1}}

/** Makes the inspector of one panel. */
export function makeInspector(panel, world, edits) {
    var shown = null            // object and type of the rows
    var pen = document.createElement('canvas').getContext('2d')     // converts colour names
    var inspector = {
        groups: [],             // groups of rows: name, rows
        rows: [],               // one row per parameter
        parts: [],              // parts of a selected robot: address in edits, name
        nameError: '',          // error of the name typed last
        inspected: {},          // name in its field, and the robot it is mounted on
        mountable: false,       // whether it can be mounted on a robot
        stays: false,           // whether it must be on a robot
        refused: ''             // errors that belong to no field
    }

    function grouped(rows) {
        function nameOf(row) {
            var found = GROUPS.filter(group => group[1] && group[1].test(row.p.name))[0]
            return found ? found[0] : OWN
        }
        var isScale = row => /^scale/.test(row.p.name) ? 1 : 0      // rarely used
        return GROUPS.map(group => ({name: group[0], rows: rows.filter(row => nameOf(row) === group[0]).sort((a, b) => isScale(a) - isScale(b))}))
            .filter(group => group.rows.length)
    }
    /** Compares texts, or lists of entries. */
    function same(a, b) {
        return angular.equals(a === undefined ? '' : a, b === undefined ? '' : b)
    }
    function rowOf(parameter) {
        var row = {p: parameter, id: 'sear-p-' + parameter.name, text: '', was: '', entries: null, error: ''}
        /** Returns the colour in the form of the browser's colour input; with an argument, sets another one. */
        row.color = function(chosen) {
            if (arguments.length) {
                row.text = chosen
                inspector.setRow(row)
            }
            pen.fillStyle = '#808080'
            pen.fillStyle = row.text || parameter['default'] || '#808080'
            return pen.fillStyle
        }
        return row
    }
    /** Returns the fields of a list entry: a group's parameters, or the value itself. */
    function entryOf(row, value) {
        var fields = row.p.parameters || [row.p]
        return fields.map(function(parameter) {
            var text = row.p.parameters ? (value || {})[parameter.name] : value
            return {p: parameter, text: text === undefined || text === null ? parameter.initial || parameter['default'] : text}
        })
    }
    /** Whether the user is typing there, and has neither pressed Enter nor left the field. */
    function isTyped(row) {
        var field = document.activeElement
        var model = field && field.closest('[data-field="' + row.p.name + '"] input.form-control') && angular.element(field).controller('ngModel')
        return Boolean(model) && field.value.trim() !== (model.$isEmpty(model.$modelValue) ? '' : String(model.$modelValue))
    }
    function fill(row, value) {
        row.behind = row.filled && !same(row.was, value) && isTyped(row)
        if (row.behind || same(row.was, value) && row.filled) {
            return              // keeps text being typed; if another page has set the value meanwhile, the service rejects it
        }
        row.filled = true
        row.was = value === undefined ? '' : value
        if (!row.refused) {
            row.error = ''
        }
        row.refused = false     // another page's new value comes together with the reason why this page could not set its own
        if (row.p.list) {
            row.entries = (value || []).map(one => entryOf(row, one))
        } else {
            row.text = row.was
        }
    }

    edits.changed.hear(function() {
        var object = edits.object
        var type = object && edits.typeOf(object.type)
        if (!type) {
            inspector.rows = []
            inspector.groups = []
            inspector.parts = []
            shown = null
            return
        }
        if (shown !== object.object + ' ' + object.type) {
            shown = object.object + ' ' + object.type
            inspector.refused = ''
            inspector.nameError = ''
            inspector.rows = type.parameters.filter(function(parameter) {
                return parameter.name !== 'name' && (type.kind !== 'robot' || PARTS.indexOf(parameter.name) < 0)
            }).map(rowOf)
            inspector.groups = grouped(inspector.rows)
        }
        inspector.rows.forEach(function(row) {
            fill(row, object.values[row.p.name])
        })
        inspector.inspected = {name: object.name, robot: object.robot || ''}
        inspector.mountable = type.robot && (type.environment || Boolean(object.robot))
        inspector.stays = Boolean(object.robot) && !type.environment
        inspector.parts = partsOf(object)
    })
    function partsOf(robot) {
        if (robot.type !== 'SEARrobot') {
            return []
        }
        var names = (robot.values.component || []).concat((robot.values.wheel || []).map(wheel => wheel.name))
        return names.map(function(name) {
            return {object: edits.address(robot.name, name), name: name.slice(name.indexOf('/') + 1)}
        })
    }

    inspector.robotNames = function() {
        var seen = world.shown()
        return seen ? seen.robots.map(robot => robot.name) : []
    }

    // ---- changes -----------------------------------------------------------------------------------------------------------------------
    function valueOf(row) {
        return !row.entries ? row.text : row.entries.map(function(entry) {
            if (!row.p.parameters) {
                return entry[0].text
            }
            var value = {}
            entry.forEach(function(field) {
                value[field.p.name] = field.text
            })
            return value
        })
    }
    /** Returns the number that a text means in a parameter's unit; empty if the text is a number, or not understood. */
    function numberMeant(parameter, text) {
        var found = parameter.kind === 'number' && isNaN(Number(text)) ? WRITTEN.exec(String(text).trim()) : null
        var unit = found && found[2].toLowerCase()
        var factor = !found ? 0 : !unit || unit === parameter.unit ? 1 : (UNITS[parameter.unit] || {})[unit] || 0
        return factor ? String(Number((Number(found[1].replace(',', '.')) * factor).toPrecision(12))) : ''
    }
    /** Returns what to set for a size: growing upwards keeps the underside in place. */
    function withUnderside(row, value) {
        var set = {}
        set[row.p.name] = value
        var values = edits.values()
        var size = sizesOf(edits.typeOf(edits.object.type)).y || (edits.object.type === 'Sphere' ? {name: 'radius', share: 0.5} : null)
        var grown = Number(value) - Number(row.was)
        var leans = ['rx', 'rz'].some(angle => Number(values[angle]) % 360)
        if (!size || size.name !== row.p.name || !row.was || !grown || values.y === undefined || leans || values.onGround === 'true'
            || values.placeLatitude !== undefined) {
            return set
        }
        var place = places.of(find(world.shown(), edits.selected), values, panel.isSimulating() && world.shown() === world.running)
        set.y = places.plain(place.at[1] + grown / size.share / 2 * (Number(values.scaleY) || 1))
        return places.edit(place, set)
    }
    /** Sends the value of a row. */
    inspector.setRow = function(row) {
        var value = valueOf(row)
        var meant = row.entries ? '' : numberMeant(row.p, value)
        if (meant || same(value, row.was)) {
            row.error = meant ? 'write ' + meant : ''
            return
        }
        var name = row.p.name
        var seen = edits.values()
        if (same(seen[name], edits.object.values[name])) {      // else this page has just set it
            seen[name] = row.was
        }
        edits.edit(edits.setting(edits.selected, withUnderside(row, value), seen), function(answer) {
            if (answer.done) {
                row.was = value
            }
            showAt(row, answer)
        })
    }
    function showAt(row, answer) {
        row.error = ''
        inspector.refused = ''
        if (answer.done) {
            return
        }
        var other = []
        angular.forEach(answer.problems, function(problem) {
            var text = 'legal: ' + problem.legal
            if (problem.field.split(/[.#]/)[0] === row.p.name) {
                row.error += (row.error ? '; ' : '') + (problem.field === row.p.name ? '' : problem.field + ' ') + text
            } else {
                other.push((problem.field ? problem.field + ' is "' + problem.value + '", ' : problem.value + ', ') + text)
            }
        })
        if (!answer.problems.length || other.length && !row.error) {
            row.error = other.shift() || answer.reason
        }
        row.refused = Boolean(row.error)
        if (!answer.problems.length) {
            row.filled = false
            fill(row, row.was)      // so that the same value can be entered again
        }
        inspector.refused = other.join('; ')
    }
    /** Escape restores a field's value and clears the parameter's error. */
    inspector.key = function(event) {
        var model = event.key === 'Escape' && event.target.matches('input.form-control') && angular.element(event.target).controller('ngModel')
        if (!model) {
            return
        }
        model.$rollbackViewValue()
        var field = event.target.closest('[data-field]')
        inspector.rows.forEach(function(row) {
            if (field && field.dataset.field === row.p.name && !row.entries) {
                row.text = row.was
                row.error = ''
            }
        })
        event.stopPropagation()
    }
    /** Renames the object. An invalid name shows an error below its field, and the field returns to the old name. */
    inspector.rename = function() {
        var name = inspector.inspected.name
        inspector.nameError = ''
        edits.rename(name, function(answer) {
            var why = answer.reason || answer.problems.map(one => 'legal: ' + one.legal).join('; ')
            inspector.nameError = '"' + name + '" is not a valid name here; ' + why
            inspector.inspected.name = edits.object.name
        })
    }
    /** Returns the choices of a field for a driven wheel's name, including its current value. */
    inspector.choices = function(field) {
        var wheels = field.p.names === 'Wheel' && edits.object ? drivenWheels(world.shown(), edits.object.robot) : []
        return !wheels.length || !field.text || wheels.indexOf(field.text) >= 0 ? wheels : wheels.concat(field.text)
    }
    /** Returns a value with its meaning. */
    inspector.wordOf = function(parameter, value) {
        var word = parameter.words && parameter.words[parameter.values.indexOf(value)]
        return word ? value + ' ' + word : value
    }
    inspector.isSwitch = row => row.p.kind === 'switch'
    inspector.isColor = row => row.p.name === 'color' && !row.entries
    /** State of a switch's box: the value, or the default. */
    inspector.isOn = row => (row.text || row.p['default']) === 'true'
    inspector.flip = function(row) {
        row.text = inspector.isOn(row) ? 'false' : 'true'
        inspector.setRow(row)
    }
    inspector.addEntry = function(row) {
        row.entries.push(entryOf(row, null))
        if (row.p.parameters) {
            inspector.setRow(row)
        }
    }
    inspector.removeEntry = function(row, entry) {
        row.entries.splice(row.entries.indexOf(entry), 1)
        inspector.setRow(row)
    }
    /** Returns the description of the selection's type. */
    inspector.about = function() {
        var type = edits.object && edits.typeOf(edits.object.type)
        return type ? type.doc.charAt(0).toUpperCase() + type.doc.slice(1) + '.' : ''
    }
    /** Returns a parameter's meaning, valid values and default. */
    inspector.docOf = function(parameter) {
        return parameter.doc + '. Legal: ' + parameter.legal + (parameter['default'] ? '. Default: ' + parameter['default'] : '') + '.'
    }
    /**
     * Returns the balance of the selected robot, or of the robot whose part is selected: centre, critical, words; null
     * for none.
     */
    inspector.balance = function() {
        var robot = robotOf(find(world.shown(), edits.selected))
        return robot && robot.balance
    }
    inspector.centreText = function() {
        return inspector.balance().centre.map(metres => metres.toFixed(3)).join(', ')
    }
    return inspector
}
