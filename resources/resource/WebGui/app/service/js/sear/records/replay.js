// SPDX-License-Identifier: Apache-2.0
// Replay of a record in the views.
import {Listeners} from '../shared/listeners.js'
import * as frames from './frames.js'

function ending(record) {
    return record.whole ? '' : record.written ? ', still being written' : ', incomplete'
}

/** The replay of one panel. */
export class Replay {
    constructor(panel, messages, world, picture) {
        this.panel = panel
        this.messages = messages
        this.world = world
        this.picture = picture
        this.shown = null       // data from the service, with world, index, playing
        this.speed = '1'
        this.moved = new Listeners() // another frame is shown, or none

        panel.scope.$on('$destroy', () => {
            this.shown = null     // stops playing, too
        })
    }

    /** Returns the time of the shown frame, seconds; null without a record. */
    time() {
        return this.shown && this.shown.times[this.shown.index]
    }

    /**
     * Returns the sensors' readings, now or in the record. A record has no sensor poses, so the views show no sensors
     * then.
     */
    sensors() {
        const seen = this.world.shown()
        return this.shown && this.shown.read || seen && seen.sensors || []
    }

    /** Returns the joints with their readings, now or in the record. */
    joints() {
        const seen = this.world.shown()
        return this.shown && this.shown.readJoints || seen && seen.joints || []
    }

    byName(list) {
        const found = Object.create(null)
        list.forEach(one => {
            found[one.name] = one
        })
        return found
    }

    show(sent) {
        const seen = this.world.now()
        if (!seen || !sent.times.length) {
            this.messages.say('warn', sent.path + ' can\'t be shown: there is no world; open the recorded project')
            return
        }
        sent.known = angular.copy(seen.sensors)
        sent.knownJoints = angular.copy((seen.joints || []).filter(joint => joint.numbers))
        sent.world = Object.assign({}, seen, {sensors: [], joints: [], robots: angular.copy(seen.robots).map(robot => {
            robot.devices = []      // the record has only their bytes
            return robot
        }), objects: seen.objects.map(object => Object.assign({}, object))})
        sent.index = 0
        sent.playing = false
        sent.note = () => sent.path + ' at ' + sent.times[sent.index].toFixed(2) + ' s of '
                + sent.times[sent.times.length - 1].toFixed(2) + ' s' + ending(sent)
        this.shown = sent
        this.world.showInstead(sent)
        this.seek()
    }

    /** Shows the slider's frame. */
    seek() {
        const record = this.shown
        record.index = Math.max(0, Math.min(record.times.length - 1, Math.round(Number(record.index))))
        const robots = this.byName(record.world.robots)
        const objects = this.byName(record.world.objects)
        frames.robotsAt(robots, record, record.index)
        record.read = frames.sensorsAt(record.known, record, record.index)
        record.readJoints = frames.sensorsAt(record.knownJoints, record, record.index)
        record.objects.forEach((name, i) => {
            if (objects[name]) {
                objects[name].pose = record.objectPoses[record.index][i]
            }
        })
        this.picture.repaint()
        this.moved.tell()
    }

    play() {
        const record = this.shown
        record.playing = !record.playing
        if (record.playing) {
            if (record.index >= record.times.length - 1) {
                record.index = 0
            }
            record.began = Date.now()
            record.from = record.times[record.index]
            record.rate = Number(this.speed)
            window.requestAnimationFrame(() => this.playOn())
        }
    }

    setSpeed() {
        if (this.shown && this.shown.playing) {
            this.play()
            this.play()
        }
    }

    playOn() {
        const record = this.shown
        if (!record || !record.playing) {
            return
        }
        const time = record.from + (Date.now() - record.began) / 1000 * record.rate
        let index = record.index
        while (index < record.times.length - 1 && record.times[index + 1] <= time) {
            index++
        }
        record.index = index
        record.playing = index < record.times.length - 1
        this.seek()
        this.panel.scope.$applyAsync()
        window.requestAnimationFrame(() => this.playOn())
    }

    end() {
        if (this.shown) {
            this.shown = null
            this.world.showInstead(null)
            this.moved.tell()
        }
    }
}
