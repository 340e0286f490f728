// SPDX-License-Identifier: Apache-2.0
// Time plots in the SEAR panel, drawn by uPlot: dragging selects a range, the wheel zooms, a double click shows all.
import uPlot from '../lib/uPlot.esm.js'
import {isNumber} from './table.js'
import {tickTexts, titleWithin} from './values.js'

export const colors = ['#337ab7', '#d9534f', '#3c9a3c', '#e08e0b', '#8e5bb5', '#1ba39c', '#b8860b', '#c2185b']
const FONT = '12px system-ui, sans-serif'
const MARK = '#d9534f'
const GRID = 'rgba(128, 128, 128, 0.25)'
const LOWER = 42             // height of the time axis, pixels
const AXIS = 58               // width of a vertical axis with numbers of up to AXIS_LETTERS letters, pixels
const AXIS_LETTERS = 5
const LETTER = 7              // width of a digit, pixels
const DRAG = 4                // pixels: a shorter movement is a click
const PAPER = 14              // margin of a saved picture, pixels

const style = document.createElement('link')
style.rel = 'stylesheet'
style.href = new URL('../lib/uPlot.min.css', import.meta.url)
document.head.appendChild(style)

/**
 * @param box element to draw in
 * @param changed called when the range changes, and with the time under the pointer, null for none
 */
export class Curves {
    constructor(box, changed) {
        this.box = box
        this.changed = changed
        this.range = null           // [from, to] chosen by the user, seconds; null for all
        this.lines = []             // {name, unit, times, values, dashed, color, source}
        this.marked = null          // marked time
        this.plot = null
        this.kind = ''              // kind that the plot was made for: lines with other values only change its numbers
    }

    /** Whether no line has a number. */
    isEmpty() {
        return !this.lines.some(line => line.values.some(isNumber))
    }

    /** Returns the visible range in seconds: [from, to]; null without a plot. */
    seen() {
        const x = this.plot && this.plot.scales.x
        return x && isNumber(x.min) ? [x.min, x.max] : null
    }

    draw(lines, marked) {
        this.lines = lines
        this.marked = marked
        this.ink = window.getComputedStyle(this.box).color
        const kind = JSON.stringify([this.ink, this.titles()]
            .concat(lines.map(line => [line.name, line.source, line.unit, line.color])))
        if (this.plot && this.kind !== kind) {
            this.plot.destroy()
            this.plot = null
        }
        this.kind = kind
        const data = this.data()
        if (!this.plot) {
            this.plot = new uPlot(this.options(), data, this.box)
            this.plot.ctx.canvas.setAttribute(
            'aria-label', 'Lines of ' + (lines.map(line => line.name).join(', ') || 'nothing'))
            this.listen(this.plot.over)
        } else {
            this.resize()
            this.plot.setData(data)
        }
    }

    /** Returns the units of the axes, each with its title. */
    titles() {
        const pen = document.createElement('canvas').getContext('2d')
        const lines = this.lines
        const room = this.size().height - LOWER
        pen.font = FONT
        return lines.map(line => line.unit).filter((unit, i, all) => all.indexOf(unit) === i).map(unit => {
            const names = lines.filter(line => line.unit === unit).map(line => line.name)
                .filter((name, i, all) => all.indexOf(name) === i)
            return {unit, title: titleWithin(names, unit, room, text => pen.measureText(text).width)}
        })
    }

    resize() {
        const size = this.size()
        if (this.plot && (this.plot.width !== size.width || this.plot.height !== size.height)) {
            this.plot.setSize(size)
        }
    }

    size() {
        return {width: this.box.clientWidth, height: this.box.clientHeight}
    }

    /**
     * Returns the data for uPlot. Lines with the same times share them. null is a gap, but not where only other lines
     * have points.
     */
    data() {
        const tables = []
        this.lines.forEach(line => {
            let table = tables.filter(one => one[0] === line.times)[0]
            if (!table) {
                table = [line.times]
                tables.push(table)
            }
            table.push(line.times.map((time, i) => isNumber(line.values[i]) ? line.values[i] : null))
        })
        const columns = {}
        let at = 1
        const joined = tables.length > 1 ? uPlot.join(tables) : tables[0] || [[]]
        tables.forEach(table => {
            columns[tables.indexOf(table)] = at
            at += table.length - 1
        })
        return [joined[0]].concat(this.lines.map(line => {
            const table = tables.findIndex(one => one[0] === line.times)
            return joined[columns[table]++]
        }))
    }

