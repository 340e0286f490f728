// Panel of the Serial service: ports, and received and sent bytes in hex.
angular.module('mrlapp.service.SerialGui', []).controller('SerialGuiCtrl', ['$scope', function($scope) {
    var msg = this.msg
    var MOST_BYTES = 4096
    var PER_LINE = 16
    var GAP = '(not shown: bytes while another tab was in front)'
    var BYTES = ['publishBytes', 'publishTX']

    $scope.bauds = [2400, 4800, 9600, 19200, 38400, 57600, 115200]
    $scope.form = {port: '', baud: 9600, data: '', hex: true}
    $scope.ports = []
    $scope.received = {bytes: [], count: 0, text: ''}
    $scope.sent = {bytes: [], count: 0, text: ''}
    $scope.problem = null
    var waiting = false

    this.onMsg = function(inMsg) {
        var data = inMsg.data[0]
        switch (inMsg.method) {
        case 'onState':
            $scope.service = data
            $scope.$applyAsync()
            break
        case 'onPortNames':
            $scope.ports = data
            $scope.$applyAsync()
            break
        case 'onBytes':
            keep($scope.received, data)
            break
        case 'onTX':
            keep($scope.sent, [data])
            break
        default:
            break
        }
    }

    // There may be many busy ports: the page subscribes to bytes only while they are visible.
    $scope.$watch('shell.shown === name', function(shown) {
        if (shown) {
            mark($scope.received)
            mark($scope.sent)
        }
        BYTES.forEach(function(topic) {
            msg[shown ? 'subscribe' : 'unsubscribe'](topic)
        })
    })

    function mark(where) {
        if (where.bytes.length && where.bytes[where.bytes.length - 1] !== GAP) {
            where.bytes.push(GAP)
            redraw()
        }
    }

    function keep(where, bytes) {
        where.count += bytes.length
        where.bytes = where.bytes.concat(bytes)
        where.bytes.splice(0, where.bytes.length - MOST_BYTES)
        redraw()
    }

    // Bytes may arrive faster than the screen refreshes.
    function redraw() {
        if (!waiting) {
            waiting = true
            window.requestAnimationFrame(function() {
                waiting = false
                $scope.received.text = hex($scope.received.bytes)
                $scope.sent.text = hex($scope.sent.bytes)
                $scope.$applyAsync()
            })
        }
    }

    function hex(bytes) {
        var column = 0
        return bytes.map(function(value) {
            if (value === GAP) {
                var end = column ? '\n' : ''
                column = 0
                return end + GAP + '\n'
            }
            var digits = (value & 0xFF).toString(16).toUpperCase()
            column = (column + 1) % PER_LINE
            return (digits.length < 2 ? '0' : '') + digits + (column ? ' ' : '\n')
        }).join('')
    }

    $scope.connect = function() {
        msg.send('connect', $scope.form.port, Number($scope.form.baud), 8, 1, 0)
    }
    $scope.refresh = function() {
        msg.send('getPortNames')
    }
    $scope.clear = function(where) {
        where.bytes = []
        where.count = 0
        where.text = ''
    }
    $scope.write = function() {
        $scope.problem = null
        if (!$scope.form.hex) {
            msg.send('write', $scope.form.data)
            return
        }
        var digits = $scope.form.data.replace(/\s|0x/g, '')
        if (!/^([0-9a-fA-F]{2})+$/.test(digits)) {
            $scope.problem = 'Enter hex bytes as pairs of digits 0 to F, for example 89 00 C8.'
            return
        }
        msg.send('write', digits.match(/../g).map(function(pair) {
            return (parseInt(pair, 16) << 24) >> 24
        }))
    }

    msg.subscribe('getPortNames')
    msg.subscribe(this)
    msg.send('getPortNames')
}])
