// SPDX-License-Identifier: Apache-2.0
// Records the SEAR panel's view as a video with the browser's recorder.
import {saveBlob} from '../shared/words.js'

const RATE = 30               // maximum frame rate
const BITS = 6e6              // bits per second
const LONGEST_MILLIS = 600000
const KINDS = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm']
const STOP = /(#[0-9a-f]{6}) (-?[\d.]+)%/g

/** The video recorder of one panel. */
export class Video {
    constructor(panel, messages, view, picture) {
        this.panel = panel
        this.messages = messages
        this.view = view
        this.picture = picture
        this.film = null        // canvas, pen, recorder, parts, timer
        this.running = false
        /** Copies the frame right after drawing, because the browser discards it afterwards. */
        picture.painted.hear(() => {
            if (this.film) {
                this.paintBehind(picture.canvas())
            }
        })
        panel.scope.$on('$destroy', () => {
            if (this.film) {
                this.film.recorder.stop()
            }
        })
    }

    kind() {
        return window.MediaRecorder && KINDS.filter(one => window.MediaRecorder.isTypeSupported(one))[0]
    }

    /** Returns why no video is possible; empty if one is. */
    whyNot() {
        return this.kind() ? '' : 'This browser can\'t record video'
    }

    toggle() {
        if (this.film) {
            this.film.recorder.stop()
        } else {
            this.begin()
        }
    }

    begin() {
        const canvas = document.createElement('canvas')
        const shown = this.picture.canvas()
        canvas.width = shown.width - shown.width % 2
        canvas.height = shown.height - shown.height % 2
        this.film = {canvas, pen: canvas.getContext('2d'), parts: []}
        this.film.recorder = new window.MediaRecorder(canvas.captureStream(RATE),
            {mimeType: this.kind(), videoBitsPerSecond: BITS})
        this.film.recorder.ondataavailable = event => {
            this.film.parts.push(event.data)
        }
        this.film.recorder.onstop = () => this.end()
        this.film.recorder.start(1000)
        this.film.timer = window.setTimeout(() => {
            this.messages.say('warn', 'the video ends here at its maximum length, ' + LONGEST_MILLIS / 60000
                + ' minutes')
            this.film.recorder.stop()
        }, LONGEST_MILLIS)
        this.running = true
        this.picture.repaint()
    }

    end() {
        const done = this.film
        this.film = null
        this.running = false
        window.clearTimeout(done.timer)
        done.recorder.stream.getTracks().forEach(track => track.stop())
        saveBlob('sear.webm', new Blob(done.parts, {type: 'video/webm'}))
        this.messages.say('info', 'saved the video as sear.webm')
        this.panel.scope.$applyAsync()
    }

    /** Paints the background of the view: the sky, which is CSS, or the page's colour. */
    paintBehind(shown) {
        const height = this.film.canvas.height
        const scene = this.view.mode === 'space' && this.view.scene()
        const stops = scene && scene.sky ? Array.from(scene.sky.matchAll(STOP))
        .map(found => [found[1], Number(found[2]) / 100]) : []
        this.film.pen.fillStyle = window.getComputedStyle(document.body).backgroundColor
        if (stops.length) {
            const low = Math.min(0, stops[0][1])
            const high = Math.max(1, stops[stops.length - 1][1])
            const sky = this.film.pen.createLinearGradient(0, low * height, 0, high * height)
            stops.forEach(stop => sky.addColorStop((stop[1] - low) / (high - low), stop[0]))
            this.film.pen.fillStyle = sky
        }
        this.film.pen.fillRect(0, 0, this.film.canvas.width, height)
        this.film.pen.drawImage(shown, 0, 0, this.film.canvas.width, height)
    }
}
