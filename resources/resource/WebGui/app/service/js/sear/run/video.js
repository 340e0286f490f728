// SPDX-License-Identifier: Apache-2.0
// Records the SEAR panel's view as a video with the browser's recorder.
import {saveBlob} from '../shared/words.js'

var RATE = 30               // maximum frame rate
var BITS = 6e6              // bits per second
var LONGEST_MILLIS = 600000
var KINDS = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm']
var STOP = /(#[0-9a-f]{6}) (-?[\d.]+)%/g

/** Makes the video recorder of one panel. */
export function makeVideo(panel, messages, view, picture) {
    var film = null             // canvas, pen, recorder, parts, timer
    var video = {running: false}

    function kind() {
        return window.MediaRecorder && KINDS.filter(one => window.MediaRecorder.isTypeSupported(one))[0]
    }
    /** Returns why no video is possible; empty if one is. */
    video.whyNot = function() {
        return kind() ? '' : 'This browser can\'t record video'
    }
    video.toggle = function() {
        if (film) {
            film.recorder.stop()
        } else {
            begin()
        }
    }
    function begin() {
        var canvas = document.createElement('canvas')
        var shown = picture.canvas()
        canvas.width = shown.width - shown.width % 2
        canvas.height = shown.height - shown.height % 2
        film = {canvas: canvas, pen: canvas.getContext('2d'), parts: []}
        film.recorder = new window.MediaRecorder(canvas.captureStream(RATE), {mimeType: kind(), videoBitsPerSecond: BITS})
        film.recorder.ondataavailable = function(event) {
            film.parts.push(event.data)
        }
        film.recorder.onstop = end
        film.recorder.start(1000)
        film.timer = window.setTimeout(function() {
            messages.say('warn', 'the video ends here at its maximum length, ' + LONGEST_MILLIS / 60000 + ' minutes')
            film.recorder.stop()
        }, LONGEST_MILLIS)
        video.running = true
        picture.repaint()
    }
    function end() {
        var done = film
        film = null
        video.running = false
        window.clearTimeout(done.timer)
        done.recorder.stream.getTracks().forEach(track => track.stop())
        saveBlob('sear.webm', new Blob(done.parts, {type: 'video/webm'}))
        messages.say('info', 'saved the video as sear.webm')
        panel.scope.$applyAsync()
    }

    /** Paints the background of the view: the sky, which is CSS, or the page's colour. */
    function paintBehind(shown) {
        var height = film.canvas.height
        var scene = view.mode === 'space' && view.scene()
        var stops = scene && scene.sky ? Array.from(scene.sky.matchAll(STOP)).map(found => [found[1], Number(found[2]) / 100]) : []
        film.pen.fillStyle = window.getComputedStyle(document.body).backgroundColor
        if (stops.length) {
            var low = Math.min(0, stops[0][1])
            var high = Math.max(1, stops[stops.length - 1][1])
            var sky = film.pen.createLinearGradient(0, low * height, 0, high * height)
            stops.forEach(stop => sky.addColorStop((stop[1] - low) / (high - low), stop[0]))
            film.pen.fillStyle = sky
        }
        film.pen.fillRect(0, 0, film.canvas.width, height)
        film.pen.drawImage(shown, 0, 0, film.canvas.width, height)
    }
    /** Copies the frame right after drawing, because the browser discards it afterwards. */
    picture.painted.hear(function() {
        if (film) {
            paintBehind(picture.canvas())
        }
    })
    panel.scope.$on('$destroy', function() {
        if (film) {
            film.recorder.stop()
        }
    })
    return video
}
