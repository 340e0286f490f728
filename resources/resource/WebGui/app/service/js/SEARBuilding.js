// Mouse and keys that select, place, move, turn and size things in the views of the SEAR panel.
(function() {
    var geometry = window.SEARPanel.geometry
    var pointing = window.SEARPanel.pointing
    var places = window.SEARPanel.places
    var handles = window.SEARPanel.handles
    var CLICK = 4               // pixels: a mouse that moves less than this clicks
    var STEP = 0.05             // metres of an arrow key; a fifth of it with the alt key
    var TURN = 15               // degrees
    var SMALLEST = 0.05         // metres that a size snaps to, at least
    var NEAR = 10               // pixels of the map: what is selected and has no shape, or is below others, can be taken so near
    var PAUSE_MILLIS = 400      // several keys within this time are one edit
    var ARROWS = {ArrowLeft: [-1, 0, 0], ArrowRight: [1, 0, 0], ArrowUp: [0, 0, 1], ArrowDown: [0, 0, -1], PageUp: [0, 1, 0], PageDown: [0, -1, 0]}
    var AXES = ['x', 'y', 'z']

    /** Adds it to a panel. */
    window.SEARPanel.building = function(panel) {
        var $scope = panel.scope
        var drag = null             // what the mouse does with the selected object
        var grip = null             // where the mouse went down
        var nudged = null           // what the keys have done that is not sent yet
        var held = null             // where what is selected is shown until the service answers, whatever a running simulation tells meanwhile

        function found() {
            return pointing.find($scope.world(), $scope.selected)
        }
        function inSpace() {
            return $scope.mode === 'space' && $scope.scene()
        }
        /** What is under a pixel of the view that is shown. @param without what is looked through in space */
        function at(x, y, without) {
            var world = $scope.world() || {objects: [], robots: [], sensors: []}
            var scene = inSpace()
            if (scene) {
                return pointing.inSpace(scene, world, x, y, without)
            }
            var point = onMap(x, y)
            return pointing.onMap(world, point[0], point[1])
        }
        /** The point of the ground, [x, z], of a pixel of the map. */
        function onMap(x, y) {
            var shown = panel.canvas()
            return [$scope.view.x - (y - shown.clientHeight / 2) / $scope.view.scale, $scope.view.z + (x - shown.clientWidth / 2) / $scope.view.scale]
        }
        /** The ray of a pixel while something is dragged. */
        function ray(x, y) {
            var scene = inSpace()
            var point = scene ? null : onMap(x, y)
            return scene ? pointing.ray(scene, x, y) : pointing.down(point[0], point[1], drag.from[1] + 1)
        }
        /** What is under the mouse. */
        panel.under = function(event) {
            var p = position(event)
            return at(p[0], p[1])
        }
        panel.middle = function() {
            var shown = panel.canvas()
            return at(shown.clientWidth / 2, shown.clientHeight / 2) || {who: null, point: [0, 0, 0], ground: false, robot: null, local: null}
        }

        // ---- what is shown -----------------------------------------------------------------------------------------------------------------
        panel.decorate = function(scene, world) {
            var selected = found()
            handles.showAids(scene, world, $scope.building)
            window.SEARPanel.balance.show(scene, selected)
            handles.show(scene, selected, selected && extent(selected), selected && spots(selected))
        }
        panel.decorateMap = function(shown) {
            var selected = found()
            if (selected) {
                var pen = shown.getContext('2d')
                handles.draw(pen, selected, extent(selected), spots(selected), $scope.toScreen)
                window.SEARPanel.balance.draw(pen, selected, $scope.toScreen)
            }
        }
        /** With the size that the mouse gives it. */
        function extent(selected) {
            return drag && drag.extent || pointing.extent(selected.object)
        }
        function spots(selected) {
            var scene = inSpace()
            return handles.spots(selected, extent(selected), selected.object.type ? handles.sizesOf(panel.typeOf(selected.object.type)) : {},
                scene ? handles.inSpace(scene, selected) : handles.above($scope.view.scale))
        }
        /** Where the handle of what is selected is in the world; null if it has none of that name. */
        $scope.handle = function(name) {
            var selected = found()
            var spot = selected && spots(selected)[name]
            return spot ? handles.placed(selected, spot) : null
        }

        // ---- moving ------------------------------------------------------------------------------------------------------------------------
        function place(selected) {
            return places.of(selected, $scope.object.values, panel.isSimulating() && $scope.world() === $scope.state)
        }
        /** Shows it elsewhere until the service answers. @param shift in its parent's frame @param degrees that it is turned about y */
        function showMoved(start, shift, degrees) {
            var selected = found()
            if (!selected) {
                return
            }
            var isSensor = selected.robot && selected.robot.parts.indexOf(selected.object) < 0
            var way = isSensor ? geometry.rotate(selected.parent, shift) : shift
            var pose = start.slice()
            for (var i = 0; i < 3; i++) {
                pose[i] += way[i]
            }
            pose[4] += degrees
            held = {object: $scope.selected, pose: pose}
            panel.repaint()
        }
        /** Comes before the views are drawn. */
        panel.hold = function() {
            var selected = held && pointing.find($scope.world(), held.object)
            if (selected) {
                selected.object.pose = held.pose
            }
        }
        /** Sends what was changed. What was shown meanwhile goes back if it is refused. @param done start: its pose before, place: see places.of */
        function send(done, set) {
            panel.edit({'do': 'set', object: $scope.selected, set: places.edit(done.place, set), stand: done.place.stands && set.y === undefined},
                function(answer) {
                    if (!answer.done) {
                        showMoved(done.start, [0, 0, 0], 0)
                        panel.say('error', panel.refusal(answer))
                    }
                    panel.hold()
                    held = null
                })
        }

        function startDrag(event, x, y) {
            var scene = inSpace()
            var selected = found()
            if (!selected || !$scope.object || $scope.armed) {
                return null
            }
            var kind = scene ? handles.pick(scene, x, y) : handles.pickOnMap(selected, spots(selected), $scope.toScreen, x, y)
            var under = kind ? null : at(x, y)
            if (!kind && !isAt(selected, under, x, y)) {
                return null
            }
            return {kind: kind || 'move', start: selected.object.pose.slice(), place: place(selected), pose: selected.pose, parent: selected.parent,
                from: kind ? $scope.handle(kind) : under.point, up: event.shiftKey && Boolean(scene), set: null,
                extent: kind && kind !== 'turn' ? pointing.extent(selected.object) : null}
        }
        /** Whether what is selected is what was met at a pixel. */
        function isAt(selected, under, x, y) {
            if (under && under.who && (under.who.address === $scope.selected || under.who.robot === $scope.selected)) {
                return true
            }
            var pixel = inSpace() || !selected.robot ? null : $scope.toScreen(selected.pose[0], selected.pose[2])
            return Boolean(pixel) && Math.abs(pixel.x - x) < NEAR && Math.abs(pixel.y - y) < NEAR
        }
        function continueDrag(event, x, y) {
            var free = event.altKey
            if (drag.kind === 'turn') {
                turn(x, y, free)
            } else if (drag.kind === 'move') {
                move(x, y, free)
            } else {
                size(x, y, free)
            }
            panel.repaint()
        }
        function groundPoint(x, y) {
            return pointing.onPlane(ray(x, y), drag.from, [0, 1, 0])
        }
        function move(x, y, free) {
            var shift
            if (slideOnBody(x, y, free)) {
                return
            }
            if (drag.up) {
                shift = [0, pointing.alongAxis(ray(x, y), drag.from, [0, 1, 0]), 0]
            } else {
                var point = groundPoint(x, y)
                if (!point) {
                    return
                }
                shift = [point[0] - drag.from[0], 0, point[2] - drag.from[2]]
            }
            shift = pointing.back(drag.parent, shift)
            drag.set = {}
            AXES.forEach(function(axis, i) {
                if (Math.abs(shift[i]) > 1e-6 && (drag.up || axis !== 'y')) {
                    var value = panel.snapped(drag.place.at[i] + shift[i], free)
                    shift[i] = value - drag.place.at[i]
                    drag.set[axis] = panel.plain(value)
                }
            })
            showMoved(drag.start, shift, 0)
        }
        /** A sensor that is dragged over the body of its robot stays on it. @return whether there was one below the mouse */
        function slideOnBody(x, y, free) {
            var selected = found()
            var isSensor = selected && selected.robot && selected.robot.parts.indexOf(selected.object) < 0
            var under = isSensor && inSpace() && !drag.up ? at(x, y, selected.object) : null
            if (!under || under.robot !== selected.robot.name || !under.normal) {
                return false
            }
            drag.set = panel.mounted(under, panel.typeOf($scope.object.type), free)
            showMoved(drag.start, AXES.map(function(axis, i) {
                return Number(drag.set[axis]) - drag.place.at[i]
            }), drag.set.ry === undefined ? 0 : Number(drag.set.ry) - drag.place.ry)
            return true
        }
        function turn(x, y, free) {
            var point = groundPoint(x, y)
            if (!point) {
                return
            }
            function angle(of) {
                var v = pointing.back(drag.parent, [of[0] - drag.pose[0], 0, of[2] - drag.pose[2]])
                return Math.atan2(v[0], v[2]) * 180 / Math.PI
            }
            var ry = drag.place.ry + angle(point) - angle(drag.from)
            ry = places.wrapped($scope.snap && !free ? Math.round(ry / TURN) * TURN : ry)
            drag.set = {ry: panel.plain(ry)}
            showMoved(drag.start, [0, 0, 0], ry - drag.place.ry)
        }
        /** The side opposite to the handle stays where it is. */
        function size(x, y, free) {
            var i = AXES.indexOf(drag.kind)
            var what = handles.sizesOf(panel.typeOf($scope.object.type))[drag.kind]
            var values = $scope.object.values
            var scale = Number(values['scale' + 'XYZ'[i]]) || 1
            var unit = [0, 0, 0]
            unit[i] = 1
            var along = pointing.alongAxis(ray(x, y), drag.from, geometry.rotate(drag.pose, unit))
            var old = Number(values[what.name])
            var wanted = old + along / scale
            var value = $scope.snap && !free ? Math.max(SMALLEST, panel.snapped(wanted, false)) : Math.max(1e-3, wanted)
            var grown = (value - old) * scale
            drag.set = {}
            drag.set[what.name] = panel.plain(value)
            drag.extent = pointing.extent(found().object)
            drag.extent[1][i] += grown
            if (what.share !== 1) {
                drag.extent[0][i] -= grown
            } else {
                keepOpposite(geometry.rotate(geometry.frame(drag.start), unit), grown / 2)
            }
        }
        function keepOpposite(axis, shift) {
            AXES.forEach(function(name, i) {
                var stands = name === 'y' && $scope.object.values.onGround === 'true'
                if (Math.abs(axis[i] * shift) > 1e-6 && !stands) {
                    drag.set[name] = panel.plain(drag.place.at[i] + axis[i] * shift)
                }
            })
        }
        function endDrag() {
            var done = drag
            drag = null
            if (done.set && Object.keys(done.set).length) {
                send(done, done.set)
            } else {
                held = null
            }
            panel.repaint()
        }

        // ---- clicks ------------------------------------------------------------------------------------------------------------------------
        function click(event, x, y) {
            var under = at(x, y)
            if ($scope.armed) {
                if (under) {
                    panel.place(under, event.altKey)
                }
            } else {
                panel.select(choice(under && under.who))
            }
            $scope.$applyAsync()
        }
        /** A robot first, its parts once it is selected. */
        function choice(who) {
            if (!who) {
                return null
            }
            var selected = $scope.selected || ''
            var inside = who.robot && (selected === who.robot || selected.indexOf(who.robot + '/') === 0)
            return who.robot && !inside && !(who.object.cones || who.object.ranges) ? who.robot : who.address
        }

        function position(event) {
            var box = panel.canvas().getBoundingClientRect()
            return [event.clientX - box.left, event.clientY - box.top]
        }
        function down(event) {
            if (event.button !== 0 || event.target !== panel.canvas()) {
                return
            }
            var p = position(event)
            grip = {x: event.clientX, y: event.clientY, moved: false}
            drag = startDrag(event, p[0], p[1])
            if (drag) {
                event.stopPropagation()
            }
        }
        function moved(event) {
            if (grip && Math.abs(event.clientX - grip.x) + Math.abs(event.clientY - grip.y) >= CLICK) {
                grip.moved = true
            }
            if (drag) {
                event.stopPropagation()
                if (grip.moved) {
                    var p = position(event)
                    continueDrag(event, p[0], p[1])
                }
            }
        }
        function up(event) {
            var was = grip
            grip = null
            if (was && drag) {
                endDrag()
            }
            if (was && !was.moved && event.target === panel.canvas()) {
                var p = position(event)
                click(event, p[0], p[1])
            }
        }
        /** Comes before what turns and moves the views. @param around the element that holds the canvases */
        panel.listenToBuilding = function(around) {
            around.addEventListener('mousedown', down, true)
            window.addEventListener('mousemove', moved, true)
            window.addEventListener('mouseup', up, true)
            $scope.$on('$destroy', function() {
                window.removeEventListener('mousemove', moved, true)
                window.removeEventListener('mouseup', up, true)
            })
        }

        // ---- keys --------------------------------------------------------------------------------------------------------------------------
        /** Left and right, forth and back as one sees it, along the world's axes. */
        function direction(arrow) {
            var scene = inSpace()
            if (!scene || arrow[1]) {
                return scene || arrow[1] ? arrow : [arrow[2], 0, arrow[0]]
            }
            var azimuth = Math.round(scene.orbit.azimuth / (Math.PI / 2)) * Math.PI / 2
            var forth = [-Math.cos(azimuth), -Math.sin(azimuth)]
            return [forth[0] * arrow[2] - forth[1] * arrow[0], 0, forth[1] * arrow[2] + forth[0] * arrow[0]]
        }
        function nudge(arrow, fine) {
            var selected = found()
            if (!selected || !$scope.object) {
                return
            }
            if (!nudged) {
                nudged = {start: selected.object.pose.slice(), place: place(selected), shift: [0, 0, 0], object: $scope.selected}
            } else {
                clearTimeout(nudged.timer)
            }
            var shift = pointing.back(selected.parent, direction(arrow))
            for (var i = 0; i < 3; i++) {
                nudged.shift[i] += shift[i] * (fine ? STEP / 5 : STEP)
            }
            showMoved(nudged.start, nudged.shift, 0)
            nudged.timer = setTimeout(sendNudged, PAUSE_MILLIS)
        }
        function sendNudged() {
            var done = nudged
            nudged = null
            var set = {}
            AXES.forEach(function(axis, i) {
                if (Math.abs(done.shift[i]) > 1e-6) {
                    set[axis] = panel.plain(done.place.at[i] + done.shift[i])
                }
            })
            if (done.object === $scope.selected && Object.keys(set).length) {
                send(done, set)
            } else {
                held = null
            }
        }
        function turnBy(degrees) {
            if ($scope.object && $scope.object.values.ry !== undefined) {
                var selected = found()
                var now = place(selected)
                send({start: selected && selected.object.pose.slice(), place: now}, {ry: panel.plain(places.wrapped(now.ry + degrees))})
            }
        }
        /** @return whether it was a key of building */
        panel.buildKey = function(event) {
            var command = event.ctrlKey || event.metaKey
            var key = event.key.length === 1 ? event.key.toLowerCase() : event.key
            if (command && (key === 'z' || key === 'y')) {
                (key === 'y' || event.shiftKey ? $scope.redo : $scope.undo)()
            } else if (key === 'Escape' && ($scope.armed || $scope.selected)) {
                $scope.disarm()
                panel.select(null)
            } else if (!$scope.selected) {
                return false
            } else if (ARROWS[key] && !command) {
                nudge(ARROWS[key], event.altKey)
            } else if (key === '[' || key === ']') {
                turnBy(key === '[' ? TURN : -TURN)
            } else if (key === 'Delete') {
                $scope.remove()
            } else if (command && key === 'd') {
                $scope.duplicate()
            } else {
                return false
            }
            event.preventDefault()
            return true
        }
        return {}
    }
})()
