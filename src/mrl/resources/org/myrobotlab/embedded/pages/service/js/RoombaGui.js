// Panel of the Roomba service: port, mode, drive buttons and sensor readings.
{
    const SERIAL = 'serial'  // the service through which all Roomba services talk
    const TOPICS = ['publishRX', 'publishState'] // the port's own panel subscribes to publishBytes
    const ALL = 0            // packet with bumpers, cliffs, wheels, distance and battery
    const MODE = 35
    const LENGTHS = {[ALL]: 26, [MODE]: 1} // bytes of each packet
    const MODES = ['off', 'passive', 'safe', 'full']
    const CHARGING = ['not charging', 'reconditioning', 'charging', 'trickle charging', 'waiting', 'fault']
    const WAYS = {passive: [128], safe: [128, 130], full: [128, 130, 132]} // commands that all models support
    const GAP_MILLIS = 40    // minimum time between mode changes
    const LOOK_MILLIS = 250
    const PATIENCE = 4       // polls until a missing answer is abandoned

    const unsigned = (data, at) => data[at] * 256 + data[at + 1]

    const signed = (data, at) => unsigned(data, at) << 16 >> 16

    const named = (bits, names) => names.filter((name, i) => name && bits >> i & 1).join(', ') || 'none'

    class RoombaPanel {
        constructor(controller, $scope, $interval, $timeout, mrl) {
            this.$scope = $scope
            this.$timeout = $timeout
            this.mrl = mrl
            this.msg = controller.msg
            this.packet = ALL  // requested packet
            this.got = null         // bytes of the answer so far; null without a request
            this.looks = 0

            $scope.bauds = [19200, 57600, 115200]
            $scope.form = {port: '', baud: 57600, speed: 200, read: false}
            $scope.ports = []
            $scope.port = null          // the open port
            $scope.mode = null
            $scope.sensors = null       // rows of name and text
            this.way = 0            // millimetres and degrees since the panel started reading
            this.angle = 0
            controller.onMsg = inMsg => {
                if (inMsg.method === 'onState') {
                    $scope.service = inMsg.data[0]
                    $scope.$applyAsync()
                }
            }
            const onSerial = inMsg => this.onSerial(inMsg)
            mrl.subscribeToService(onSerial, SERIAL)
            $scope.$watch(() => this.isShown() && Boolean(mrl.getService(SERIAL)), listens => {
                TOPICS.forEach(topic => {
                    mrl[listens ? 'subscribe' : 'unsubscribe'](SERIAL, topic)
                })
                if (listens) {
                    mrl.sendTo(SERIAL, 'broadcastState')
                }
            })
            const timer = $interval(() => this.look(), LOOK_MILLIS, 0, false)
            $scope.$on('$destroy', () => {
                $interval.cancel(timer)
                mrl.unsubscribeFromService(onSerial, SERIAL)
            })
            ;['refresh', 'connect', 'setMode', 'drive', 'read'].forEach(name => {
                $scope[name] = this[name].bind(this)
            })
            this.refresh()
            this.msg.subscribe(controller)
        }

        isShown() {
            return this.$scope.$parent.shell.shown === this.msg.name
        }

        // ---- commands
        // -------------------------------------------------------------------------------------------------------------
        refresh() {
            this.msg.sendBlocking('getPortNames').then(names => {
                this.$scope.ports = names
            })
        }

        connect() {
            this.mrl.sendTo(SERIAL, 'connect', this.$scope.form.port, this.$scope.form.baud, 8, 1, 0)
        }

        setMode(name) {
            WAYS[name].forEach((command, i) => {
                this.$timeout(() => {
                    this.msg.send('send', command)
                }, i * GAP_MILLIS, false)
            })
        }

        /** Calls goForward, spinLeft and so on, at the form's speed. */
        drive(method) {
            this.msg.send('setSpeed', Math.round(Number(this.$scope.form.speed)) || 0)
            this.msg.send(method)
        }

        // ---- sensors
        // -------------------------------------------------------------------------------------------------------------
        read() {
            this.got = null
            this.way = this.angle = 0
            this.$scope.sensors = this.$scope.mode = null
        }

        ask(next) {
            this.packet = next
            this.got = []
            this.looks = 0
            this.msg.send('updateSensors', this.packet)
        }

        look() {
            if (!this.$scope.port || !this.$scope.form.read || !this.isShown()) {
                this.got = null
            } else if (this.got === null || this.looks++ >= PATIENCE) {
                if (this.got !== null && this.packet === MODE) {
                    this.$scope.mode = 'unknown: the first Roombas have no packet for it'
                }
                this.ask(this.packet === ALL && this.got !== null ? ALL : this.packet === ALL ? MODE : ALL)
            }
        }

        take(value) {
            if (this.got === null) {
                return
            }
            this.got.push(value)
            if (this.got.length >= LENGTHS[this.packet]) {
                if (this.packet === ALL) {
                    this.$scope.sensors = this.rows(this.got)
                } else {
                    this.$scope.mode = MODES[this.got[0]] || 'unknown'
                }
                this.got = null
            }
        }

        /** Decodes packet 0, laid out as in the Open Interface specification. */
        rows(data) {
            this.way += signed(data, 12)
            this.angle += signed(data, 14)
            return [
                {name: 'Bumpers', text: named(data[0], ['right', 'left'])},
                {name: 'Dropped wheels', text: named(data[0], ['', '', 'right', 'left', 'caster'])},
                {name: 'Wall', text: data[1] ? 'yes' : 'no'},
                {name: 'Cliffs', text: named(data[2] + 2 * data[3] + 4 * data[4] + 8 * data[5],
                    ['left', 'front left', 'front right', 'right'])},
                {name: 'Virtual wall', text: data[6] ? 'yes' : 'no'},
                {name: 'Distance', text: this.way + ' mm'},
                {name: 'Angle', text: String(this.angle),
                    note: 'degrees; with the first Roombas millimetres between the wheels'},
                {name: 'Battery', text: unsigned(data, 22) + ' of ' + unsigned(data, 24) + ' mAh, '
                    + (unsigned(data, 17) / 1000).toFixed(2) + ' V, ' + signed(data, 19) + ' mA, '
                    + (data[21] << 24 >> 24) + ' °C, ' + (CHARGING[data[16]] || 'unknown')}
            ]
        }

        // ---- messages
        // -------------------------------------------------------------------------------------------------------------
        onSerial(inMsg) {
            if (inMsg.method === 'onState') {
                this.$scope.port = inMsg.data[0].portName || null
                this.$scope.$applyAsync()
            } else if (inMsg.method === 'onRX') {
                this.take(inMsg.data[0])
                this.$scope.$applyAsync()
            }
        }
    }

    angular.module('mrlapp.service.RoombaGui', [])
        .controller('RoombaGuiCtrl', ['$scope', '$interval', '$timeout', 'mrl', function(...services) {
        new RoombaPanel(this, ...services)
    }])
}
