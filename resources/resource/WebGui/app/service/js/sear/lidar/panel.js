// SPDX-License-Identifier: Apache-2.0
// Panel of the LIDAR service: live polar plot of the last scan, device settings, scan as a table and as a CSV file.
import '../shared/style.js'
import {Messages} from '../shared/messages.js'
import {oncePerPicture, penOf, whenPageChanges} from '../shared/page.js'
import {Panel} from '../shared/panel.js'
import {Port} from '../shared/port.js'
import * as plot from './plot.js'
import {saveText} from '../shared/words.js'

const RATE_MILLIS = 3000
const TABLE_MILLIS = 300
const KEY_STEPS = {ArrowLeft: 1, ArrowRight: -1, ArrowUp: 1, ArrowDown: -1, PageUp: 10, PageDown: -10, Home: -Infinity,
    End: Infinity}
const SAME_RESOLUTION = 0.1   // relative tolerance: devices with their own steps report a slightly different resolution

/** One panel. The scope has its state. */
class LidarPanel {
    constructor(controller, $scope, $timeout) {
        this.$scope = $scope
        this.$timeout = $timeout
        this.panel = new Panel(controller, $scope, 'lidar', $timeout)
        this.msg = this.panel.msg
        this.messages = $scope.messages = new Messages()
        this.port = $scope.port = new Port(this.panel, 9600)
        $scope.models = []          // of the service: name, bauds, modes (spread and resolution), centimetres
        $scope.bauds = []
        $scope.modes = []
        $scope.centimetres = true
        $scope.form = {model: 'LMS200', mode: null, table: false, rings: 'auto'}
        $scope.scan = null
        $scope.rate = 0
        $scope.table = null
        $scope.beam = null          // index of the highlighted value of the scan
        this.wanted = {}        // choices not confirmed by the service yet: model, baud, mode
        this.arrivals = []
        this.farthest = 0       // automatic range of the plot, metres; 0 before the first scan

        // Scans may arrive faster than the screen refreshes: only the newest one is drawn.
        this.redrawSoon = oncePerPicture(() => {
            this.draw()
            $scope.$applyAsync()
        })

        // A table of hundreds of rows takes longer to lay out than a plot. While scans stream, the table shows some of
        // them, and the last one at the end.
        this.tableTimer = null
        whenPageChanges($scope, () => this.draw())
        $scope.$on('$destroy', () => {
            $timeout.cancel(this.tableTimer)
        })
        $scope.$watch(() => {
            const element = this.canvas()
            return element ? element.clientWidth + ' ' + element.clientHeight : ''
        }, () => this.draw())

        $scope.point = plot.point
        this.panel.offer(this, ['connect', 'setModel', 'setBaud', 'setMode', 'geometry', 'hover', 'choose', 'key',
            'beamText', 'showTable',
            'download', 'redraw'])
        this.panel.hear(['publishScan', 'publishStatus'], ['getPortNames', 'getModels', 'getLastScan'], Object.assign({
            onState: service => {
                $scope.service = service
                this.follow()
                $timeout(() => this.draw())
            },
            onScan: scan => this.onScan(scan),
            onLastScan: scan => 
                 scan && !$scope.scan && this.showScan(scan)       // a scan received meanwhile is newer
            ,
            onModels: models => {
                $scope.models = models
                if ($scope.service) {
                    this.follow()
                }
            },
            onStatus: status => {
                if (status.level === 'error' && $scope.service) {
                    this.wanted = {}
                    this.follow()
                }
                this.messages.take(status)
            }
        }, this.port.handlers))
    }

    // The fields show the device's settings; before the user connects, the user's input.
    follow() {
        const service = this.$scope.service
        const config = service.config || {}
        this.wanted.model = this.wanted.model === config.model ? null : this.wanted.model
        this.$scope.form.model = this.wanted.model || config.model || this.$scope.form.model
        this.takeModel()
        const mode = this.modeOf(service)
        this.wanted.mode = this.wanted.mode === mode ? null : this.wanted.mode
        this.$scope.form.mode = this.wanted.mode || mode
        this.wanted.baud = this.wanted.baud === config.baud ? null : this.wanted.baud
        this.port.follow(service, this.wanted.baud)
    }

    takeModel() {
        const model = this.$scope.models.filter(each => each.name === this.$scope.form.model)[0]
        if (model && model !== this.$scope.known) {
            this.$scope.known = model
            this.$scope.bauds = model.bauds
            this.$scope.centimetres = model.centimetres
            this.$scope.modes = model.modes.map(
            mode => ({label: mode[0] + '° / ' + mode[1] + '°', spread: mode[0], resolution: mode[1]}))
        }
    }

