// SPDX-License-Identifier: Apache-2.0
// Driving in the SEAR panel with held keys (WASD, arrows) or a gamepad. The robot stops on release.
const SPEED = 0.2             // m/s with keys, as with the buttons
const FASTEST = 0.4           // m/s with a gamepad stick at its end
const DEAD = 0.15             // dead zone of a stick
const LOOK_MILLIS = 50        // polling interval of gamepads
const KEYS = {w: [1, 0], s: [-1, 0], a: [0, 1], d: [0, -1], arrowup: [1, 0], arrowdown: [-1, 0], arrowleft: [0, 1],
    arrowright: [0, -1]}
const PAD = {12: [1, 0], 13: [-1, 0], 14: [0, 1], 15: [0, -1]}    // buttons of the D-pad

function sum(ways) {
    return ways.reduce((a, b) => [a[0] + b[0], a[1] + b[1]], [0, 0]).map(value => Math.max(-1, Math.min(1, value)))
}
/** Returns the direction that a gamepad commands: [forward, left], -1 to 1. */
function wayOf(pad) {
    const stick = [pad.axes[1], pad.axes[0]].map(value => Math.abs(value) > DEAD ? -Math.round(20 * value) / 20 : 0)
    return sum([stick].concat(Object.keys(PAD).filter(i => pad.buttons[i] && pad.buttons[i].pressed).map(i => PAD[i])))
}

/** The keyboard and gamepad control of one panel. */
export class Driving {
    constructor(panel, world, view, edits, run, picture) {
        this.panel = panel
        this.world = world
        this.view = view
        this.edits = edits
        this.run = run
        this.picture = picture
        this.held = {}          // keys held down, by name
        this.padded = false     // whether a gamepad has commanded a movement not stopped yet
        this.last = []          // the latest calls
        panel.scope.$watch(() => panel.isSimulating(), () => {
            this.held = {}
            this.padded = false
        })
        // stops driving during a replay
        panel.scope.$watch(() => Boolean(world.instead), instead => instead && this.letGo())
    }

    /** Sends changed drive calls. @param way forward and left, -1 to 1 @param most m/s at 1 */
    go(way, most) {
        const calls = this.run.orders(way, most)
        calls.filter((call, i) => String(call) !== String(this.last[i]))
        .forEach(call => this.panel.msg.send.apply(this.panel.msg, call))
        this.last = calls
    }

    canDrive() {
        return this.panel.isSimulating() && !this.world.instead && this.run.drivers(this.world.running).length > 0
    }

    goOn() {
        this.go(sum(Object.keys(this.held).map(key => KEYS[key])), SPEED)
    }

    letGo() {
        if (Object.keys(this.held).length || this.padded) {
            this.held = {}
            this.padded = false
            this.go([0, 0], 0)
        }
    }

    // ---- keys
    // -----------------------------------------------------------------------------------------------------------------
    /** While building, arrow keys move the selection, except in a test drive. */
    isBuilding(key) {
        return key.length > 1 && this.view.building && this.edits.selected && !this.run.testing
    }

    /** Handles a key. @return whether it was a drive key */
    key(event) {
        const key = (event.key || '').toLowerCase()
        if (!KEYS[key] || !this.canDrive() || this.isBuilding(key) || event.ctrlKey || event.altKey || event.metaKey
            || event.shiftKey) {
            return false
        }
        event.preventDefault()
        if (!this.held[key]) {
            if (!Object.keys(this.held).length) {
                this.last = []       // another client may have driven the robot meanwhile
            }
            this.held[key] = true
            this.goOn()
        }
        return true
    }

    up(event) {
        const key = (event.key || '').toLowerCase()
        if (this.held[key]) {
            delete this.held[key]
            this.goOn()
        }
    }

    // ---- gamepads
    // -----------------------------------------------------------------------------------------------------------------
    look() {
        if (!this.canDrive() || !this.picture.width() || document.hidden || !navigator.getGamepads) {
            return
        }
        const way = sum([].filter.call(navigator.getGamepads(), Boolean).map(wayOf))
        const moved = way[0] !== 0 || way[1] !== 0
        if (moved || this.padded) {
            if (!this.padded) {
                this.last = []
            }
            this.padded = moved
            this.go(way, FASTEST)
        }
    }

    /** Adds the listeners once the views exist. */
    listen() {
        this.panel.listen(window, {keyup: event => this.up(event)}, true)
        this.panel.listen(window, {blur: () => this.letGo(), beforeunload: () => this.letGo()})
        const looking = window.setInterval(() => this.look(), LOOK_MILLIS)
        this.panel.scope.$on('$destroy', () => window.clearInterval(looking))
    }
}
