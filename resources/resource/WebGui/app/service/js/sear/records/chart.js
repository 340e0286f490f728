// Lines over time on a canvas, for the SEAR panel: drag over a range to see only that, the wheel zooms, a double click shows all.
import {penOf} from '../shared/page.js'

var LEFT = 64               // pixels beside the plot, for the numbers
var RIGHT = 8
var TOP = 8
var BOTTOM = 22
export var colors = ['#337ab7', '#d9534f', '#3c9a3c', '#e08e0b', '#8e5bb5', '#1ba39c', '#b8860b', '#c2185b']
var TICKS = 6
var DRAG = 4                // pixels that are no click

/** The step of a scale with at most so many: 1, 2 or 5 times a power of ten. */
function stepOf(span, most) {
    var power = Math.pow(10, Math.floor(Math.log(span / most) / Math.LN10))
    var rest = span / most / power
    return power * (rest <= 1 ? 1 : rest <= 2 ? 2 : rest <= 5 ? 5 : 10)
}

/** So many digits as a scale of such steps needs. */
function text(value, step) {
    var digits = Math.max(0, Math.min(9, -Math.floor(Math.log(step) / Math.LN10 + 1e-9)))
    return Math.abs(value) >= 1e7 ? value.toExponential(2) : value.toFixed(digits)
}

function isNumber(value) {
    return typeof value === 'number' && isFinite(value)
}

/** Where in ordered times one would stand. */
function indexOf(times, time) {
    var low = 0
    var high = times.length
    while (low < high) {
        var middle = (low + high) >> 1
        if (times[middle] < time) {
            low = middle + 1
        } else {
            high = middle
        }
    }
    return low
}

/** @param changed is called when the user has chosen another range; the pointer's time, too: changed(time or null) */
export function Chart(canvas, changed) {
    this.canvas = canvas
    this.range = null           // [from, to] that the user has chosen, seconds; null for all
    this.lines = []             // {name, times, values, dashed, color}
    this.marked = null          // a time that is marked
    this.scale = null           // as it was drawn last
    this.listen(changed)
}

Chart.prototype.listen = function(changed) {
    var self = this
    var start = null
    this.canvas.addEventListener('mousedown', function(event) {
        start = event.offsetX
        event.preventDefault()
    })
    this.canvas.addEventListener('mousemove', function(event) {
        changed(self.timeAt(event.offsetX))
    })
    this.canvas.addEventListener('mouseleave', function() {
        start = null
        changed(null)
    })
    this.canvas.addEventListener('mouseup', function(event) {
        if (start !== null && Math.abs(event.offsetX - start) > DRAG && self.scale) {
            self.range = [self.timeAt(Math.min(start, event.offsetX)), self.timeAt(Math.max(start, event.offsetX))]
        }
        start = null
        changed(self.timeAt(event.offsetX))
    })
    this.canvas.addEventListener('dblclick', function() {
        self.range = null
        changed(null)
    })
    this.canvas.addEventListener('wheel', function(event) {
        self.zoom(event.deltaY < 0 ? 0.8 : 1.25, self.timeAt(event.offsetX))
        changed(self.timeAt(event.offsetX))
        event.preventDefault()
    })
}

/** Seconds at a pixel; null before anything was drawn. */
Chart.prototype.timeAt = function(x) {
    var s = this.scale
    return s && s.from + Math.max(0, Math.min(1, (x - LEFT) / s.width)) * (s.to - s.from)
}

/** @param about a time that stays where it is; the middle without */
Chart.prototype.zoom = function(factor, about) {
    if (this.scale) {
        var s = this.scale
        var middle = isNumber(about) ? about : (s.from + s.to) / 2
        this.range = [middle - (middle - s.from) * factor, middle + (s.to - middle) * factor]
    }
}

Chart.prototype.limits = function() {
    var from = Infinity
    var to = -Infinity
    this.lines.forEach(function(line) {
        if (line.times.length) {
            from = Math.min(from, line.times[0])
            to = Math.max(to, line.times[line.times.length - 1])
        }
    })
    var range = this.range || [from, to]
    if (!isFinite(range[0]) || !isFinite(range[1])) {
        return null
    }
    var low = Infinity
    var high = -Infinity
    this.lines.forEach(function(line) {
        for (var i = Math.max(0, indexOf(line.times, range[0]) - 1); i < line.times.length && line.times[i] <= range[1]; i++) {
            if (isNumber(line.values[i])) {
                low = Math.min(low, line.values[i])
                high = Math.max(high, line.values[i])
            }
        }
    })
    if (low > high) {
        low = 0
        high = 1
    }
    var edge = (high - low) * 0.05 || Math.abs(high) * 0.05 || 0.5
    return {from: range[0], to: Math.max(range[1], range[0] + 1e-3), low: low - edge, high: high + edge}
}

