// SPDX-License-Identifier: Apache-2.0
// Plotted lines as numbers: a line's value at a time, and lines as a table.

/** Returns the insertion index of a time in sorted times. */
function indexOf(times, time) {
    let low = 0
    let high = times.length
    while (low < high) {
        const middle = (low + high) >> 1
        if (times[middle] < time) {
            low = middle + 1
        } else {
            high = middle
        }
    }
    return low
}

export function isNumber(value) {
    return typeof value === 'number' && isFinite(value)
}

/** Returns a line's value at a time: that of the latest point up to then; undefined without one. */
export function valueAt(line, time) {
    const i = indexOf(line.times, time + 1e-9) - 1
    return i < 0 ? undefined : line.values[i]
}

/**
 * Returns lines as CSV: a column of times and one of values each. Successive lines with the same times share the times.
 */
export function csv(lines) {
    const columns = []
    lines.forEach(line => {
        if (!columns.length || columns.times !== line.times) {
            columns.push({name: 'time (s)' + (line.source ? ' ' + line.source : ''), values: line.times})
        }
        columns.times = line.times
        columns.push({name: line.name + (line.unit ? ' (' + line.unit + ')' : '')
            + (line.source ? ' ' + line.source : ''), values: line.values})
    })
    const rows = [columns.map(column =>
        /[",\n]/.test(column.name) ? '"' + column.name.replace(/"/g, '""') + '"' : column.name).join(',')]
    const count = Math.max.apply(null, columns.map(column => column.values.length).concat(0))
    function cell(column) {
        return isNumber(column.values[rows.length - 1]) ? column.values[rows.length - 1] : ''
    }
    while (rows.length <= count) {
        rows.push(columns.map(cell).join(','))
    }
    return rows.join('\n') + '\n'
}
