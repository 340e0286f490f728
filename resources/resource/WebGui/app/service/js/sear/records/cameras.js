// SPDX-License-Identifier: Apache-2.0
// Camera pictures in the SEAR panel, of the running world or of a record. The page requests a camera's pictures one by
// one while the camera is visible.
var LOOK_MILLIS = 100       // interval of checks for wanted pictures
var REST_MILLIS = 200       // minimum pause between an answer and the next request; longer if the answer took longer
var PATIENCE_MILLIS = 10000 // timeout: requests the picture again
var SMALL = 320             // pixels of the longer side in the drawer
var LARGE = 640             // pixels of the longer side over the view
var SMALLEST = 200          // minimum width over the view, page pixels
var AROUND = 170            // height kept free above and below it, page pixels
var STEPS = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}

/** Makes the camera pictures of one panel. @param $interval Angular's */
export function makeCameras(panel, world, replay, picture, $interval) {
    var shown = Object.create(null)    // by name of the camera: last answer of the running world
    var kept = Object.create(null)    // by name of the camera: last answer of the shown record
    var marks = Object.create(null)    // by name: the pixel whose value is shown, {column, row, style}
    var questions = Object.create(null)    // by name: last request, {key, asked: when, rest: time of the next allowed request, awaited}
    var plotted = () => []
    var cameras = {
        large: ''               // name of the camera shown over the view
    }

    /** Sets the source of plotted names. @param lines returns the names plotted of the running world */
    cameras.plottedBy = function(lines) {
        plotted = lines
    }
    /** Returns what is shown of a camera: picture, words, range, column, row, pixel; null for none. */
    cameras.seen = function(sensor) {
        var record = replay.shown
        if (record) {
            return kept[sensor.name] && kept[sensor.name].path === record.path ? kept[sensor.name] : null
        }
        return world.running ? shown[sensor.name] || null : sensor.picture ? sensor : null
    }
    /** Whether there is a camera. */
    cameras.any = () => replay.sensors().some(sensor => sensor.eye)
    /** Returns the camera shown over the view. */
    cameras.ofLarge = function() {
        return replay.sensors().filter(sensor => sensor.name === cameras.large && sensor.eye)[0] || null
    }
    /** Returns the width of the large picture, which fits between the other elements over the view. */
    cameras.largeSize = function(sensor) {
        var canvas = picture.canvas()
        var room = canvas ? Math.min(0.46 * canvas.clientWidth, (canvas.clientHeight - AROUND) * sensor.eye.width / sensor.eye.height, LARGE) : 0
        return {width: Math.max(SMALLEST, Math.round(room)) + 'px'}
    }
    cameras.enlarge = function(name) {
        cameras.large = cameras.large === name ? '' : name
    }
    /** Returns why there is no picture. */
    cameras.why = function(sensor) {
        return isLive(sensor) ? '...' : replay.shown ? 'The record contains no pictures of this camera' : 'Start the simulation to see pictures'
    }
    /** Whether pictures are available. */
    function isLive(sensor) {
        return replay.shown ? replay.shown.pictures.indexOf(sensor.name) >= 0 : panel.isSimulating()
    }

    // ---- a pixel ---------------------------------------------------------------------------------------------------------------------
    function mark(sensor, column, row) {
        var at = {column: Math.max(0, Math.min(sensor.eye.width - 1, column)), row: Math.max(0, Math.min(sensor.eye.height - 1, row))}
        at.style = {left: 100 * (at.column + 0.5) / sensor.eye.width + '%', top: 100 * (at.row + 0.5) / sensor.eye.height + '%'}
        marks[sensor.name] = at
        look()
    }
    /** Marks the pixel under the mouse; a key marks the middle pixel. */
    cameras.point = function(sensor, event) {
        var image = event.currentTarget.querySelector('img')
        var box = image && image.getBoundingClientRect()
        var byMouse = (event.originalEvent || event).detail > 0 && box      // jQuery does not copy it
        mark(sensor, Math.floor(sensor.eye.width * (byMouse ? (event.clientX - box.left) / box.width : 0.5)),
            Math.floor(sensor.eye.height * (byMouse ? (event.clientY - box.top) / box.height : 0.5)))
    }
    /** Arrow keys move the mark by a pixel, with Shift by ten; Escape removes it. */
    cameras.key = function(sensor, event) {
        var at = marks[sensor.name]
        var step = STEPS[event.key]
        if (event.key === 'Escape') {
            delete marks[sensor.name]
        } else if (step && at) {
            mark(sensor, at.column + step[0] * (event.shiftKey ? 10 : 1), at.row + step[1] * (event.shiftKey ? 10 : 1))
            event.preventDefault()
        }
    }
    /** Returns the mark's place on the picture; null without a mark. */
    cameras.cross = function(sensor) {
        return marks[sensor.name] ? marks[sensor.name].style : null
    }
    /** Returns the marked pixel's value as text. */
    cameras.pixel = function(sensor) {
        var at = marks[sensor.name]
        var seen = cameras.seen(sensor)
        var told = at && seen && seen.column === at.column && seen.row === at.row
        var words = told ? seen.pixel : isLive(sensor) ? '...' : 'shown while the simulation runs'
        return at ? 'column ' + at.column + ', row ' + at.row + ': ' + words : ''
    }

    // ---- asking ----------------------------------------------------------------------------------------------------------------------
    function isSeen(element) {
        var box = element.getBoundingClientRect()
        var around = element.closest('.sear-inside')
        var within = around ? around.getBoundingClientRect() : {top: 0, bottom: window.innerHeight}
        return box.height > 0 && box.bottom > Math.max(0, within.top) && box.top < Math.min(window.innerHeight, within.bottom)
    }
    /** Returns the picture size in pixels of each visible camera, by name. */
    function wanted() {
        var sizes = Object.create(null)
        var workspace = panel.element('workspace')
        if (!workspace || !picture.width() || document.hidden) {
            return sizes
        }
        workspace.querySelectorAll('[data-eye]').forEach(function(element) {
            if (isSeen(element)) {
                sizes[element.dataset.eye] = Math.max(sizes[element.dataset.eye] || 0, element.dataset.large ? LARGE : SMALL)
            }
        })
        var lines = replay.shown ? [] : plotted()
        replay.sensors().forEach(function(sensor) {
            if (sensor.eye && lines.some(line => line.indexOf(sensor.name + '.') === 0)) {
                sizes[sensor.name] = sizes[sensor.name] || SMALL
            }
        })
        return sizes
    }
    function look() {
        var sizes = wanted()
        Object.keys(sizes).forEach(function(name) {
            ask(name, sizes[name])
        })
    }
    function ask(name, size) {
        var record = replay.shown
        var at = marks[name] || {column: -1, row: -1}
        var time = record ? replay.time() : world.running && world.running.time
        var question = questions[name] = questions[name] || {rest: 0}
        var now = Date.now()
        var key = [record ? record.path : '', time, size, at.column, at.row].join(' ')
        if (time === null || record && record.pictures.indexOf(name) < 0 || question.key === key
            || (question.awaited ? now - question.asked < PATIENCE_MILLIS : now < question.rest)) {
            return
        }
        angular.extend(question, {key: key, asked: now, awaited: true})
        if (record) {
            panel.msg.send('getRecordPicture', record.path, name, time, size, at.column, at.row)
        } else {
            panel.msg.send('getCameraPicture', name, size, at.column, at.row)
        }
    }
    /** Matches an answer with its request. Each page receives the answers to all pages. */
    function answered(sent) {
        var question = sent && questions[sent.name]
        if (question && question.awaited) {
            var now = Date.now()
            question.awaited = false
            question.rest = now + Math.max(REST_MILLIS, now - question.asked)
        }
        return question
    }
    function onCameraPicture(sent) {
        if (!answered(sent) || !world.running) {
            return false
        }
        shown[sent.name] = sent
        world.running.sensors.forEach(function(sensor) {
            if (sensor.name === sent.name) {
                sensor.words = sent.words
                sensor.numbers = sent.numbers
            }
        })
        return true
    }
    function onRecordPicture(sent) {
        if (!answered(sent)) {
            return false
        }
        kept[sent.name] = sent
        return true
    }

    /** Drops the pictures of the previous world. */
    function forget() {
        shown = Object.create(null)
        questions = Object.create(null)
    }
    world.news.hear(forget)
    world.previewed.hear(forget)
    var looks = $interval(look, LOOK_MILLIS, 0, false)
    panel.scope.$on('$destroy', function() {
        $interval.cancel(looks)
    })
    cameras.handlers = {onCameraPicture: onCameraPicture, onRecordPicture: onRecordPicture}
    return cameras
}
