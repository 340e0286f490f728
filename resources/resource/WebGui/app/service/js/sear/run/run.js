// SPDX-License-Identifier: Apache-2.0
// Simulation controls of the SEAR panel: start, stop, speed, driving.
import {drive, isFixed} from './steering.js'
import {Listeners} from '../shared/listeners.js'
import {find} from '../world/pointing.js'

const SPEED = 0.2             // m/s of the drive buttons, MyRobotLab's Roomba default
// Forward and left; steered robots can't turn in place.
const WAYS = {forward: [1, 0], backward: [-1, 0], left: [0, 1], right: [0, -1], stop: [0, 0]}
const ARCS = {left: [1, 1], right: [1, -1]}
const KEYS = {h: 'left', k: 'right', u: 'forward', j: 'backward', ';': 'stop', enter: 'reset'}

/** The simulation controls of one panel. */
export class Run {
    constructor(panel, messages, world, problems, view, edits, picture) {
        this.panel = panel
        this.messages = messages
        this.world = world
        this.problems = problems
        this.view = view
        this.edits = edits
        this.$scope = panel.scope
        this.msg = panel.msg
        let known = 1           // current speed of the simulation
        this.driving = false    // whether a test drive waits for the simulation to start
        this.fixed = []         // robots with a warning in this run that nothing steers them
        this.before = null      // last message when this page started the simulation
        this.followed = null    // whether the view followed a robot before the test drive; null without one
        this.pending = null     // call to the service that is not done yet: starting or stopping
        this.testing = false    // whether a test drive is running
        this.begun = new Listeners() // this page starts the simulation
        this.speed = '1'
        panel.scope.$watch(() => panel.isSimulating(), simulating => {
            this.fixed = []
            if (simulating) {
                messages.succeed(this.before)
                this.before = null
            }
            if (simulating && this.driving) {
                picture.canvas().focus()
                messages.say('info', 'drive ' + view.robot + ': W or arrow up forward, S back, A left, D right, Enter '
                    + 'back to the start')
            }
            this.driving = this.driving && !simulating && Boolean(this.pending)
            this.testing = this.testing && (simulating || this.driving)
            if (this.followed !== null && !this.testing) {
                view.follow = this.followed
                this.followed = null
            }
        })
        world.told.hear(running => {
            if (running && running.wantedSpeed !== known) {
                known = running.wantedSpeed
                this.speed = String(known)
            }
        })
        this.handlers = {onStartSimulation: () => this.settle(), onStopSimulation: () => this.settle()}
    }

    start() {
        this.problems.forget()
        this.before = this.messages.last
        this.pending = 'starting'
        this.begun.tell()
        this.msg.send('startSimulation')
    }

    stop() {
        this.pending = 'stopping'
        this.msg.send('stopSimulation')
    }

    setSpeed() {
        this.msg.send('setSpeed', Number(this.speed))
    }

    drive(way) {
        if (way === 'reset') {
            this.msg.send('reset')
        } else {
            this.orders(WAYS[way], SPEED, ARCS[way]).forEach(call => this.msg.send.apply(this.msg, call))
        }
    }

    key(event) {
        const way = KEYS[(event.key || '').toLowerCase()]
        if (way && this.panel.isSimulating() && !this.world.instead && !event.ctrlKey && !event.altKey
            && !event.metaKey) {
            this.drive(way)
            event.preventDefault()
        }
    }

    /** Lets time run by itself, as no script advances it. */
    letTimeRun() {
        this.msg.send('setSpeed', 1)
        this.msg.send('setLockStep', false)
    }

    statusText() {
        return this.pending || (!this.$scope.service.started ? this.$scope.service.name + ' is starting'
            : !this.panel.isSimulating() ? 'no simulation runs' : this.$scope.service.paused
            ? 'paused' :
            this.world.waiting ? 'time waits for a script' : 'running')
    }

    /** Continues the status text. A separate element, because screen readers announce status changes. */
    timeText() {
        const state = this.pending ? null : this.world.running
        return state ? ' at ' + state.time.toFixed(2) + ' s'
        + (state.speed ? ', ' + state.speed.toFixed(1) + ' × real time' : '') : ''
    }

    // ---- the test drive
    // -----------------------------------------------------------------------------------------------------------------
    /**
     * Returns the calls that drive the chosen robot, else the first. Warns once per run if nothing steers the robot.
     * @param way forward and left, -1 to 1 @param most m/s at 1 @param arc direction for a robot that can't turn in
     * place, if another
     */
    orders(way, most, arc) {
        const robots = this.world.running ? this.world.running.robots : []
        const robot = robots.filter(one => one.name === this.view.robot)[0] || robots[0]
        if (robot && way[1] !== 0 && isFixed(robot) && this.fixed.indexOf(robot.name) < 0) {
            this.fixed.push(robot.name)
            this.messages.say('warn', robot.name + ' can\'t be steered: all driven wheels are on its centre line, and '
                + 'no wheel is steered. '
                + 'Add driven wheels left and right, or give front or rear wheels a steering angle or a steering servo')
        }
        return robot ? drive(robot, robot.steered && arc || way, most) : []
    }

    /** Returns the robots of a world with driven wheels. */
    drivers(seen) {
        return seen ? seen.robots.filter(robot => robot.drives) : []
    }

    /** Returns why there is nothing to drive; empty if there is. */
    whyNoDrive() {
        const seen = this.world.now()
        return this.panel.isSimulating() || this.drivers(seen).length ? '' : !seen || !seen.robots.length
            ? 'no robot to drive: choose one in the palette and click on the ground'
            : seen.robots.map(robot => robot.name).join(', ') + ' has no driven wheels: add a Wheel of type 1, or '
            + 'place a complete robot'
    }

    /** Returns why no other project can be opened now; empty if one can. */
    whyNoOther() {
        return this.panel.isSimulating() ? 'stop the simulation first' : ''
    }

    /** Starts or ends a simulation in which the keys drive the selected robot, else the chosen one. */
    testDrive() {
        const seen = this.world.now()
        if (this.panel.isSimulating()) {
            this.stop()
        } else if (this.whyNoDrive()) {
            this.messages.say('error', this.whyNoDrive())
        } else {
            const found = find(seen, this.edits.selected)
            const robot = found && (found.robot || found.object)
            this.view.driveRobot(robot && robot.parts ? robot.name : this.view.robot || this.drivers(seen)[0].name)
            this.driving = true
            this.testing = true
            this.followed = this.view.follow
            this.view.follow = true
            this.start()
        }
    }

    // ---- messages of the service
    // -----------------------------------------------------------------------------------------------------------
    /** Ends the pending state after the service's answer or failure. */
    settle() {
        this.pending = null
    }

    /** Takes the service's simulation state; a state from before the call may arrive first. */
    follow() {
        if (this.pending === (this.panel.isSimulating() ? 'starting' : 'stopping')) {
            this.settle()
        }
    }
}
