// SPDX-License-Identifier: Apache-2.0
import {makeEvent} from './event.js'
import {oncePerPicture} from './page.js'

/** Redraw requests from the parts below the view, which draws the world. */
export function makePicture($scope) {
    var view = null             // canvas(): the shown one, draw()
    var picture = {
        painted: makeEvent(),   // after each drawing
        drawnBy: function(one) {
            view = one
        },
        canvas: () => view.canvas(),
        /** Returns the canvas width in pixels; 0 while the tab is hidden. */
        width: function() {
            var shown = view.canvas()
            return shown ? shown.clientWidth : 0
        },
        /** Redraws in the next animation frame, once however much changes. */
        repaint: oncePerPicture(function() {
            view.draw()
            picture.painted.tell()
            $scope.$applyAsync()
        }),
        /** Updates the texts beside the view without redrawing it. */
        retell: oncePerPicture(() => $scope.$applyAsync())
    }
    return picture
}
