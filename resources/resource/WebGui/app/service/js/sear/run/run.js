// The run of the simulation in the SEAR panel: start, stop, speed, driving.
import {drive, isFixed} from './steering.js'
import {makeEvent} from '../shared/event.js'
import {find} from '../world/pointing.js'

var SPEED = 0.2             // m/s of the drive buttons, MyRobotLab's Roomba default
// How far forward and to the left; what is steered can't turn in place.
var WAYS = {forward: [1, 0], backward: [-1, 0], left: [0, 1], right: [0, -1], stop: [0, 0]}
var ARCS = {left: [1, 1], right: [1, -1]}
var KEYS = {h: 'left', k: 'right', u: 'forward', j: 'backward', ';': 'stop', enter: 'reset'}

/** Of one panel. */
export function makeRun(panel, messages, world, problems, view, edits, picture) {
    var $scope = panel.scope
    var msg = panel.msg
    var known = 1               // the speed that the simulation has
    var driving = false         // whether a test drive is to begin as soon as the simulation runs
    var fixed = []              // names of the robots of which this run has said that nothing steers them
    var before = null           // the last message when this page told it to start
    var followed = null         // whether the view has followed before the test drive; null without one
    var run = {
        pending: null,          // what the service has been told to do and has not done yet: starting or stopping
        testing: false,         // whether a test drive goes on
        begun: makeEvent(),     // this page has it start
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
    /** Nobody waits for the script any more: time runs by itself. */
    run.letTimeRun = function() {
        msg.send('setSpeed', 1)
        msg.send('setLockStep', false)
    }
    run.statusText = function() {
        return run.pending || (!panel.isSimulating() ? 'no simulation runs' : $scope.service.paused ? 'paused' :
            world.waiting ? 'time waits for a script' : 'running')
    }
    /** Goes on where the status ends; apart from it, since that is read out when it changes. */
    run.timeText = function() {
        var state = run.pending ? null : world.running
        return state ? ' at ' + state.time.toFixed(2) + ' s' + (state.speed ? ', ' + state.speed.toFixed(1) + ' × real time' : '') : ''
    }

    // ---- the test drive --------------------------------------------------------------------------------------------------------------------
    /**
     * Calls that drive the chosen robot, else the first; says so once in a run if nothing steers that.
     * @param way how far forward and to the left, -1 to 1; @param most m/s at 1; @param arc the way of what can't turn in place, if it is another
     */
    run.orders = function(way, most, arc) {
        var robots = world.running ? world.running.robots : []
        var robot = robots.filter(one => one.name === view.robot)[0] || robots[0]
        if (robot && way[1] !== 0 && isFixed(robot) && fixed.indexOf(robot.name) < 0) {
            fixed.push(robot.name)
            messages.say('warn', robot.name + ' can\'t be steered: its driven wheels all stand in its middle, and no wheel is steered. Put driven '
                + 'wheels to its left and right, or give wheels before or behind them a steering angle, or a servo that steers them')
        }
        return robot ? drive(robot, robot.steered && arc || way, most) : []
    }
    /** Robots of a world that have something to drive. */
    run.drivers = function(seen) {
        return seen ? seen.robots.filter(robot => robot.drives) : []
    }
    /** Why there is nothing to drive; empty if there is. */
    run.whyNoDrive = function() {
        var seen = world.now()
        return panel.isSimulating() || run.drivers(seen).length ? '' : !seen || !seen.robots.length
            ? 'there is no robot to drive: choose one in the palette and click on the ground'
            : seen.robots.map(robot => robot.name).join(', ') + ' has no driven wheels: put a Wheel of type 1 on it, or a whole robot on the ground'
    }
    /** Why no other project can be opened now; empty if one can. */
    run.whyNoOther = () => panel.isSimulating() ? 'not while the simulation runs: Stop it first' : ''
    /** Starts, or ends, a simulation in which the keys drive the robot that is selected, else the one that is driven anyway. */
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

    // ---- what the service tells ------------------------------------------------------------------------------------------------------------
    /** The service has done what it was told, or has failed, whatever has happened since. */
    run.settle = function() {
        run.pending = null
    }
    /** The service has said whether it simulates; another state may have been on its way before. */
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
