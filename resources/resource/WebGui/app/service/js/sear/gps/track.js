// SPDX-License-Identifier: Apache-2.0
// Track of a GPS receiver in metres, as pure functions: a list of points [east, north] relative to the first fix.
const HALF = 45               // half size of the plot, in its units
// WGS84: metres per degree, as series in the latitude
const METRES_PER_DEGREE = 111132.954
const EQUATOR_DEGREE = 111412.84

/** Returns a position's offset [east, north] from another one, metres. Positions are [latitude, longitude], degrees. */
export function metresBetween(start, position) {
    const latitude = start[0] * Math.PI / 180
    const north = (position[0] - start[0]) * (METRES_PER_DEGREE - 559.82 * Math.cos(2 * latitude)
        + 1.175 * Math.cos(4 * latitude))
    const turn = position[1] - start[1]
    const shorter = turn > 180 ? turn - 360 : turn < -180 ? turn + 360 : turn
    return [shorter * (EQUATOR_DEGREE * Math.cos(latitude) - 93.5 * Math.cos(3 * latitude)), north]
}

/** Returns the last point as text. */
export function offsetText(track) {
    if (!track.length) {
        return '–'
    }
    const last = track[track.length - 1]
    return Math.abs(last[0]).toFixed(2) + (last[0] < 0 ? ' m west, ' : ' m east, ')
        + Math.abs(last[1]).toFixed(2) + (last[1] < 0 ? ' m south' : ' m north')
}

/** Returns the track as an SVG polyline in a square of 100 units, with its scale. */
export function plotOf(track) {
    const farthest = track.reduce((most, point) => Math.max(most, Math.abs(point[0]), Math.abs(point[1])), 1)
    const step = Math.pow(10, Math.floor(Math.log(farthest) / Math.LN10))
    const reach = Math.ceil(farthest / step) * step
    return {
        reach,
        points: track.map(point => (point[0] / reach * HALF).toFixed(2) + ',' + (-point[1] / reach * HALF)
            .toFixed(2)).join(' '),
        last: track[track.length - 1].map((metres, axis) => (axis ? -1 : 1) * metres / reach * HALF)
    }
}

/** Formats the time of a GGA sentence; '–' without one. */
export function timeText(utc) {
    return utc ? utc.substring(0, 2) + ':' + utc.substring(2, 4) + ':' + utc.substring(4) + ' UTC' : '–'
}
