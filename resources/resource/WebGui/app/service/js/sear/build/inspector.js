// SPDX-License-Identifier: Apache-2.0
// The inspector of the SEAR panel: each parameter of the selected object with its unit, valid values and meaning from
// the grammar.
import {parameterWords} from '../shared/words.js'
import {robotOf} from './balance.js'
import {sizesOf} from './handles.js'
import * as joints from './joints.js'
import * as places from './places.js'
import {drivenWheels} from './wheels.js'
import {find} from '../world/pointing.js'

const PARTS = ['component', 'wheel']              // parameters of a robot that other edits handle
// Groups of parameters, in the order shown, with a pattern of their names. All other parameters are in the group OWN.
const GROUPS = [
    ['Size', /^(length|width|height|radius|scale[XYZ]|size)$/],
    ['Place', /^([xyz]|r[xyz]|onGround)$/],
    ['Settings', null],
    ['Look', /^(color|image|imageSize)$/],
    ['Physics', /^(mass|friction|rollingFriction|restitution|(velocity|spin)[XYZ])$/],
    ['Earth', /^place[A-Z]/]
]
const OWN = 'Settings'
// Numbers with a decimal comma or a unit, and each unit's factor to SEAR's unit.
const WRITTEN = /^([+-]?\d*[.,]?\d+)\s*([a-z°]*)$/i
const UNITS = {m: {mm: 0.001, cm: 0.01, dm: 0.1, m: 1, km: 1000}, kg: {g: 0.001, kg: 1, t: 1000},
    deg: {deg: 1, '°': 1}}

/** The inspector of one panel. */
export class Inspector {
    constructor(panel, world, edits) {
        this.panel = panel
        this.world = world
        this.edits = edits
        let shown = null      // object and type of the rows
        this.pen = document.createElement('canvas').getContext('2d') // converts colour names
        this.groups = []        // groups of rows: name, rows
        this.rows = []          // one row per parameter
        this.parts = []         // parts of a selected robot: address in edits, name
        this.nameError = ''     // error of the name typed last
        this.inspected = {}     // name in its field, and the robot it is mounted on
        this.mountable = false  // whether it can be mounted on a robot
        this.stays = false      // whether it must be on a robot
        this.refused = ''       // errors that belong to no field

        edits.changed.hear(() => {
            const object = edits.object
            const type = object && edits.typeOf(object.type)
            if (!type) {
                this.rows = []
                this.groups = []
                this.parts = []
                shown = null
                return
            }
            if (shown !== object.object + ' ' + object.type) {
                shown = object.object + ' ' + object.type
                this.refused = ''
                this.nameError = ''
                this.rows = type.parameters.filter(parameter => parameter.name !== 'name'
                    && (type.kind !== 'robot' || PARTS.indexOf(parameter.name) < 0))
                    .map(parameter => this.rowOf(parameter))
                this.groups = this.grouped(this.rows, type.kind === 'joint' ? joints.GROUPS : GROUPS)
            }
            this.rows.forEach(row => {
                this.fill(row, object.values[row.p.name])
            })
            this.inspected = {name: object.name, robot: object.robot || ''}
            this.mountable = type.robot && type.kind !== 'joint' && (type.environment || Boolean(object.robot))
            this.stays = Boolean(object.robot) && !type.environment
            this.parts = this.partsOf(object)
        })
    }

    grouped(rows, groups) {
        function nameOf(row) {
            const found = groups.filter(group => group[1] && group[1].test(row.p.name))[0]
            return found ? found[0] : OWN
        }
        const isScale = row => /^scale/.test(row.p.name) ? 1 : 0      // rarely used
        return groups.map(group => ({name: group[0], rows: rows.filter(row => nameOf(row) === group[0])
            .sort((a, b) => isScale(a) - isScale(b))}))
            .filter(group => group.rows.length)
    }

    labelOf(parameter) {
        return parameterWords(parameter.name)
    }

    /** Compares texts, or lists of entries. */
    same(a, b) {
        return angular.equals(a === undefined ? '' : a, b === undefined ? '' : b)
    }

    rowOf(parameter) {
        const ofJoint = this.edits.typeOf(this.edits.object.type).kind === 'joint'
        const row = {p: parameter, id: 'sear-p-' + parameter.name, text: '', was: '', entries: null, error: '',
            word: ofJoint && joints.WORDS[parameter.name] || parameterWords(parameter.name),
            isPartner: ofJoint && (parameter.name === 'first' || parameter.name === 'second')}
        /** Returns the colour in the form of the browser's colour input; with an argument, sets another one. */
        row.color = (...chosen) => {
            if (chosen.length) {
                row.text = chosen[0]
                this.setRow(row)
            }
            this.pen.fillStyle = '#808080'
            this.pen.fillStyle = row.text || parameter['default'] || '#808080'
            return this.pen.fillStyle
        }
        return row
    }

