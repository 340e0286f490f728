// SPDX-License-Identifier: Apache-2.0
// Drag spring in the SEAR panel: with the Shift key, the mouse pulls a loose object of a running world. The service
// simulates the spring.
import * as geometry from '../shared/geometry.js'
import {find, local, onPlane, ray} from '../world/pointing.js'

const SEND_MILLIS = 50        // between two messages to the service
const AGAIN_MILLIS = 400      // the service releases the object after a second without messages

/** The drag spring of one panel. */
export class Hand {
    constructor(panel, world, view, pointer) {
        this.panel = panel
        this.world = world
        this.view = view
        this.pointer = pointer
        // name, from: point taken, grip: the same in its own frame, way, normal of the mouse's plane
        this.held = null
        this.spring = null      // drawn line
        world.told.hear(running => {
            if (this.held && running) {
                this.draw()
            } else {
                this.letGo()
            }
        })
    }

    nameOf(who) {
        return who && (who.robot || (who.object.loose ? who.object.name : null))
    }

    /** Returns the viewing direction. */
    ahead() {
        const canvas = this.pointer.canvas()
        return this.pointer.scene() ? ray(this.pointer.scene(), canvas.clientWidth / 2,
            canvas.clientHeight / 2).along : null
    }

    take(event) {
        const p = this.pointer.position(event)
        const canPull = this.panel.isSimulating() && this.world.running && !this.world.instead && !this.view.building
        const under = event.button === 0 && event.shiftKey && canPull && event.target === this.pointer.canvas()
        ? this.pointer.at(p[0], p[1]) : null
        const name = under && this.nameOf(under.who)
        const body = name && find(this.world.running, name)
        if (!body) {
            return
        }
        this.held = {name, from: under.point, grip: local(body.pose, under.point), way: [0, 0, 0], sent: 0, at: p,
            normal: this.ahead()}
        event.stopImmediatePropagation()
        event.preventDefault()
        this.pointer.canvas().focus()
        this.held.timer = window.setInterval(() => this.send(), AGAIN_MILLIS)
        this.send()
        this.draw()
    }

    send() {
        this.held.sent = Date.now()
        this.panel.msg.send('hold', this.held.name, this.held.way)
    }

    move(event) {
        if (!this.held) {
            return
        }
        event.stopImmediatePropagation()
        if (!event.buttons) {
            this.letGo()
            return
        }
        this.held.at = this.pointer.position(event)
        const [x, y] = this.held.at
        const to = this.pointer.scene() ? onPlane(ray(this.pointer.scene(), x, y), this.held.from,
            this.held.normal) : this.onMap()
        if (to) {
            this.held.way = to.map((value, i) => value - this.held.from[i])
        }
        if (Date.now() - this.held.sent >= SEND_MILLIS) {
            this.send()
        }
        this.draw()
    }

    onMap() {
        const canvas = this.pointer.canvas()
        return [this.view.x - (this.held.at[1] - canvas.clientHeight / 2) / this.view.scale, this.held.from[1],
            this.view.z + (this.held.at[0] - canvas.clientWidth / 2) / this.view.scale]
    }

    letGo() {
        if (this.held) {
            window.clearInterval(this.held.timer)
            this.panel.msg.send('letGo', this.held.name)
            this.held = null
            this.draw()
        }
    }

    // ---- drawing
    // -----------------------------------------------------------------------------------------------------------------
    makeSpring() {
        const space = 'http://www.w3.org/2000/svg'
        const svg = document.createElementNS(space, 'svg')
        this.spring = document.createElementNS(space, 'line')
        svg.setAttribute('class', 'sear-spring')
        svg.setAttribute('aria-hidden', 'true')
        svg.append(this.spring)
        this.pointer.canvas().parentElement.append(svg)
    }

    draw() {
        if (!this.spring) {
            this.makeSpring()
        }
        const body = this.held && this.world.running && find(this.world.running, this.held.name)
        this.spring.parentElement.style.display = body ? '' : 'none'
        if (body) {
            const turned = geometry.rotate(body.pose, this.held.grip)
            const grip = [0, 1, 2].map(i => body.pose[i] + turned[i])
            const seen = this.pointer.scene() ? this.pointer.scene()
            .toScreen(grip[0], grip[1], grip[2]) : this.view.toScreen(grip[0], grip[2])
            const ends = {x1: seen.x, y1: seen.y, x2: this.held.at[0], y2: this.held.at[1]}
            Object.keys(ends).forEach(name => this.spring.setAttribute(name, ends[name]))
        }
    }

    /** Adds the listeners once the views exist, before all other listeners to the mouse. */
    listen() {
        this.panel.element('view').parentElement.addEventListener('pointerdown', event => this.take(event), true)
        this.panel.listen(window, {
            pointermove: event => this.move(event),
            pointerup: () => this.letGo(),
            pointercancel: () => this.letGo(),
            beforeunload: () => this.letGo(),
            blur: event => event.target === window && this.letGo()      // not for an element in the window
        }, true)
        this.panel.scope.$on('$destroy', () => this.letGo())
    }
}