Chart.prototype.draw = function(lines) {
    this.lines = lines
    var canvas = this.canvas
    var pen = penOf(canvas)
    pen.font = '11px sans-serif'
    var s = this.limits()
    this.scale = s
    if (!s) {
        return
    }
    s.width = canvas.clientWidth - LEFT - RIGHT
    s.height = canvas.clientHeight - TOP - BOTTOM
    s.x = function(time) {
        return LEFT + (time - s.from) / (s.to - s.from) * s.width
    }
    s.y = function(value) {
        return TOP + (s.high - value) / (s.high - s.low) * s.height
    }
    drawGrid(pen, s, window.getComputedStyle(canvas).color)
    pen.save()
    pen.beginPath()
    pen.rect(LEFT, TOP, s.width, s.height)
    pen.clip()
    lines.forEach(function(line) {
        drawLine(pen, s, line)
    })
    if (isNumber(this.marked)) {
        pen.strokeStyle = '#d9534f'
        pen.lineWidth = 1
        pen.setLineDash([])
        pen.strokeRect(s.x(this.marked), TOP - 1, 0, s.height + 2)
    }
    pen.restore()
}

function drawGrid(pen, s, ink) {
    pen.fillStyle = ink
    pen.strokeStyle = 'rgba(128, 128, 128, 0.3)'
    pen.lineWidth = 1
    pen.beginPath()
    var step = stepOf(s.high - s.low, TICKS)
    pen.textAlign = 'right'
    pen.textBaseline = 'middle'
    for (var value = Math.ceil(s.low / step) * step; value <= s.high; value += step) {
        pen.moveTo(LEFT, s.y(value))
        pen.lineTo(LEFT + s.width, s.y(value))
        pen.fillText(text(value, step), LEFT - 6, s.y(value))
    }
    step = stepOf(s.to - s.from, TICKS)
    pen.textAlign = 'center'
    pen.textBaseline = 'top'
    for (var time = Math.ceil(s.from / step) * step; time <= s.to; time += step) {
        pen.moveTo(s.x(time), TOP)
        pen.lineTo(s.x(time), TOP + s.height)
        if (s.x(time) < LEFT + s.width - 30) {
            pen.fillText(text(time, step), s.x(time), TOP + s.height + 5)
        }
    }
    pen.stroke()
    pen.textAlign = 'right'
    pen.fillText('s', LEFT + s.width, TOP + s.height + 5)
}

function drawLine(pen, s, line) {
    pen.strokeStyle = line.color
    pen.lineWidth = 1.5
    pen.setLineDash(line.dashed ? [6, 4] : [])
    pen.beginPath()
    var on = false
    for (var i = Math.max(0, indexOf(line.times, s.from) - 1); i < line.times.length; i++) {
        if (isNumber(line.values[i])) {
            pen[on ? 'lineTo' : 'moveTo'](s.x(line.times[i]), s.y(line.values[i]))
        }
        on = isNumber(line.values[i])
        if (line.times[i] > s.to) {
            break
        }
    }
    pen.stroke()
}

/** A line's value at a time: that of its last point before; undefined if it has none there. */
export function valueAt(line, time) {
    var i = indexOf(line.times, time + 1e-9) - 1
    return i < 0 ? undefined : line.values[i]
}

/** Lines as a table: for each, a column of times and one of values; lines of the same times share the first. */
export function csv(lines) {
    var columns = []
    lines.forEach(function(line) {
        if (!columns.length || columns.times !== line.times) {
            columns.push({name: 'time (s)' + (line.source ? ' ' + line.source : ''), values: line.times})
        }
        columns.times = line.times
        columns.push({name: line.name + (line.source ? ' ' + line.source : ''), values: line.values})
    })
    var rows = [columns.map(column => /[",\n]/.test(column.name) ? '"' + column.name.replace(/"/g, '""') + '"' : column.name).join(',')]
    var count = Math.max.apply(null, columns.map(column => column.values.length).concat(0))
    function cell(column) {
        return isNumber(column.values[rows.length - 1]) ? column.values[rows.length - 1] : ''
    }
    while (rows.length <= count) {
        rows.push(columns.map(cell).join(','))
    }
    return rows.join('\n') + '\n'
}
