// What a panel tells its user, newest first.
var MOST = 100
var REPEATED = 'could not invoke '      // so MyRobotLab begins to say once more that a call has failed

/** Of one panel: list; last, the newest one as a line, null for none. */
export function makeMessages() {
    var told = false            // whether the service has said why a call failed, and MyRobotLab has not repeated that yet
    var said = 0
    var messages = {list: [], last: null}

    messages.say = function(level, text) {
        var newest = messages.list[0]
        if (newest && newest.text === text && newest.level === level) {
            newest.times++
            newest.time = new Date()
        } else {
            messages.list.unshift({id: said++, level: level, text: text, time: new Date(), times: 1})
            messages.list.splice(MOST)
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
    /** Hides a message if it is still the last one. */
    messages.settle = function(one) {
        if (messages.last === one) {
            messages.hideLast()
        }
    }
    messages.clear = function() {
        messages.list = []
        messages.last = null
    }
    return messages
}
