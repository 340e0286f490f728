import {makeEvent} from './event.js'
import {oncePerPicture} from './page.js'

/** The picture of the world, for those below the view: they ask for it, and the view draws it. */
export function makePicture($scope) {
    var view = null             // canvas(): the one that is shown, draw()
    var picture = {
        painted: makeEvent(),   // it was drawn just now
        drawnBy: function(one) {
            view = one
        },
        canvas: () => view.canvas(),
        /** Of the canvas, in pixels; 0 while the tab is not shown. */
        width: function() {
            var shown = view.canvas()
            return shown ? shown.clientWidth : 0
        },
        /** Draws with the browser's next picture, however much changes until then. */
        repaint: oncePerPicture(function() {
            view.draw()
            picture.painted.tell()
            $scope.$applyAsync()
        }),
        /** Nothing that is seen in the view has changed, but words and numbers beside it have. */
        retell: oncePerPicture(() => $scope.$applyAsync())
    }
    return picture
}
