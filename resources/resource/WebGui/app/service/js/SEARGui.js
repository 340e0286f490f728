// Panel of the SEAR service: project, run control, a view from above, driving, the world as a tree, the sensors as a live table.
// First geometry and drawing, as functions of what they are given, then the controller. MyRobotLab loads this file; it loads SEARTerrain.js itself.
(function() {
    // ---- geometry --------------------------------------------------------------------------------------------------------------------------
    /** A pose [x, y, z, rx, ry, rz] in metres and degrees as [x, y, z, qx, qy, qz, qw], the rotation as jME's Quaternion.fromAngles. */
    function frame(pose) {
        var a = [3, 4, 5].map(function(i) {
            return pose[i] * Math.PI / 360
        })
        var s = a.map(Math.sin)
        var c = a.map(Math.cos)
        return [pose[0], pose[1], pose[2], c[1] * c[2] * s[0] + s[1] * s[2] * c[0], s[1] * c[2] * c[0] + c[1] * s[2] * s[0],
            c[1] * s[2] * c[0] - s[1] * c[2] * s[0], c[1] * c[2] * c[0] - s[1] * s[2] * s[0]]
    }

    function cross(a, b) {
        return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    }

    function rotate(pose, v) {
        var q = [pose[3], pose[4], pose[5]]
        var t = cross(q, v).map(function(value) {
            return 2 * value
        })
        var u = cross(q, t)
        return [v[0] + pose[6] * t[0] + u[0], v[1] + pose[6] * t[1] + u[1], v[2] + pose[6] * t[2] + u[2]]
    }

    function times(outer, inner) {
        var p = rotate(outer, inner)
        var a = outer.slice(3)
        var b = inner.slice(3)
        return [outer[0] + p[0], outer[1] + p[1], outer[2] + p[2],
            a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
            a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]]
    }

    /** Where a point that is fixed to something lies on the ground: [x, z]. */
    function onGround(pose, point) {
        var at = rotate(pose, point)
        return [pose[0] + at[0], pose[2] + at[2]]
    }

    /** The convex outline on the ground, [x, z] points in order. */
    function outline(object, pose) {
        var points = object.corners.map(function(corner) {
            return onGround(pose, corner)
        }).sort(function(a, b) {
            return a[0] - b[0] || a[1] - b[1]
        })
        return halfHull(points).concat(halfHull(points.reverse()))
    }

    function halfHull(points) {
        var hull = []
        points.forEach(function(p) {
            while (hull.length > 1 && turn(hull[hull.length - 2], hull[hull.length - 1], p) <= 0) {
                hull.pop()
            }
            hull.push(p)
        })
        hull.pop()
        return hull
    }

    function turn(a, b, c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    }

    /** Everything of a world that has a surface, with its outline on the ground; floors and terrains first, since all else lies on them. */
    function shapesOf(world) {
        var all = world.objects.map(shapeOf)
        world.robots.forEach(function(robot) {
            var body = frame(robot.pose)
            robot.parts.forEach(function(part) {
                all.push({color: colorOf(part, ROBOT), ground: false, robot: true, outline: outline(part, times(body, frame(part.pose)))})
            })
        })
        all = all.filter(function(shape) {
            return shape.outline.length > 2
        })
        return all.filter(isGround).concat(all.filter(isNoGround))
    }
    /** Of an object of the environment, made anew only when that has moved. */
    function shapeOf(object) {
        if (!object.$shape || object.$shape.pose !== object.pose) {
            var ground = object.type === 'Floor' || object.type === 'Terrain' || object.terrain
            object.$shape = {color: object.ground ? 'transparent' : colorOf(object, ground ? GROUND : object.color), ground: ground, robot: false, pose: object.pose,
                outline: outline(object, frame(object.pose))}
        }
        return object.$shape
    }
    /** An object's own colour, else another one. */
    function colorOf(object, other) {
        return object.colored ? object.color : other
    }
    function isGround(shape) {
        return shape.ground
    }
    function isNoGround(shape) {
        return !shape.ground
    }

    /** Has a view show everything but the ground; that too if there is nothing but robots on it. */
    function fit(view, shapes, element) {
        var things = shapes.filter(isNoGround)
        var points = [].concat.apply([], (things.some(isNoRobot) ? things : shapes).map(function(shape) {
            return shape.outline
        }))
        if (points.length) {
            var x = extent(points, 0)
            var z = extent(points, 1)
            view.x = x.middle
            view.z = z.middle
            view.scale = 0.92 * Math.min(element.clientHeight / x.length, element.clientWidth / z.length)
        }
        view.fitted = true
    }
    function isNoRobot(shape) {
        return !shape.robot
    }
    function extent(points, axis) {
        var low = Infinity
        var high = -Infinity
        points.forEach(function(point) {
            low = Math.min(low, point[axis])
            high = Math.max(high, point[axis])
        })
        return {middle: (low + high) / 2, length: Math.max(0.1, high - low)}
    }

    // ---- drawing: north (+x) up, east (+z) to the right ------------------------------------------------------------------------------------
    var GROUND = 'rgba(128, 128, 128, 0.12)'
    var ROBOT = 'rgba(51, 122, 183, 0.55)'
    var PATH = '#337ab7'
    var SMALLEST_ROBOT = 4      // pixels: one that looks smaller is a dot

    /** A function from metres on the ground to pixels of a canvas. */
    function projection(element, view) {
        var x0 = element.clientWidth / 2
        var y0 = element.clientHeight / 2
        return function(x, z) {
            return {x: x0 + (z - view.z) * view.scale, y: y0 - (x - view.x) * view.scale}
        }
    }

    /** @param world may be null @param terrain null without one @param beams whether to draw what the sensors see */
    function drawWorld(element, view, world, terrain, shapes, beams) {
        var ratio = window.devicePixelRatio || 1
        element.width = element.clientWidth * ratio
        element.height = element.clientHeight * ratio
        var pen = element.getContext('2d')
        pen.scale(ratio, ratio)
        var at = projection(element, view)
        var ink = window.getComputedStyle(element).color
        if (terrain) {
            terrain.draw(pen, at, areaOf(element, view), view.scale, isLight(ink))
        }
        drawGrid(pen, at, ink, element, view)
        if (!world) {
            return
        }
        shapes.forEach(function(shape) {
            drawShape(pen, at, ink, shape)
        })
        world.robots.forEach(function(robot) {
            trace(pen, robot.path.map(function(point) {
                return at(point[0], point[1])
            }))
            pen.strokeStyle = PATH
            pen.stroke()
        })
        if (beams) {
            world.sensors.forEach(function(sensor) {
                drawBeams(pen, at, sensor)
            })
        }
        world.robots.forEach(function(robot) {
            drawHeading(pen, at, ink, robot)
        })
    }

    /** What a canvas shows: its ends in metres. */
    function areaOf(element, view) {
        var up = element.clientHeight / 2 / view.scale
        var across = element.clientWidth / 2 / view.scale
        return {south: view.x - up, north: view.x + up, west: view.z - across, east: view.z + across}
    }

    /** Whether a colour as the browser says it is light: then the theme is dark. */
    function isLight(color) {
        var parts = (color.match(/[\d.]+/g) || [0, 0, 0]).map(Number)
        return parts[0] + parts[1] + parts[2] > 384
    }

    /** Makes points, in pixels, the present path. */
    function trace(pen, points) {
        pen.beginPath()
        points.forEach(function(point) {
            pen.lineTo(point.x, point.y)
        })
    }

    function drawGrid(pen, at, ink, element, view) {
        var step = 1
        while (step * view.scale < 40) {
            step *= String(step).charAt(0) === '2' ? 2.5 : 2      // 1, 2, 5, 10, ..
        }
        var across = element.clientWidth / 2 / view.scale
        var up = element.clientHeight / 2 / view.scale
        pen.beginPath()
        for (var z = Math.ceil((view.z - across) / step) * step; z <= view.z + across; z += step) {
            pen.moveTo(at(0, z).x, 0)
            pen.lineTo(at(0, z).x, element.clientHeight)
        }
        for (var x = Math.ceil((view.x - up) / step) * step; x <= view.x + up; x += step) {
            pen.moveTo(0, at(x, 0).y)
            pen.lineTo(element.clientWidth, at(x, 0).y)
        }
        pen.globalAlpha = 0.12
        pen.strokeStyle = ink
        pen.stroke()
        pen.globalAlpha = 0.8
        pen.fillStyle = ink
        pen.font = '12px sans-serif'
        pen.fillText('N ↑   grid ' + step + ' m', 8, 16)
        pen.globalAlpha = 1
    }

    function drawShape(pen, at, ink, shape) {
        trace(pen, shape.outline.map(function(point) {
            return at(point[0], point[1])
        }))
        pen.closePath()
        pen.fillStyle = shape.color
        pen.fill()
        pen.globalAlpha = 0.6
        pen.strokeStyle = ink
        pen.stroke()
        pen.globalAlpha = 1
    }

    function drawBeams(pen, at, sensor) {
        var pose = frame(sensor.pose)
        if (sensor.ranges) {
            drawScan(pen, at, pose, sensor)
        }
        angular.forEach(sensor.cones, function(cone) {
            drawCone(pen, at, pose, cone)
        })
        if (sensor.hit) {
            var hit = at(sensor.hit[0], sensor.hit[2])
            pen.fillStyle = '#d9534f'
            pen.fillRect(hit.x - 2.5, hit.y - 2.5, 5, 5)
        }
    }

    /** Where a beam ends, in pixels. @param degrees to the left of the sensor's forward axis */
    function beamEnd(at, pose, degrees, metres) {
        var angle = degrees * Math.PI / 180
        var end = onGround(pose, [Math.sin(angle) * metres, 0, Math.cos(angle) * metres])
        return at(end[0], end[1])
    }

    /** The beams that met something; where nothing was met there is a gap. */
    function drawScan(pen, at, pose, sensor) {
        var from = at(pose[0], pose[2])
        var ends = sensor.ranges.map(function(metres, i) {
            return metres === null ? null : beamEnd(at, pose, i * sensor.resolution - sensor.spread / 2, metres)
        })
        trace(pen, [from].concat(ends.map(function(end) {
            return end || from
        })))
        pen.closePath()
        pen.fillStyle = 'rgba(240, 173, 78, 0.18)'
        pen.fill()
        pen.fillStyle = '#f0ad4e'
        ends.forEach(function(end) {
            if (end) {
                pen.fillRect(end.x - 1.5, end.y - 1.5, 3, 3)
            }
        })
    }

    /** A cone of a sonar; one without width is a line. */
    function drawCone(pen, at, pose, cone) {
        var points = [at(pose[0], pose[2])]
        for (var i = -6; i <= 6; i++) {
            points.push(beamEnd(at, pose, (cone.yaw || 0) + cone.halfAngle * i / 6, cone.range))
        }
        trace(pen, points)
        pen.closePath()
        pen.fillStyle = 'rgba(217, 83, 79, 0.12)'
        pen.fill()
        pen.strokeStyle = 'rgba(217, 83, 79, 0.25)'
        pen.stroke()
    }

    function drawHeading(pen, at, ink, robot) {
        var ahead = onGround(frame(robot.pose), [0, 0, 0.3])
        var from = at(robot.pose[0], robot.pose[2])
        var end = at(ahead[0], ahead[1])
        if (Math.abs(end.x - from.x) + Math.abs(end.y - from.y) < SMALLEST_ROBOT) {
            pen.beginPath()
            pen.arc(from.x, from.y, SMALLEST_ROBOT, 0, 2 * Math.PI)
            pen.fillStyle = PATH
            pen.fill()
        }
        trace(pen, [from, end])
        pen.strokeStyle = ink
        pen.lineWidth = 2
        pen.stroke()
        pen.lineWidth = 1
        pen.fillStyle = ink
        pen.fillText(robot.name, from.x + 8, from.y - 8)
    }

    // ---- words -----------------------------------------------------------------------------------------------------------------------------
    var UNITS = {Distance: ['m', 3], Compass: ['°', 1], Accelerometer: ['m/s²', 3], Gyroscope: ['rad/s', 3], Odometer: ['m', 3]}
    var NO_BREAK = '\u00a0'
    var PLAIN = ['', 6]         // of a sensor that somebody has added

    /** A sensor's reading for people, with its unit and as many digits as it has sense in. */
    function readingText(sensor) {
        if (sensor.ranges) {
            var near = sensor.ranges.filter(function(metres) {
                return metres !== null
            })
            return sensor.ranges.length + ' beams, ' + (near.length ? 'nearest ' + Math.min.apply(null, near).toFixed(3) + ' m' : 'nothing in range')
        }
        if (sensor.hit === null) {
            return 'nothing within ' + Math.round(sensor.value * 1e3) / 1e3 + ' m'
        }
        var values = angular.isArray(sensor.value) ? sensor.value : String(sensor.value).split(',')
        if (sensor.type === 'GPS') {
            return fixed(values[0], 7) + '°, ' + fixed(values[1], 7) + '°, ' + fixed(values[2], 2) + NO_BREAK + 'm'
        }
        var unit = Object.prototype.hasOwnProperty.call(UNITS, sensor.type) ? UNITS[sensor.type] : PLAIN
        return values.map(function(value) {
            return isNaN(value) ? value : unit === PLAIN ? String(Number(Number(value).toPrecision(PLAIN[1]))) : fixed(value, unit[1])
        }).join(', ') + (unit[0] && unit[0] !== '°' ? NO_BREAK : '') + unit[0]
    }

    /** So many digits behind the point, without the sign of a zero. */
    function fixed(value, digits) {
        var text = Number(value).toFixed(digits)
        return Number(text) === 0 ? text.replace('-', '') : text
    }

    function count(number, thing) {
        return number + ' ' + thing + (number === 1 ? '' : 's')
    }

    // ---- files -----------------------------------------------------------------------------------------------------------------------------
    function bytes(base64) {
        return Uint8Array.from(window.atob(base64), function(one) {
            return one.charCodeAt(0)
        })
    }

    /** The last part of a path. */
    function fileName(path) {
        return path.split(/[\\/]/).pop()
    }

    /** Has the browser save a file. @param parts of it, in base64 */
    function saveFile(name, parts) {
        var link = document.createElement('a')
        link.href = window.URL.createObjectURL(new Blob(parts.map(bytes), {type: 'application/zip'}))
        link.download = name
        document.body.appendChild(link)
        link.click()
        document.body.removeChild(link)
        setTimeout(function() {
            window.URL.revokeObjectURL(link.href)
        }, 60000)
    }

    // ---- the panel -------------------------------------------------------------------------------------------------------------------------
    var SPEED = 0.2             // m/s of the drive buttons, MyRobotLab's Roomba default
    var STRAIGHT = 1e6          // metres: JSON has no infinity
    var DRIVES = {forward: [SPEED, STRAIGHT], backward: [-SPEED, STRAIGHT], left: [SPEED, 0], right: [-SPEED, 0], stop: [0, STRAIGHT]}
    var KEYS = {h: 'left', k: 'right', u: 'forward', j: 'backward', ';': 'stop', enter: 'reset'}
    var CHUNK = 256 * 1024      // characters; MyRobotLab takes messages up to 1 MiB
    var RECENT = 'sear.recentProjects'
    var NEW = 'project.sear'
    var MOST_RECENT = 8
    var MOST_MESSAGES = 100
    var REPEATED = 'could not invoke '      // so MyRobotLab begins to say once more that a call has failed
    var MOST_LISTED = 100       // objects of the world; the others on request
    var PATH_STEP = 0.02        // metres; as the service has it
    var LONGEST_PATH = 500      // points
    var LOOK_MILLIS = 1000      // how often a page that shows the project asks whether that has changed
    var PATIENCE_MILLIS = 10000 // an answer that takes longer is asked for again
    var WAIT_MILLIS = 1500         // so long time stands still in lock-step before the page says so
    var TOPICS = ['publishSimulation', 'getWorld', 'publishStatus', 'publishProblems', 'publishUploaded', 'getPreview', 'getProblems', 'getExamples',
        'getExampleScripts', 'getBundle', 'getTerrain', 'saveProject', 'saveProjectAs', 'loadProject', 'newProject', 'copyTemplate',
        'startSimulation', 'stopSimulation']

    angular.module('mrlapp.service.SEARGui', []).controller('SEARGuiCtrl', ['$scope', '$timeout', '$interval', 'mrl', SEARGuiCtrl])

    function SEARGuiCtrl($scope, $timeout, $interval, mrl) {
        var self = this
        var msg = this.msg

        $scope.form = {path: NEW, speed: '1', example: '', script: '', template: 'userCode.py', folder: 'SEARproject', beams: true, follow: false,
            robot: null}        // the one that is driven and followed
        $scope.state = null         // of the running world
        $scope.preview = null       // the project as it would start: stamp, world, problems, reason
        $scope.examples = []
        $scope.scripts = []         // names of the examples that drive
        $scope.problems = []        // what a call found wrong
        $scope.messages = []        // newest first
        $scope.last = null          // the newest one as a line
        $scope.question = null      // a file that is to be overwritten: path, and free, a name that is not taken
        $scope.listed = MOST_LISTED
        $scope.transfer = null
        $scope.pending = null       // what the service has been told to do and has not done yet: starting or stopping
        $scope.recent = readRecent()
        $scope.view = {x: 0, z: 0, scale: 60, fitted: false}

        // ---- messages from the service -----------------------------------------------------------------------------------------------------
        var handlers = {
            onState: function(service) {
                self.updateState(service)
            },
            onSimulation: onSimulation,
            onWorld: onWorld,
            onPreview: onPreview,
            onStartSimulation: settle,
            onStopSimulation: settle,
            onProblems: onProblems,
            onStatus: onStatus,
            onBundle: onBundle,
            onTerrain: onTerrain,
            onExamples: function(paths) {
                $scope.examples = paths || []
            },
            onExampleScripts: function(names) {
                $scope.scripts = names || []
                $scope.form.script = $scope.form.script || $scope.scripts[0]
            },
            onUploaded: function(text) {
                $scope.transfer = null
                if (asked.upload) {
                    $scope.form.path = asked.upload
                }
                asked.upload = null
                say('info', text)
            },
            onSaveProject: function() {
                say('info', 'saved by another page')
            },
            onSaveProjectAs: onSaved,
            onLoadProject: onLoaded,
            onNewProject: function(backup) {
                if (asked.anew) {
                    $scope.form.path = NEW
                }
                asked.anew = false
                say('info', 'an empty project' + (backup ? '; the former one is kept in ' + backup : ''))
            },
            onCopyTemplate: function(path) {
                say('info', 'copied to ' + path)
            }
        }

        this.onMsg = function(inMsg) {
            var handler = Object.prototype.hasOwnProperty.call(handlers, inMsg.method) && handlers[inMsg.method]
            if (handler) {
                handler(inMsg.data && inMsg.data[0])
                if (handler !== onSimulation && handler !== onWorld) {     // which may come faster than the screen is drawn
                    $scope.$applyAsync()
                }
            }
        }

        /** The service has done what it was told, whatever has happened since. */
        function settle() {
            $scope.pending = null
        }

        this.updateState = function(service) {
            $scope.service = service
            if ($scope.pending === (service.simulating ? 'starting' : 'stopping')) {    // another state was on its way before
                $scope.pending = null
            }
            if (!service.simulating) {
                $scope.state = null
                look()
            }
            repaint()
        }

        var told = false            // whether the service has said why a call failed, and MyRobotLab has not repeated that yet
        function onStatus(status) {
            var text = status && (status.key || status.detail)
            if (!text) {
                return
            }
            if (status.level === 'error') {
                $scope.transfer = null
                $scope.pending = null
                asked = {}
                var repeats = text.indexOf(REPEATED) === 0
                var wasTold = told
                told = !repeats
                if (repeats && wasTold) {
                    return
                }
            }
            var problems = $scope.allProblems()
            var listed = problems.length > 1 && text.indexOf(problems[0].file) === 0
            say(status.level, listed ? 'the project has ' + count(problems.length, 'problem') + ', listed below' : text)
        }

        var said = 0
        function say(level, text) {
            var newest = $scope.messages[0]
            if (newest && newest.text === text && newest.level === level) {
                newest.times++
                newest.time = new Date()
            } else {
                $scope.messages.unshift({id: said++, level: level, text: text, time: new Date(), times: 1})
                $scope.messages.splice(MOST_MESSAGES)
            }
            $scope.last = {level: level, text: text, line: text.split('\n')[0]}
        }
        $scope.clear = function() {
            $scope.messages = []
            $scope.last = null
        }

        // ---- problems ----------------------------------------------------------------------------------------------------------------------
        var checking = false
        $scope.check = function() {
            checking = true
            msg.send('getProblems')
        }
        function onProblems(problems) {
            $scope.problems = problems || []
            if (checking && !$scope.problems.length) {
                say('info', 'the project has no problems')
            }
            checking = false
        }
        /** What a call found wrong, else what is wrong with the project as it is. */
        $scope.allProblems = function() {
            return $scope.problems.length || isSimulating() || !$scope.preview ? $scope.problems : $scope.preview.problems
        }

        // ---- the running world -------------------------------------------------------------------------------------------------------------
        var speed = 1               // as the simulation has it
        var missing = 0             // when the whole was asked for, 0 if nothing is awaited
        /** The whole world, for a page that opens later: what was warned of until then, too. */
        function onWorld(state) {
            angular.forEach(state && state.warnings, function(text) {
                if (!$scope.messages.some(function(message) { return message.text === text })) {
                    say('warn', text)
                }
            })
            onSimulation(state)
        }

        /** Takes the whole of a world, or what has changed in the one that is shown. */
        function onSimulation(state) {
            if (!state || !state.running || !isSimulating()) {
                $scope.state = null
            } else if (!state.changes) {
                missing = 0
                if (!$scope.state) {
                    show(state)
                }
                $scope.state = state
            } else if ($scope.state && state.number <= $scope.state.number) {
                return              // it came after the whole that has it already
            } else if ($scope.state && state.number === $scope.state.number + 1) {
                change($scope.state, state)
            } else {
                askForWorld()
            }
            if ($scope.state && $scope.state.wantedSpeed !== speed) {
                speed = $scope.state.wantedSpeed
                $scope.form.speed = String(speed)
            }
            watchTime($scope.state)
            repaint()
        }

        var moved = 0               // when simulated time was seen to pass, by this page's clock
        var seenTime = null
        /** In lock-step time stands still unless a script lets it pass. */
        function watchTime(state) {
            var waited = $scope.waiting
            if (!state || state.time !== seenTime) {
                seenTime = state && state.time
                moved = Date.now()
            }
            $scope.waiting = Boolean(state && state.lockStep && !state.paused && Date.now() - moved > WAIT_MILLIS)
            if ($scope.waiting !== waited) {
                $scope.$applyAsync()
            }
        }
        /** Nobody waits for the script any more: time runs by itself. */
        $scope.letTimeRun = function() {
            msg.send('setSpeed', 1)
            msg.send('setLockStep', false)
        }

        function askForWorld() {
            if (Date.now() - missing > PATIENCE_MILLIS) {
                missing = Date.now()
                msg.send('getWorld')
            }
        }

        function change(state, message) {
            angular.forEach(message.changes, function(changed, list) {
                angular.forEach(changed, function(values, index) {
                    angular.extend(state[list][index], values)
                })
            })
            state.robots.forEach(extendPath)
            angular.extend(state, message)
            delete state.changes
        }

        /** As the service does it for pages that open later. */
        function extendPath(robot) {
            var path = robot.path
            var last = path[path.length - 1]
            if (Math.sqrt(Math.pow(last[0] - robot.pose[0], 2) + Math.pow(last[1] - robot.pose[2], 2)) > PATH_STEP) {
                path.push([robot.pose[0], robot.pose[2]])
            }
            if (path.length > LONGEST_PATH) {
                robot.path = path.filter(function(one, i) {
                    return i === 0 || i === path.length - 1 || (path.length - 2 - i) % 2
                })
            }
        }

        function isSimulating() {
            return Boolean($scope.service && $scope.service.simulating)
        }
        $scope.statusText = function() {
            return $scope.pending || (!isSimulating() ? 'no simulation runs' : $scope.service.paused ? 'paused' :
                $scope.waiting ? 'time waits for a script' : 'running')
        }
        /** Goes on where the status ends; apart from it, since that is read out when it changes. */
        $scope.timeText = function() {
            var state = $scope.pending ? null : $scope.state
            return state ? ' at ' + state.time.toFixed(2) + ' s' + (state.speed ? ', ' + state.speed.toFixed(1) + ' × real time' : '') : ''
        }
        $scope.reading = readingText

        $scope.start = function() {
            $scope.problems = []
            $scope.pending = 'starting'
            msg.send('startSimulation')
        }
        $scope.stop = function() {
            $scope.pending = 'stopping'
            msg.send('stopSimulation')
        }
        $scope.setSpeed = function() {
            msg.send('setSpeed', Number($scope.form.speed))
        }
        $scope.drive = function(way) {
            if (way === 'reset') {
                msg.send('reset')
            } else {
                msg.send.apply(msg, ['drive'].concat($scope.form.robot || [], DRIVES[way]))
            }
        }
        $scope.key = function(event) {
            var way = KEYS[(event.key || '').toLowerCase()]
            if (way && isSimulating() && !event.ctrlKey && !event.altKey && !event.metaKey) {
                $scope.drive(way)
                event.preventDefault()
            }
        }

        // ---- the project as it would start, while nothing runs -------------------------------------------------------------------------------
        var lookedAt = 0            // when it was asked for, 0 if nothing is awaited
        function look() {
            var now = Date.now()
            if (width() && !document.hidden && !isSimulating() && now - lookedAt > PATIENCE_MILLIS) {
                lookedAt = now
                msg.send('getPreview', $scope.preview ? $scope.preview.stamp : '')
            }
        }
        function onPreview(preview) {
            lookedAt = 0
            // each page gets the answers to all pages: only what has a world or says why not is one, else the page that asked has the newest
            if (preview && preview.problems && !isSimulating() && !angular.equals(preview, $scope.preview)) {
                $scope.preview = preview
                $scope.problems = []
                if (preview.world) {
                    show(preview.world)
                }
                repaint()
            }
        }

        /** The running world, else the project as it would start; null if it has none. */
        $scope.world = function() {
            return $scope.state || $scope.preview && $scope.preview.world
        }
        $scope.note = function() {
            var preview = $scope.preview
            if (isSimulating() || !preview) {
                return ''
            }
            if (preview.reason) {
                return 'Not running, and nothing to show: ' + preview.reason
            }
            if (!preview.world) {
                return 'Not running, and nothing to show: the project has ' + count(preview.problems.length, 'problem') + ', listed below'
            }
            if (!preview.world.objects.length && !preview.world.robots.length) {
                return 'Not running, and the project is empty: open one or an example above, drop a .sear file there, or create objects in a script'
            }
            return 'Not running: this is how the project starts, with the button Start or ' + $scope.service.name + '.startSimulation()'
        }

        // ---- projects ----------------------------------------------------------------------------------------------------------------------
        var asked = {}              // paths that this page wants saved and opened
        function readRecent() {
            try {
                return JSON.parse(window.localStorage.getItem(RECENT)) || []
            } catch (e) {
                return []
            }
        }
        function remember(path) {
            $scope.recent = [path].concat($scope.recent.filter(function(other) {
                return other !== path
            })).slice(0, MOST_RECENT)
            try {
                window.localStorage.setItem(RECENT, JSON.stringify($scope.recent))
            } catch (e) {
                say('warn', 'this browser does not remember recent projects: ' + e.message)
            }
        }
        $scope.load = function(path) {
            $scope.problems = []
            $scope.form.path = path
            remember(path)
            asked.load = path
            msg.send('loadProject', path)
        }
        /** What comes from an example is saved beside it, not over it. */
        function onLoaded() {
            say('info', 'opened ' + (asked.load || 'by another page'))
            if (asked.load && $scope.examples.indexOf(asked.load) >= 0) {
                $scope.form.path = fileName(asked.load)
            }
            asked.load = null
        }
        $scope.startAnew = function() {
            asked.anew = true
            msg.send('newProject')
        }

        var written = {}            // paths that this page has saved to: those it overwrites without asking
        $scope.saveProject = function() {
            $scope.saveTo($scope.form.path, Boolean(written[$scope.form.path]))
        }
        $scope.saveTo = function(path, overwrite) {
            $scope.question = null
            asked.save = path
            msg.send('saveProjectAs', path, overwrite)
        }
        $scope.cancel = function() {
            $scope.question = null
        }
        function onSaved(answer) {
            var mine = asked.save === answer.asked
            if (answer.saved) {
                say('info', mine ? 'saved ' + answer.path : 'saved by another page')
            }
            if (mine && answer.saved) {
                written[answer.path] = true
                $scope.form.path = answer.path
                remember(answer.path)
            } else if (mine) {
                $scope.question = answer
            }
            asked.save = mine ? null : asked.save
        }
        $scope.plain = function(script) {
            return script.replace(/\.py$/, '').replace(/_/g, ' ')
        }
        $scope.runScript = function() {
            say('info', 'running ' + $scope.form.script)
            msg.send('runExampleScript', $scope.form.script)
        }
        $scope.copyTemplate = function() {
            msg.send('copyTemplate', $scope.form.template, $scope.form.folder)
        }

        $scope.upload = function(file) {
            if (!file) {
                return
            }
            var reader = new FileReader()
            reader.onload = function() {
                var text = reader.result.substring(reader.result.indexOf(',') + 1)
                var parts = Math.max(1, Math.ceil(text.length / CHUNK))
                $scope.problems = []
                for (var i = 0; i < parts; i++) {
                    msg.send('uploadProject', file.name, i, parts, text.substring(i * CHUNK, (i + 1) * CHUNK))
                }
                $scope.transfer = 'loading ' + file.name
                asked.upload = file.name
                $scope.$applyAsync()
            }
            reader.onerror = function() {
                say('error', file.name + ' can\'t be read: ' + reader.error.message)
                $scope.$applyAsync()
            }
            reader.readAsDataURL(file)
        }

        var parts = null            // of the bundle that this page downloads
        $scope.download = function() {
            parts = []
            $scope.transfer = 'saving'
            msg.send('getBundle', 0)
        }
        function onBundle(part) {
            if (!parts || part.index !== parts.length) {
                return              // another page downloads
            }
            parts.push(part.data)
            if (parts.length < part.count) {
                $scope.transfer = 'saving, part ' + parts.length + ' of ' + part.count
                msg.send('getBundle', parts.length)
                return
            }
            saveFile(fileName($scope.form.path).replace(/(\.sear)?$/, '.sear'), parts)
            parts = null
            $scope.transfer = null
        }

        // ---- the view from above -----------------------------------------------------------------------------------------------------------
        function canvas() {
            return $scope.service ? document.getElementById('sear-view-' + $scope.service.name) : null
        }
        /** Of the canvas, in pixels; 0 while the tab is not shown. */
        function width() {
            var element = canvas()
            return element ? element.clientWidth : 0
        }

        /** Where a point of the ground lies on the canvas; also what tests compare with the robot's pose. */
        $scope.toScreen = function(x, z) {
            return projection(canvas(), $scope.view)(x, z)
        }
        $scope.zoom = function(factor) {
            $scope.view.scale = Math.min(2000, Math.max(0.002, $scope.view.scale * factor))
            $scope.view.chosen = true
            repaint()
        }
        $scope.fit = function() {
            $scope.view.fitted = false
            $scope.view.chosen = false
            repaint()
        }
        $scope.redraw = repaint

        /** Another world is to be seen: what the user has zoomed to stays as long as it has the same robots. */
        function show(world) {
            var view = $scope.view
            var robots = world.robots.map(function(robot) {
                return robot.name
            }).join('\n')
            if (!world.robots.some(isChosen)) {
                $scope.form.robot = world.robots.length ? world.robots[0].name : null
            }
            $scope.listed = MOST_LISTED
            view.chosen = Boolean(view.chosen && view.robots === robots)
            view.fitted = view.chosen
            view.robots = robots
        }

        function isChosen(robot) {
            return robot.name === $scope.form.robot
        }
        $scope.listAll = function() {
            $scope.listed = Infinity
        }

        var waiting = false
        /** Draws with the browser's next picture, however much changes until then. */
        function repaint() {
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
            if (!width()) {
                return
            }
            var element = canvas()
            var world = $scope.world()
            var shapes = world ? shapesOf(world) : []
            var view = $scope.view
            var size = element.clientWidth + ' ' + element.clientHeight
            if (view.size !== size) {
                view.size = size
                view.fitted = Boolean(view.fitted && view.chosen)
            }
            if (world && !view.fitted) {
                fit(view, shapes, element)
            }
            if (world && $scope.form.follow && world.robots.length) {
                var followed = world.robots.filter(isChosen)[0] || world.robots[0]
                view.x = followed.pose[0]
                view.z = followed.pose[2]
            }
            drawWorld(element, view, world, terrainOf(world), shapes, $scope.form.beams)
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
            if (!stamps.length || !window.SEARTerrain) {
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
                terrain = new window.SEARTerrain.Terrain(sent, repaint)
                repaint()
            }
        }
        function point(element, event) {
            var box = element.getBoundingClientRect()
            var view = $scope.view
            var ground = terrainOf($scope.world())
            var words = ground ? ground.words(view.x - (event.clientY - box.top - element.clientHeight / 2) / view.scale,
                view.z + (event.clientX - box.left - element.clientWidth / 2) / view.scale) : ''
            if (words !== $scope.pointed) {
                $scope.pointed = words
                $scope.$applyAsync()
            }
        }
        function loadTerrain() {
            if (!window.SEARTerrain) {
                var script = document.createElement('script')
                script.src = 'service/js/SEARTerrain.js'
                script.onload = repaint
                document.head.appendChild(script)
            }
        }

        // ---- what the page itself tells ----------------------------------------------------------------------------------------------------
        var first = null
        function listen() {
            var element = canvas()
            if (element) {
                listenToView(element)
                listenToFiles()
            } else {
                first = $timeout(listen, 100)
            }
        }
        function listenToView(element) {
            var grip = null
            element.addEventListener('wheel', function(event) {
                $scope.zoom(event.deltaY < 0 ? 1.15 : 1 / 1.15)
                event.preventDefault()
            })
            element.addEventListener('mousedown', function(event) {
                grip = {x: event.clientX, y: event.clientY, at: {x: $scope.view.x, z: $scope.view.z}}
            })
            element.addEventListener('mousemove', function(event) {
                if (grip && event.buttons) {
                    $scope.view.z = grip.at.z - (event.clientX - grip.x) / $scope.view.scale
                    $scope.view.x = grip.at.x + (event.clientY - grip.y) / $scope.view.scale
                    $scope.view.chosen = true
                    repaint()
                }
                point(element, event)
            })
        }
        function listenToFiles() {
            var drop = document.getElementById('sear-drop-' + $scope.service.name)
            drop.addEventListener('dragover', function(event) {
                event.preventDefault()
            })
            drop.addEventListener('drop', function(event) {
                event.preventDefault()
                $scope.upload(event.dataTransfer.files[0])
            })
            document.getElementById('sear-file-' + $scope.service.name).addEventListener('change', function(event) {
                $scope.upload(event.target.files[0])
                event.target.value = ''     // so that the same file can be chosen again
            })
        }

        loadTerrain()
        var theme = window.matchMedia('(prefers-color-scheme: dark)')
        var looks = $interval(look, LOOK_MILLIS, 0, false)
        first = $timeout(listen)
        theme.addEventListener('change', draw)
        window.addEventListener('resize', draw)
        $scope.$on('$destroy', function() {
            theme.removeEventListener('change', draw)
            window.removeEventListener('resize', draw)
            $interval.cancel(looks)
            $timeout.cancel(first)
        })
        $scope.$watch(width, function() {
            draw()
            look()
        })

        TOPICS.forEach(function(topic) {
            msg.subscribe(topic)
        })
        msg.subscribe(this)
        msg.send('getExamples')
        msg.send('getExampleScripts')
    }
})()
