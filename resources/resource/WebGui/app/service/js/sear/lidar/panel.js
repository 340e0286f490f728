// SPDX-License-Identifier: Apache-2.0
// Panel of the LIDAR service: live polar plot of the last scan, device settings, scan as a table and as a CSV file.
import '../shared/style.js'
import {makeMessages} from '../shared/messages.js'
import {oncePerPicture, penOf, whenPageChanges} from '../shared/page.js'
import {makePanel} from '../shared/panel.js'
import {makePort} from '../shared/port.js'
import {saveText} from '../shared/words.js'

var MARGIN = 28             // pixels above and below the plot
var SIDE = 42               // pixels beside the plot, for the labels of 0 and 180 degrees
var LABEL = 40              // pixels for a ring's label
var ANGLE_STEP = 30
var RING_STEPS = [0.25, 0.5, 1, 2, 5, 10, 20]
var MOST_RINGS = 6
var EMPTY_REACH = 8         // range of an empty plot, metres: that of most scanners
var SHRINK = 0.6            // the automatic range shrinks below this fraction, which avoids jumping
var FULL_CIRCLE = 180.5
var RATE_MILLIS = 3000
var TABLE_MILLIS = 300
var KEY_STEPS = {ArrowLeft: 1, ArrowRight: -1, ArrowUp: 1, ArrowDown: -1, PageUp: 10, PageDown: -10, Home: -Infinity, End: Infinity}
var SAME_RESOLUTION = 0.1   // relative tolerance: devices with their own steps report a slightly different resolution

