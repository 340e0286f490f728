// SPDX-License-Identifier: Apache-2.0
// The user's own projects and the kept ones, with pictures that the service draws one after another.

const DAY_MILLIS = 24 * 60 * 60 * 1000

/** Returns when something happened: the time of day, before today the date. @param now milliseconds since 1970 */
export function timeOf(millis, now) {
    const then = new Date(millis)
    const today = new Date(now).toDateString() === then.toDateString()
    return today ? then.toTimeString().slice(0, 5)
        : then.getDate() + ' ' + then.toLocaleString('en', {month: 'short'}) + (now - millis > 300 * DAY_MILLIS
            ? ' ' + then.getFullYear() : ' ' + then.toTimeString().slice(0, 5))
}

/** Projects that one panel can open, besides the examples. */
export class Shelf {
    constructor(panel) {
        this.msg = panel.msg
        this.list = []          // own and kept projects, as ProjectShelf describes them
        this.pictures = {}      // data URL by path and time; empty without a picture
        this.asked = null       // project whose picture is awaited
        this.isSeen = () => false // whether the user sees the list
        this.handlers = {
            onProjects: list => {
                this.list = list || []
                this.asked = null
                this.draw()
            },
            onProjectPicture: answer => this.onPicture(answer)
        }
    }

    /** Requests the list again. */
    look() {
        this.msg.send('getProjects')
    }

    key(project) {
        return project.path + ' ' + project.time
    }

    picture(project) {
        return this.pictures[this.key(project)] || ''
    }

    /** Requests the next missing picture while the user sees the list. */
    draw() {
        if (!this.asked && this.isSeen()) {
            this.asked = this.list.filter(project => this.pictures[this.key(project)] === undefined)[0] || null
            if (this.asked) {
                this.msg.send('getProjectPicture', this.asked.path)
            }
        }
    }

    onPicture(answer) {
        const mine = this.asked
        if (!mine || !answer || answer.path !== mine.path) {
            return false        // another page's
        }
        this.asked = null
        this.pictures[this.key(mine)] = answer.svg
            ? 'data:image/svg+xml;charset=utf-8,' + encodeURIComponent(answer.svg) : ''
        this.draw()
        return true
    }

    /** Returns the projects of a kind: own or kept. */
    of(kind) {
        return this.list.filter(project => project.kind === kind)
    }

    /** Returns a project's line: kept 11:43: rover1, 2 boxes. */
    words(project) {
        const time = timeOf(project.time, Date.now())
        return project.kind === 'kept' ? 'kept ' + time + ': ' + project.words : 'saved ' + time
    }
}
