// SPDX-License-Identifier: Apache-2.0
// A panel's messages to the user, newest first.
const MOST = 100
const REPEATED = 'could not invoke '      // start of MyRobotLab's second message about a failed call

/**
 * The messages of one panel: list; unread, the number of unseen messages; last, the newest one as a line, null
 * for none.
 */
export class Messages {
    constructor() {
        this.told = false       // whether the service has reported why a call failed, before MyRobotLab's repetition
        this.said = 0
        this.list = []
        this.unread = 0
        this.last = null
    }

    say(level, text) {
        const newest = this.list[0]
        if (newest && newest.text === text && newest.level === level) {
            newest.times++
            newest.time = new Date()
        } else {
            this.list.unshift({id: this.said++, level, text, time: new Date(), times: 1})
            this.list.splice(MOST)
            this.unread = Math.min(this.unread + 1, MOST)
        }
        this.last = {level, text, line: text.split('\n')[0]}
    }

    /**
     * Returns the news in a service's status; empty for a repetition. Of an exception, detail is the stack trace and
     * key the message.
     */
    newsOf(status) {
        const text = status && (status.key || status.detail) || ''
        if (text && status.level === 'error') {
            const repeats = text.indexOf(REPEATED) === 0
            const wasTold = this.told
            this.told = !repeats
            return repeats && wasTold ? '' : text
        }
        return text
    }

    take(status) {
        const text = this.newsOf(status)
        if (text) {
            this.say(status.level, text)
        }
    }

    hideLast() {
        this.last = null
    }

    /** Hides an older error after a success. @param before the last message before the successful action */
    succeed(before) {
        if (before && before.level === 'error') {
            this.settle(before)
        }
    }

    /** Hides a message if it is still the last one. */
    settle(one) {
        if (this.last === one) {
            this.hideLast()
        }
    }

    /** Called while the list is visible. */
    read() {
        this.unread = 0
    }

    clear() {
        this.list = []
        this.unread = 0
        this.last = null
    }
}