    modeOf(service) {
        return this.$scope.modes.filter(mode => Math.abs(mode.spread - service.spread) <= 2 * mode.resolution
                && Math.abs(mode.resolution - service.resolution) <= SAME_RESOLUTION * mode.resolution)[0] || null
    }

    onScan(scan) {
        const now = Date.now()
        this.arrivals.push(now)
        while (this.arrivals[0] < now - RATE_MILLIS) {
            this.arrivals.shift()
        }
        this.$scope.rate = this.arrivals.length > 1 && now > this.arrivals[0] ? (this.arrivals.length - 1) * 1000 / (
            now - this.arrivals[0]) : 0
        return this.showScan(scan)
    }

    showScan(scan) {
        this.$scope.scan = scan
        this.$scope.beam = this.$scope.beam === null ? null : Math.min(this.$scope.beam, scan.angles.length - 1)
        this.farthest = plot.reachOf(scan, this.farthest)
        this.updateTable()
        this.redrawSoon()
        return false            // showScan requests the update itself
    }

    connect() {
        this.wanted = {}
        this.messages.hideLast()
        this.msg.send('connect', this.port.path, Number(this.port.baud))
    }

    setModel() {
        this.wanted.model = this.$scope.form.model
        this.takeModel()
        this.port.baud = this.$scope.bauds[0]
        this.msg.send('setModel', this.wanted.model)
    }

    setBaud() {
        this.wanted.baud = this.$scope.service.connected ? Number(this.port.baud) : this.wanted.baud
        this.port.setBaud()
    }

    setMode() {
        this.wanted.mode = this.$scope.form.mode
        this.msg.send('setScanMode', this.wanted.mode.spread, this.wanted.mode.resolution)
    }

    // ---- the plot
    // -----------------------------------------------------------------------------------------------------------------
    canvas() {
        return this.panel.element('plot')
    }

    /** Returns the plot's geometry, see plot.js. Tests use it, too. */
    geometry() {
        const element = this.canvas()
        return plot.geometryOf(element ? element.clientWidth : 0, element ? element.clientHeight : 0, this.$scope.scan,
            this.$scope.form.rings === 'auto' ? this.farthest : Number(this.$scope.form.rings))
    }

    draw() {
        const element = this.canvas()
        if (element && element.clientWidth) {
            plot.draw(penOf(element), this.geometry(), window.getComputedStyle(element).color, this.$scope.scan,
                this.$scope.beam)
        }
    }

    // ---- one beam: under the mouse, or chosen with the keys
    // --------------------------------------------------------------------------------
    hover(event) {
        if (this.$scope.scan) {
            this.choose(plot.beamAt(this.geometry(), this.$scope.scan, event.offsetX, event.offsetY))
        }
    }

    choose(index) {
        this.$scope.beam = index
        this.draw()
    }

    key(event) {
        const step = KEY_STEPS[event.key]
        if (step && this.$scope.scan) {
            event.preventDefault()
            const last = this.$scope.scan.angles.length - 1
            const from = this.$scope.beam === null ? Math.round(last / 2)
            - (isFinite(step) ? step : 0) : this.$scope.beam
            this.choose(Math.max(0, Math.min(last, from + step)))
        }
    }

    /** Returns the chosen beam as text. */
    beamText() {
        return this.$scope.scan && this.$scope.beam !== null ? plot.beamText(this.$scope.scan, this.$scope.beam) : ''
    }

    updateTable() {
        if (this.$scope.form.table && !this.tableTimer) {
            this.tableTimer = this.$timeout(() => {
                this.tableTimer = null
                this.makeTable()
            }, TABLE_MILLIS)
        }
    }

    makeTable() {
        this.$scope.table = {unit: this.$scope.scan.unit, rows: plot.rowsOf(this.$scope.scan)}
    }

    showTable() {
        this.$scope.form.table = !this.$scope.form.table
        this.makeTable()
    }

    download() {
        saveText(this.$scope.service.name + '-scan.csv', plot.csv(this.$scope.scan))
    }

    redraw() {
        this.$timeout(() => this.draw())
    }
}

/** Opens a panel. @param controller MyRobotLab's */
export function open(controller, $scope, $timeout) {
    new LidarPanel(controller, $scope, $timeout)
}
