// Panel of the Serial service: ports, and received and sent bytes in hex.
{
    const MOST_BYTES = 4096
    const PER_LINE = 16
    const GAP = '(not shown: bytes while another tab was in front)'
    const BYTES = ['publishBytes', 'publishTX']

    const hex = bytes => {
        let column = 0
        return bytes.map(value => {
            if (value === GAP) {
                const end = column ? '\n' : ''
                column = 0
                return end + GAP + '\n'
            }
            const digits = (value & 0xFF).toString(16).toUpperCase()
            column = (column + 1) % PER_LINE
            return (digits.length < 2 ? '0' : '') + digits + (column ? ' ' : '\n')
        }).join('')
    }

    class SerialPanel {
        constructor(controller, $scope) {
            this.$scope = $scope
            this.msg = controller.msg

            $scope.bauds = [2400, 4800, 9600, 19200, 38400, 57600, 115200]
            $scope.form = {port: '', baud: 9600, data: '', hex: true}
            $scope.ports = []
            $scope.received = {bytes: [], count: 0, text: ''}
            $scope.sent = {bytes: [], count: 0, text: ''}
            $scope.problem = null
            this.waiting = false

            controller.onMsg = inMsg => {
                const data = inMsg.data[0]
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
                    this.keep($scope.received, data)
                    break
                case 'onTX':
                    this.keep($scope.sent, [data])
                    break
                default:
                    break
                }
            }

            // There may be many busy ports: the page subscribes to bytes only while they are visible.
            $scope.$watch('shell.shown === name', shown => {
                if (shown) {
                    this.mark($scope.received)
                    this.mark($scope.sent)
                }
                BYTES.forEach(topic => {
                    this.msg[shown ? 'subscribe' : 'unsubscribe'](topic)
                })
            })

            ;['connect', 'refresh', 'clear', 'write'].forEach(name => {
                $scope[name] = this[name].bind(this)
            })
            this.msg.subscribe('getPortNames')
            this.msg.subscribe(controller)
            this.msg.send('getPortNames')
        }

        mark(where) {
            if (where.bytes.length && where.bytes[where.bytes.length - 1] !== GAP) {
                where.bytes.push(GAP)
                this.redraw()
            }
        }

        keep(where, bytes) {
            where.count += bytes.length
            where.bytes = where.bytes.concat(bytes)
            where.bytes.splice(0, where.bytes.length - MOST_BYTES)
            this.redraw()
        }

        // Bytes may arrive faster than the screen refreshes.
        redraw() {
            if (!this.waiting) {
                this.waiting = true
                window.requestAnimationFrame(() => {
                    this.waiting = false
                    this.$scope.received.text = hex(this.$scope.received.bytes)
                    this.$scope.sent.text = hex(this.$scope.sent.bytes)
                    this.$scope.$applyAsync()
                })
            }
        }

        connect() {
            this.msg.send('connect', this.$scope.form.port, Number(this.$scope.form.baud), 8, 1, 0)
        }

        refresh() {
            this.msg.send('getPortNames')
        }

        clear(where) {
            where.bytes = []
            where.count = 0
            where.text = ''
        }

        write() {
            this.$scope.problem = null
            if (!this.$scope.form.hex) {
                this.msg.send('write', this.$scope.form.data)
                return
            }
            const digits = this.$scope.form.data.replace(/\s|0x/g, '')
            if (!/^([0-9a-fA-F]{2})+$/.test(digits)) {
                this.$scope.problem = 'Enter hex bytes as pairs of digits 0 to F, for example 89 00 C8.'
                return
            }
            this.msg.send('write', digits.match(/../g).map(pair => (parseInt(pair, 16) << 24) >> 24))
        }
    }

    angular.module('mrlapp.service.SerialGui', []).controller('SerialGuiCtrl', ['$scope', function(...services) {
        new SerialPanel(this, ...services)
    }])
}
