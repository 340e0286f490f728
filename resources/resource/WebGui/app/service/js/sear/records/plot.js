// SPDX-License-Identifier: Apache-2.0
// Plots in the SEAR panel: values over time, live and from records.
import {Curves, colors} from './curves.js'
import {csv, valueAt} from './table.js'
import {firstOf, unitOf, valuesOf} from './values.js'
import {oncePerPicture, whenPageChanges} from '../shared/page.js'
import {saveBlob, saveText} from '../shared/words.js'

var MOST_SAMPLES = 6000     // live samples: ten minutes
var MOST_NAMES = 300        // values of a live world
var MOST_LINES = 16

/** Makes the plots of one panel. */
export function makePlot(panel, world, records, replay, layout) {
    var msg = panel.msg
    var chart = null            // made when first shown
    var live = {times: [], values: Object.create(null), last: -1}
    var fetched = {}            // values of records, by path and name: {times, values}
    var awaited = {}
    var touched = false         // whether the user has chosen values
    var plot = {
        source: '',             // path of the plotted record; empty for the running simulation
        other: '',              // path of a second record, for comparison
        add: '',                // name being chosen
        open: false,            // whether the plots are unfolded
        paused: null,           // live samples at the time of the pause
        lines: [],              // plotted names
        hint: '',               // hint while nothing is visible
        names: []               // available names
    }

    // ---- which values ------------------------------------------------------------------------------------------------------------------
    panel.scope.$watch(() => layout.isFolded('plots'), function(folded) {
        plot.open = !folded
        if (plot.open) {
            msg.send('getRecords')
            nameValues()
        } else {
            replay.end()
        }
    })
    function nameValues() {
        var now = plot.source ? null : world.now()
        if (now) {
            plot.names = Object.keys(valuesOf(now)).slice(0, MOST_NAMES)
            begin()
        }
    }
    /** Plots the usual first values until the user chooses. */
    function begin() {
        var first = touched ? [] : firstOf(world.now(), plot.names)
        if (first.length) {
            plot.lines = first
            fetch()
        }
    }
    plot.chooseSource = function() {
        plot.names = []
        replay.end()
        showAll()
        plot.replay()
        nameValues()
        fetch()
    }
    /** Shows the record in the views, from its beginning. */
    plot.replay = function() {
        awaited.frames = plot.source || null
        if (plot.source) {
            msg.send('getRecordFrames', plot.source)
        }
    }
    /** Plots and shows the present instead of a record. */
    plot.showNow = function() {
        replay.end()
        if (plot.source) {
            plot.source = ''
            plot.chooseSource()
        }
    }
    plot.addLine = function() {
        var name = plot.add
        touched = true
        if (name && plot.lines.indexOf(name) < 0 && plot.lines.length < MOST_LINES) {
            plot.lines.push(name)
        }
        plot.add = ''
        fetch()
    }
    plot.removeLine = function(name) {
        touched = true
        plot.lines = plot.lines.filter(other => other !== name)
        draw()
    }
    /** Requests plotted values of records that are missing. */
    function fetch() {
        [plot.source, plot.other].filter(Boolean).forEach(function(path) {
            plot.lines.forEach(function(name) {
                var key = path + '\n' + name
                if (!fetched[key] && !awaited[key]) {
                    awaited[key] = true
                    msg.send('getRecordValues', path, [name])
                }
            })
        })
        draw()
    }
    plot.compare = fetch

    // ---- live --------------------------------------------------------------------------------------------------------------------------
    /** Adds a sample after each message of the running world. */
    function sample() {
        var state = world.running
        if (!state || state.time === live.last) {
            return
        }
        if (state.time < live.last || !live.times.length) {     // another run
            live = {times: [], values: Object.create(null), last: -1}
            plot.names = plot.source ? plot.names : []
        }
        live.last = state.time
        var values = valuesOf(state)
        live.times.push(state.time)
        Object.keys(values).slice(0, MOST_NAMES).forEach(function(name) {
            var column = live.values[name] = live.values[name] || []
            column[live.times.length - 1] = values[name]
        })
        if (live.times.length > MOST_SAMPLES) {
            live.times.shift()
            angular.forEach(live.values, function(column) {
                column.shift()
            })
        }
        if (plot.open && !plot.source) {
            if (!plot.names.length) {
                nameValues()
            }
            draw()
        }
    }
    plot.pause = function() {
        plot.paused = plot.paused ? null : angular.copy(live)
        draw()
    }

    // ---- drawing -----------------------------------------------------------------------------------------------------------------------
    function linesToDraw() {
        var shown = []
        plot.lines.forEach(function(name, i) {
            var color = colors[i % colors.length]
            var unit = unitOf(name, world.now())
            if (!plot.source) {
                var from = plot.paused || live
                shown.push({name: name, unit: unit, times: from.times, values: from.values[name] || [], color: color})
            }
            [plot.source, plot.other].forEach(function(path, k) {
                var data = path && fetched[path + '\n' + name]
                if (data && (k === 0 || path !== plot.source)) {
                    shown.push({name: name, unit: unit, source: path, times: data.times, values: data.values, color: color, dashed: k === 1})
                }
            })
        })
        return shown
    }
    plot.lineColor = function(name) {
        return colors[plot.lines.indexOf(name) % colors.length]
    }
    var pointed = null
    function timeMarked() {
        return pointed !== null ? pointed : replay.time()
    }
    /** Returns a line's values at the time under the mouse, else at the slider. */
    plot.lineText = function(name) {
        var time = timeMarked()
        return !chart ? '' : chart.lines.filter(line => line.name === name).map(function(line) {
            var value = time === null ? line.values[line.values.length - 1] : valueAt(line, time)
            return typeof value === 'number' && isFinite(value) ? String(Number(value.toPrecision(6))) : '-'
        }).join(' / ')
    }
    function draw() {
        var box = panel.element('plot')
        if (!box || !box.clientWidth || !box.clientHeight) {
            return
        }
        if (!chart || chart.box !== box) {
            var range = chart && chart.range
            chart = new Curves(box, function(time) {
                pointed = time
                redraw()
            })
            chart.range = range
        }
        chart.draw(linesToDraw(), timeMarked())
        plot.hint = hint()
    }
    var redraw = oncePerPicture(function() {
        draw()
        panel.scope.$applyAsync()
    })
    /** Returns a hint for an empty plot. */
    function hint() {
        if (plot.lines.length && !chart.isEmpty()) {
            return ''
        }
        return !plot.lines.length ? 'Choose a value above to plot it' : plot.source || world.running ? 'No values yet'
            : 'Start the simulation, or choose a record, to plot its values'
    }
    plot.zoom = function(factor) {
        if (chart) {
            chart.zoom(factor)
        }
    }
    function showAll() {
        if (chart) {
            chart.range = null
        }
    }
    plot.whole = function() {
        showAll()
        draw()
    }
    plot.save = function() {
        saveText('plot.csv', csv(linesToDraw()))
    }
    plot.savePicture = function() {
        draw()
        chart.picture(layout.dark ? '#1e1e1e' : '#ffffff').toBlob(function(blob) {
            saveBlob('plot.png', blob)
        })
    }
    panel.scope.$watch(function() {
        var box = plot.open && panel.element('plot')
        return box ? box.clientWidth + ' ' + box.clientHeight : ''
    }, draw)
    /** Returns the drawn chart, for tests; null before the first drawing. */
    plot.chart = function() {
        return chart
    }

    world.told.hear(sample)
    replay.moved.hear(draw)
    world.previewed.hear(function() {
        nameValues()
        draw()
    })
    whenPageChanges(panel.scope, draw)
    records.ended.hear(function() {
        fetched = {}
        awaited = {}
    })
    plot.handlers = {
        onRecordFrames: function(sent) {
            if (sent && sent.path === awaited.frames && sent.path === plot.source) {
                awaited.frames = null
                plot.names = sent.names
                begin()
                replay.show(sent)
            }
        },
        onRecordValues: function(sent) {
            sent.names.forEach(function(name, i) {
                fetched[sent.path + '\n' + name] = {times: sent.times, values: sent.values[i]}
                delete awaited[sent.path + '\n' + name]
            })
            draw()
        }
    }
    return plot
}
