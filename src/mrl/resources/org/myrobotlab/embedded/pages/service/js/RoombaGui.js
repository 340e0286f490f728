// Panel of the Roomba service: port, mode, drive buttons and sensor readings.
angular.module('mrlapp.service.RoombaGui', []).controller('RoombaGuiCtrl', ['$scope', '$interval', '$timeout', 'mrl', function($scope, $interval, $timeout, mrl) {
    var msg = this.msg
    var SERIAL = 'serial'       // the service through which all Roomba services talk
    var TOPICS = ['publishRX', 'publishState']  // the port's own panel subscribes to publishBytes
    var ALL = 0                 // packet with bumpers, cliffs, wheels, distance and battery
    var MODE = 35
    var LENGTHS = {}            // bytes of each packet
    var MODES = ['off', 'passive', 'safe', 'full']
    var CHARGING = ['not charging', 'reconditioning', 'charging', 'trickle charging', 'waiting', 'fault']
    var WAYS = {passive: [128], safe: [128, 130], full: [128, 130, 132]}    // commands that all models support
    var GAP_MILLIS = 40         // minimum time between mode changes
    var LOOK_MILLIS = 250
    var PATIENCE = 4            // polls until a missing answer is abandoned
    var packet = ALL            // requested packet
    var got = null              // bytes of the answer so far; null without a request
    var looks = 0
    LENGTHS[ALL] = 26
    LENGTHS[MODE] = 1

    $scope.bauds = [19200, 57600, 115200]
    $scope.form = {port: '', baud: 57600, speed: 200, read: false}
    $scope.ports = []
    $scope.port = null          // the open port
    $scope.mode = null
    $scope.sensors = null       // rows of name and text
    var way = 0                 // millimetres and degrees since the panel started reading
    var angle = 0

    function isShown() {
        return $scope.$parent.shell.shown === msg.name
    }

    // ---- commands --------------------------------------------------------------------------------------------------------------------------
    $scope.refresh = function() {
        msg.sendBlocking('getPortNames').then(function(names) {
            $scope.ports = names
        })
    }
    $scope.connect = function() {
        mrl.sendTo(SERIAL, 'connect', $scope.form.port, $scope.form.baud, 8, 1, 0)
    }
    $scope.setMode = function(name) {
        WAYS[name].forEach(function(command, i) {
            $timeout(function() {
                msg.send('send', command)
            }, i * GAP_MILLIS, false)
        })
    }
    /** Calls goForward, spinLeft and so on, at the form's speed. */
    $scope.drive = function(method) {
        msg.send('setSpeed', Math.round(Number($scope.form.speed)) || 0)
        msg.send(method)
    }

    // ---- sensors ---------------------------------------------------------------------------------------------------------------------------
    $scope.read = function() {
        got = null
        way = angle = 0
        $scope.sensors = $scope.mode = null
    }
    function ask(next) {
        packet = next
        got = []
        looks = 0
        msg.send('updateSensors', packet)
    }
    function look() {
        if (!$scope.port || !$scope.form.read || !isShown()) {
            got = null
        } else if (got === null || looks++ >= PATIENCE) {
            if (got !== null && packet === MODE) {
                $scope.mode = 'unknown: the first Roombas have no packet for it'
            }
            ask(packet === ALL && got !== null ? ALL : packet === ALL ? MODE : ALL)
        }
    }
    function take(value) {
        if (got === null) {
            return
        }
        got.push(value)
        if (got.length >= LENGTHS[packet]) {
            if (packet === ALL) {
                $scope.sensors = rows(got)
            } else {
                $scope.mode = MODES[got[0]] || 'unknown'
            }
            got = null
        }
    }
    function unsigned(data, at) {
        return data[at] * 256 + data[at + 1]
    }
    function signed(data, at) {
        return unsigned(data, at) << 16 >> 16
    }
    function named(bits, names) {
        return names.filter(function(name, i) {
            return name && bits >> i & 1
        }).join(', ') || 'none'
    }
    /** Decodes packet 0, laid out as in the Open Interface specification. */
    function rows(data) {
        way += signed(data, 12)
        angle += signed(data, 14)
        return [
            {name: 'Bumpers', text: named(data[0], ['right', 'left'])},
            {name: 'Dropped wheels', text: named(data[0], ['', '', 'right', 'left', 'caster'])},
            {name: 'Wall', text: data[1] ? 'yes' : 'no'},
            {name: 'Cliffs', text: named(data[2] + 2 * data[3] + 4 * data[4] + 8 * data[5], ['left', 'front left', 'front right', 'right'])},
            {name: 'Virtual wall', text: data[6] ? 'yes' : 'no'},
            {name: 'Distance', text: way + ' mm'},
            {name: 'Angle', text: String(angle), note: 'degrees; with the first Roombas millimetres between the wheels'},
            {name: 'Battery', text: unsigned(data, 22) + ' of ' + unsigned(data, 24) + ' mAh, ' + (unsigned(data, 17) / 1000).toFixed(2) + ' V, '
                + signed(data, 19) + ' mA, ' + (data[21] << 24 >> 24) + ' °C, ' + (CHARGING[data[16]] || 'unknown')}
        ]
    }

    // ---- messages --------------------------------------------------------------------------------------------------------------------------
    function onSerial(inMsg) {
        if (inMsg.method === 'onState') {
            $scope.port = inMsg.data[0].portName || null
            $scope.$applyAsync()
        } else if (inMsg.method === 'onRX') {
            take(inMsg.data[0])
            $scope.$applyAsync()
        }
    }
    this.onMsg = function(inMsg) {
        if (inMsg.method === 'onState') {
            $scope.service = inMsg.data[0]
            $scope.$applyAsync()
        }
    }
    mrl.subscribeToService(onSerial, SERIAL)
    $scope.$watch(function() {
        return isShown() && Boolean(mrl.getService(SERIAL))
    }, function(listens) {
        TOPICS.forEach(function(topic) {
            mrl[listens ? 'subscribe' : 'unsubscribe'](SERIAL, topic)
        })
        if (listens) {
            mrl.sendTo(SERIAL, 'broadcastState')
        }
    })
    var timer = $interval(look, LOOK_MILLIS, 0, false)
    $scope.$on('$destroy', function() {
        $interval.cancel(timer)
        mrl.unsubscribeFromService(onSerial, SERIAL)
    })
    $scope.refresh()
    msg.subscribe(this)
}])