    // ---- appearance
    // -----------------------------------------------------------------------------------------------------------------
    options() {
        const scales = {x: {time: false, range: (u, from, to) => this.rangeOf(from, to)}}
        const axis = more => Object.assign({stroke: this.ink, font: FONT, labelFont: FONT, labelSize: 16, labelGap: 0,
            values: (u, ticks, at, space, step) => tickTexts(ticks, step),
            grid: {stroke: GRID, width: 1}, ticks: {stroke: 'rgba(128, 128, 128, 0.4)', width: 1, size: 5}}, more)
        const axes = [axis({label: 'simulated time (s)', size: 26})]
        this.titles().forEach((one, i) => {
            const unit = one.unit
            scales['in ' + unit] = {range: (u, low, high) => limits(low, high)}
            axes.push(axis({scale: 'in ' + unit, label: one.title, side: i === 0 ? 3 : 1, space: 22,
                size: (u, texts) => axisWidth(texts),
                grid: {show: i === 0, stroke: GRID, width: 1}}))
        })
        return Object.assign(this.size(), {
            legend: {show: false},
            scales,
            axes,
            series: [{}].concat(this.lines.map(
                line => ({label: line.name, scale: 'in ' + line.unit, stroke: line.color, width: 1.5,
                dash: line.dashed ? [6, 4] : undefined, points: {show: false}}))),
            cursor: {y: false, points: {show: false}, drag: {x: true, y: false, setScale: false, dist: DRAG},
                bind: {dblclick: () => () => this.look(null)}},
            hooks: {draw: [u => this.mark(u)], setSelect: [u => this.select(u)],
                setCursor: [u => this.changed(u.cursor.left >= 0 ? u.posToVal(u.cursor.left, 'x') : null)]}
        })
    }

    rangeOf(from, to) {
        return this.range || (isNumber(from) && isNumber(to) ? [from, Math.max(to, from + 1e-3)] : [0, 1])
    }

    mark(u) {
        if (isNumber(this.marked)) {
            const x = u.valToPos(this.marked, 'x', true)
            u.ctx.save()
            u.ctx.beginPath()
            u.ctx.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height)
            u.ctx.clip()
            u.ctx.fillStyle = MARK
            u.ctx.fillRect(x, u.bbox.top, window.devicePixelRatio || 1, u.bbox.height)
            u.ctx.restore()
        }
    }

    // ---- the range
    // -----------------------------------------------------------------------------------------------------------------
    /** Shows a range. @param range seconds; null for all */
    look(range) {
        this.range = range
        this.changed(null)
    }

    select(u) {
        const from = u.select.left
        const width = u.select.width
        if (width > DRAG) {
            const range = [u.posToVal(from, 'x'), u.posToVal(from + width, 'x')]
            u.setSelect({left: 0, top: 0, width: 0, height: 0}, false)
            this.look(range)
        }
    }

    /** Zooms. @param about time that stays in place; the middle by default */
    zoom(factor, about) {
        const now = this.seen()
        if (now) {
            const middle = isNumber(about) ? about : (now[0] + now[1]) / 2
            this.look([middle - (middle - now[0]) * factor, middle + (now[1] - middle) * factor])
        }
    }

    listen(over) {
        over.addEventListener('wheel', event => {
            this.zoom(event.deltaY < 0 ? 0.8 : 1.25, this.plot.posToVal(event.offsetX, 'x'))
            event.preventDefault()
        }, {passive: false})
    }

    // ---- the picture
    // -----------------------------------------------------------------------------------------------------------------
    /** Returns a picture of the plot with a legend. @param paper its background colour @return a canvas */
    picture(paper) {
        const drawn = this.plot.ctx.canvas
        const ratio = drawn.width / this.plot.width
        const row = 18 * ratio
        const edge = PAPER * ratio
        const canvas = document.createElement('canvas')
        canvas.width = drawn.width + 2 * edge
        canvas.height = drawn.height + this.lines.length * row + 3 * edge
        const pen = canvas.getContext('2d')
        pen.fillStyle = paper
        pen.fillRect(0, 0, canvas.width, canvas.height)
        pen.font = Math.round(12 * ratio) + 'px system-ui, sans-serif'
        pen.textBaseline = 'middle'
        this.lines.forEach((line, i) => {
            const y = edge + (i + 0.5) * row
            pen.strokeStyle = line.color
            pen.lineWidth = 2 * ratio
            pen.setLineDash(line.dashed ? [6 * ratio, 4 * ratio] : [])
            pen.beginPath()
            pen.moveTo(edge, y)
            pen.lineTo(edge + 30 * ratio, y)
            pen.stroke()
            pen.fillStyle = this.ink
            pen.fillText(line.name + (line.unit ? ' (' + line.unit + ')' : '')
                + (line.source ? ', ' + line.source : ''), edge + 38 * ratio, y)
        })
        pen.drawImage(drawn, edge, 2 * edge + this.lines.length * row)
        return canvas
    }
}

/** Returns the width of a vertical axis with its title, pixels. */
function axisWidth(texts) {
    const longest = Math.max(0, ...(texts || []).map(text => text.length))
    return Math.max(AXIS, AXIS + (longest - AXIS_LETTERS) * LETTER)
}

function limits(low, high) {
    if (!isNumber(low) || !isNumber(high)) {
        return [0, 1]
    }
    const edge = (high - low) * 0.05 || Math.abs(high) * 0.05 || 0.5
    return [low - edge, high + edge]
}
