// SPDX-License-Identifier: Apache-2.0
// Panel of the GPS service: table of the last fix, track in metres, raw sentences.
import '../shared/style.js'
import {Messages} from '../shared/messages.js'
import {Panel} from '../shared/panel.js'
import {Port} from '../shared/port.js'
import {metresBetween, offsetText, plotOf, timeText} from './track.js'

const LATITUDE = 2
const LONGITUDE = 4
const QUALITY = 6
const ALTITUDE = 9
const QUALITIES = {0: 'no fix', 1: 'GPS', 2: 'differential GPS', 6: 'dead reckoning', 7: 'manual', 8: 'simulator'}
const MOST_SENTENCES = 40
const LONGEST_TRACK = 2000

const UBLOX = 'NEO-M8N'
const UBLOX_BAUD = 9600       // factory setting
const OTHER_BAUD = 38400
const BAUDS = [4800, 9600, 14400, 19200, 38400, 57600, 115200]
const UBLOX_BAUDS = [4800, 9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600]

/** One panel. The scope has its state. */
class GpsPanel {
    constructor(controller, $scope, $timeout) {
        this.$scope = $scope
        const panel = new Panel(controller, $scope, 'gps', $timeout)
        this.msg = panel.msg
        this.messages = $scope.messages = new Messages()
        this.port = $scope.port = new Port(panel, OTHER_BAUD)
        $scope.models = ['FV-M8', 'MT3301', 'MT3329', UBLOX, 'NMEA']
        $scope.form = {model: 'FV-M8', raw: false}
        $scope.sentences = []
        $scope.received = 0
        $scope.tokens = null
        $scope.position = null
        $scope.track = []
        this.start = null
        this.counting = false   // whether the number of sentences was requested
        this.connections = undefined    // the service's number of connections; undefined before the first state
        $scope.latitude = LATITUDE
        $scope.longitude = LONGITUDE
        $scope.altitude = ALTITUDE

        panel.offer(this, ['bauds', 'offset', 'token', 'hasFix', 'quality', 'time', 'chooseModel', 'connect',
            'clearTrack'])
        panel.hear(['publishGGAData', 'publishGPS', 'publishSentence', 'publishStatus', 'getSentenceCount'],
            ['getPortNames', 'getLastFix'],
            Object.assign({
                onState: service => this.onState(service),
                onGGAData: tokens => {
                    $scope.tokens = tokens
                },
                onGPS: position => this.onPosition(position),
                onSentence: sentence => this.onSentence(sentence),
                onLastFix: fix => this.onLastFix(fix),
                onSentenceCount: count => {
                    $scope.received = count
                    this.counting = false
                },
                onStatus: status => this.messages.take(status)
            }, this.port.handlers))
    }

    onState(service) {
        this.$scope.service = service
        this.followConnection(service.connections)
        this.$scope.received = service.sentences || 0
        this.counting = false
        this.$scope.form.model = this.port.follow(service) && service.config.model || this.$scope.form.model
    }

    onSentence(sentence) {
        if (!this.counting) {
            this.counting = true
            this.msg.send('getSentenceCount')
        }
        this.$scope.sentences.unshift(sentence)
        this.$scope.sentences.splice(MOST_SENTENCES)
    }

    bauds() {
        return this.$scope.form.model === UBLOX ? UBLOX_BAUDS : BAUDS
    }

    /** Takes the last fix before the page opened. A sentence received since then is newer. */
    onLastFix(fix) {
        if (fix && !this.$scope.tokens) {
            this.$scope.tokens = fix.tokens
            if (fix.latitude !== null) {
                this.onPosition([fix.latitude, fix.longitude, fix.altitude])
            }
        }
    }

    onPosition(position) {
        this.$scope.position = position
        this.start = this.start || position
        this.$scope.track.push(metresBetween(this.start, position))
        this.$scope.track.splice(0, this.$scope.track.length - LONGEST_TRACK)
        this.$scope.plot = plotOf(this.$scope.track)
    }

    /** Returns the last fix relative to the first, as text. */
    offset() {
        return offsetText(this.$scope.track)
    }

    token(index) {
        return this.$scope.tokens && this.$scope.tokens[index] !== '' ? this.$scope.tokens[index] : '–'
    }

    hasFix() {
        return this.$scope.tokens !== null && Number(this.$scope.tokens[QUALITY]) > 0
    }

    quality() {
        return this.$scope.tokens ? QUALITIES[this.$scope.tokens[QUALITY] || 0]
            || 'quality ' + this.$scope.tokens[QUALITY] : '–'
    }

    time() {
        return timeText(this.$scope.tokens && this.$scope.tokens[1])
    }

    /** Replaces the other kind's default baud rate with that of the chosen model. */
    chooseModel() {
        const ublox = this.$scope.form.model === UBLOX
        this.port.touch()
        if (this.port.baud === (ublox ? OTHER_BAUD : UBLOX_BAUD)) {
            this.port.baud = ublox ? UBLOX_BAUD : OTHER_BAUD
        }
    }

    connect() {
        this.messages.hideLast()
        this.msg.send('setModel', this.$scope.form.model)
        this.msg.send('connect', this.port.path, Number(this.port.baud))
    }

    clearTrack() {
        this.$scope.track = []
        this.$scope.plot = null
        this.start = null
    }

    /** Forgets the data of the previous connection. @param number of connections so far */
    followConnection(number) {
        if (this.connections !== undefined && this.connections !== number) {
            this.$scope.tokens = null
            this.$scope.position = null
            this.$scope.sentences = []
            this.clearTrack()
        }
        this.connections = number
    }
}

/** Opens a panel. @param controller MyRobotLab's */
export function open(controller, $scope, $timeout) {
    new GpsPanel(controller, $scope, $timeout)
}
