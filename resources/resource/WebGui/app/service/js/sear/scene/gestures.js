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

    // ---- mouse, wheel, fingers
    // -------------------------------------------------------------------------------------------------------------
    listenToMap(shown) {
        this.listenTo(shown, (right, down) => this.view.moveTo(this.view.x + down / this.view.scale,
            this.view.z - right / this.view.scale), (x, y) => this.pointAtMap(x, y))
    }

    /** Left button or one finger turns; other buttons, the Shift key or two fingers pan. */
    listenToScene(shown) {
        shown.addEventListener('contextmenu', event => {
            event.preventDefault()
        })
        this.listenTo(shown, (right, down, pans) => this.view.drag(right, down, pans),
            (x, y) => this.pointAtScene(x, y))
    }

    /**
     * Listens to wheel, mouse buttons and fingers; two fingers also zoom.
     * @param drag receives pixels right and down, and whether another button, the Shift key or a second finger is down
     * @param point receives the pixel under the mouse
     */
    listenTo(shown, drag, point) {
        const down = new Map()      // pointer -> its place
        shown.addEventListener('wheel', event => {
            this.view.zoom(event.deltaY < 0 ? 1.15 : 1 / 1.15)
            event.preventDefault()
        })
        shown.addEventListener('pointerdown', event => {
            if (event.isPrimary || down.size) {     // not a second finger while the first one drags an object
                shown.setPointerCapture(event.pointerId)
                down.set(event.pointerId, [event.clientX, event.clientY])
            }
        })
        shown.addEventListener('pointermove', event => {
            if (down.has(event.pointerId)) {
                const before = middle(down)
                down.set(event.pointerId, [event.clientX, event.clientY])
                const now = middle(down)
                drag(now.x - before.x, now.y - before.y, down.size > 1 || event.buttons !== 1 || event.shiftKey)
                if (down.size > 1 && before.apart > 0) {
                    this.view.zoom(now.apart / before.apart)
                }
            } else {
                const box = shown.getBoundingClientRect()
                point(event.clientX - box.left, event.clientY - box.top)
            }
        })
        ;['pointerup', 'pointercancel'].forEach(end => shown.addEventListener(end, event => {
            down.delete(event.pointerId)
        }))
    }

    /** Adds the listeners once the canvases exist. */
    listen() {
        this.listenToMap(this.panel.element('view'))
        this.listenToScene(this.panel.element('scene'))
    }
}

/** Returns the middle of the first two pointers, and their distance, pixels. */
function middle(down) {
    const [a, b = a] = down.values()
    return {x: (a[0] + b[0]) / 2, y: (a[1] + b[1]) / 2, apart: Math.hypot(a[0] - b[0], a[1] - b[1])}
}
