// Panel of the SEAR service: project, run control, a view from above, driving, the world as a tree, the sensors as a live table.
angular.module('mrlapp.service.SEARGui', []).controller('SEARGuiCtrl', ['$scope', '$timeout', 'mrl', function($scope, $timeout, mrl) {
    var self = this
    var msg = this.msg

    var SPEED = 0.2             // m/s of the drive buttons, MyRobotLab's Roomba default
    var STRAIGHT = 1e6          // metres: JSON has no infinity
    var CHUNK = 256 * 1024      // characters; MyRobotLab takes messages up to 1 MiB
    var RECENT = 'sear.recentProjects'
    var KEYS = {h: 'left', k: 'right', u: 'forward', j: 'backward', ';': 'stop', Enter: 'reset'}
    var DRIVES = {forward: [SPEED, STRAIGHT], backward: [-SPEED, STRAIGHT], left: [SPEED, 0], right: [-SPEED, 0], stop: [0, STRAIGHT]}

    $scope.form = {path: 'project.sear', speed: '1', example: '', template: 'userCode.py', folder: 'SEARproject', beams: true, follow: false}
    var asked = {}              // paths that this page wants saved and opened
    $scope.state = null
    $scope.examples = []
    $scope.problems = []
    $scope.messages = []
    $scope.transfer = null
    $scope.recent = readRecent()
    $scope.view = {x: 0, z: 0, scale: 60, fitted: false}

    this.updateState = function(service) {
        $scope.service = service
        if (!service.simulating) {
            $scope.state = null
            $scope.view.fitted = false
        }
        $timeout(draw)
    }

    this.onMsg = function(inMsg) {
        var data = inMsg.data && inMsg.data[0]
        switch (inMsg.method) {
        case 'onState':
            self.updateState(data)
            break
        case 'onSimulation':
            onSimulation(data)
            return
        case 'onProblems':
            onProblems(data || [])
            break
        case 'onExamples':
            $scope.examples = data || []
            break
        case 'onUploaded':
            $scope.transfer = null
            say('info', data)
            break
        case 'onSaveProject':
            say('info', 'saved ' + (asked.save || 'by another page'))
            asked.save = null
            break
        case 'onLoadProject':
            say('info', 'opened ' + (asked.load || 'by another page'))
            asked.load = null
            break
        case 'onNewProject':
            say('info', 'an empty project' + (data ? '; the former one is kept in ' + data : ''))
            break
        case 'onCopyTemplate':
            say('info', 'copied to ' + data)
            break
        case 'onBundle':
            onBundle(data)
            break
        case 'onStatus':
            if (data && data.detail) {
                onStatus(data)
            }
            break
        default:
            return
        }
        $scope.$applyAsync()
    }

    var lastError = ''
    function onStatus(status) {
        if (status.level === 'error') {
            // MyRobotLab tells of a call that failed what the service has told already
            var again = lastError && status.detail !== lastError && status.detail.slice(-lastError.length) === lastError
            lastError = status.detail
            if (again) {
                return
            }
        }
        var listed = $scope.problems.length && status.detail.indexOf($scope.problems[0].file) === 0
        if (status.level === 'error') {
            $scope.transfer = null
        }
        say(status.level, listed ? 'the project has ' + $scope.problems.length + ' problem(s), listed below' : status.detail)
    }

    function onProblems(problems) {
        $scope.problems = problems
        if (checking && !problems.length) {
            say('info', 'the project has no problems')
        }
        checking = false
    }

    function say(level, text) {
        $scope.messages.unshift({level: level, text: text})
        $scope.messages.splice(6)
    }
    $scope.clear = function() {
        $scope.messages = []
    }

    // ---- the running world -----------------------------------------------------------------------------------------------------------------
    var waiting = false
    var speed = 1               // as the simulation has it
    function onSimulation(state) {
        $scope.state = state && state.running ? state : null
        if ($scope.state && state.wantedSpeed !== speed) {
            speed = state.wantedSpeed
            $scope.form.speed = String(speed)
        }
        if (!waiting) {
            waiting = true
            window.requestAnimationFrame(function() {
                waiting = false
                draw()
                $scope.$applyAsync()
            })
        }
    }

    $scope.statusText = function() {
        if (!$scope.service || !$scope.service.simulating) {
            return 'no simulation runs'
        }
        var state = $scope.state
        return ($scope.service.paused ? 'paused' : 'running') + (state ? ' at ' + state.time.toFixed(2) + ' s' : '')
            + (state && state.speed ? ', ' + state.speed.toFixed(1) + ' × real time' : '')
    }

    $scope.start = function() {
        $scope.problems = []
        msg.send('startSimulation')
    }
    $scope.setSpeed = function() {
        msg.send('setSpeed', Number($scope.form.speed))
    }
    $scope.drive = function(way) {
        if (way === 'reset') {
            msg.send('reset')
        } else {
            msg.send('drive', DRIVES[way][0], DRIVES[way][1])
        }
    }
    $scope.key = function(event) {
        var way = KEYS[event.key] || KEYS[(event.key || '').toLowerCase()]
        if (way && $scope.service && $scope.service.simulating) {
            $scope.drive(way)
            event.preventDefault()
        }
    }

    // ---- projects --------------------------------------------------------------------------------------------------------------------------
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
        })).slice(0, 8)
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
    $scope.save = function() {
        remember($scope.form.path)
        asked.save = $scope.form.path
        msg.send('saveProject', $scope.form.path)
    }
    var checking = false
    $scope.check = function() {
        checking = true
        msg.send('getProblems')
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
            var count = Math.max(1, Math.ceil(text.length / CHUNK))
            $scope.problems = []
            for (var i = 0; i < count; i++) {
                msg.send('uploadProject', file.name, i, count, text.substring(i * CHUNK, (i + 1) * CHUNK))
            }
            $scope.transfer = 'loading ' + file.name
            $scope.$applyAsync()
        }
        reader.readAsDataURL(file)
    }
    var parts = []
    $scope.download = function() {
        parts = []
        $scope.transfer = 'saving'
        msg.send('getBundle', 0)
    }
    function onBundle(part) {
        parts[part.index] = part.data
        $scope.transfer = 'saving, part ' + (part.index + 1) + ' of ' + part.count
        if (part.index + 1 < part.count) {
            msg.send('getBundle', part.index + 1)
            return
        }
        $scope.transfer = null
        var link = document.createElement('a')
        link.href = window.URL.createObjectURL(new Blob(parts.map(bytes), {type: 'application/zip'}))
        link.download = $scope.form.path.split(/[\\/]/).pop().replace(/(\.sear)?$/, '.sear')
        document.body.appendChild(link)
        link.click()
        document.body.removeChild(link)
        $timeout(function() {
            window.URL.revokeObjectURL(link.href)
        }, 60000)
    }
    function bytes(base64) {
        return Uint8Array.from(window.atob(base64), function(one) {
            return one.charCodeAt(0)
        })
    }

    // ---- the view from above: north (+x) up, east (+z) to the right ----------------------------------------------------------------------------
    function canvas() {
        return $scope.service ? document.getElementById('sear-view-' + $scope.service.name) : null
    }

    /** Where a point of the ground lies on the canvas; also what tests compare with the robot's pose. */
    $scope.toScreen = function(x, z) {
        var element = canvas()
        return {x: element.clientWidth / 2 + (z - $scope.view.z) * $scope.view.scale,
            y: element.clientHeight / 2 - (x - $scope.view.x) * $scope.view.scale}
    }
    $scope.zoom = function(factor) {
        $scope.view.scale = Math.min(2000, Math.max(0.5, $scope.view.scale * factor))
        $timeout(draw)
    }
    $scope.fit = function() {
        $scope.view.fitted = false
        $timeout(draw)
    }
    $scope.redraw = function() {
        $timeout(draw)
    }

    function fitView(element) {
        var low = [Infinity, Infinity]
        var high = [-Infinity, -Infinity]
        var all = shapes()
        var walls = all.filter(function(shape) {
            return !isGround(shape) && !shape.robot
        })
        angular.forEach(walls.length ? walls.concat(all.filter(ofRobot)) : all, function(shape) {
            angular.forEach(shape.outline, function(point) {
                for (var axis = 0; axis < 2; axis++) {
                    low[axis] = Math.min(low[axis], point[axis])
                    high[axis] = Math.max(high[axis], point[axis])
                }
            })
        })
        if (low[0] < high[0]) {
            $scope.view.x = (low[0] + high[0]) / 2
            $scope.view.z = (low[1] + high[1]) / 2
            $scope.view.scale = 0.92 * Math.min(element.clientHeight / (high[0] - low[0]), element.clientWidth / Math.max(0.1, high[1] - low[1]))
            $scope.view.fitted = true
        }
    }

    function ofRobot(shape) {
        return shape.robot
    }
    function isGround(shape) {
        return shape.object.type === 'Floor' || shape.object.terrain
    }

    /** Everything that has a surface, with its outline on the ground. */
    function shapes() {
        var all = []
        angular.forEach($scope.state && $scope.state.objects, function(object) {
            all.push({object: object, outline: outline(object, frame(object.pose))})
        })
        angular.forEach($scope.state && $scope.state.robots, function(robot) {
            var body = frame(robot.pose)
            angular.forEach(robot.parts, function(part) {
                all.push({object: part, robot: robot, outline: outline(part, times(body, frame(part.pose)))})
            })
        })
        return all.filter(function(shape) {
            return shape.outline.length > 2
        })
    }

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

    function rotate(pose, v) {
        var q = [pose[3], pose[4], pose[5]]
        var t = cross(q, v).map(function(value) {
            return 2 * value
        })
        var u = cross(q, t)
        return [v[0] + pose[6] * t[0] + u[0], v[1] + pose[6] * t[1] + u[1], v[2] + pose[6] * t[2] + u[2]]
    }
    function cross(a, b) {
        return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    }
    function times(outer, inner) {
        var p = rotate(outer, inner)
        var a = outer.slice(3)
        var b = inner.slice(3)
        return [outer[0] + p[0], outer[1] + p[1], outer[2] + p[2],
            a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
            a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]]
    }

    /** Corners of an object's shape in its own frame: of a model as they came, of a box, or of round things' rims. */
    function corners(object) {
        return object.corners || plainCorners(object).map(function(point) {
            return object.scale ? [point[0] * object.scale[0], point[1] * object.scale[1], point[2] * object.scale[2]] : point
        })
    }
    function plainCorners(object) {
        var size = object.size
        var points = []
        var i
        if (object.type === 'Cylinder' || object.type === 'Cone' || object.type === 'Wheel') {
            for (i = 0; i < 24; i++) {
                var across = size[0] * Math.cos(i * Math.PI / 12)
                var ahead = size[0] * Math.sin(i * Math.PI / 12)
                angular.forEach([-size[1] / 2, size[1] / 2], function(end) {
                    if (object.type === 'Wheel') {
                        points.push([end, across, ahead])
                    } else if (object.type === 'Cylinder' || end < 0) {
                        points.push([across, end, ahead])
                    }
                })
            }
            if (object.type === 'Cone') {
                points.push([0, size[1] / 2, 0])
            }
        } else if (size.length > 1) {
            var half = (size.length === 2 ? [size[0], 0, size[1]] : size).map(function(length) {
                return length / 2
            })
            for (i = 0; i < 8; i++) {
                points.push([i & 1 ? half[0] : -half[0], i & 2 ? half[1] : -half[1], i & 4 ? half[2] : -half[2]])
            }
        }
        return points
    }

    /** The convex outline on the ground, [x, z] points in order. */
    function outline(object, pose) {
        var points = corners(object).map(function(corner) {
            var at = rotate(pose, corner)
            return [pose[0] + at[0], pose[2] + at[2]]
        }).sort(function(a, b) {
            return a[0] - b[0] || a[1] - b[1]
        })
        function half(list) {
            var hull = []
            angular.forEach(list, function(p) {
                while (hull.length > 1 && turn(hull[hull.length - 2], hull[hull.length - 1], p) <= 0) {
                    hull.pop()
                }
                hull.push(p)
            })
            hull.pop()
            return hull
        }
        return half(points).concat(half(points.slice().reverse()))
    }
    function turn(a, b, c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    }

    var COLOURS = {Box: '#c49a6c', Cylinder: '#5b8c5a', Cone: '#e8722a', Model: '#6b8e23', Floor: 'rgba(128, 128, 128, 0.12)'}

    function draw() {
        var element = canvas()
        if (!element || !element.clientWidth) {
            return
        }
        if (!$scope.view.fitted && $scope.state) {
            fitView(element)
        }
        if ($scope.form.follow && $scope.state && $scope.state.robots.length) {
            $scope.view.x = $scope.state.robots[0].pose[0]
            $scope.view.z = $scope.state.robots[0].pose[2]
        }
        var ratio = window.devicePixelRatio || 1
        element.width = element.clientWidth * ratio
        element.height = element.clientHeight * ratio
        var pen = element.getContext('2d')
        pen.scale(ratio, ratio)
        var ink = window.getComputedStyle(element).color
        drawGrid(pen, element, ink)
        var all = shapes()
        all.sort(function(a, b) {
            return Boolean(isGround(b)) - Boolean(isGround(a))
        })
        angular.forEach(all, function(shape) {
            polygon(pen, shape.outline)
            pen.fillStyle = shape.robot ? 'rgba(51, 122, 183, 0.55)' : COLOURS[isGround(shape) ? 'Floor' : shape.object.type] || '#999'
            pen.fill()
            pen.strokeStyle = ink
            pen.globalAlpha = 0.6
            pen.stroke()
            pen.globalAlpha = 1
        })
        drawPaths(pen)
        if ($scope.form.beams && $scope.state) {
            drawBeams(pen)
        }
        drawHeadings(pen, ink)
    }

    function polygon(pen, points) {
        pen.beginPath()
        angular.forEach(points, function(point) {
            var at = $scope.toScreen(point[0], point[1])
            pen.lineTo(at.x, at.y)
        })
        pen.closePath()
    }

    function drawGrid(pen, element, ink) {
        var step = 1
        while (step * $scope.view.scale < 40) {
            step *= 5
        }
        pen.strokeStyle = ink
        pen.globalAlpha = 0.12
        pen.beginPath()
        var across = element.clientWidth / 2 / $scope.view.scale
        var up = element.clientHeight / 2 / $scope.view.scale
        for (var z = Math.ceil(($scope.view.z - across) / step) * step; z <= $scope.view.z + across; z += step) {
            var x = $scope.toScreen(0, z).x
            pen.moveTo(x, 0)
            pen.lineTo(x, element.clientHeight)
        }
        for (var north = Math.ceil(($scope.view.x - up) / step) * step; north <= $scope.view.x + up; north += step) {
            var y = $scope.toScreen(north, 0).y
            pen.moveTo(0, y)
            pen.lineTo(element.clientWidth, y)
        }
        pen.stroke()
        pen.globalAlpha = 0.8
        pen.fillStyle = ink
        pen.font = '12px sans-serif'
        pen.fillText('N ↑   grid ' + step + ' m', 8, 16)
        pen.globalAlpha = 1
    }

    function drawPaths(pen) {
        pen.strokeStyle = '#337ab7'
        angular.forEach($scope.state && $scope.state.robots, function(robot) {
            pen.beginPath()
            angular.forEach(robot.path, function(point) {
                var at = $scope.toScreen(point[0], point[1])
                pen.lineTo(at.x, at.y)
            })
            pen.stroke()
        })
    }

    function drawBeams(pen) {
        angular.forEach($scope.state.sensors, function(sensor) {
            var pose = frame(sensor.pose)
            if (sensor.ranges) {
                drawScan(pen, pose, sensor)
            }
            angular.forEach(sensor.cones, function(cone) {
                wedge(pen, pose, cone)
            })
            if (sensor.hit) {
                var hit = $scope.toScreen(sensor.hit[0], sensor.hit[2])
                pen.fillStyle = '#d9534f'
                pen.fillRect(hit.x - 2.5, hit.y - 2.5, 5, 5)
            }
        })
    }

    /** Where a beam ends, in pixels. @param degrees to the left of the sensor's forward axis */
    function groundPoint(pose, degrees, metres) {
        var angle = degrees * Math.PI / 180
        var along = rotate(pose, [Math.sin(angle) * metres, 0, Math.cos(angle) * metres])
        return $scope.toScreen(pose[0] + along[0], pose[2] + along[2])
    }

    /** The beams that met something; where nothing was met there is a gap. */
    function drawScan(pen, pose, sensor) {
        var from = $scope.toScreen(pose[0], pose[2])
        pen.beginPath()
        pen.moveTo(from.x, from.y)
        angular.forEach(sensor.ranges, function(metres, i) {
            var at = metres === null ? from : groundPoint(pose, i * sensor.resolution - sensor.spread / 2, metres)
            pen.lineTo(at.x, at.y)
        })
        pen.closePath()
        pen.fillStyle = 'rgba(240, 173, 78, 0.18)'
        pen.fill()
        pen.fillStyle = '#f0ad4e'
        angular.forEach(sensor.ranges, function(metres, i) {
            if (metres !== null) {
                var at = groundPoint(pose, i * sensor.resolution - sensor.spread / 2, metres)
                pen.fillRect(at.x - 1.5, at.y - 1.5, 3, 3)
            }
        })
    }

    /** A cone of a sonar; one without width is a line. */
    function wedge(pen, pose, cone) {
        var from = $scope.toScreen(pose[0], pose[2])
        pen.beginPath()
        pen.moveTo(from.x, from.y)
        for (var i = -6; i <= 6; i++) {
            var at = groundPoint(pose, (cone.yaw || 0) + cone.halfAngle * i / 6, cone.range)
            pen.lineTo(at.x, at.y)
        }
        pen.closePath()
        pen.fillStyle = 'rgba(217, 83, 79, 0.12)'
        pen.fill()
        pen.strokeStyle = 'rgba(217, 83, 79, 0.25)'
        pen.stroke()
    }

    /** A sensor's reading for people. */
    $scope.reading = function(sensor) {
        if (sensor.ranges) {
            var near = sensor.ranges.filter(function(metres) {
                return metres !== null
            })
            return sensor.ranges.length + ' beams, ' + (near.length ? 'nearest ' + Math.min.apply(null, near).toFixed(3) + ' m' : 'nothing in range')
        }
        if (sensor.hit === null) {
            return 'nothing within ' + String(Math.round(sensor.value * 1e3) / 1e3) + ' m'
        }
        var values = angular.isArray(sensor.value) ? sensor.value : String(sensor.value).split(',')
        return values.map(function(value) {
            return isNaN(value) ? value : String(Math.round(value * 1e6) / 1e6)
        }).join(', ')
    }

    function drawHeadings(pen, ink) {
        angular.forEach($scope.state && $scope.state.robots, function(robot) {
            var ahead = rotate(frame(robot.pose), [0, 0, 0.3])
            var from = $scope.toScreen(robot.pose[0], robot.pose[2])
            var to = $scope.toScreen(robot.pose[0] + ahead[0], robot.pose[2] + ahead[2])
            pen.strokeStyle = ink
            pen.lineWidth = 2
            pen.beginPath()
            pen.moveTo(from.x, from.y)
            pen.lineTo(to.x, to.y)
            pen.stroke()
            pen.lineWidth = 1
            pen.fillStyle = ink
            pen.fillText(robot.name, from.x + 8, from.y - 8)
        })
    }

    // ---- mouse and drag and drop -----------------------------------------------------------------------------------------------------------
    var first = null
    function listen() {
        var element = canvas()
        if (!element) {
            first = $timeout(listen, 100)
            return
        }
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
                draw()
            }
        })
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
    first = $timeout(listen)
    window.addEventListener('resize', draw)
    var theme = window.matchMedia('(prefers-color-scheme: dark)')
    theme.addListener(draw)
    $scope.$on('$destroy', function() {
        window.removeEventListener('resize', draw)
        theme.removeListener(draw)
        $timeout.cancel(first)
    })
    $scope.$watch(function() {
        var element = canvas()
        return element ? element.clientWidth : 0
    }, draw)

    msg.subscribe('publishSimulation')
    msg.subscribe('publishStatus')
    msg.subscribe('getProblems')
    msg.subscribe('publishProblems')
    msg.subscribe('saveProject')
    msg.subscribe('loadProject')
    msg.subscribe('newProject')
    msg.subscribe('copyTemplate')
    msg.subscribe('getExamples')
    msg.subscribe('getBundle')
    msg.subscribe('publishUploaded')
    msg.subscribe(this)
    msg.send('getExamples')
}])
