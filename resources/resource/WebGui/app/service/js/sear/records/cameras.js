// SPDX-License-Identifier: Apache-2.0
// Camera pictures in the SEAR panel, of the running world or of a record. The page requests a camera's pictures one by
// one while the camera is visible.
const LOOK_MILLIS = 100       // interval of checks for wanted pictures
const REST_MILLIS = 200       // minimum pause between an answer and the next request; longer if the answer took longer
const PATIENCE_MILLIS = 10000 // timeout: requests the picture again
const SMALL = 320             // pixels of the longer side in the drawer
const LARGE = 640             // pixels of the longer side over the view
const SMALLEST = 200          // minimum width over the view, page pixels
const AROUND = 170            // height kept free above and below it, page pixels
const STEPS = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}

/** The camera pictures of one panel. @param $interval Angular's */
export class Cameras {
    constructor(panel, world, replay, picture, $interval) {
        this.panel = panel
        this.world = world
        this.replay = replay
        this.picture = picture
        this.shown = Object.create(null) // by name of the camera: last answer of the running world
        this.kept = Object.create(null) // by name of the camera: last answer of the shown record
        this.marks = Object.create(null) // by name: the pixel whose value is shown, {column, row, style}
        // by name: last request, {key, asked: when, rest: time of the next allowed request, awaited}
        this.questions = Object.create(null)
        this.plotted = () => []
        this.large = ''         // name of the camera shown over the view
        world.news.hear(() => this.forget())
        world.previewed.hear(() => this.forget())
        const looks = $interval(() => this.look(), LOOK_MILLIS, 0, false)
        panel.scope.$on('$destroy', () => {
            $interval.cancel(looks)
        })
        this.handlers = {onCameraPicture: sent => this.onCameraPicture(sent), onRecordPicture: sent =>
            this.onRecordPicture(sent)}
    }

    /** Sets the source of plotted names. @param lines returns the names plotted of the running world */
    plottedBy(lines) {
        this.plotted = lines
    }

    /** Returns what is shown of a camera: picture, words, range, column, row, pixel; null for none. */
    seen(sensor) {
        const record = this.replay.shown
        if (record) {
            return this.kept[sensor.name] && this.kept[sensor.name].path === record.path ? this.kept[sensor.name] : null
        }
        return this.world.running ? this.shown[sensor.name] || null : sensor.picture ? sensor : null
    }

    /** Whether there is a camera. */
    any() {
        return this.replay.sensors().some(sensor => sensor.eye)
    }

    /** Returns the camera shown over the view. */
    ofLarge() {
        return this.replay.sensors().filter(sensor => sensor.name === this.large && sensor.eye)[0] || null
    }

    /** Returns the width of the large picture, which fits between the other elements over the view. */
    largeSize(sensor) {
        const canvas = this.picture.canvas()
        const room = canvas ? Math.min(0.46 * canvas.clientWidth, (canvas.clientHeight - AROUND) * sensor.eye.width
            / sensor.eye.height, LARGE) : 0
        return {width: Math.max(SMALLEST, Math.round(room)) + 'px'}
    }

    enlarge(name) {
        this.large = this.large === name ? '' : name
    }

    /** Returns why there is no picture. */
    why(sensor) {
        return this.isLive(sensor) ? '...' : this.replay.shown ? 'The record contains no pictures of this camera'
            : 'Start the simulation to see pictures'
    }

    /** Whether pictures are available. */
    isLive(sensor) {
        return this.replay.shown ? this.replay.shown.pictures.indexOf(sensor.name) >= 0 : this.panel.isSimulating()
    }

    // ---- a pixel
    // -----------------------------------------------------------------------------------------------------------------
    mark(sensor, column, row) {
        const at = {column: Math.max(0, Math.min(sensor.eye.width - 1, column)),
            row: Math.max(0, Math.min(sensor.eye.height - 1, row))}
        at.style = {left: 100 * (at.column + 0.5) / sensor.eye.width + '%',
            top: 100 * (at.row + 0.5) / sensor.eye.height + '%'}
        this.marks[sensor.name] = at
        this.look()
    }

    /** Marks the pixel under the mouse; a key marks the middle pixel. */
    point(sensor, event) {
        const image = event.currentTarget.querySelector('img')
        const box = image && image.getBoundingClientRect()
        const byMouse = (event.originalEvent || event).detail > 0 && box      // jQuery does not copy it
        this.mark(sensor, Math.floor(sensor.eye.width * (byMouse ? (event.clientX - box.left) / box.width : 0.5)),
            Math.floor(sensor.eye.height * (byMouse ? (event.clientY - box.top) / box.height : 0.5)))
    }