    /** Returns the fields of a list entry: a group's parameters, or the value itself. */
    entryOf(row, value) {
        const fields = row.p.parameters || [row.p]
        return fields.map(parameter => {
            const text = row.p.parameters ? (value || {})[parameter.name] : value
            return {p: parameter, text: text === undefined || text === null ? parameter.initial
                || parameter['default'] : text}
        })
    }

    /** Whether the user is typing there, and has neither pressed Enter nor left the field. */
    isTyped(row) {
        const field = document.activeElement
        const model = field && field.closest('[data-field="' + row.p.name + '"] :is(input, textarea).form-control')
        && angular.element(field).controller('ngModel')
        const text = model && row.p.drawing ? field.value : field && (field.value || '').trim()
        return Boolean(model) && text !== (model.$isEmpty(model.$modelValue) ? '' : String(model.$modelValue))
    }

    fill(row, value) {
        row.behind = row.filled && !this.same(row.was, value) && this.isTyped(row)
        if (row.behind || this.same(row.was, value) && row.filled) {
            // keeps text being typed; if another page has set the value meanwhile, the service rejects it
            return
        }
        row.filled = true
        row.was = value === undefined ? '' : value
        if (!row.refused) {
            row.error = ''
        }
        // another page's new value comes together with the reason why this page could not set its own
        row.refused = false
        if (row.p.drawing) {
            row.text = (value || []).join('\n')
        } else if (row.p.list) {
            row.entries = (value || []).map(one => this.entryOf(row, one))
        } else {
            row.text = row.was
        }
    }

    partsOf(robot) {
        if (robot.type !== 'SEARrobot') {
            return []
        }
        const names = (robot.values.component || []).concat((robot.values.wheel || []).map(wheel => wheel.name))
        return names.map(name => ({object: this.edits.address(robot.name, name),
            name: name.slice(name.indexOf('/') + 1)}))
    }

    robotNames() {
        const seen = this.world.shown()
        return seen ? seen.robots.map(robot => robot.name) : []
    }

    // ---- changes
    // -----------------------------------------------------------------------------------------------------------------
    valueIn(row) {
        if (row.p.drawing) {
            return row.text.replace(/\s+$/, '').split('\n')
        }
        return !row.entries ? row.text : row.entries.map(entry => {
            if (!row.p.parameters) {
                return entry[0].text
            }
            const value = {}
            entry.forEach(field => {
                value[field.p.name] = field.text
            })
            return value
        })
    }

    /** Returns the number that a text means in a parameter's unit; empty if the text is a number, or not understood. */
    numberMeant(parameter, text) {
        const found = parameter.kind === 'number' && isNaN(Number(text)) ? WRITTEN.exec(String(text).trim()) : null
        const unit = found && found[2].toLowerCase()
        const factor = !found ? 0 : !unit || unit === parameter.unit ? 1 : (UNITS[parameter.unit] || {})[unit] || 0
        return factor ? String(Number((Number(found[1].replace(',', '.')) * factor).toPrecision(12))) : ''
    }

    /** Returns what to set for a size: growing upwards keeps the underside in place. */
    withUnderside(row, value) {
        const set = {}
        set[row.p.name] = value
        const values = this.edits.values()
        const type = this.edits.object.type
        const size = sizesOf(this.edits.typeOf(type)).y || (type === 'Sphere' ? {name: 'radius', share: 0.5} : null)
        const grown = Number(value) - Number(row.was)
        const leans = ['rx', 'rz'].some(angle => Number(values[angle]) % 360)
        if (!size || size.name !== row.p.name || !row.was || !grown || values.y === undefined || leans
            || values.onGround === 'true'
            || values.placeLatitude !== undefined) {
            return set
        }
        const live = this.panel.isSimulating() && this.world.shown() === this.world.running
        const place = places.of(find(this.world.shown(), this.edits.selected), values, live)
        set.y = places.plain(place.at[1] + grown / size.share / 2 * (Number(values.scaleY) || 1))
        return places.edit(place, set)
    }

    /** Sends the value of a row. */
    setRow(row) {
        const value = this.valueIn(row)
        const meant = row.p.list ? '' : this.numberMeant(row.p, value)
        if (meant || this.same(value, row.was)) {
            row.error = meant ? 'write ' + meant : ''
            return
        }
        const name = row.p.name
        const seen = this.edits.values()
        if (this.same(seen[name], this.edits.object.values[name])) {      // else this page has just set it
            seen[name] = row.was
        }
        this.edits.edit(this.edits.setting(this.edits.selected, this.withUnderside(row, value), seen), answer => {
            if (answer.done) {
                row.was = value
            }
            this.showAt(row, answer)
        })
    }

