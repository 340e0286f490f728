// SPDX-License-Identifier: Apache-2.0
/** The mouse, wheel and touch control of the views, and the text about the point under the mouse. */
export class Pointed {
    constructor(panel, world, ground, view) {
        this.panel = panel
        this.world = world
        this.ground = ground
        this.view = view
        this.text = ''
    }

    tell(text) {
        if (text !== this.text) {
            this.text = text
            this.panel.scope.$applyAsync()
        }
    }

    pointAtMap(x, y) {
        const shown = this.panel.element('view')
        const land = this.ground.of(this.world.shown())
        const view = this.view
        this.tell(land ? land.words(view.x - (y - shown.clientHeight / 2) / view.scale,
            view.z + (x - shown.clientWidth / 2) / view.scale) : '')
    }

    pointAtScene(x, y) {
        const scene = this.view.scene()
        const found = scene && scene.pick(x, y)
        const land = found && !found.object ? this.ground.of(this.world.shown()) : null
        this.tell(!found ? '' : land ? land.words(found.point[0], found.point[2]) : found.object ? found.object.name
            + ', ' + found.object.type : '')
    }

    // ---- mouse, wheel, touch
    // ---------------------------------------------------------------------------------------------------------------
    listenToMap(shown) {
        let grip = null
        this.listenToWheel(shown)
        shown.addEventListener('mousedown', event => {
            grip = {x: event.clientX, y: event.clientY, at: {x: this.view.x, z: this.view.z}}
        })
        shown.addEventListener('mousemove', event => {
            if (grip && event.buttons) {
                this.view.moveTo(grip.at.x + (event.clientY - grip.y) / this.view.scale,
                    grip.at.z - (event.clientX - grip.x) / this.view.scale)
            }
            const box = shown.getBoundingClientRect()
            this.pointAtMap(event.clientX - box.left, event.clientY - box.top)
        })
    }

    listenToWheel(shown) {
        shown.addEventListener('wheel', event => {
            this.view.zoom(event.deltaY < 0 ? 1.15 : 1 / 1.15)
            event.preventDefault()
        })
    }

    /** Left button or one finger turns; other buttons, the Shift key or two fingers pan. */
    listenToScene(shown) {
        let grip = null
        this.listenToWheel(shown)
        shown.addEventListener('contextmenu', event => {
            event.preventDefault()
        })
        shown.addEventListener('mousedown', event => {
            grip = {x: event.clientX, y: event.clientY}
        })
        shown.addEventListener('mousemove', event => {
            if (grip && event.buttons) {
                this.view.drag(event.clientX - grip.x, event.clientY - grip.y, event.buttons !== 1 || event.shiftKey)
                grip = {x: event.clientX, y: event.clientY}
            } else {
                const box = shown.getBoundingClientRect()
                this.pointAtScene(event.clientX - box.left, event.clientY - box.top)
            }
        })
        this.listenToFingers(shown)
    }

    listenToFingers(shown) {
        let last = null
        function middle(touches) {
            const a = touches[0]
            const b = touches[1] || a
            return {count: touches.length, x: (a.clientX + b.clientX) / 2, y: (a.clientY + b.clientY) / 2,
                apart: Math.sqrt(Math.pow(a.clientX - b.clientX, 2) + Math.pow(a.clientY - b.clientY, 2))}
        }
        shown.addEventListener('touchstart', event => {
            last = middle(event.touches)
        })
        shown.addEventListener('touchmove', event => {
            const now = middle(event.touches)
            if (last && last.count === now.count) {
                this.view.drag(now.x - last.x, now.y - last.y, now.count > 1)
                if (now.count > 1 && last.apart > 0) {
                    this.view.zoom(now.apart / last.apart)
                }
            }
            last = now
            event.preventDefault()
        })
    }

    /** Adds the listeners once the canvases exist. */
    listen() {
        this.listenToMap(this.panel.element('view'))
        this.listenToScene(this.panel.element('scene'))
    }
}
