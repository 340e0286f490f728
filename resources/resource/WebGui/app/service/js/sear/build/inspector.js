// The inspector of the SEAR panel: every parameter of the selected object with its unit, what is legal, and what it means, as the grammar says it.
import {robotOf} from './balance.js'
import {find} from '../world/pointing.js'

var PARTS = ['component', 'wheel']              // of a robot: other edits see to them
// Which parameters stand together, by their names, in the order in which the groups are shown; the others are in the group OWN.
var GROUPS = [
    ['Size', /^(length|width|height|radius|scale[XYZ]|size)$/],
    ['Place', /^([xyz]|r[xyz]|onGround)$/],
    ['Settings', null],
    ['Look', /^(color|image|imageSize)$/],
    ['Physics', /^(mass|friction|rollingFriction|restitution|(velocity|spin)[XYZ])$/],
    ['Earth', /^place[A-Z]/]
]
var OWN = 'Settings'

/** Of one panel. */
export function makeInspector(panel, world, edits) {
    var shown = null            // whose rows these are
    var pen = document.createElement('canvas').getContext('2d')     // which knows the names of colours
    var inspector = {
        groups: [],             // of the rows: name, rows
        rows: [],               // of the parameters
        parts: [],              // of a selected robot: what edits call them, and their names
        inspected: {},          // the name as it stands in its field, and the robot that it is on
        mountable: false,       // whether it may be on a robot
        stays: false,           // whether it has to
        refused: ''             // what was wrong and belongs to no field
    }

    function grouped(rows) {
        function nameOf(row) {
            var found = GROUPS.filter(group => group[1] && group[1].test(row.p.name))[0]
            return found ? found[0] : OWN
        }
        var isScale = row => /^scale/.test(row.p.name) ? 1 : 0      // which few use
        return GROUPS.map(group => ({name: group[0], rows: rows.filter(row => nameOf(row) === group[0]).sort((a, b) => isScale(a) - isScale(b))}))
            .filter(group => group.rows.length)
    }
    /** Text of a value, entries of a list of them. */
    function same(a, b) {
        return angular.equals(a === undefined ? '' : a, b === undefined ? '' : b)
    }
    function rowOf(parameter) {
        var row = {p: parameter, id: 'sear-p-' + parameter.name, text: '', was: '', entries: null, error: ''}
        /** Its colour in the form that the browser's chooser has, be it a name or such a form; sets another one. */
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
    /** Fields of one entry of a list: of a group its parameters, else the value itself. */
    function entryOf(row, value) {
        var fields = row.p.parameters || [row.p]
        return fields.map(function(parameter) {
            var text = row.p.parameters ? (value || {})[parameter.name] : value
            return {p: parameter, text: text === undefined || text === null ? parameter.initial || parameter['default'] : text}
        })
    }
    function fill(row, value) {
        if (same(row.was, value) && row.filled) {
            return              // what the user is just typing stays
        }
        row.filled = true
        row.was = value === undefined ? '' : value
        if (!row.refused) {
            row.error = ''
        }
        row.refused = false     // what another page has set in the meantime comes with the reason why this page could not set it
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
    /** Sends what stands in a row. */
    inspector.setRow = function(row) {
        var value = valueOf(row)
        if (same(value, row.was)) {
            row.error = ''
            return
        }
        var edit = {'do': 'set', object: edits.selected, set: {}, was: {}}
        edit.set[row.p.name] = value
        edit.was[row.p.name] = row.was
        edits.edit(edit, function(answer) {
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
        inspector.refused = other.join('; ')
        edits.ask()
    }
    inspector.isSwitch = row => row.p.kind === 'switch'
    inspector.isColor = row => row.p.name === 'color' && !row.entries
    /** What the box of a switch shows: its value, or its default where it has none. */
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
    /** What the selected thing is, of a sensor also where it looks: ahead, or at the floor. */
    inspector.about = function() {
        var type = edits.object && edits.typeOf(edits.object.type)
        return type ? type.doc.charAt(0).toUpperCase() + type.doc.slice(1) + '.' : ''
    }
    /** What it means, what is legal and what it is without a value. */
    inspector.docOf = function(parameter) {
        return parameter.doc + '. Legal: ' + parameter.legal + (parameter['default'] ? '. Default: ' + parameter['default'] : '') + '.'
    }
    /** Of the robot that is selected, or whose part is: centre, critical, words; null for none. */
    inspector.balance = function() {
        var robot = robotOf(find(world.shown(), edits.selected))
        return robot && robot.balance
    }
    inspector.centreText = function() {
        return inspector.balance().centre.map(metres => metres.toFixed(3)).join(', ')
    }
    return inspector
}
