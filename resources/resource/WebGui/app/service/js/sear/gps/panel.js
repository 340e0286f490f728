// SPDX-License-Identifier: Apache-2.0
// Panel of the GPS service: table of the last fix, track in metres, raw sentences.
import '../shared/style.js'
import {makeMessages} from '../shared/messages.js'
import {makePanel} from '../shared/panel.js'
import {makePort} from '../shared/port.js'

var LATITUDE = 2
var LONGITUDE = 4
var QUALITY = 6
var ALTITUDE = 9
var QUALITIES = {0: 'no fix', 1: 'GPS', 2: 'differential GPS', 6: 'dead reckoning', 7: 'manual', 8: 'simulator'}
var MOST_SENTENCES = 40
var LONGEST_TRACK = 2000
var HALF = 45               // half size of the plot, in its units
// WGS84: metres per degree, as series in the latitude
var METRES_PER_DEGREE = 111132.954
var EQUATOR_DEGREE = 111412.84

var UBLOX = 'NEO-M8N'
var UBLOX_BAUD = 9600       // factory setting
var OTHER_BAUD = 38400
var BAUDS = [4800, 9600, 14400, 19200, 38400, 57600, 115200]
var UBLOX_BAUDS = [4800, 9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600]

/** Opens a panel. @param controller MyRobotLab's, whose scope gets the panel's state */
export function open(controller, $scope, $timeout) {
    var panel = makePanel(controller, $scope, 'gps', $timeout)
    var msg = panel.msg
    var messages = $scope.messages = makeMessages()
    var port = $scope.port = makePort(panel, OTHER_BAUD)
    $scope.models = ['FV-M8', 'MT3301', 'MT3329', UBLOX, 'NMEA']
    $scope.bauds = function() {
        return $scope.form.model === UBLOX ? UBLOX_BAUDS : BAUDS
    }
    $scope.form = {model: 'FV-M8', raw: false}
    $scope.sentences = []
    $scope.received = 0
    $scope.tokens = null
    $scope.position = null
    $scope.track = []
    var start = null
    var counting = false        // whether the number of sentences was requested
    var connections             // the service's number of connections; undefined before the first state

    /** Takes the last fix before the page opened. A sentence received since then is newer. */
    function onLastFix(fix) {
        if (fix && !$scope.tokens) {
            $scope.tokens = fix.tokens
            if (fix.latitude !== null) {
                onPosition([fix.latitude, fix.longitude, fix.altitude])
            }
        }
    }

    function onPosition(position) {
        $scope.position = position
        start = start || position
        var latitude = start[0] * Math.PI / 180
        var north = (position[0] - start[0]) * (METRES_PER_DEGREE - 559.82 * Math.cos(2 * latitude) + 1.175 * Math.cos(4 * latitude))
        var turn = position[1] - start[1]
        turn = turn > 180 ? turn - 360 : turn < -180 ? turn + 360 : turn
        var east = turn * (EQUATOR_DEGREE * Math.cos(latitude) - 93.5 * Math.cos(3 * latitude))
        $scope.track.push([east, north])
        $scope.track.splice(0, $scope.track.length - LONGEST_TRACK)
        $scope.plot = plot()
    }

    /** Returns the last fix relative to the first, as text. */
    $scope.offset = function() {
        if (!$scope.track.length) {
            return '–'
        }
        var last = $scope.track[$scope.track.length - 1]
        return Math.abs(last[0]).toFixed(2) + (last[0] < 0 ? ' m west, ' : ' m east, ')
            + Math.abs(last[1]).toFixed(2) + (last[1] < 0 ? ' m south' : ' m north')
    }

    /** Returns the track as an SVG polyline in a square of 100 units, with its scale. */
    function plot() {
        var reach = 1
        $scope.track.forEach(function(point) {
            reach = Math.max(reach, Math.abs(point[0]), Math.abs(point[1]))
        })
        var step = Math.pow(10, Math.floor(Math.log(reach) / Math.LN10))
        reach = Math.ceil(reach / step) * step
        return {
            reach: reach,
            points: $scope.track.map(point => (point[0] / reach * HALF).toFixed(2) + ',' + (-point[1] / reach * HALF).toFixed(2)).join(' '),
            last: $scope.track[$scope.track.length - 1].map((metres, axis) => (axis ? -1 : 1) * metres / reach * HALF)
        }
    }

    $scope.token = function(index) {
        return $scope.tokens && $scope.tokens[index] !== '' ? $scope.tokens[index] : '–'
    }
    $scope.latitude = LATITUDE
    $scope.longitude = LONGITUDE
    $scope.altitude = ALTITUDE
    $scope.hasFix = function() {
        return $scope.tokens !== null && Number($scope.tokens[QUALITY]) > 0
    }
    $scope.quality = function() {
        return $scope.tokens ? QUALITIES[$scope.tokens[QUALITY] || 0] || 'quality ' + $scope.tokens[QUALITY] : '–'
    }
    $scope.time = function() {
        var utc = $scope.tokens && $scope.tokens[1]
        return utc ? utc.substring(0, 2) + ':' + utc.substring(2, 4) + ':' + utc.substring(4) + ' UTC' : '–'
    }

    /** Replaces the other kind's default baud rate with that of the chosen model. */
    $scope.chooseModel = function() {
        var ublox = $scope.form.model === UBLOX
        port.touch()
        if (port.baud === (ublox ? OTHER_BAUD : UBLOX_BAUD)) {
            port.baud = ublox ? UBLOX_BAUD : OTHER_BAUD
        }
    }
    $scope.connect = function() {
        messages.hideLast()
        msg.send('setModel', $scope.form.model)
        msg.send('connect', port.path, Number(port.baud))
    }
    $scope.clearTrack = function() {
        $scope.track = []
        $scope.plot = null
        start = null
    }

    /** Forgets the data of the previous connection. @param number of connections so far */
    function followConnection(number) {
        if (connections !== undefined && connections !== number) {
            $scope.tokens = null
            $scope.position = null
            $scope.sentences = []
            $scope.clearTrack()
        }
        connections = number
    }

    panel.hear(['publishGGAData', 'publishGPS', 'publishSentence', 'publishStatus', 'getSentenceCount'], ['getPortNames', 'getLastFix'],
        angular.extend({
            onState: function(service) {
                $scope.service = service
                followConnection(service.connections)
                $scope.received = service.sentences || 0
                counting = false
                $scope.form.model = port.follow(service) && service.config.model || $scope.form.model
            },
            onGGAData: function(tokens) {
                $scope.tokens = tokens
            },
            onGPS: onPosition,
            onSentence: function(sentence) {
                if (!counting) {
                    counting = true
                    msg.send('getSentenceCount')
                }
                $scope.sentences.unshift(sentence)
                $scope.sentences.splice(MOST_SENTENCES)
            },
            onLastFix: onLastFix,
            onSentenceCount: function(count) {
                $scope.received = count
                counting = false
            },
            onStatus: messages.take
        }, port.handlers))
}
