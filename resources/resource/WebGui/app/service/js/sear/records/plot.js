// SPDX-License-Identifier: Apache-2.0
// Plots in the SEAR panel: values over time, live and from records.
import {Curves, colors} from './curves.js'
import {csv, valueAt} from './table.js'
import {firstOf, unitOf, valuesOf} from './values.js'
import {oncePerPicture, whenPageChanges} from '../shared/page.js'
import {saveBlob, saveText} from '../shared/words.js'

const MOST_SAMPLES = 6000     // live samples: ten minutes
const MOST_NAMES = 300        // values of a live world
const MOST_LINES = 16

/** The plots of one panel. */
export class Plot {
    constructor(panel, world, records, replay, layout) {
        this.panel = panel
        this.world = world
        this.replayer = replay
        this.layout = layout
        this.msg = panel.msg
        this.curves = null      // made when first shown
        this.live = {times: [], values: Object.create(null), last: -1}
        this.fetched = {}       // values of records, by path and name: {times, values}
        this.awaited = {}
        this.touched = false    // whether the user has chosen values
        this.source = ''        // path of the plotted record; empty for the running simulation
        this.other = ''         // path of a second record, for comparison
        this.add = ''           // name being chosen
        this.open = false       // whether the plots are unfolded
        this.paused = null      // live samples at the time of the pause
        this.lines = []         // plotted names
        this.hint = ''          // hint while nothing is visible
        this.names = []         // available names

        panel.scope.$watch(() => layout.isFolded('plots'), folded => {
            this.open = !folded
            if (this.open) {
                this.msg.send('getRecords')
                this.nameValues()
            } else {
                replay.end()
            }
        })
        this.compare = () => this.fetch()
        this.pointed = null
        this.redraw = oncePerPicture(() => {
            this.draw()
            panel.scope.$applyAsync()
        })
        panel.scope.$watch(() => {
            const box = this.open && panel.element('plot')
            return box ? box.clientWidth + ' ' + box.clientHeight : ''
        }, () => this.draw())

        world.told.hear(() => this.sample())
        replay.moved.hear(() => this.draw())
        world.previewed.hear(() => {
            this.nameValues()
            this.draw()
        })
        whenPageChanges(panel.scope, () => this.draw())
        records.ended.hear(() => {
            this.fetched = {}
            this.awaited = {}
        })
        this.handlers = {
            onRecordFrames: sent => {
                if (sent && sent.path === this.awaited.frames && sent.path === this.source) {
                    this.awaited.frames = null
                    this.names = sent.names
                    this.begin()
                    replay.show(sent)
                }
            },
            onRecordValues: sent => {
                sent.names.forEach((name, i) => {
                    this.fetched[sent.path + '\n' + name] = {times: sent.times, values: sent.values[i]}
                    delete this.awaited[sent.path + '\n' + name]
                })
                this.draw()
            }
        }
    }

    nameValues() {
        const now = this.source ? null : this.world.now()
        if (now) {
            this.names = Object.keys(valuesOf(now)).slice(0, MOST_NAMES)
            this.begin()
        }
    }

    /** Plots the usual first values until the user chooses. */
    begin() {
        const first = this.touched ? [] : firstOf(this.world.now(), this.names)
        if (first.length) {
            this.lines = first
            this.fetch()
        }
    }

    chooseSource() {
        this.names = []
        this.replayer.end()
        this.showAll()
        this.replay()
        this.nameValues()
        this.fetch()
    }

    /** Shows the record in the views, from its beginning. */
    replay() {
        this.awaited.frames = this.source || null
        if (this.source) {
            this.msg.send('getRecordFrames', this.source)
        }
    }

    /** Plots and shows the present instead of a record. */
    showNow() {
        this.replayer.end()
        if (this.source) {
            this.source = ''
            this.chooseSource()
        }
    }

    addLine() {
        const name = this.add
        this.touched = true
        if (name && this.lines.indexOf(name) < 0 && this.lines.length < MOST_LINES) {
            this.lines.push(name)
        }
        this.add = ''
        this.fetch()
    }

    removeLine(name) {
        this.touched = true
        this.lines = this.lines.filter(other => other !== name)
        this.draw()
    }

