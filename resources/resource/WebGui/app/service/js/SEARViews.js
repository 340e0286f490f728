// The views of the SEAR panel: the one in space where the browser can do that, else the map; what mouse, fingers and keys do there.
(function() {
    var geometry = window.SEARPanel.geometry
    var map = window.SEARPanel.map
    var MODE = 'sear.view'      // where the browser remembers which one was chosen
    var MOST_LISTED = 100       // objects of the world; the others on request
    var LOOK_MILLIS = 1000      // how often a page that shows the project asks whether that has changed
    var PATIENCE_MILLIS = 10000 // an answer that takes longer is asked for again
    var TURN = 20               // pixels of a mouse that an arrow key stands for
    var ARROWS = {ArrowLeft: [-TURN, 0], ArrowRight: [TURN, 0], ArrowUp: [0, TURN], ArrowDown: [0, -TURN]}

    /** Adds it to a panel. @return what it does with messages */
    window.SEARPanel.views = function(panel) {
        var $scope = panel.scope
        var msg = panel.msg
        var scene = null            // made when it is first seen
        var fitted = {}             // by mode: whether that view shows everything, or what the user wants
        $scope.view = {x: 0, z: 0, scale: 60, fitted: false}
        $scope.listed = MOST_LISTED
        $scope.mode = firstMode()   // 'space' or 'map'
        $scope.noSpace = ''         // why there is no view in space

        function remembered() {
            try {
                return window.localStorage.getItem(MODE)
            } catch (e) {
                return null
            }
        }
        function firstMode() {
            var mode = remembered()
            return mode === 'map' || !window.SEARPanel.isScenePossible(mode !== 'space') ? 'map' : 'space'
        }
        $scope.setMode = function(mode) {
            if (mode === 'space' && !window.SEARPanel.isScenePossible(false)) {
                $scope.noSpace = 'This browser has no WebGL: the map is all that it can show'
                return
            }
            $scope.mode = mode
            try {
                window.localStorage.setItem(MODE, mode)
            } catch (e) {
                panel.say('warn', 'this browser does not remember the view: ' + e.message)
            }
            panel.timeout(function() {  // when the canvas is there
                panel.repaint()
            })
        }

        function element(kind) {
            return $scope.service ? document.getElementById('sear-' + kind + '-' + $scope.service.name) : null
        }
        function canvas() {
            return element($scope.mode === 'space' ? 'scene' : 'view')
        }
        panel.canvas = canvas
        /** Of the canvas, in pixels; 0 while the tab is not shown. */
        panel.width = function() {
            var shown = canvas()
            return shown ? shown.clientWidth : 0
        }
        /** Width and height of the canvas; changes when something beside it is folded, too. */
        function sizeOf() {
            var shown = canvas()
            return shown ? shown.clientWidth + ' ' + shown.clientHeight : ''
        }

        /** Where a point of the ground lies on the map; also what tests compare with the robot's pose. */
        $scope.toScreen = function(x, z) {
            return map.projection(element('view'), $scope.view)(x, z)
        }
        /** The view in space; null before it was seen. */
        $scope.scene = function() {
            return scene
        }
        $scope.zoom = function(factor) {
            if ($scope.mode === 'space' && scene) {
                scene.zoom(factor)
            } else {
                $scope.view.scale = Math.min(2000, Math.max(0.002, $scope.view.scale * factor))
            }
            $scope.view.chosen = true
            panel.repaint()
        }
        $scope.fit = function() {
            refit()
            $scope.view.chosen = false
            $scope.form.eye = ''
            panel.repaint()
        }
        $scope.redraw = function() {
            panel.repaint()
        }

        /** Another world is to be seen: what the user has zoomed to stays as long as it has the same robots. */
        panel.show = function(world) {
            var view = $scope.view
            var robots = world.robots.map(function(robot) {
                return robot.name
            }).join('\n')
            if (!world.robots.some(isChosen)) {
                $scope.form.robot = world.robots.length ? world.robots[0].name : null
            }
            $scope.listed = MOST_LISTED
            view.chosen = Boolean(view.chosen && (view.robots === robots || $scope.building))
            if (!view.chosen) {
                refit()
            }
            view.robots = robots
        }
        /** Each view shows everything when it is drawn next. */
        function refit() {
            $scope.view.fitted = false      // the one that is shown
            fitted = {}
        }

        function isChosen(robot) {
            return robot.name === $scope.form.robot
        }
        $scope.listAll = function() {
            $scope.listed = Infinity
        }

        // ---- drawing -----------------------------------------------------------------------------------------------------------------------
        var waiting = false
        /** Draws with the browser's next picture, however much changes until then. */
        panel.repaint = function() {
            if (!waiting) {
                waiting = true
                window.requestAnimationFrame(function() {
                    waiting = false
                    draw()
                    $scope.$applyAsync()
                })
            }
        }

        function draw() {
            var shown = canvas()
            if (!panel.width()) {
                return
            }
            var world = $scope.world()
            var view = $scope.view
            var size = sizeOf()
            if (view.size !== size && !view.chosen) {
                refit()
            }
            view.size = size
            if ($scope.building && (!world || !world.objects.length && !world.robots.length)) {
                fitted = {space: true, map: true}       // what is made first does not fill the view
            }
            panel.hold()
            if ($scope.mode === 'space') {
                drawScene(shown, world)
            } else {
                drawMap(shown, world)
            }
            view.fitted = Boolean(fitted[$scope.mode])
        }

        function followed(world) {
            return $scope.form.follow && world.robots.length ? Math.max(0, world.robots.findIndex(isChosen)) : -1
        }

        function drawMap(shown, world) {
            var view = $scope.view
            var shapes = world ? geometry.shapesOf(world) : []
            if (world && !fitted.map) {
                geometry.fit(view, shapes, shown)
                fitted.map = true
            }
            if (world && followed(world) >= 0) {
                var robot = world.robots[followed(world)]
                view.x = robot.pose[0]
                view.z = robot.pose[2]
            }
            map.draw(shown, view, world, terrainOf(world), shapes, $scope.form.beams)
            panel.decorateMap(shown)
        }

        function drawScene(shown, world) {
            if (!scene) {
                scene = new window.SEARPanel.Scene(shown, function(keys) {
                    msg.send('getLooks', keys)
                }, panel.repaint)
            }
            world = world || {objects: [], robots: [], sensors: []}
            var terrain = terrainOf(world)
            scene.show(world, terrain, $scope.form.beams)
            if (!fitted.space && (world.objects.length || world.robots.length)) {
                var area = geometry.area(geometry.shapesOf(world))
                if (area) {
                    scene.fit({x: area.x, y: heightOf(world, terrain, area), z: area.z, size: area.size})
                }
                fitted.space = true
            }
            panel.decorate(scene, world)
            scene.draw(eyes(world).indexOf($scope.form.eye), followed(world), geometry.isLight(window.getComputedStyle(shown).color))
        }

        /** Of what is looked at: that of the first robot, else that of the ground. */
        function heightOf(world, terrain, area) {
            return world.robots.length ? world.robots[0].pose[1] : terrain ? terrain.height(area.x, area.z) || 0 : 0
        }

        function eyes(world) {
            return world.sensors.map(function(sensor) {
                return sensor.name
            })
        }
        /** Names of the sensors through whose eyes one may look. */
        $scope.eyes = function() {
            var world = $scope.world()
            return world ? eyes(world) : []
        }

        // ---- the ground --------------------------------------------------------------------------------------------------------------------
        var terrain = null          // what the service has sent last, ready for use
        var awaited = {}            // which has been asked for, and when
        $scope.pointed = ''         // what is under the pointer
        $scope.terrain = function() {
            return terrain
        }
        /** The ground of a world, which is asked for when it is first seen; null if there is none or it has not come yet. */
        function terrainOf(world) {
            var stamps = world ? world.objects.map(function(object) {
                return object.ground
            }).filter(Boolean) : []
            if (!stamps.length) {
                return null
            }
            if (terrain && terrain.sent.stamp === stamps[0]) {
                return terrain
            }
            if (awaited.stamp !== stamps[0] || Date.now() - awaited.since > PATIENCE_MILLIS) {
                awaited = {stamp: stamps[0], since: Date.now()}
                msg.send('getTerrain')
            }
            return null
        }
        /** Each page gets the answers to all pages. */
        function onTerrain(sent) {
            if (sent && sent.stamp && sent.stamp === awaited.stamp && !(terrain && terrain.sent.stamp === sent.stamp)) {
                terrain = new window.SEARTerrain.Terrain(sent, panel.repaint)
                panel.repaint()
            }
        }

        // ---- the pointer -------------------------------------------------------------------------------------------------------------------
        function tell(text) {
            if (text !== $scope.pointed) {
                $scope.pointed = text
                $scope.$applyAsync()
            }
        }
        function pointAtMap(x, y) {
            var view = $scope.view
            var shown = element('view')
            var ground = terrainOf($scope.world())
            tell(ground ? ground.words(view.x - (y - shown.clientHeight / 2) / view.scale, view.z + (x - shown.clientWidth / 2) / view.scale) : '')
        }
        function pointAtScene(x, y) {
            var found = scene && scene.pick(x, y)
            var ground = found && !found.object ? terrainOf($scope.world()) : null
            tell(!found ? '' : ground ? ground.words(found.point[0], found.point[2]) : found.object ? found.object.name + ', ' + found.object.type : '')
        }

        function listenToMap(shown) {
            var grip = null
            listenToWheel(shown)
            shown.addEventListener('mousedown', function(event) {
                grip = {x: event.clientX, y: event.clientY, at: {x: $scope.view.x, z: $scope.view.z}}
            })
            shown.addEventListener('mousemove', function(event) {
                if (grip && event.buttons) {
                    $scope.view.z = grip.at.z - (event.clientX - grip.x) / $scope.view.scale
                    $scope.view.x = grip.at.x + (event.clientY - grip.y) / $scope.view.scale
                    $scope.view.chosen = true
                    panel.repaint()
                }
                var box = shown.getBoundingClientRect()
                pointAtMap(event.clientX - box.left, event.clientY - box.top)
            })
        }
        function listenToWheel(shown) {
            shown.addEventListener('wheel', function(event) {
                $scope.zoom(event.deltaY < 0 ? 1.15 : 1 / 1.15)
                event.preventDefault()
            })
        }

        /** Left button or one finger: turn; other buttons, the shift key or two fingers: move. */
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
                    drag(event.clientX - grip.x, event.clientY - grip.y, event.buttons !== 1 || event.shiftKey)
                    grip = {x: event.clientX, y: event.clientY}
                } else {
                    var box = shown.getBoundingClientRect()
                    pointAtScene(event.clientX - box.left, event.clientY - box.top)
                }
            })
            listenToFingers(shown)
        }
        function drag(right, down, moves) {
            if (scene) {
                scene[moves ? 'pan' : 'turn'](right, down)
                $scope.form.eye = ''
                $scope.view.chosen = true
                panel.repaint()
            }
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
                    drag(now.x - last.x, now.y - last.y, now.count > 1)
                    if (now.count > 1 && last.apart > 0) {
                        $scope.zoom(now.apart / last.apart)
                    }
                }
                last = now
                event.preventDefault()
            })
        }
        /** Arrow keys turn the view in space, + and - zoom; all others drive. */
        $scope.viewKey = function(event) {
            if (panel.buildKey(event)) {
                return
            }
            if (ARROWS[event.key] && $scope.mode === 'space') {
                drag(ARROWS[event.key][0], ARROWS[event.key][1], event.shiftKey)
                event.preventDefault()
            } else if (event.key === '+' || event.key === '-') {
                $scope.zoom(event.key === '+' ? 1.3 : 1 / 1.3)
            } else {
                $scope.key(event)
            }
        }

        // ---- what the page itself tells ----------------------------------------------------------------------------------------------------
        var first = null
        function listen() {
            if (element('view')) {
                listenToMap(element('view'))
                listenToScene(element('scene'))
                panel.listenToFiles()
                panel.listenToBuilding(element('view').parentNode)
                panel.repaint()
            } else {
                first = panel.timeout(listen, 100)
            }
        }

        var theme = window.matchMedia('(prefers-color-scheme: dark)')
        var looks = panel.interval(panel.look, LOOK_MILLIS, 0, false)
        first = panel.timeout(listen)
        theme.addEventListener('change', panel.repaint)
        window.addEventListener('resize', panel.repaint)    // which digests, too, and so measures
        $scope.$on('$destroy', function() {
            theme.removeEventListener('change', panel.repaint)
            window.removeEventListener('resize', panel.repaint)
            panel.interval.cancel(looks)
            panel.timeout.cancel(first)
            if (scene) {
                scene.close()
            }
        })
        $scope.$watch(sizeOf, function() {
            draw()
            panel.look()
        })

        return {
            onTerrain: onTerrain,
            onLooks: function(sent) {
                if (scene) {
                    scene.looks.take(sent)
                }
            }
        }
    }
})()