    /** Arrow keys move the mark by a pixel, with Shift by ten; Escape removes it. */
    key(sensor, event) {
        const at = this.marks[sensor.name]
        const step = STEPS[event.key]
        if (event.key === 'Escape') {
            delete this.marks[sensor.name]
        } else if (step && at) {
            this.mark(sensor, at.column + step[0] * (event.shiftKey ? 10 : 1),
                at.row + step[1] * (event.shiftKey ? 10 : 1))
            event.preventDefault()
        }
    }

    /** Returns the mark's place on the picture; null without a mark. */
    cross(sensor) {
        return this.marks[sensor.name] ? this.marks[sensor.name].style : null
    }

    /** Returns the marked pixel's value as text. */
    pixel(sensor) {
        const at = this.marks[sensor.name]
        const seen = this.seen(sensor)
        const told = at && seen && seen.column === at.column && seen.row === at.row
        const words = told ? seen.pixel : this.isLive(sensor) ? '...' : 'shown while the simulation runs'
        return at ? 'column ' + at.column + ', row ' + at.row + ': ' + words : ''
    }

    // ---- asking
    // -----------------------------------------------------------------------------------------------------------------
    isSeen(element) {
        const box = element.getBoundingClientRect()
        const around = element.closest('.sear-inside')
        const within = around ? around.getBoundingClientRect() : {top: 0, bottom: window.innerHeight}
        return box.height > 0 && box.bottom > Math.max(0, within.top)
            && box.top < Math.min(window.innerHeight, within.bottom)
    }

    /** Returns the picture size in pixels of each visible camera, by name. */
    wanted() {
        const sizes = Object.create(null)
        const workspace = this.panel.element('workspace')
        if (!workspace || !this.picture.width() || document.hidden) {
            return sizes
        }
        workspace.querySelectorAll('[data-eye]').forEach(element => {
            if (this.isSeen(element)) {
                sizes[element.dataset.eye] = Math.max(sizes[element.dataset.eye] || 0, element.dataset.large
                    ? LARGE : SMALL)
            }
        })
        const lines = this.replay.shown ? [] : this.plotted()
        this.replay.sensors().forEach(sensor => {
            if (sensor.eye && lines.some(line => line.indexOf(sensor.name + '.') === 0)) {
                sizes[sensor.name] = sizes[sensor.name] || SMALL
            }
        })
        return sizes
    }

    look() {
        const sizes = this.wanted()
        Object.keys(sizes).forEach(name => {
            this.ask(name, sizes[name])
        })
    }

    ask(name, size) {
        const record = this.replay.shown
        const at = this.marks[name] || {column: -1, row: -1}
        const time = record ? this.replay.time() : this.world.running && this.world.running.time
        const question = this.questions[name] = this.questions[name] || {rest: 0}
        const now = Date.now()
        const key = [record ? record.path : '', time, size, at.column, at.row].join(' ')
        if (time === null || record && record.pictures.indexOf(name) < 0 || question.key === key
            || (question.awaited ? now - question.asked < PATIENCE_MILLIS : now < question.rest)) {
            return
        }
        Object.assign(question, {key, asked: now, awaited: true})
        if (record) {
            this.panel.msg.send('getRecordPicture', record.path, name, time, size, at.column, at.row)
        } else {
            this.panel.msg.send('getCameraPicture', name, size, at.column, at.row)
        }
    }

    /** Matches an answer with its request. Each page receives the answers to all pages. */
    answered(sent) {
        const question = sent && this.questions[sent.name]
        if (question && question.awaited) {
            const now = Date.now()
            question.awaited = false
            question.rest = now + Math.max(REST_MILLIS, now - question.asked)
        }
        return question
    }

    onCameraPicture(sent) {
        if (!this.answered(sent) || !this.world.running) {
            return false
        }
        this.shown[sent.name] = sent
        this.world.running.sensors.forEach(sensor => {
            if (sensor.name === sent.name) {
                sensor.words = sent.words
                sensor.numbers = sent.numbers
            }
        })
        return true
    }

    onRecordPicture(sent) {
        if (!this.answered(sent)) {
            return false
        }
        this.kept[sent.name] = sent
        return true
    }

    /** Drops the pictures of the previous world. */
    forget() {
        this.shown = Object.create(null)
        this.questions = Object.create(null)
    }
}