    showAt(row, answer) {
        row.error = ''
        this.refused = ''
        if (answer.done) {
            return
        }
        const other = []
        angular.forEach(answer.problems, problem => {
            const text = 'legal: ' + problem.legal
            if (problem.field.split(/[.#]/)[0] === row.p.name) {
                row.error += (row.error ? '; ' : '') + (problem.field === row.p.name ? '' : problem.field + ' ') + text
            } else {
                other.push((problem.field ? problem.field + ' is "' + problem.value + '", ' : problem.value
                    + ', ') + text)
            }
        })
        if (!answer.problems.length || other.length && !row.error) {
            row.error = other.shift() || answer.reason
        }
        row.refused = Boolean(row.error)
        if (!answer.problems.length) {
            row.filled = false
            this.fill(row, row.was)      // so that the same value can be entered again
        }
        this.refused = other.join('; ')
    }

    /** Escape restores a field's value and clears the parameter's error. */
    key(event) {
        const model = event.key === 'Escape' && event.target.matches(':is(input, textarea).form-control')
            && angular.element(event.target).controller('ngModel')
        if (!model) {
            return
        }
        model.$rollbackViewValue()
        const field = event.target.closest('[data-field]')
        this.rows.forEach(row => {
            if (field && field.dataset.field === row.p.name && !row.entries) {
                row.text = row.p.drawing ? row.was.join('\n') : row.was
                row.error = ''
            }
        })
        event.stopPropagation()
    }

    /** Renames the object. An invalid name shows an error below its field, and the field returns to the old name. */
    rename() {
        const name = this.inspected.name
        this.nameError = ''
        this.edits.rename(name, answer => {
            const why = answer.reason || answer.problems.map(one => 'legal: ' + one.legal).join('; ')
            this.nameError = '"' + name + '" is not a valid name here; ' + why
            this.inspected.name = this.edits.object.name
        })
    }

    /** Returns the choices of a field for a driven wheel's name, including its current value. */
    choices(field) {
        const wheels = field.p.names === 'Wheel' && this.edits.object
            ? drivenWheels(this.world.shown(), this.edits.object.robot) : []
        return !wheels.length || !field.text || wheels.indexOf(field.text) >= 0 ? wheels : wheels.concat(field.text)
    }

    /** Returns the objects that a joint may name there, including its present one. */
    partners(row) {
        const robot = this.edits.object && this.edits.object.robot
        const names = robot ? joints.partsOf(this.world.shown(), robot) : joints.partners(this.world.shown())
        return !row.text || names.indexOf(row.text) >= 0 ? names : names.concat(row.text)
    }

    /** Returns the directions of a joint's axis, by words; empty for an object without one. */
    directions() {
        return this.edits.object && joints.hasAxis(this.edits.object.type) ? joints.DIRECTIONS : []
    }

    /** Points the axis of the selected joint. @param angles rx, ry, rz in degrees */
    point(angles) {
        const set = {rx: String(angles[0]), ry: String(angles[1]), rz: String(angles[2])}
        this.edits.edit(this.edits.setting(this.edits.selected, set, this.edits.values()))
    }

    /** Returns why the selected joint does not move; empty if it can. */
    still() {
        const found = find(this.world.shown(), this.edits.selected)
        return found && found.object.still || ''
    }

    /** Returns a value with its meaning. */
    wordOf(parameter, value) {
        const word = parameter.words && parameter.words[parameter.values.indexOf(value)]
        return word ? value + ' ' + word : value
    }

    isSwitch(row) {
        return row.p.kind === 'switch'
    }

    isColor(row) {
        return row.p.name === 'color' && !row.entries
    }

    /** State of a switch's box: the value, or the default. */
    isOn(row) {
        return (row.text || row.p['default']) === 'true'
    }

    flip(row) {
        row.text = this.isOn(row) ? 'false' : 'true'
        this.setRow(row)
    }

    addEntry(row) {
        row.entries.push(this.entryOf(row, null))
        if (row.p.parameters) {
            this.setRow(row)
        }
    }

    removeEntry(row, entry) {
        row.entries.splice(row.entries.indexOf(entry), 1)
        this.setRow(row)
    }

    /** Returns the description of the selection's type. */
    about() {
        const type = this.edits.object && this.edits.typeOf(this.edits.object.type)
        return type ? type.doc.charAt(0).toUpperCase() + type.doc.slice(1) + '.' : ''
    }

    /** Returns a parameter's meaning, valid values and default. */
    docOf(parameter) {
        return parameter.doc + '. Legal: ' + parameter.legal
            + (parameter['default'] ? '. Default: ' + parameter['default'] : '') + '.'
    }

    /**
     * Returns the balance of the selected robot, or of the robot whose part is selected: centre, critical, words; null
     * for none.
     */
    balance() {
        const robot = robotOf(find(this.world.shown(), this.edits.selected))
        return robot && robot.balance
    }

    centreText() {
        return this.balance().centre.map(metres => metres.toFixed(3)).join(', ')
    }
}