/** Opens a panel. @param controller MyRobotLab's, whose scope gets the panel's state */
export function open(controller, $scope, $timeout) {
    var panel = makePanel(controller, $scope, 'lidar', $timeout)
    var msg = panel.msg
    var messages = $scope.messages = makeMessages()
    var port = $scope.port = makePort(panel, 9600)
    $scope.models = []          // of the service: name, bauds, modes (spread and resolution), centimetres
    $scope.bauds = []
    $scope.modes = []
    $scope.centimetres = true
    $scope.form = {model: 'LMS200', mode: null, table: false, rings: 'auto'}
    $scope.scan = null
    $scope.rate = 0
    $scope.table = null
    $scope.beam = null          // index of the highlighted value of the scan
    var wanted = {}             // choices not confirmed by the service yet: model, baud, mode
    var arrivals = []
    var reach = 0

    // The fields show the device's settings; before the user connects, the user's input.
    function follow() {
        var service = $scope.service
        var config = service.config || {}
        wanted.model = wanted.model === config.model ? null : wanted.model
        $scope.form.model = wanted.model || config.model || $scope.form.model
        takeModel()
        var mode = modeOf(service)
        wanted.mode = wanted.mode === mode ? null : wanted.mode
        $scope.form.mode = wanted.mode || mode
        wanted.baud = wanted.baud === config.baud ? null : wanted.baud
        port.follow(service, wanted.baud)
    }

    function takeModel() {
        var model = $scope.models.filter(each => each.name === $scope.form.model)[0]
        if (model && model !== $scope.known) {
            $scope.known = model
            $scope.bauds = model.bauds
            $scope.centimetres = model.centimetres
            $scope.modes = model.modes.map(function(mode) {
                return {label: mode[0] + '° / ' + mode[1] + '°', spread: mode[0], resolution: mode[1]}
            })
        }
    }

    function modeOf(service) {
        return $scope.modes.filter(function(mode) {
            return Math.abs(mode.spread - service.spread) <= 2 * mode.resolution
                && Math.abs(mode.resolution - service.resolution) <= SAME_RESOLUTION * mode.resolution
        })[0] || null
    }

    // Scans may arrive faster than the screen refreshes: only the newest one is drawn.
    var redraw = oncePerPicture(function() {
        draw()
        $scope.$applyAsync()
    })
    function onScan(scan) {
        var now = Date.now()
        arrivals.push(now)
        while (arrivals[0] < now - RATE_MILLIS) {
            arrivals.shift()
        }
        $scope.rate = arrivals.length > 1 && now > arrivals[0] ? (arrivals.length - 1) * 1000 / (now - arrivals[0]) : 0
        return showScan(scan)
    }

    function showScan(scan) {
        $scope.scan = scan
        $scope.beam = $scope.beam === null ? null : Math.min($scope.beam, scan.angles.length - 1)
        updateReach()
        updateTable()
        redraw()
        return false            // showScan requests the update itself
    }

    $scope.connect = function() {
        wanted = {}
        messages.hideLast()
        msg.send('connect', port.path, Number(port.baud))
    }
    $scope.setModel = function() {
        wanted.model = $scope.form.model
        takeModel()
        port.baud = $scope.bauds[0]
        msg.send('setModel', wanted.model)
    }
    $scope.setBaud = function() {
        wanted.baud = $scope.service.connected ? Number(port.baud) : wanted.baud
        port.setBaud()
    }
    $scope.setMode = function() {
        wanted.mode = $scope.form.mode
        msg.send('setScanMode', wanted.mode.spread, wanted.mode.resolution)
    }

    // ---- the plot: sensor at the bottom centre, 0 degrees to the right, 90 degrees ahead -------------------------------------------------
    function canvas() {
        return panel.element('plot')
    }

    /** Returns the radius of the outermost ring, metres: as chosen, or a round number beyond the greatest distance. */
    $scope.reach = function() {
        return $scope.form.rings === 'auto' ? reach || EMPTY_REACH : Number($scope.form.rings)
    }

    function updateReach() {
        var farthest = 0
        $scope.scan.metres.forEach(function(metres) {
            if (metres !== null && metres > farthest) {
                farthest = metres
            }
        })
        farthest = farthest || EMPTY_REACH
        if (farthest > reach || farthest < reach * SHRINK) {
            var step = ringStep(farthest)
            reach = Math.ceil(farthest / step) * step
        }
    }

    function ringStep(radius) {
        for (var i = 0; i < RING_STEPS.length; i++) {
            if (radius / RING_STEPS[i] <= MOST_RINGS) {
                return RING_STEPS[i]
            }
        }
        return RING_STEPS[RING_STEPS.length - 1]
    }

    /** Returns the plot's geometry in pixels. Tests use it, too. */
    $scope.geometry = function() {
        var element = canvas()
        var width = element ? element.clientWidth : 0
        var height = element ? element.clientHeight : 0
        var full = $scope.scan && $scope.scan.spread > FULL_CIRCLE
        var radius = Math.min(width / 2 - SIDE, full ? height / 2 - MARGIN : height - 2 * MARGIN)
        return {x: width / 2, y: full ? height / 2 : height - MARGIN, radius: radius, reach: $scope.reach(), full: full}
    }

    $scope.point = function(geometry, metres, degrees) {
        var pixels = metres / geometry.reach * geometry.radius
        var angle = degrees * Math.PI / 180
        return {x: geometry.x + pixels * Math.cos(angle), y: geometry.y - pixels * Math.sin(angle)}
    }

    function draw() {
        var element = canvas()
        if (!element || !element.clientWidth) {
            return
        }
        var pen = penOf(element)
        var colour = window.getComputedStyle(element).color
        var geometry = $scope.geometry()
        drawGrid(pen, geometry, colour)
        if ($scope.scan) {
            drawScan(pen, geometry)
            drawBeam(pen, geometry, colour)
        }
        pen.fillStyle = colour
        pen.beginPath()
        pen.arc(geometry.x, geometry.y, 4, 0, 2 * Math.PI)
        pen.fill()
    }

    function drawGrid(pen, geometry, colour) {
        pen.strokeStyle = colour
        pen.fillStyle = colour
        pen.font = '11px sans-serif'
        pen.lineWidth = 1
        pen.globalAlpha = 0.35
        var step = ringStep(geometry.reach)
        for (var ring = step; ring <= geometry.reach + 1e-9; ring += step) {
            pen.beginPath()
            pen.arc(geometry.x, geometry.y, ring / geometry.reach * geometry.radius, geometry.full ? 0 : Math.PI, 2 * Math.PI)
            pen.stroke()
        }
        var last = geometry.full ? 359 : 180
        for (var degrees = 0; degrees <= last; degrees += ANGLE_STEP) {
            var end = $scope.point(geometry, geometry.reach, degrees)
            pen.beginPath()
            pen.moveTo(geometry.x, geometry.y)
            pen.lineTo(end.x, end.y)
            pen.stroke()
        }
        pen.globalAlpha = 0.9
        var crowded = step / geometry.reach * geometry.radius < LABEL
        for (ring = crowded ? 2 * step : step; ring <= geometry.reach + 1e-9; ring += crowded ? 2 * step : step) {
            pen.textAlign = 'center'
            pen.fillText(label(ring), geometry.x + ring / geometry.reach * geometry.radius, geometry.y + 14)
        }
        for (degrees = 0; degrees <= last; degrees += ANGLE_STEP) {
            end = $scope.point(geometry, geometry.reach * (1 + 14 / geometry.radius), degrees)
            pen.textAlign = degrees < 80 || degrees > 280 ? 'left' : degrees > 100 && degrees < 260 ? 'right' : 'center'
            pen.fillText(degrees + '°', end.x, end.y + (degrees > 0 && degrees < 180 ? 0 : -3))
        }
        pen.globalAlpha = 1
    }

    function label(metres) {
        return $scope.scan && $scope.scan.unit === 'cm' ? Math.round(metres * 100) + ' cm' : metres + ' m'
    }

    function drawScan(pen, geometry) {
        var scan = $scope.scan
        pen.beginPath()
        pen.moveTo(geometry.x, geometry.y)
        for (var i = 0; i < scan.angles.length; i++) {
            var metres = scan.metres[i] === null ? geometry.reach : Math.min(scan.metres[i], geometry.reach)
            var at = $scope.point(geometry, metres, scan.angles[i])
            pen.lineTo(at.x, at.y)
        }
        pen.closePath()
        pen.fillStyle = 'rgba(51, 122, 183, 0.18)'
        pen.fill()
        pen.fillStyle = '#d9534f'
        for (i = 0; i < scan.angles.length; i++) {
            if (scan.metres[i] !== null && scan.metres[i] <= geometry.reach) {
                at = $scope.point(geometry, scan.metres[i], scan.angles[i])
                pen.fillRect(at.x - 1.5, at.y - 1.5, 3, 3)
            }
        }
    }

    function drawBeam(pen, geometry, colour) {
        if ($scope.beam === null) {
            return
        }
        var metres = $scope.scan.metres[$scope.beam]
        var at = $scope.point(geometry, metres === null ? geometry.reach : Math.min(metres, geometry.reach), $scope.scan.angles[$scope.beam])
        pen.strokeStyle = colour
        pen.lineWidth = 1.5
        pen.beginPath()
        pen.moveTo(geometry.x, geometry.y)
        pen.lineTo(at.x, at.y)
        pen.stroke()
        if (metres !== null && metres <= geometry.reach) {
            pen.beginPath()
            pen.arc(at.x, at.y, 5, 0, 2 * Math.PI)
            pen.stroke()
        }
    }

    // ---- one beam: under the mouse, or chosen with the keys --------------------------------------------------------------------------------
    $scope.hover = function(event) {
        if ($scope.scan) {
            var geometry = $scope.geometry()
            var degrees = Math.atan2(geometry.y - event.offsetY, event.offsetX - geometry.x) * 180 / Math.PI
            var resolution = $scope.scan.resolution || 1
            var index = Math.round(((degrees + 360 - $scope.scan.angles[0]) % 360) / resolution)
            $scope.choose(index < $scope.scan.angles.length ? index : null)
        }
    }

    $scope.choose = function(index) {
        $scope.beam = index
        draw()
    }

    $scope.key = function(event) {
        var step = KEY_STEPS[event.key]
        if (step && $scope.scan) {
            event.preventDefault()
            var last = $scope.scan.angles.length - 1
            var from = $scope.beam === null ? Math.round(last / 2) - (isFinite(step) ? step : 0) : $scope.beam
            $scope.choose(Math.max(0, Math.min(last, from + step)))
        }
    }

    /** Returns the chosen beam as text. */
    $scope.beamText = function() {
        var scan = $scope.scan
        var i = $scope.beam
        return !scan || i === null ? '' : scan.angles[i] + '°: '
            + (scan.metres[i] === null ? 'no return (' + scan.raw[i] + ')' : scan.metres[i] + ' m (' + scan.raw[i] + ' ' + scan.unit + ')')
    }

    // ---- table and file ------------------------------------------------------------------------------------------------------------------
    // A table of hundreds of rows takes longer to lay out than a plot. While scans stream, the table shows some of
    // them, and the last one at the end.
    var tableTimer = null
    function updateTable() {
        if ($scope.form.table && !tableTimer) {
            tableTimer = $timeout(function() {
                tableTimer = null
                makeTable()
            }, TABLE_MILLIS)
        }
    }

    function makeTable() {
        $scope.table = {unit: $scope.scan.unit, rows: $scope.rows()}
    }

    $scope.showTable = function() {
        $scope.form.table = !$scope.form.table
        makeTable()
    }

    $scope.rows = function() {
        var scan = $scope.scan
        return scan ? scan.angles.map(function(angle, i) {
            return {angle: angle, raw: scan.raw[i], metres: scan.metres[i]}
        }) : []
    }

    $scope.download = function() {
        var lines = ['angle_deg,raw_' + $scope.scan.unit + ',metres']
        $scope.rows().forEach(function(row) {
            lines.push(row.angle + ',' + row.raw + ',' + (row.metres === null ? '' : row.metres))
        })
        saveText($scope.service.name + '-scan.csv', lines.join('\r\n') + '\r\n')
    }

    $scope.redraw = function() {
        $timeout(draw)
    }
    whenPageChanges($scope, draw)
    $scope.$on('$destroy', function() {
        $timeout.cancel(tableTimer)
    })
    $scope.$watch(function() {
        var element = canvas()
        return element ? element.clientWidth + ' ' + element.clientHeight : ''
    }, draw)

    panel.hear(['publishScan', 'publishStatus'], ['getPortNames', 'getModels', 'getLastScan'], angular.extend({
        onState: function(service) {
            $scope.service = service
            follow()
            $timeout(draw)
        },
        onScan: onScan,
        onLastScan: function(scan) {
            return scan && !$scope.scan && showScan(scan)       // a scan received meanwhile is newer
        },
        onModels: function(models) {
            $scope.models = models
            if ($scope.service) {
                follow()
            }
        },
        onStatus: function(status) {
            if (status.level === 'error' && $scope.service) {
                wanted = {}
                follow()
            }
            messages.take(status)
        }
    }, port.handlers))
}
