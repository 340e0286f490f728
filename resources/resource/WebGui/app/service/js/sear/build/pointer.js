// SPDX-License-Identifier: Apache-2.0
import * as pointing from '../world/pointing.js'

var NOTHING = {objects: [], robots: [], sensors: []}

/** Finds objects under points of the shown view, 3D or map. Points are pixels of its canvas. */
export function makePointer(world, view, picture) {
    /** Returns the ground point [x, z] of a pixel of the map. */
    function onMap(x, y) {
        var shown = picture.canvas()
        return [view.x - (y - shown.clientHeight / 2) / view.scale, view.z + (x - shown.clientWidth / 2) / view.scale]
    }
    var pointer = {
        canvas: picture.canvas,
        /** Returns the 3D view; null while it is hidden. */
        scene: () => view.mode === 'space' ? view.scene() : null,
        position: function(event) {
            var box = picture.canvas().getBoundingClientRect()
            return [event.clientX - box.left, event.clientY - box.top]
        },
        /** Finds the object at a pixel. @param without object to ignore in the 3D view */
        at: function(x, y, without) {
            var scene = pointer.scene()
            if (scene) {
                return pointing.inSpace(scene, world.shown() || NOTHING, x, y, without)
            }
            var point = onMap(x, y)
            return pointing.onMap(world.shown() || NOTHING, point[0], point[1])
        },
        /** Returns the ray of a pixel. @param height metres from which it starts downwards on the map */
        ray: function(x, y, height) {
            var scene = pointer.scene()
            var point = scene ? null : onMap(x, y)
            return scene ? pointing.ray(scene, x, y) : pointing.down(point[0], point[1], height)
        },
        /** Finds the object under the mouse. */
        under: function(event) {
            var p = pointer.position(event)
            return pointer.at(p[0], p[1])
        },
        middle: function() {
            var shown = picture.canvas()
            return pointer.at(shown.clientWidth / 2, shown.clientHeight / 2) || {who: null, point: [0, 0, 0], ground: false, robot: null, local: null}
        }
    }
    return pointer
}
