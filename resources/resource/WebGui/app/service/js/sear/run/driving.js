// SPDX-License-Identifier: Apache-2.0
// Driving in the SEAR panel with held keys (WASD, arrows) or a gamepad. The robot stops on release.
var SPEED = 0.2             // m/s with keys, as with the buttons
var FASTEST = 0.4           // m/s with a gamepad stick at its end
var DEAD = 0.15             // dead zone of a stick
var LOOK_MILLIS = 50        // polling interval of gamepads
var KEYS = {w: [1, 0], s: [-1, 0], a: [0, 1], d: [0, -1], arrowup: [1, 0], arrowdown: [-1, 0], arrowleft: [0, 1], arrowright: [0, -1]}
var PAD = {12: [1, 0], 13: [-1, 0], 14: [0, 1], 15: [0, -1]}    // buttons of the D-pad

function sum(ways) {
    return ways.reduce((a, b) => [a[0] + b[0], a[1] + b[1]], [0, 0]).map(value => Math.max(-1, Math.min(1, value)))
}
/** Returns the direction that a gamepad commands: [forward, left], -1 to 1. */
function wayOf(pad) {
    var stick = [pad.axes[1], pad.axes[0]].map(value => Math.abs(value) > DEAD ? -Math.round(20 * value) / 20 : 0)
    return sum([stick].concat(Object.keys(PAD).filter(i => pad.buttons[i] && pad.buttons[i].pressed).map(i => PAD[i])))
}

/** Makes the keyboard and gamepad control of one panel. */
export function makeDriving(panel, world, view, edits, run, picture) {
    var held = {}               // keys held down, by name
    var padded = false          // whether a gamepad has commanded a movement not stopped yet
    var looking = null
    var last = []               // the latest calls
    var driving = {}

    /** Sends changed drive calls. @param way forward and left, -1 to 1 @param most m/s at 1 */
    function go(way, most) {
        var calls = run.orders(way, most)
        calls.filter((call, i) => String(call) !== String(last[i])).forEach(call => panel.msg.send.apply(panel.msg, call))
        last = calls
    }
    function canDrive() {
        return panel.isSimulating() && !world.instead && run.drivers(world.running).length > 0
    }
    function goOn() {
        go(sum(Object.keys(held).map(key => KEYS[key])), SPEED)
    }
    function letGo() {
        if (Object.keys(held).length || padded) {
            held = {}
            padded = false
            go([0, 0], 0)
        }
    }

    // ---- keys --------------------------------------------------------------------------------------------------------------------------
    /** While building, arrow keys move the selection, except in a test drive. */
    function isBuilding(key) {
        return key.length > 1 && view.building && edits.selected && !run.testing
    }
    /** Handles a key. @return whether it was a drive key */
    driving.key = function(event) {
        var key = (event.key || '').toLowerCase()
        if (!KEYS[key] || !canDrive() || isBuilding(key) || event.ctrlKey || event.altKey || event.metaKey || event.shiftKey) {
            return false
        }
        event.preventDefault()
        if (!held[key]) {
            if (!Object.keys(held).length) {
                last = []       // another client may have driven the robot meanwhile
            }
            held[key] = true
            goOn()
        }
        return true
    }
    function up(event) {
        var key = (event.key || '').toLowerCase()
        if (held[key]) {
            delete held[key]
            goOn()
        }
    }

    // ---- gamepads ----------------------------------------------------------------------------------------------------------------------
    function look() {
        if (!canDrive() || !picture.width() || document.hidden || !navigator.getGamepads) {
            return
        }
        var way = sum([].filter.call(navigator.getGamepads(), Boolean).map(wayOf))
        var moved = way[0] !== 0 || way[1] !== 0
        if (moved || padded) {
            if (!padded) {
                last = []
            }
            padded = moved
            go(way, FASTEST)
        }
    }

    /** Adds the listeners once the views exist. */
    driving.listen = function() {
        var leaving = ['blur', 'beforeunload']
        window.addEventListener('keyup', up, true)
        leaving.forEach(name => window.addEventListener(name, letGo))
        looking = window.setInterval(look, LOOK_MILLIS)
        panel.scope.$on('$destroy', function() {
            window.removeEventListener('keyup', up, true)
            leaving.forEach(name => window.removeEventListener(name, letGo))
            window.clearInterval(looking)
        })
    }
    panel.scope.$watch(panel.isSimulating, function() {
        held = {}
        padded = false
    })
    panel.scope.$watch(() => Boolean(world.instead), instead => instead && letGo())     // stops driving during a replay
    return driving
}
