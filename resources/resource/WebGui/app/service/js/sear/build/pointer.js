// SPDX-License-Identifier: Apache-2.0
import * as pointing from '../world/pointing.js'

const NOTHING = {objects: [], robots: [], sensors: []}

/** Finds objects under points of the shown view, 3D or map. Points are pixels of its canvas. */
export class Pointer {
    constructor(world, view, picture) {
        this.world = world
        this.view = view
        this.picture = picture
    }

    /** Returns the ground point [x, z] of a pixel of the map. */
    onMap(x, y) {
        const shown = this.canvas()
        return [this.view.x - (y - shown.clientHeight / 2) / this.view.scale, this.view.z
            + (x - shown.clientWidth / 2) / this.view.scale]
    }

    /** Returns the 3D view; null while it is hidden. */
    scene() {
        return this.view.mode === 'space' ? this.view.scene() : null
    }

    canvas() {
        return this.picture.canvas()
    }

    position(event) {
        const box = this.canvas().getBoundingClientRect()
        return [event.clientX - box.left, event.clientY - box.top]
    }

    /** Finds the object at a pixel. @param without object to ignore in the 3D view */
    at(x, y, without) {
        const scene = this.scene()
        if (scene) {
            return pointing.inSpace(scene, this.world.shown() || NOTHING, x, y, without)
        }
        const point = this.onMap(x, y)
        return pointing.onMap(this.world.shown() || NOTHING, point[0], point[1])
    }

    /** Returns the ray of a pixel. @param height metres from which it starts downwards on the map */
    ray(x, y, height) {
        const scene = this.scene()
        const point = scene ? null : this.onMap(x, y)
        return scene ? pointing.ray(scene, x, y) : pointing.down(point[0], point[1], height)
    }

    /** Finds the object under the mouse. */
    under(event) {
        const p = this.position(event)
        return this.at(p[0], p[1])
    }

    middle() {
        const shown = this.canvas()
        return this.at(shown.clientWidth / 2, shown.clientHeight / 2)
        || {who: null, point: [0, 0, 0], ground: false, robot: null, local: null}
    }
}
