// SPDX-License-Identifier: Apache-2.0
// Simulation controls of the SEAR panel: start, stop, speed, driving.
import {drive, isFixed} from './steering.js'
import {makeEvent} from '../shared/event.js'
import {find} from '../world/pointing.js'

var SPEED = 0.2             // m/s of the drive buttons, MyRobotLab's Roomba default
// Forward and left; steered robots can't turn in place.
var WAYS = {forward: [1, 0], backward: [-1, 0], left: [0, 1], right: [0, -1], stop: [0, 0]}
var ARCS = {left: [1, 1], right: [1, -1]}
var KEYS = {h: 'left', k: 'right', u: 'forward', j: 'backward', ';': 'stop', enter: 'reset'}

/** Makes the simulation controls of one panel. */
export function makeRun(panel, messages, world, problems, view, edits, picture) {
    var $scope = panel.scope
    var msg = panel.msg
    var known = 1               // current speed of the simulation
    var driving = false         // whether a test drive waits for the simulation to start
    var fixed = []              // robots with a warning in this run that nothing steers them
    var before = null           // last message when this page started the simulation
    var followed = null         // whether the view followed a robot before the test drive; null without one
    var run = {
        pending: null,          // call to the service that is not done yet: starting or stopping
        testing: false,         // whether a test drive is running
        begun: makeEvent(),     // this page starts the simulation
        speed: '1'
    }

    run.start = function() {
        problems.forget()
        before = messages.last
        run.pending = 'starting'
        run.begun.tell()
        msg.send('startSimulation')
    }
    run.stop = function() {
        run.pending = 'stopping'
        msg.send('stopSimulation')
    }
    run.setSpeed = function() {
        msg.send('setSpeed', Number(run.speed))
    }
    run.drive = function(way) {
        if (way === 'reset') {
            msg.send('reset')
        } else {
            run.orders(WAYS[way], SPEED, ARCS[way]).forEach(call => msg.send.apply(msg, call))
        }
    }
    run.key = function(event) {
        var way = KEYS[(event.key || '').toLowerCase()]
        if (way && panel.isSimulating() && !world.instead && !event.ctrlKey && !event.altKey && !event.metaKey) {
            run.drive(way)
            event.preventDefault()
        }
    }
    /** Lets time run by itself, as no script advances it. */
    run.letTimeRun = function() {
        msg.send('setSpeed', 1)
        msg.send('setLockStep', false)
    }
    run.statusText = function() {
        return run.pending || (!panel.isSimulating() ? 'no simulation runs' : $scope.service.paused ? 'paused' :
            world.waiting ? 'time waits for a script' : 'running')
    }
    /** Continues the status text. A separate element, because screen readers announce status changes. */
    run.timeText = function() {
        var state = run.pending ? null : world.running
        return state ? ' at ' + state.time.toFixed(2) + ' s' + (state.speed ? ', ' + state.speed.toFixed(1) + ' × real time' : '') : ''
    }

    // ---- the test drive --------------------------------------------------------------------------------------------------------------------
    /**
     * Returns the calls that drive the chosen robot, else the first. Warns once per run if nothing steers the robot.
     * @param way forward and left, -1 to 1 @param most m/s at 1 @param arc direction for a robot that can't turn in
     * place, if another
     */
    run.orders = function(way, most, arc) {
        var robots = world.running ? world.running.robots : []
        var robot = robots.filter(one => one.name === view.robot)[0] || robots[0]
        if (robot && way[1] !== 0 && isFixed(robot) && fixed.indexOf(robot.name) < 0) {
            fixed.push(robot.name)
            messages.say('warn', robot.name + ' can\'t be steered: all driven wheels are on its centre line, and no wheel is steered. Add driven '
                + 'wheels left and right, or give front or rear wheels a steering angle or a steering servo')
        }
        return robot ? drive(robot, robot.steered && arc || way, most) : []
    }
    /** Returns the robots of a world with driven wheels. */
    run.drivers = function(seen) {
        return seen ? seen.robots.filter(robot => robot.drives) : []
    }
    /** Returns why there is nothing to drive; empty if there is. */
    run.whyNoDrive = function() {
        var seen = world.now()
        return panel.isSimulating() || run.drivers(seen).length ? '' : !seen || !seen.robots.length
            ? 'no robot to drive: choose one in the palette and click on the ground'
            : seen.robots.map(robot => robot.name).join(', ') + ' has no driven wheels: add a Wheel of type 1, or place a complete robot'
    }
    /** Returns why no other project can be opened now; empty if one can. */
    run.whyNoOther = () => panel.isSimulating() ? 'stop the simulation first' : ''
    /** Starts or ends a simulation in which the keys drive the selected robot, else the chosen one. */
    run.testDrive = function() {
        var seen = world.now()
        if (panel.isSimulating()) {
            run.stop()
        } else if (run.whyNoDrive()) {
            messages.say('error', run.whyNoDrive())
        } else {
            var found = find(seen, edits.selected)
            var robot = found && (found.robot || found.object)
            view.driveRobot(robot && robot.parts ? robot.name : view.robot || run.drivers(seen)[0].name)
            driving = true
            run.testing = true
            followed = view.follow
            view.follow = true
            run.start()
        }
    }
    panel.scope.$watch(panel.isSimulating, function(simulating) {
        fixed = []
        if (simulating) {
            messages.succeed(before)
            before = null
        }
        if (simulating && driving) {
            picture.canvas().focus()
            messages.say('info', 'drive ' + view.robot + ': W or arrow up forward, S back, A left, D right, Enter back to the start')
        }
        driving = driving && !simulating && Boolean(run.pending)
        run.testing = run.testing && (simulating || driving)
        if (followed !== null && !run.testing) {
            view.follow = followed
            followed = null
        }
    })

    // ---- messages of the service -----------------------------------------------------------------------------------------------------------
    /** Ends the pending state after the service's answer or failure. */
    run.settle = function() {
        run.pending = null
    }
    /** Takes the service's simulation state; a state from before the call may arrive first. */
    run.follow = function() {
        if (run.pending === (panel.isSimulating() ? 'starting' : 'stopping')) {
            run.settle()
        }
    }
    world.told.hear(function(running) {
        if (running && running.wantedSpeed !== known) {
            known = running.wantedSpeed
            run.speed = String(known)
        }
    })
    run.handlers = {onStartSimulation: run.settle, onStopSimulation: run.settle}
    return run
}
