// SPDX-License-Identifier: Apache-2.0
// A panel's messages to the user, newest first.
var MOST = 100
var REPEATED = 'could not invoke '      // start of MyRobotLab's second message about a failed call

/**
 * Makes the messages of one panel: list; unread, the number of unseen messages; last, the newest one as a line, null
 * for none.
 */
export function makeMessages() {
    var told = false            // whether the service has reported why a call failed, before MyRobotLab's repetition
    var said = 0
    var messages = {list: [], unread: 0, last: null}

    messages.say = function(level, text) {
        var newest = messages.list[0]
        if (newest && newest.text === text && newest.level === level) {
            newest.times++
            newest.time = new Date()
        } else {
            messages.list.unshift({id: said++, level: level, text: text, time: new Date(), times: 1})
            messages.list.splice(MOST)
            messages.unread = Math.min(messages.unread + 1, MOST)
        }
        messages.last = {level: level, text: text, line: text.split('\n')[0]}
    }
    /**
     * Returns the news in a service's status; empty for a repetition. Of an exception, detail is the stack trace and
     * key the message.
     */
    messages.newsOf = function(status) {
        var text = status && (status.key || status.detail) || ''
        if (text && status.level === 'error') {
            var repeats = text.indexOf(REPEATED) === 0
            var wasTold = told
            told = !repeats
            return repeats && wasTold ? '' : text
        }
        return text
    }
    messages.take = function(status) {
        var text = messages.newsOf(status)
        if (text) {
            messages.say(status.level, text)
        }
    }
    messages.hideLast = function() {
        messages.last = null
    }
    /** Hides an older error after a success. @param before the last message before the successful action */
    messages.succeed = function(before) {
        if (before && before.level === 'error') {
            messages.settle(before)
        }
    }
    /** Hides a message if it is still the last one. */
    messages.settle = function(one) {
        if (messages.last === one) {
            messages.hideLast()
        }
    }
    /** Called while the list is visible. */
    messages.read = function() {
        messages.unread = 0
    }
    messages.clear = function() {
        messages.list = []
        messages.unread = 0
        messages.last = null
    }
    return messages
}
