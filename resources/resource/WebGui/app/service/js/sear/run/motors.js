// SPDX-License-Identifier: Apache-2.0
// Sliders for the motors of joints in the SEAR panel.

const SEND_MILLIS = 50        // between two commands of a slider
const STEPS = 200             // of a slider: its range is 0 to this
const POWER = 'setJointPower'
const POSITION = 'setJointPosition'

/** The sliders of one panel. */
export class Motors {
    constructor(panel, world) {
        this.panel = panel
        this.wanted = {}        // last command of each joint, by name
        this.sliders = {}       // getters and setters of the sliders, by name
        this.timers = {}        // timeouts of commands that are not sent yet
        world.news.hear(() => {
            this.wanted = {}
            this.sliders = {}
        })
    }

    /** Returns the value that a joint's slider shows: the last command, else the present position, or 0. */
    value(joint) {
        const wanted = this.wanted[joint.name]
        return wanted !== undefined ? wanted : joint.command === POSITION && joint.numbers ? joint.numbers[0] : 0
    }

    /** Returns the model of a joint's slider: value() returns its place from 0 to STEPS; an argument sets it. */
    slider(joint) {
        this.sliders[joint.name] = this.sliders[joint.name] || {value: (...place) => {
            const range = joint.most - joint.least
            if (place.length) {
                this.set(joint, joint.least + range * Number(place[0]) / STEPS)
            }
            return String(Math.round(STEPS * (this.value(joint) - joint.least) / range))
        }}
        return this.sliders[joint.name]
    }

    /** Commands a joint's motor, at most once per SEND_MILLIS. */
    set(joint, value) {
        this.wanted[joint.name] = Number(value.toPrecision(6))
        this.timers[joint.name] = this.timers[joint.name] || window.setTimeout(() => {
            delete this.timers[joint.name]
            if (this.panel.isSimulating()) {
                this.panel.msg.send(joint.command, joint.name, this.wanted[joint.name])
            }
        }, SEND_MILLIS)
    }

    /** Returns what a joint's slider sets. */
    label(joint) {
        return joint.command === POWER ? 'power' : joint.command === POSITION ? 'position' : 'speed'
    }

    unit(joint) {
        const units = joint.unit.split(', ')
        return joint.command === POWER ? '' : joint.command === POSITION ? units[0] : units[1]
    }
}
