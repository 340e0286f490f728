// SPDX-License-Identifier: Apache-2.0
// Edits of the project, done by the service, and the selected object.
import {plain} from './places.js'
import {Listeners} from '../shared/listeners.js'

const PATIENCE_MILLIS = 15000 // timeout: a later answer is lost, for example with the connection
const UNANSWERED = 'no answer to an edit: MyRobotLab has ended or is busy, and the edit may not be done'

/** The edits of one panel. */
export class Edits {
    constructor(panel, messages, world, view, picture) {
        this.panel = panel
        this.messages = messages
        this.world = world
        this.view = view
        this.picture = picture
        this.msg = panel.msg
        // distinguishes answers to this page from answers to other pages
        this.page = Math.random().toString(36).slice(2)
        this.sent = 0
        this.waiting = {}       // edits of this page without an answer, by number: edit, answered(answer)
        this.others = ''        // latest edit of another page or a script since the selected object was last seen
        this.grammar = null     // types and templates that can be made; null until known
        this.undoable = null    // text of the edit that undo reverts
        this.redoable = null
        this.selected = null    // address of the selected object in edits: box1, rover, rover/ping
        this.object = null      // values in its file; null until known
        this.changed = new Listeners() // another object is selected, or its values changed
        this.leaving = new Listeners() // before another edit or selection: sends pending key presses

        world.previewed.hear(() => {
            this.ask()
            this.msg.send('getEdits')    // another project has other edits, and no message announces them
        })
        this.handlers = {
            onEdit: answer => this.onEdit(answer),
            onEdits: state => this.onEdits(state),
            onGrammar: grammar => {
                this.grammar = grammar || this.grammar
                this.changed.tell()
            },
            onProjectObject: object => this.onProjectObject(object)
        }
    }

    /** Sends an edit to the service. @param then takes the answer; without it, the page shows why an edit failed */
    edit(edit, then) {
        this.leaving.tell()
        edit.page = this.page + ' ' + ++this.sent
        const before = this.messages.last
        const answered = then || (answer => this.sayRefusal(answer))
        this.waiting[edit.page] = {edit, answered: answer => {
            if (answer.done) {
                this.messages.succeed(before)
            }
            answered(answer)
        }}
        this.view.choose()           // a user who builds keeps the view where it is
        this.msg.send('tryEdit', edit)
        this.panel.timeout(() => {
            if (this.waiting[edit.page]) {
                this.onEdit({page: edit.page, done: false, reason: UNANSWERED, problems: []})
            }
        }, PATIENCE_MILLIS)
    }

    /** Returns what this page has set in an object, without an answer yet. */
    unanswered(object) {
        return Object.values(this.waiting).map(one => one.edit)
            .filter(edit => edit['do'] === 'set' && edit.object === object)
            .reduce((all, edit) => Object.assign(all, edit.set), {})
    }

    /** Returns the selection's values as its file will contain them. */
    values() {
        return Object.assign({}, this.object.values, this.unanswered(this.selected))
    }

    /**
     * Returns an edit that sets values; the service rejects it if another client has changed them. @param seen values
     * that the user saw
     */
    setting(object, set, seen) {
        const was = {}
        Object.keys(set).forEach(name => {
            was[name] = seen[name] === undefined ? '' : seen[name]
        })
        return {'do': 'set', object, set, was}
    }

    sayRefusal(answer) {
        if (!answer.done) {
            this.messages.say('error', this.refusal(answer))
        }
    }

    /** Returns why an edit failed, as one text. */
    refusal(answer) {
        return answer.reason || answer.problems.map(problem => problem.file + ': '
            + (problem.field ? problem.field + ' is "' + problem.value + '"' : problem.value) + ', legal: '
                + problem.legal).join('\n')
    }

