// SPDX-License-Identifier: Apache-2.0
// Edits of the project, done by the service, and the selected object.
import {plain} from './places.js'
import {makeEvent} from '../shared/event.js'

var PATIENCE_MILLIS = 15000 // timeout: a later answer is lost, for example with the connection
var UNANSWERED = 'no answer to an edit: MyRobotLab has ended or is busy, and the edit may not be done'

/** Makes the edits of one panel. */
export function makeEdits(panel, messages, world, view, picture) {
    var msg = panel.msg
    var page = Math.random().toString(36).slice(2)      // distinguishes answers to this page from answers to other pages
    var sent = 0
    var waiting = {}            // edits of this page without an answer, by number: edit, answered(answer)
    var others = ''             // latest edit of another page or a script since the selected object was last seen
    var edits = {
        grammar: null,          // types and templates that can be made; null until known
        undoable: null,         // text of the edit that undo reverts
        redoable: null,
        selected: null,         // address of the selected object in edits: box1, rover, rover/ping
        object: null,           // values in its file; null until known
        changed: makeEvent(),   // another object is selected, or its values changed
        leaving: makeEvent()    // before another edit or selection: sends pending key presses
    }

    /** Sends an edit to the service. @param then takes the answer; without it, the page shows why an edit failed */
    edits.edit = function(edit, then) {
        edits.leaving.tell()
        edit.page = page + ' ' + ++sent
        var before = messages.last
        var answered = then || sayRefusal
        waiting[edit.page] = {edit: edit, answered: function(answer) {
            if (answer.done) {
                messages.succeed(before)
            }
            answered(answer)
        }}
        view.choose()           // a user who builds keeps the view where it is
        msg.send('tryEdit', edit)
        panel.timeout(function() {
            if (waiting[edit.page]) {
                onEdit({page: edit.page, done: false, reason: UNANSWERED, problems: []})
            }
        }, PATIENCE_MILLIS)
    }
    /** Returns what this page has set in an object, without an answer yet. */
    function unanswered(object) {
        return Object.values(waiting).map(one => one.edit).filter(edit => edit['do'] === 'set' && edit.object === object)
            .reduce((all, edit) => angular.extend(all, edit.set), {})
    }
    /** Returns the selection's values as its file will contain them. */
    edits.values = () => angular.extend({}, edits.object.values, unanswered(edits.selected))
    /**
     * Returns an edit that sets values; the service rejects it if another client has changed them. @param seen values
     * that the user saw
     */
    edits.setting = function(object, set, seen) {
        var was = {}
        Object.keys(set).forEach(function(name) {
            was[name] = seen[name] === undefined ? '' : seen[name]
        })
        return {'do': 'set', object: object, set: set, was: was}
    }
    function sayRefusal(answer) {
        if (!answer.done) {
            messages.say('error', edits.refusal(answer))
        }
    }
    /** Returns why an edit failed, as one text. */
    edits.refusal = function(answer) {
        return answer.reason || answer.problems.map(function(problem) {
            return problem.file + ': ' + (problem.field ? problem.field + ' is "' + problem.value + '"' : problem.value) + ', legal: ' + problem.legal
        }).join('\n')
    }

    function onEdit(answer) {
        if (!answer) {
            return
        }
        var mine = waiting[answer.page]
        delete waiting[answer.page]
        if (answer.done) {
            onEdits(answer)
            world.look()
            if (answer.note && mine) {
                messages.say('warn', answer.note)
            }
            others = mine ? '' : (answer.words === answer.redo ? 'undo ' : '') + answer.words
        }
        if (answer.done || mine) {
            edits.ask()
        }
        if (mine) {
            if (answer.done && mine.edit['do'] === 'set' && edits.object && edits.object.object === mine.edit.object) {
                angular.extend(edits.object.values, mine.edit.set)
            }
            mine.answered(answer)
        }
    }
    function onEdits(state) {
        if (state) {
            edits.undoable = state.undo
            edits.redoable = state.redo
        }
    }
    function takeBack(kind, said) {
        edits.edit({'do': kind}, function(answer) {
            messages.say(answer.done ? 'info' : 'error', answer.done ? said + ': ' + answer.words : edits.refusal(answer))
            if (!answer.done) {
                msg.send('getEdits')
            }
        })
    }
    edits.undo = function() {
        takeBack('undo', 'undone')
    }
    edits.redo = function() {
        takeBack('redo', 'redone')
    }

    // ---- what is selected --------------------------------------------------------------------------------------------------------------
    /** Selects an object. @param address see selected; null for none */
    edits.select = function(address) {
        if (edits.selected !== address) {
            edits.leaving.tell()
            others = ''
            edits.selected = address
            edits.object = null
            edits.changed.tell()
        }
        edits.ask()
        picture.repaint()
    }
    edits.ask = function() {
        if (edits.selected) {
            msg.send('getProjectObject', edits.selected)
        }
    }
    /** Takes the data of an object. Each page receives the answers to all pages. */
    function onProjectObject(object) {
        if (!object || object.object !== edits.selected) {
            return
        }
        if (object.gone) {
            if (others) {
                messages.say('warn', edits.selected + ' was deleted or renamed by another page or a script. Its last edit: ' + others)
            }
            edits.select(null)
            return
        }
        others = ''
        if (Object.keys(unanswered(object.object)).length) {
            return              // the answer to the edit asks for it again
        }
        edits.object = object
        edits.changed.tell()
        picture.repaint()
    }
    /** Returns the address of a robot's part or sensor; the world message may prefix the robot's name. */
    edits.address = function(robot, name) {
        return robot + '/' + name.slice(name.indexOf('/') + 1)
    }

    /** Returns the description of a class; null if there is none. */
    edits.typeOf = function(name) {
        return edits.grammar && edits.grammar.types.filter(type => type.type === name)[0] || null
    }

    // ---- edits of what is selected -----------------------------------------------------------------------------------------------------
    function selectAfter(answer) {
        sayRefusal(answer)
        if (answer.done && answer.object) {
            edits.select(answer.object)
        }
    }
    edits.selectAfter = selectAfter
    edits.remove = function() {
        if (edits.selected) {
            edits.edit({'do': 'delete', object: edits.selected}, function(answer) {
                sayRefusal(answer)
                if (answer.done) {
                    if (!answer.note) {     // a note says what was deleted with it
                        messages.say('info', answer.words + ': Undo restores it')
                    }
                    edits.select(null)
                }
            })
        }
    }
    /** Copies the selection half a metre to the side. */
    edits.duplicate = function() {
        if (edits.object) {
            edits.leaving.tell()
            edits.edit({'do': 'duplicate', object: edits.selected, set: {z: plain(Number(edits.values().z) + 0.5)}}, selectAfter)
        }
    }
    /** Renames the selection. @param refused takes the answer if the name is invalid */
    edits.rename = function(name, refused) {
        edits.edit({'do': 'rename', object: edits.selected, name: name}, answer => (answer.done ? selectAfter : refused)(answer))
    }
    edits.mount = function(robot) {
        if (robot) {
            edits.edit({'do': 'mount', object: edits.selected, to: robot, set: {x: '0', y: '0.1', z: '0'}}, selectAfter)
        } else {
            edits.edit({'do': 'unmount', object: edits.selected, set: {x: '0', y: '0.5', z: '0'}}, selectAfter)
        }
    }

    world.previewed.hear(function() {
        edits.ask()
        msg.send('getEdits')    // another project has other edits, and no message announces them
    })
    edits.handlers = {
        onEdit: onEdit,
        onEdits: onEdits,
        onGrammar: function(grammar) {
            edits.grammar = grammar || edits.grammar
            edits.changed.tell()
        },
        onProjectObject: onProjectObject
    }
    return edits
}
