// SPDX-License-Identifier: Apache-2.0
/** Makes the mouse, wheel and touch control of the views, and the text about the point under the mouse. */
export function makePointed(panel, world, ground, view) {
    var pointed = {text: ''}

    function tell(text) {
        if (text !== pointed.text) {
            pointed.text = text
            panel.scope.$applyAsync()
        }
    }
    function pointAtMap(x, y) {
        var shown = panel.element('view')
        var land = ground.of(world.shown())
        tell(land ? land.words(view.x - (y - shown.clientHeight / 2) / view.scale, view.z + (x - shown.clientWidth / 2) / view.scale) : '')
    }
    function pointAtScene(x, y) {
        var scene = view.scene()
        var found = scene && scene.pick(x, y)
        var land = found && !found.object ? ground.of(world.shown()) : null
        tell(!found ? '' : land ? land.words(found.point[0], found.point[2]) : found.object ? found.object.name + ', ' + found.object.type : '')
    }

    // ---- mouse, wheel, touch ---------------------------------------------------------------------------------------------------------------
    function listenToMap(shown) {
        var grip = null
        listenToWheel(shown)
        shown.addEventListener('mousedown', function(event) {
            grip = {x: event.clientX, y: event.clientY, at: {x: view.x, z: view.z}}
        })
        shown.addEventListener('mousemove', function(event) {
            if (grip && event.buttons) {
                view.moveTo(grip.at.x + (event.clientY - grip.y) / view.scale, grip.at.z - (event.clientX - grip.x) / view.scale)
            }
            var box = shown.getBoundingClientRect()
            pointAtMap(event.clientX - box.left, event.clientY - box.top)
        })
    }
    function listenToWheel(shown) {
        shown.addEventListener('wheel', function(event) {
            view.zoom(event.deltaY < 0 ? 1.15 : 1 / 1.15)
            event.preventDefault()
        })
    }

    /** Left button or one finger turns; other buttons, the Shift key or two fingers pan. */
    function listenToScene(shown) {
        var grip = null
        listenToWheel(shown)
        shown.addEventListener('contextmenu', function(event) {
            event.preventDefault()
        })
        shown.addEventListener('mousedown', function(event) {
            grip = {x: event.clientX, y: event.clientY}
        })
        shown.addEventListener('mousemove', function(event) {
            if (grip && event.buttons) {
                view.drag(event.clientX - grip.x, event.clientY - grip.y, event.buttons !== 1 || event.shiftKey)
                grip = {x: event.clientX, y: event.clientY}
            } else {
                var box = shown.getBoundingClientRect()
                pointAtScene(event.clientX - box.left, event.clientY - box.top)
            }
        })
        listenToFingers(shown)
    }
    function listenToFingers(shown) {
        var last = null
        function middle(touches) {
            var a = touches[0]
            var b = touches[1] || a
            return {count: touches.length, x: (a.clientX + b.clientX) / 2, y: (a.clientY + b.clientY) / 2,
                apart: Math.sqrt(Math.pow(a.clientX - b.clientX, 2) + Math.pow(a.clientY - b.clientY, 2))}
        }
        shown.addEventListener('touchstart', function(event) {
            last = middle(event.touches)
        })
        shown.addEventListener('touchmove', function(event) {
            var now = middle(event.touches)
            if (last && last.count === now.count) {
                view.drag(now.x - last.x, now.y - last.y, now.count > 1)
                if (now.count > 1 && last.apart > 0) {
                    view.zoom(now.apart / last.apart)
                }
            }
            last = now
            event.preventDefault()
        })
    }

    /** Adds the listeners once the canvases exist. */
    pointed.listen = function() {
        listenToMap(panel.element('view'))
        listenToScene(panel.element('scene'))
    }
    return pointed
}
