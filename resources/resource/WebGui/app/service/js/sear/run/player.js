// SPDX-License-Identifier: Apache-2.0
// Plays the record of a shared run in its own page, without SEAR. share.js writes that page.
import * as geometry from '../shared/geometry.js'
import {Motion} from './motion.js'
import {oncePerPicture} from '../shared/page.js'
import {Scene} from '../scene/scene.js'
import {Terrain} from '../world/terrain.js'
import {robotsAt} from '../records/frames.js'

function element(id) {
    return document.getElementById(id)
}

function byName(list) {
    return list.reduce((all, one) => {
        all[one.name] = one
        return all
    }, {})
}

/** Player of one run. */
class Player {
    /** @param run world, record, motion or null, looks by key, terrain or null, title */
    constructor(run) {
        const repaint = oncePerPicture(() => this.draw())
        this.repaint = repaint
        this.record = run.record
        this.world = run.world
        this.last = run.record.times.length - 1
        this.index = 0
        this.began = 0          // start of playing, by the browser's clock; 0 while paused
        this.from = 0           // simulated time at that start, seconds
        this.scene = new Scene(element('view'), keys => {
            window.setTimeout(() => this.scene.looks.take(keys.map(key => run.looks[key]).filter(Boolean)))
        }, repaint)
        this.motion = run.motion ? new Motion(run.motion, run.world) : null
        this.terrain = run.terrain ? new Terrain(run.terrain, repaint) : null
        this.robots = byName(run.world.robots)
        this.objects = byName(run.world.objects)
    }

    draw() {
        if (this.began) {
            this.goOn()
        }
        this.scene.show(this.world, this.terrain, element('beams').checked)
        this.scene.draw(-1, element('follow').checked ? 0 : -1,
            window.matchMedia('(prefers-color-scheme: dark)').matches)
        if (this.began) {
            this.repaint()
        }
    }

    /** Shows a frame. */
    seek(to) {
        const record = this.record
        const index = this.index = Math.max(0, Math.min(this.last, Math.round(to)))
        robotsAt(this.robots, record, index)
        record.objects.forEach((name, i) => {
            if (this.objects[name]) {
                this.objects[name].pose = record.objectPoses[index][i]
            }
        })
        this.world.time = record.times[index]
        if (this.motion) {
            this.motion.show(this.world.time)
        }
        element('slider').value = index
        element('time').textContent = record.times[index].toFixed(2) + ' s of ' + record.times[this.last]
        .toFixed(2) + ' s'
        this.repaint()
    }

    goOn() {
        const time = this.from + (Date.now() - this.began) / 1000 * Number(element('speed').value)
        let to = this.index
        while (to < this.last && this.record.times[to + 1] <= time) {
            to++
        }
        if (to !== this.index) {
            this.seek(to)
        }
        if (to === this.last) {
            this.stop()
        }
    }

    stop() {
        this.began = 0
        element('play').textContent = 'Play'
    }

    start() {
        if (this.index === this.last) {
            this.seek(0)
        }
        this.from = this.record.times[this.index]
        this.began = Date.now()
        element('play').textContent = 'Pause'
        this.repaint()
    }

    listenToControls() {
        element('play').onclick = () => this.began ? this.stop() : this.start()
        element('slider').max = this.last
        element('slider').oninput = () => {
            this.stop()
            this.seek(Number(element('slider').value))
        }
        element('speed').onchange = () => {
            if (this.began) {
                this.start()
            }
        }
        element('follow').onchange = this.repaint
        element('beams').onchange = this.repaint
        element('beams').parentElement.hidden = !this.world.sensors.length
        window.addEventListener('resize', this.repaint)
    }

    listenToView() {
        const view = element('view')
        let grip = null
        view.onpointerdown = event => {
            grip = {x: event.clientX, y: event.clientY}
            view.setPointerCapture(event.pointerId)
        }
        view.onpointermove = event => {
            if (grip && event.buttons) {
                this.scene[event.buttons !== 1 || event.shiftKey ? 'pan' : 'turn'](event.clientX - grip.x,
                    event.clientY - grip.y)
                grip = {x: event.clientX, y: event.clientY}
                this.repaint()
            }
        }
        view.oncontextmenu = () => false
        view.addEventListener('wheel', event => {
            this.scene.zoom(event.deltaY < 0 ? 1.15 : 1 / 1.15)
            event.preventDefault()
            this.repaint()
        }, {passive: false})
    }

    fit() {
        const area = geometry.area(geometry.shapesOf(this.world))
        if (area) {
            const robot = this.world.robots[0]
            this.scene.fit({x: area.x, y: robot ? robot.pose[1] : 0, z: area.z, size: area.size},
                geometry.corners(this.world.objects))
        }
    }
}

/** Plays a run in this page. @return the player */
export function play(run) {
    const player = new Player(run)
    player.listenToControls()
    player.listenToView()
    player.seek(0)
    player.fit()
    player.start()
    return player
}
