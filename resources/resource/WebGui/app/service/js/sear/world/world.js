// What the SEAR panel knows of the world: the running one, which the service tells again and again, else the project as it would start.
import {makeEvent} from '../shared/event.js'
import {unpackRanges} from './ranges.js'
import * as words from '../shared/words.js'

var PATH_STEP = 0.02        // metres; as the service has it
var LONGEST_PATH = 500      // points
var PATIENCE_MILLIS = 10000 // an answer that takes longer is asked for again
var WAIT_MILLIS = 1500      // so long time stands still in lock-step before the page says so
// fields of robots and sensors that the view does not draw
var UNSEEN = ['speed', 'turnRate', 'devices', 'value', 'words', 'numbers', 'picture']

/** Of one panel. */
export function makeWorld(panel, messages, picture) {
    var $scope = panel.scope
    var msg = panel.msg
    var world = {
        running: null,          // that of the simulation
        preview: null,          // the project as it would start: stamp, world, problems, reason
        instead: null,          // what is shown in place of these: world, note()
        waiting: false,         // whether time stands still in lock-step
        news: makeEvent(),      // of another world that is to be seen
        told: makeEvent(),      // of the running world as it is now, null for none
        previewed: makeEvent()  // of another preview
    }
    var missing = 0             // when the whole was asked for, 0 if nothing is awaited
    /** The whole world, for a page that opens later: what was warned of until then, too. */
    function onWorld(state) {
        angular.forEach(state && state.warnings, function(text) {
            if (!messages.list.some(function(message) { return message.text === text })) {
                messages.say('warn', text)
            }
        })
        return onSimulation(state)
    }

    /** Takes the whole of a world, or what has changed in the one that is shown. */
    function onSimulation(state) {
        unpackRanges(state && (state.changes ? state.changes.sensors : state.sensors))
        if (!state || !state.running || !panel.isSimulating()) {
            world.running = null
        } else if (!state.changes) {
            missing = 0
            if (!world.running) {
                world.news.tell(state)
            }
            world.running = state
        } else if (world.running && state.number <= world.running.number) {
            return false        // it came after the whole that has it already
        } else if (world.running && state.number === world.running.number + 1) {
            change(world.running, state)
        } else {
            askForWorld()
        }
        watchTime(world.running)
        world.told.tell(world.running)
        if (world.running && state.changes && !isSeen(state.changes)) {
            world.running.restedUntil = world.running.time
            picture.retell()
        } else {
            picture.repaint()
        }
        return false            // it may come faster than the screen is drawn
    }
    /** Whether changes are of what the view draws, not of words and numbers only. */
    function isSeen(changes) {
        return Object.keys(changes).some(list => Object.values(changes[list]).some(one => Object.keys(one).some(field => UNSEEN.indexOf(field) < 0)))
    }

    var moved = 0               // when simulated time was seen to pass, by this page's clock
    var seenTime = null
    /** In lock-step time stands still unless a script lets it pass. */
    function watchTime(state) {
        var waited = world.waiting
        if (!state || state.time !== seenTime) {
            seenTime = state && state.time
            moved = Date.now()
        }
        world.waiting = Boolean(state && state.lockStep && !state.paused && Date.now() - moved > WAIT_MILLIS)
        if (world.waiting !== waited) {
            $scope.$applyAsync()
        }
    }
    function askForWorld() {
        if (Date.now() - missing > PATIENCE_MILLIS) {
            missing = Date.now()
            msg.send('getWorld')
        }
    }

    function change(state, message) {
        angular.forEach(message.changes, function(changed, list) {
            angular.forEach(changed, function(values, index) {
                angular.extend(state[list][index], values)
                if (list === 'robots' && values.pose) {
                    extendPath(state.robots[index])
                }
            })
        })
        angular.extend(state, message)
        delete state.changes
    }

    /** As the service does it for pages that open later. */
    function extendPath(robot) {
        var path = robot.path
        var last = path[path.length - 1]
        if (Math.sqrt(Math.pow(last[0] - robot.pose[0], 2) + Math.pow(last[1] - robot.pose[2], 2)) > PATH_STEP) {
            path.push([robot.pose[0], robot.pose[2]])
        }
        if (path.length > LONGEST_PATH) {
            robot.path = path.filter((one, i) => i === 0 || i === path.length - 1 || (path.length - 2 - i) % 2)
        }
    }

    // ---- the project as it would start, while nothing runs --------------------------------------------------------------------------------
    var lookedAt = 0            // when it was asked for, 0 if nothing is awaited
    world.look = function() {
        var now = Date.now()
        if (picture.width() && !document.hidden && !panel.isSimulating() && now - lookedAt > PATIENCE_MILLIS) {
            lookedAt = now
            msg.send('getPreview', world.preview ? world.preview.stamp : '')
        }
    }
    function onPreview(preview) {
        lookedAt = 0
        unpackRanges(preview && preview.world && preview.world.sensors)
        // each page gets the answers to all pages: only what has a world or says why not is one, else the page that asked has the newest
        if (preview && preview.problems && !panel.isSimulating() && !angular.equals(preview, world.preview)) {
            world.preview = preview
            world.previewed.tell(preview)
            if (preview.world) {
                world.news.tell(preview.world)
            }
            picture.repaint()
        }
    }

    /** The service has said whether it simulates. */
    world.follow = function() {
        if (!panel.isSimulating()) {
            world.running = null
            world.look()
        }
        picture.repaint()
    }
    /** @param other what is to be shown in place of what is now; null for nothing */
    world.showInstead = function(other) {
        world.instead = other
        picture.repaint()
    }
    /** The running world, else the project as it would start; null if it has none. */
    world.now = function() {
        return world.running || world.preview && world.preview.world
    }
    world.shown = function() {
        return world.instead ? world.instead.world : world.now()
    }
    /** Whether it is known that there is nothing to start. */
    world.isEmpty = function() {
        var seen = !panel.isSimulating() && world.preview && world.preview.world
        return Boolean(seen && !seen.objects.length && !seen.robots.length)
    }
    world.note = function() {
        var preview = world.preview
        if (world.instead) {
            return world.instead.note()
        }
        if (panel.isSimulating() || !preview) {
            return ''
        }
        if (preview.reason) {
            return 'Not running, and nothing to show: ' + preview.reason
        }
        if (!preview.world) {
            return 'Not running, and nothing to show: the project has ' + words.count(preview.problems.length, 'problem') + ', listed below'
        }
        if (!preview.world.objects.length && !preview.world.robots.length) {
            return 'Not running, and the project is empty: ' + ($scope.view.building
                ? 'choose something in the palette, then click where it is to stand'
                : 'open one or an example, drop a .sear file here, press Build, or create objects in a script')
        }
        return 'Not running: this is how the project starts, with the button Start or ' + $scope.service.name + '.startSimulation()'
    }

    world.handlers = {onSimulation: onSimulation, onWorld: onWorld, onPreview: onPreview}
    return world
}
