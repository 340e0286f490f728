// Panel of the GPS service: the table of the last fix, a track in metres, the raw sentences.
angular.module('mrlapp.service.GPSGui', []).controller('GPSGuiCtrl', ['$scope', 'mrl', function($scope, mrl) {
    var self = this
    var msg = this.msg

    var LATITUDE = 2
    var LONGITUDE = 4
    var QUALITY = 6
    var ALTITUDE = 9
    var QUALITIES = {0: 'no fix', 1: 'GPS', 2: 'differential GPS', 6: 'dead reckoning', 7: 'manual', 8: 'simulator'}
    var MOST_SENTENCES = 40
    var LONGEST_TRACK = 2000
    var MOST_MESSAGES = 100
    var REPEATED = 'could not invoke '      // so MyRobotLab begins to say once more that a call has failed
    var HALF = 45               // units of the plot from the middle to the edge
    // WGS84: metres in a degree, as series in the latitude
    var METRES_PER_DEGREE = 111132.954
    var EQUATOR_DEGREE = 111412.84

    var UBLOX = 'NEO-M8N'
    var UBLOX_BAUD = 9600       // as delivered
    var OTHER_BAUD = 38400
    $scope.models = ['FV-M8', 'MT3301', 'MT3329', UBLOX, 'NMEA']
    var bauds = [4800, 9600, 14400, 19200, 38400, 57600, 115200]
    var ubloxBauds = [4800, 9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600]
    $scope.bauds = function() {
        return $scope.form.model === UBLOX ? ubloxBauds : bauds
    }
    $scope.form = {port: '', baud: 38400, model: 'FV-M8', raw: false}
    $scope.ports = []
    $scope.sentences = []
    $scope.received = 0
    $scope.messages = []        // newest first
    $scope.last = null          // the newest one as a line
    $scope.tokens = null
    $scope.position = null
    $scope.track = []
    var touched = false
    var start = null
    var counting = false        // whether the number of sentences has been asked for

    // The fields show what the service is set to; until the user connects, what the user has typed.
    this.updateState = function(service) {
        $scope.service = service
        $scope.received = service.sentences || 0
        counting = false
        touched = touched && !service.connected
        if (service.config && !touched) {
            $scope.form.port = service.config.port || $scope.form.port
            $scope.form.baud = service.config.baud || $scope.form.baud
            $scope.form.model = service.config.model || $scope.form.model
        }
    }

    this.onMsg = function(inMsg) {
        var data = inMsg.data && inMsg.data[0]
        switch (inMsg.method) {
        case 'onState':
            self.updateState(data)
            break
        case 'onGGAData':
            $scope.tokens = data
            break
        case 'onGPS':
            onPosition(data)
            break
        case 'onSentence':
            if (!counting) {
                counting = true
                msg.send('getSentenceCount')
            }
            $scope.sentences.unshift(data)
            $scope.sentences.splice(MOST_SENTENCES)
            break
        case 'onLastFix':
            onLastFix(data)
            break
        case 'onSentenceCount':
            $scope.received = data
            counting = false
            break
        case 'onPortNames':
            $scope.ports = data
            break
        case 'onStatus':
            say(data)
            break
        default:
            return
        }
        $scope.$applyAsync()
    }

    /** What came before this page was opened; a sentence that has come meanwhile is newer. */
    function onLastFix(fix) {
        if (fix && !$scope.tokens) {
            $scope.tokens = fix.tokens
            if (Number(fix.tokens[QUALITY]) > 0) {
                onPosition([fix.latitude, fix.longitude, fix.altitude])
            }
        }
    }

    var told = false            // whether the service has said why a call failed, and MyRobotLab has not repeated that yet
    var said = 0
    // An exception's detail is its stack trace; its key says what happened.
    function say(status) {
        var text = status.key || status.detail
        if (status.level === 'error') {
            var repeats = text.indexOf(REPEATED) === 0
            var wasTold = told
            told = !repeats
            if (repeats && wasTold) {
                return
            }
        }
        var newest = $scope.messages[0]
        if (newest && newest.text === text && newest.level === status.level) {
            newest.times++
            newest.time = new Date()
        } else {
            $scope.messages.unshift({id: said++, level: status.level, text: text, time: new Date(), times: 1})
            $scope.messages.splice(MOST_MESSAGES)
        }
        $scope.last = {level: status.level, text: text, line: text.split('\n')[0]}
    }
    $scope.clearMessages = function() {
        $scope.messages = []
        $scope.last = null
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

    /** Where the last fix lies from the first one, in words. */
    $scope.offset = function() {
        if (!$scope.track.length) {
            return '–'
        }
        var last = $scope.track[$scope.track.length - 1]
        return Math.abs(last[0]).toFixed(2) + (last[0] < 0 ? ' m west, ' : ' m east, ')
            + Math.abs(last[1]).toFixed(2) + (last[1] < 0 ? ' m south' : ' m north')
    }

    /** The track as an SVG polyline in a square of 100 units, with the scale that it has. */
    function plot() {
        var reach = 1
        $scope.track.forEach(function(point) {
            reach = Math.max(reach, Math.abs(point[0]), Math.abs(point[1]))
        })
        var step = Math.pow(10, Math.floor(Math.log(reach) / Math.LN10))
        reach = Math.ceil(reach / step) * step
        return {
            reach: reach,
            points: $scope.track.map(function(point) {
                return (point[0] / reach * HALF).toFixed(2) + ',' + (-point[1] / reach * HALF).toFixed(2)
            }).join(' '),
            last: $scope.track[$scope.track.length - 1].map(function(metres, axis) {
                return (axis ? -1 : 1) * metres / reach * HALF
            })
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

    $scope.touch = function() {
        touched = true
    }
    /** A speed that the other kind of receiver is delivered with becomes that of this kind. */
    $scope.chooseModel = function() {
        var ublox = $scope.form.model === UBLOX
        touched = true
        if ($scope.form.baud === (ublox ? OTHER_BAUD : UBLOX_BAUD)) {
            $scope.form.baud = ublox ? UBLOX_BAUD : OTHER_BAUD
        }
    }
    $scope.connect = function() {
        $scope.last = null
        msg.send('setModel', $scope.form.model)
        msg.send('connect', $scope.form.port, Number($scope.form.baud))
    }
    $scope.setBaud = function() {
        if ($scope.service.connected) {
            msg.send('setBaud', Number($scope.form.baud))
        } else {
            touched = true
        }
    }
    $scope.refreshPorts = function() {
        msg.send('getPortNames')
    }
    $scope.clearTrack = function() {
        $scope.track = []
        $scope.plot = null
        start = null
    }

    msg.subscribe('publishGGAData')
    msg.subscribe('publishGPS')
    msg.subscribe('publishSentence')
    msg.subscribe('publishStatus')
    msg.subscribe('getSentenceCount')
    msg.subscribe('getPortNames')
    msg.subscribe('getLastFix')
    msg.subscribe(this)
    msg.send('getPortNames')
    msg.send('getLastFix')
}])
