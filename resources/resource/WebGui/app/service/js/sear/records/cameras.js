// Pictures of cameras in the SEAR panel: asked for one after the other while somebody looks at them, of the running world or of a record.
var LOOK_MILLIS = 100       // how often it looks whether a picture is wanted
var REST_MILLIS = 200       // between an answer and the next question; longer if the answer took longer
var PATIENCE_MILLIS = 10000 // an answer that takes longer is asked for again
var SMALL = 320             // pixels of the longer side in the drawer
var LARGE = 640             // and over the view
var SMALLEST = 200          // on the page, over the view
var AROUND = 170            // above and below it there
var STEPS = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}

/** Of one panel. @param $interval Angular's */
export function makeCameras(panel, world, replay, picture, $interval) {
    var shown = Object.create(null)    // by name of the camera: the last answer of the running world
    var kept = Object.create(null)    // likewise of the record that is shown
    var marks = Object.create(null)    // by name: the pixel of which is told what it sees, {column, row, style}
    var questions = Object.create(null)    // by name: the last question, {key, asked: when, rest: until when nothing is asked, awaited}
    var plotted = () => []
    var cameras = {
        large: ''               // name of the one that is shown over the view
    }

    /** @param lines a function that answers the names of what is plotted of the running world */
    cameras.plottedBy = function(lines) {
        plotted = lines
    }
    /** What is shown of a camera: picture, words, range, column, row, pixel; null for nothing. */
    cameras.seen = function(sensor) {
        var record = replay.shown
        if (record) {
            return kept[sensor.name] && kept[sensor.name].path === record.path ? kept[sensor.name] : null
        }
        return world.running ? shown[sensor.name] || null : sensor.picture ? sensor : null
    }
    /** Whether there is a camera. */
    cameras.any = () => replay.sensors().some(sensor => sensor.eye)
    /** Of the camera that is shown over the view. */
    cameras.ofLarge = function() {
        return replay.sensors().filter(sensor => sensor.name === cameras.large && sensor.eye)[0] || null
    }
    /** How wide that is, so that it fits between what else stands over the view. */
    cameras.largeSize = function(sensor) {
        var canvas = picture.canvas()
        var room = canvas ? Math.min(0.46 * canvas.clientWidth, (canvas.clientHeight - AROUND) * sensor.eye.width / sensor.eye.height, LARGE) : 0
        return {width: Math.max(SMALLEST, Math.round(room)) + 'px'}
    }
    cameras.enlarge = function(name) {
        cameras.large = cameras.large === name ? '' : name
    }
    /** Why there is no picture. */
    cameras.why = function(sensor) {
        return isLive(sensor) ? '...' : replay.shown ? 'The record has no pictures of it' : 'Pictures come when the simulation runs'
    }
    /** Whether pictures come. */
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
    /** The pixel under the mouse; by a key, which has no place, the one in the middle. */
    cameras.point = function(sensor, event) {
        var image = event.currentTarget.querySelector('img')
        var box = image && image.getBoundingClientRect()
        var byMouse = (event.originalEvent || event).detail > 0 && box      // jQuery does not hand it on
        mark(sensor, Math.floor(sensor.eye.width * (byMouse ? (event.clientX - box.left) / box.width : 0.5)),
            Math.floor(sensor.eye.height * (byMouse ? (event.clientY - box.top) / box.height : 0.5)))
    }
    /** Arrow keys go from pixel to pixel, with shift ten at once; Escape forgets it. */
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
    /** Where the mark stands on the picture; null without one. */
    cameras.cross = function(sensor) {
        return marks[sensor.name] ? marks[sensor.name].style : null
    }
    /** What the marked pixel sees, in words. */
    cameras.pixel = function(sensor) {
        var at = marks[sensor.name]
        var seen = cameras.seen(sensor)
        var told = at && seen && seen.column === at.column && seen.row === at.row
        var words = told ? seen.pixel : isLive(sensor) ? '...' : 'told while the simulation runs'
        return at ? 'column ' + at.column + ', row ' + at.row + ': ' + words : ''
    }

    // ---- asking ----------------------------------------------------------------------------------------------------------------------
    function isSeen(element) {
        var box = element.getBoundingClientRect()
        var around = element.closest('.sear-inside')
        var within = around ? around.getBoundingClientRect() : {top: 0, bottom: window.innerHeight}
        return box.height > 0 && box.bottom > Math.max(0, within.top) && box.top < Math.min(window.innerHeight, within.bottom)
    }
    /** By name of each camera that somebody looks at: how many pixels its picture is to have. */
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
    /** Each page gets the answers to all pages. */
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

    /** Another world, or none: what was seen of it is gone. */
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
