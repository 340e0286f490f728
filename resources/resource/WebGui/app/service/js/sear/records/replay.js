// SPDX-License-Identifier: Apache-2.0
// Replay of a record in the views.
import {makeEvent} from '../shared/event.js'
import * as frames from './frames.js'

function ending(record) {
    return record.whole ? '' : record.written ? ', still being written' : ', incomplete'
}

/** Makes the replay of one panel. */
export function makeReplay(panel, messages, world, picture) {
    var replay = {
        shown: null,            // data from the service, with world, index, playing
        speed: '1',
        moved: makeEvent()      // another frame is shown, or none
    }
    /** Returns the time of the shown frame, seconds; null without a record. */
    replay.time = function() {
        return replay.shown && replay.shown.times[replay.shown.index]
    }
    /**
     * Returns the sensors' readings, now or in the record. A record has no sensor poses, so the views show no sensors
     * then.
     */
    replay.sensors = function() {
        var seen = world.shown()
        return replay.shown && replay.shown.read || seen && seen.sensors || []
    }
    function byName(list) {
        var found = Object.create(null)
        list.forEach(function(one) {
            found[one.name] = one
        })
        return found
    }
    replay.show = function(sent) {
        var seen = world.now()
        if (!seen || !sent.times.length) {
            messages.say('warn', sent.path + ' can\'t be shown: there is no world; open the recorded project')
            return
        }
        sent.known = angular.copy(seen.sensors)
        sent.world = angular.extend({}, seen, {sensors: [], robots: angular.copy(seen.robots).map(function(robot) {
            robot.devices = []      // the record has only their bytes
            return robot
        }), objects: seen.objects.map(object => angular.extend({}, object))})
        sent.index = 0
        sent.playing = false
        sent.note = function() {
            return sent.path + ' at ' + sent.times[sent.index].toFixed(2) + ' s of '
                + sent.times[sent.times.length - 1].toFixed(2) + ' s' + ending(sent)
        }
        replay.shown = sent
        world.showInstead(sent)
        replay.seek()
    }
    /** Shows the slider's frame. */
    replay.seek = function() {
        var record = replay.shown
        record.index = Math.max(0, Math.min(record.times.length - 1, Math.round(Number(record.index))))
        var robots = byName(record.world.robots)
        var objects = byName(record.world.objects)
        frames.robotsAt(robots, record, record.index)
        record.read = frames.sensorsAt(record.known, record, record.index)
        record.objects.forEach(function(name, i) {
            if (objects[name]) {
                objects[name].pose = record.objectPoses[record.index][i]
            }
        })
        picture.repaint()
        replay.moved.tell()
    }
    replay.play = function() {
        var record = replay.shown
        record.playing = !record.playing
        if (record.playing) {
            if (record.index >= record.times.length - 1) {
                record.index = 0
            }
            record.began = Date.now()
            record.from = record.times[record.index]
            record.rate = Number(replay.speed)
            window.requestAnimationFrame(playOn)
        }
    }
    replay.setSpeed = function() {
        if (replay.shown && replay.shown.playing) {
            replay.play()
            replay.play()
        }
    }
    function playOn() {
        var record = replay.shown
        if (!record || !record.playing) {
            return
        }
        var time = record.from + (Date.now() - record.began) / 1000 * record.rate
        var index = record.index
        while (index < record.times.length - 1 && record.times[index + 1] <= time) {
            index++
        }
        record.index = index
        record.playing = index < record.times.length - 1
        replay.seek()
        panel.scope.$applyAsync()
        window.requestAnimationFrame(playOn)
    }
    replay.end = function() {
        if (replay.shown) {
            replay.shown = null
            world.showInstead(null)
            replay.moved.tell()
        }
    }

    panel.scope.$on('$destroy', function() {
        replay.shown = null     // stops playing, too
    })
    return replay
}
