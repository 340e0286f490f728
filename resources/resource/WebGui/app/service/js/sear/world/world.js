// SPDX-License-Identifier: Apache-2.0
// The world in the SEAR panel: the running one, updated by the service, else the project as it would start.
import {Listeners} from '../shared/listeners.js'
import {unpackRanges} from './ranges.js'
import * as words from '../shared/words.js'

const PATH_STEP = 0.02        // metres; as in the service
const LONGEST_PATH = 500      // points
const PATIENCE_MILLIS = 10000 // timeout: requests it again
const WAIT_MILLIS = 1500      // standstill in lock-step after which the page reports it
// Fields of robots and sensors that the view does not draw.
const UNSEEN = ['speed', 'turnRate', 'devices', 'value', 'words', 'numbers', 'picture']

/** The world of one panel. */
export class World {
    constructor(panel, messages, picture) {
        this.panel = panel
        this.messages = messages
        this.picture = picture
        this.$scope = panel.scope
        this.msg = panel.msg
        this.running = null     // the simulation's world
        this.preview = null     // the project as it would start: stamp, world, problems, reason
        this.instead = null     // shown instead of both: world, note()
        this.waiting = false    // whether time stands still in lock-step
        this.news = new Listeners() // another world is to be shown
        this.told = new Listeners() // new state of the running world, null for none
        this.previewed = new Listeners() // another preview has arrived
        this.missing = 0        // time of the request for the whole world, 0 if none is pending

        this.moved = 0          // when simulated time last advanced, by this page's clock
        this.seenTime = null

        this.lookedAt = 0       // time of the request, 0 if none is pending

        this.handlers = {
            onSimulation: state => this.onSimulation(state),
            onWorld: state => this.onWorld(state),
            onPreview: preview => this.onPreview(preview)
        }
    }

    /** Takes the whole world, with earlier warnings for a page that opens later. */
    onWorld(state) {
        angular.forEach(state && state.warnings, text => {
            if (!this.messages.list.some(message => message.text === text)) {
                this.messages.say('warn', text)
            }
        })
        return this.onSimulation(state)
    }

    /** Takes a whole world, or changes of the shown one. */
    onSimulation(state) {
        unpackRanges(state && (state.changes ? state.changes.sensors : state.sensors))
        if (!state || !state.running || !this.panel.isSimulating()) {
            this.running = null
        } else if (!state.changes) {
            this.missing = 0
            if (!this.running) {
                this.news.tell(state)
            }
            this.running = state
        } else if (this.running && state.number <= this.running.number) {
            return false        // older than the whole world received before
        } else if (this.running && state.number === this.running.number + 1) {
            this.change(this.running, state)
        } else {
            this.askForWorld()
        }
        this.watchTime(this.running)
        this.told.tell(this.running)
        if (this.running && state.changes && !this.isSeen(state.changes)) {
            this.running.restedUntil = this.running.time
            this.picture.retell()
        } else {
            this.picture.repaint()
        }
        return false            // may arrive faster than the screen refreshes
    }

    /** Whether the view draws any of the changes, not only texts and numbers. */
    isSeen(changes) {
        return Object.keys(changes).some(list => Object.values(changes[list])
            .some(one => Object.keys(one).some(field => UNSEEN.indexOf(field) < 0)))
    }

    /** Detects a standstill: in lock-step, only a script advances time. */
    watchTime(state) {
        const waited = this.waiting
        if (!state || state.time !== this.seenTime) {
            this.seenTime = state && state.time
            this.moved = Date.now()
        }
        this.waiting = Boolean(state && state.lockStep && !state.paused && Date.now() - this.moved > WAIT_MILLIS)
        if (this.waiting !== waited) {
            this.$scope.$applyAsync()
        }
    }

    askForWorld() {
        if (Date.now() - this.missing > PATIENCE_MILLIS) {
            this.missing = Date.now()
            this.msg.send('getWorld')
        }
    }

    change(state, message) {
        angular.forEach(message.changes, (changed, list) => {
            angular.forEach(changed, (values, index) => {
                Object.assign(state[list][index], values)
                if (list === 'robots' && values.pose) {
                    this.extendPath(state.robots[index])
                }
            })
        })
        Object.assign(state, message)
        delete state.changes
    }

    /** Extends a path like the service does for pages that open later. */
    extendPath(robot) {
        const path = robot.path
        const last = path[path.length - 1]
        if (Math.sqrt(Math.pow(last[0] - robot.pose[0], 2) + Math.pow(last[1] - robot.pose[2], 2)) > PATH_STEP) {
            path.push([robot.pose[0], robot.pose[2]])
        }
        if (path.length > LONGEST_PATH) {
            robot.path = path.filter((one, i) => i === 0 || i === path.length - 1 || (path.length - 2 - i) % 2)
        }
    }

    look() {
        const now = Date.now()
        if (this.picture.width() && !document.hidden && !this.panel.isSimulating()
            && now - this.lookedAt > PATIENCE_MILLIS) {
            this.lookedAt = now
            this.msg.send('getPreview', this.preview ? this.preview.stamp : '')
        }
    }

    onPreview(preview) {
        this.lookedAt = 0
        unpackRanges(preview && preview.world && preview.world.sensors)
        // Each page receives the answers to all pages: ignore answers without world and problems, as the page that
        // asked has the newest preview.
        if (preview && preview.problems && !this.panel.isSimulating() && !angular.equals(preview, this.preview)) {
            this.preview = preview
            this.previewed.tell(preview)
            if (preview.world) {
                this.news.tell(preview.world)
            }
            this.picture.repaint()
        }
    }

    /** Takes the service's simulation state. */
    follow() {
        if (!this.panel.isSimulating()) {
            this.running = null
            this.look()
        }
        this.picture.repaint()
    }

    /** Shows another world instead of the present one. @param other null for none */
    showInstead(other) {
        this.instead = other
        this.picture.repaint()
    }

    /** Returns the running world, else the project as it would start; null if it has none. */
    now() {
        return this.running || this.preview && this.preview.world
    }

    shown() {
        return this.instead ? this.instead.world : this.now()
    }

    /** Whether the project is known to be empty. */
    isEmpty() {
        const seen = !this.panel.isSimulating() && this.preview && this.preview.world
        return Boolean(seen && !seen.objects.length && !seen.robots.length)
    }

    note() {
        const preview = this.preview
        if (this.instead) {
            return this.instead.note()
        }
        if (this.panel.isSimulating() || !preview) {
            return ''
        }
        if (preview.reason) {
            return 'Not running, and nothing to show: ' + preview.reason
        }
        if (!preview.world) {
            return 'Not running, and nothing to show: the project has '
                + words.count(preview.problems.length, 'problem') + ', listed below'
        }
        if (!preview.world.objects.length && !preview.world.robots.length) {
            return 'Not running, and the project is empty: ' + (this.$scope.view.building
                ? this.$scope.palette.armed ? 'click where to place the object'
                    : 'choose an object in the palette, then click where to place it'
                : 'open a project or an example, drop a .sear file here, press Build, or create objects in a script')
        }
        return 'Not running: the view shows the project before its start, by the button Start or '
            + this.$scope.service.name + '.startSimulation()'
    }
}