    onEdit(answer) {
        if (!answer) {
            return
        }
        const mine = this.waiting[answer.page]
        delete this.waiting[answer.page]
        if (answer.done) {
            this.onEdits(answer)
            this.world.look()
            if (answer.note && mine) {
                this.messages.say('warn', answer.note)
            }
            this.others = mine ? '' : (answer.words === answer.redo ? 'undo ' : '') + answer.words
        }
        if (answer.done || mine) {
            this.ask()
        }
        if (mine) {
            if (answer.done && mine.edit['do'] === 'set' && this.object && this.object.object === mine.edit.object) {
                Object.assign(this.object.values, mine.edit.set)
            }
            mine.answered(answer)
        }
    }

    onEdits(state) {
        if (state) {
            this.undoable = state.undo
            this.redoable = state.redo
        }
    }

    takeBack(kind, said) {
        this.edit({'do': kind}, answer => {
            this.messages.say(answer.done ? 'info' : 'error', answer.done ? said + ': '
                + answer.words : this.refusal(answer))
            if (!answer.done) {
                this.msg.send('getEdits')
            }
        })
    }

    undo() {
        this.takeBack('undo', 'undone')
    }

    redo() {
        this.takeBack('redo', 'redone')
    }

    // ---- what is selected
    // --------------------------------------------------------------------------------------------------------------
    /** Selects an object. @param address see selected; null for none */
    select(address) {
        if (this.selected !== address) {
            this.leaving.tell()
            this.others = ''
            this.selected = address
            this.object = null
            this.changed.tell()
        }
        this.ask()
        this.picture.repaint()
    }

    ask() {
        if (this.selected) {
            this.msg.send('getProjectObject', this.selected)
        }
    }

    /** Takes the data of an object. Each page receives the answers to all pages. */
    onProjectObject(object) {
        if (!object || object.object !== this.selected) {
            return
        }
        if (object.gone) {
            if (this.others) {
                this.messages.say('warn', this.selected + ' was deleted or renamed by another page or a script. '
                    + 'Its last edit: ' + this.others)
            }
            this.select(null)
            return
        }
        this.others = ''
        if (Object.keys(this.unanswered(object.object)).length) {
            return              // the answer to the edit asks for it again
        }
        this.object = object
        this.changed.tell()
        this.picture.repaint()
    }

    /** Returns the address of a robot's part or sensor; the world message may prefix the robot's name. */
    address(robot, name) {
        return robot + '/' + name.slice(name.indexOf('/') + 1)
    }

    /** Returns the description of a class; null if there is none. */
    typeOf(name) {
        return this.grammar && this.grammar.types.filter(type => type.type === name)[0] || null
    }

    // ---- edits of what is selected
    // -----------------------------------------------------------------------------------------------------
    selectAfter(answer) {
        this.sayRefusal(answer)
        if (answer.done && answer.object) {
            this.select(answer.object)
        }
    }

    remove() {
        if (this.selected) {
            this.edit({'do': 'delete', object: this.selected}, answer => {
                this.sayRefusal(answer)
                if (answer.done) {
                    if (!answer.note) {     // a note says what was deleted with it
                        this.messages.say('info', answer.words + ': Undo restores it')
                    }
                    this.select(null)
                }
            })
        }
    }

    /** Copies the selection half a metre to the side. */
    duplicate() {
        if (this.object) {
            this.leaving.tell()
            const set = {z: plain(Number(this.values().z) + 0.5)}
            this.edit({'do': 'duplicate', object: this.selected, set}, answer => this.selectAfter(answer))
        }
    }

    /** Renames the selection. @param refused takes the answer if the name is invalid */
    rename(name, refused) {
        this.edit({'do': 'rename', object: this.selected, name}, answer => answer.done
            ? this.selectAfter(answer) : refused(answer))
    }

    mount(robot) {
        if (robot) {
            this.edit({'do': 'mount', object: this.selected, to: robot, set: {x: '0', y: '0.1', z: '0'}},
                answer => this.selectAfter(answer))
        } else {
            this.edit({'do': 'unmount', object: this.selected, set: {x: '0', y: '0.5', z: '0'}},
                answer => this.selectAfter(answer))
        }
    }
}