    /** Requests plotted values of records that are missing. */
    fetch() {
        [this.source, this.other].filter(Boolean).forEach(path => {
            this.lines.forEach(name => {
                const key = path + '\n' + name
                if (!this.fetched[key] && !this.awaited[key]) {
                    this.awaited[key] = true
                    this.msg.send('getRecordValues', path, [name])
                }
            })
        })
        this.draw()
    }

    // ---- live
    // -----------------------------------------------------------------------------------------------------------------
    /** Adds a sample after each message of the running world. */
    sample() {
        const state = this.world.running
        if (!state || state.time === this.live.last) {
            return
        }
        if (state.time < this.live.last || !this.live.times.length) {     // another run
            this.live = {times: [], values: Object.create(null), last: -1}
            this.names = this.source ? this.names : []
        }
        this.live.last = state.time
        const values = valuesOf(state)
        this.live.times.push(state.time)
        Object.keys(values).slice(0, MOST_NAMES).forEach(name => {
            const column = this.live.values[name] = this.live.values[name] || []
            column[this.live.times.length - 1] = values[name]
        })
        if (this.live.times.length > MOST_SAMPLES) {
            this.live.times.shift()
            angular.forEach(this.live.values, column => {
                column.shift()
            })
        }
        if (this.open && !this.source) {
            if (!this.names.length) {
                this.nameValues()
            }
            this.draw()
        }
    }

    pause() {
        this.paused = this.paused ? null : angular.copy(this.live)
        this.draw()
    }

    // ---- drawing
    // -----------------------------------------------------------------------------------------------------------------
    linesToDraw() {
        const shown = []
        this.lines.forEach((name, i) => {
            const color = colors[i % colors.length]
            const unit = unitOf(name, this.world.now())
            if (!this.source) {
                const from = this.paused || this.live
                shown.push({name, unit, times: from.times, values: from.values[name] || [], color})
            }
            [this.source, this.other].forEach((path, k) => {
                const data = path && this.fetched[path + '\n' + name]
                if (data && (k === 0 || path !== this.source)) {
                    shown.push({name, unit, source: path, times: data.times, values: data.values, color,
                        dashed: k === 1})
                }
            })
        })
        return shown
    }

    lineColor(name) {
        return colors[this.lines.indexOf(name) % colors.length]
    }

    timeMarked() {
        return this.pointed !== null ? this.pointed : this.replayer.time()
    }

    /** Returns a line's values at the time under the mouse, else at the slider. */
    lineText(name) {
        const time = this.timeMarked()
        return !this.curves ? '' : this.curves.lines.filter(line => line.name === name).map(line => {
            const value = time === null ? line.values[line.values.length - 1] : valueAt(line, time)
            return typeof value === 'number' && isFinite(value) ? String(Number(value.toPrecision(6))) : '-'
        }).join(' / ')
    }

    draw() {
        const box = this.panel.element('plot')
        if (!box || !box.clientWidth || !box.clientHeight) {
            return
        }
        if (!this.curves || this.curves.box !== box) {
            const range = this.curves && this.curves.range
            this.curves = new Curves(box, time => {
                this.pointed = time
                this.redraw()
            })
            this.curves.range = range
        }
        this.curves.draw(this.linesToDraw(), this.timeMarked())
        this.hint = this.hintText()
    }

    /** Returns a hint for an empty plot. */
    hintText() {
        if (this.lines.length && !this.curves.isEmpty()) {
            return ''
        }
        return !this.lines.length ? 'Choose a value above to plot it' : this.source || this.world.running
            ? 'No values yet'
            : 'Start the simulation, or choose a record, to plot its values'
    }

    zoom(factor) {
        if (this.curves) {
            this.curves.zoom(factor)
        }
    }

    showAll() {
        if (this.curves) {
            this.curves.range = null
        }
    }

    whole() {
        this.showAll()
        this.draw()
    }

    save() {
        saveText('plot.csv', csv(this.linesToDraw()))
    }

    savePicture() {
        this.draw()
        this.curves.picture(this.layout.dark ? '#1e1e1e' : '#ffffff').toBlob(blob => {
            saveBlob('plot.png', blob)
        })
    }

    /** Returns the drawn chart, for tests; null before the first drawing. */
    chart() {
        return this.curves
    }
}
