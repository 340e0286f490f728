// SPDX-License-Identifier: Apache-2.0
// Scans in the form of the Java class ScanRanges: 16 bits per beam.
const NOTHING = 65535         // a beam without a hit
const TENTHS = 10000          // tenths of a millimetre per metre

/** @return metres of each beam, null without a hit */
export function rangesOf(text) {
    const bytes = atob(text)
    const unit = numberAt(bytes, 0) / TENTHS
    const ranges = new Array(bytes.length / 2 - 1)
    for (let i = 0; i < ranges.length; i++) {
        const number = numberAt(bytes, i + 1)
        ranges[i] = number === NOTHING ? null : number * unit
    }
    return ranges
}
function numberAt(bytes, at) {
    return bytes.charCodeAt(2 * at) + 256 * bytes.charCodeAt(2 * at + 1)
}

/** Converts the ranges of sensors, or of their changes, to numbers. */
export function unpackRanges(sensors) {
    Object.values(sensors || {}).forEach(sensor => {
        if (typeof sensor.ranges === 'string') {
            sensor.ranges = rangesOf(sensor.ranges)
        }
    })
}
