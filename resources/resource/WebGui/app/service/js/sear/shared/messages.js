// What a panel tells its user, newest first.
var MOST = 100
var REPEATED = 'could not invoke '      // so MyRobotLab begins to say once more that a call has failed

/** Of one panel: list; unread, how many of it nobody has seen; last, the newest one as a line, null for none. */
export function makeMessages() {
    var told = false            // whether the service has said why a call failed, and MyRobotLab has not repeated that yet
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
    /** What a service's status says that was not said before; empty for nothing. An exception's detail is its stack trace, its key what happened. */
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
    /** What has succeeded since makes an error old. @param before the last message when that began */
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
    /** The list is before its reader's eyes. */
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
