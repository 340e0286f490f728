// What the SEAR panel has the service do to the project, and which object is selected.
import {plain} from './places.js'
import {makeEvent} from '../shared/event.js'

var PATIENCE_MILLIS = 15000 // an answer that takes longer does not come, as when the connection was lost
var UNANSWERED = 'an edit has no answer: MyRobotLab has ended or is busy, and it may not have been done'

/** Of one panel. */
export function makeEdits(panel, messages, world, view, picture) {
    var msg = panel.msg
    var page = Math.random().toString(36).slice(2)      // tells answers to this page from those to others
    var sent = 0
    var waiting = {}            // by number of an edit of this page that has no answer yet: edit, answered(answer)
    var others = ''             // what another page or a script has done since the selected object was last seen
    var edits = {
        grammar: null,          // types and templates of what can be made; null until it is known
        undoable: null,         // what undo would take back, in words
        redoable: null,
        selected: null,         // what edits call it: box1, rover, rover/ping
        object: null,           // as its file has it; null until it is known
        changed: makeEvent(),   // what is selected is another thing, or has other values
        leaving: makeEvent()    // another edit or another selection follows: what has waited for more is sent before
    }

    /** Has the service do an edit. @param then takes its answer; else this page says what was wrong */
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
        view.choose()           // who builds looks where he wants to
        msg.send('tryEdit', edit)
        panel.timeout(function() {
            if (waiting[edit.page]) {
                onEdit({page: edit.page, done: false, reason: UNANSWERED, problems: []})
            }
        }, PATIENCE_MILLIS)
    }
    /** What this page has set in an object without an answer yet. */
    function unanswered(object) {
        return Object.values(waiting).map(one => one.edit).filter(edit => edit['do'] === 'set' && edit.object === object)
            .reduce((all, edit) => angular.extend(all, edit.set), {})
    }
    /** The values of what is selected, as its file will have them. */
    edits.values = () => angular.extend({}, edits.object.values, unanswered(edits.selected))
    /** An edit that sets, and is refused where somebody else has changed the same. @param seen the values that its user has seen */
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
    /** Why an edit was not done, in one text. */
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
        takeBack('redo', 'done again')
    }

    // ---- what is selected --------------------------------------------------------------------------------------------------------------
    /** @param address what edits call it; null for nothing */
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
    /** Each page gets the answers to all pages. */
    function onProjectObject(object) {
        if (!object || object.object !== edits.selected) {
            return
        }
        if (object.gone) {
            if (others) {
                messages.say('warn', edits.selected + ' is gone or has another name; the last edit of another page or a script: ' + others)
            }
            edits.select(null)
            return
        }
        others = ''
        if (Object.keys(unanswered(object.object)).length) {
            return              // it is asked for again with the answer
        }
        edits.object = object
        edits.changed.tell()
        picture.repaint()
    }
    /** What edits call a part or sensor of a robot, which the world may tell with its robot's name before it. */
    edits.address = function(robot, name) {
        return robot + '/' + name.slice(name.indexOf('/') + 1)
    }

    /** The description of a class; null if there is none. */
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
                    if (!answer.note) {     // else that says what went with it
                        messages.say('info', answer.words + ': Undo brings it back')
                    }
                    edits.select(null)
                }
            })
        }
    }
    /** The copy stands a little beside. */
    edits.duplicate = function() {
        if (edits.object) {
            edits.leaving.tell()
            edits.edit({'do': 'duplicate', object: edits.selected, set: {z: plain(Number(edits.values().z) + 0.5)}}, selectAfter)
        }
    }
    /** @param refused takes the answer if that is no legal name */
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
        msg.send('getEdits')    // another project has other edits, which nobody tells
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
