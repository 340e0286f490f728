// SPDX-License-Identifier: Apache-2.0
import {Listeners} from './listeners.js'
import {oncePerPicture} from './page.js'

/** Redraw requests from the parts below the view, which draws the world. */
export class Picture {
    constructor($scope) {
        this.view = null        // canvas(): the shown one, draw()
        this.painted = new Listeners() // after each drawing
        /** Redraws in the next animation frame, once however much changes. */
        this.repaint = oncePerPicture(() => {
            this.view.draw()
            this.painted.tell()
            $scope.$applyAsync()
        })
        /** Updates the texts beside the view without redrawing it. */
        this.retell = oncePerPicture(() => $scope.$applyAsync())
    }

    drawnBy(one) {
        this.view = one
    }

    canvas() {
        return this.view.canvas()
    }

    /** Returns the canvas width in pixels; 0 while the tab is hidden. */
    width() {
        const shown = this.view.canvas()
        return shown ? shown.clientWidth : 0
    }
}
