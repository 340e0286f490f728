// SPDX-License-Identifier: Apache-2.0
// The world in the SEAR panel: the running one, updated by the service, else the project as it would start.
import {makeEvent} from '../shared/event.js'
import {unpackRanges} from './ranges.js'
import * as words from '../shared/words.js'

var PATH_STEP = 0.02        // metres; as in the service
var LONGEST_PATH = 500      // points
var PATIENCE_MILLIS = 10000 // timeout: requests it again
var WAIT_MILLIS = 1500      // standstill in lock-step after which the page reports it
// Fields of robots and sensors that the view does not draw.
var UNSEEN = ['speed', 'turnRate', 'devices', 'value', 'words', 'numbers', 'picture']

/** Makes the world of one panel. */
export function makeWorld(panel, messages, picture) {
    var $scope = panel.scope
    var msg = panel.msg
    var world = {
        running: null,          // the simulation's world
        preview: null,          // the project as it would start: stamp, world, problems, reason
        instead: null,          // shown instead of both: world, note()
        waiting: false,         // whether time stands still in lock-step
        news: makeEvent(),      // another world is to be shown
        told: makeEvent(),      // new state of the running world, null for none
        previewed: makeEvent()  // another preview has arrived
    }
    var missing = 0             // time of the request for the whole world, 0 if none is pending
    /** Takes the whole world, with earlier warnings for a page that opens later. */
    function onWorld(state) {
        angular.forEach(state && state.warnings, function(text) {
            if (!messages.list.some(function(message) { return message.text === text })) {
                messages.say('warn', text)
            }
        })
        return onSimulation(state)
    }

    /** Takes a whole world, or changes of the shown one. */
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
            return false        // older than the whole world received before
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
        return false            // may arrive faster than the screen refreshes
    }
    /** Whether the view draws any of the changes, not only texts and numbers. */
    function isSeen(changes) {
        return Object.keys(changes).some(list => Object.values(changes[list]).some(one => Object.keys(one).some(field => UNSEEN.indexOf(field) < 0)))
    }

    var moved = 0               // when simulated time last advanced, by this page's clock
    var seenTime = null
    /** Detects a standstill: in lock-step, only a script advances time. */
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

    /** Extends a path like the service does for pages that open later. */
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
    var lookedAt = 0            // time of the request, 0 if none is pending
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
        // Each page receives the answers to all pages: ignore answers without world and problems, as the page that
        // asked has the newest preview.
        if (preview && preview.problems && !panel.isSimulating() && !angular.equals(preview, world.preview)) {
            world.preview = preview
            world.previewed.tell(preview)
            if (preview.world) {
                world.news.tell(preview.world)
            }
            picture.repaint()
        }
    }

    /** Takes the service's simulation state. */
    world.follow = function() {
        if (!panel.isSimulating()) {
            world.running = null
            world.look()
        }
        picture.repaint()
    }
    /** Shows another world instead of the present one. @param other null for none */
    world.showInstead = function(other) {
        world.instead = other
        picture.repaint()
    }
    /** Returns the running world, else the project as it would start; null if it has none. */
    world.now = function() {
        return world.running || world.preview && world.preview.world
    }
    world.shown = function() {
        return world.instead ? world.instead.world : world.now()
    }
    /** Whether the project is known to be empty. */
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
                ? 'choose an object in the palette, then click where to place it'
                : 'open a project or an example, drop a .sear file here, press Build, or create objects in a script')
        }
        return 'Not running: the view shows the project before its start, by the button Start or ' + $scope.service.name + '.startSimulation()'
    }

    world.handlers = {onSimulation: onSimulation, onWorld: onWorld, onPreview: onPreview}
    return world
}
