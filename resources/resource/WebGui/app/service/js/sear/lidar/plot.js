// SPDX-License-Identifier: Apache-2.0
// Polar plot of a scan: sensor at the bottom centre, 0 degrees to the right, 90 degrees ahead. Pure functions of scan
// and geometry: x and y of the sensor, radius (all pixels), reach (metres at that radius), full (whether it is a
// circle).
const MARGIN = 28             // pixels above and below the plot
const SIDE = 42               // pixels beside the plot, for the labels of 0 and 180 degrees
const LABEL = 40              // pixels for a ring's label
const ANGLE_STEP = 30
const RING_STEPS = [0.25, 0.5, 1, 2, 5, 10, 20]
const MOST_RINGS = 6
const EMPTY_REACH = 8         // range of an empty plot, metres: that of most scanners
const SHRINK = 0.6            // the automatic range shrinks below this fraction, which avoids jumping
const FULL_CIRCLE = 180.5
const NEARLY = 1e-9           // metres

/** Returns the distance between two rings of a plot, metres. @param reach its radius, metres */
export function ringStep(reach) {
    return RING_STEPS.find(step => reach / step <= MOST_RINGS) || RING_STEPS[RING_STEPS.length - 1]
}

/**
 * Returns the automatic range of a plot, metres: a round number beyond the greatest distance.
 * @param before the range until now, which stays if it still fits; 0 for none
 */
export function reachOf(scan, before) {
    const farthest = scan.metres.reduce((most, metres) => Math.max(most, metres), 0) || EMPTY_REACH
    const step = ringStep(farthest)
    return farthest > before || farthest < before * SHRINK ? Math.ceil(farthest / step) * step : before
}

/** Returns the geometry in an area of pixels. @param scan null without one @param reach metres; 0 if unknown */
export function geometryOf(width, height, scan, reach) {
    const full = Boolean(scan) && scan.spread > FULL_CIRCLE
    const radius = Math.min(width / 2 - SIDE, full ? height / 2 - MARGIN : height - 2 * MARGIN)
    return {x: width / 2, y: full ? height / 2 : height - MARGIN, radius, reach: reach || EMPTY_REACH, full}
}

/** Returns the pixel of a distance and a direction. */
export function point(geometry, metres, degrees) {
    const pixels = metres / geometry.reach * geometry.radius
    const angle = degrees * Math.PI / 180
    return {x: geometry.x + pixels * Math.cos(angle), y: geometry.y - pixels * Math.sin(angle)}
}

/** Returns the index of the beam at a pixel; null for none. */
export function beamAt(geometry, scan, x, y) {
    const degrees = Math.atan2(geometry.y - y, x - geometry.x) * 180 / Math.PI
    const index = Math.round(((degrees + 360 - scan.angles[0]) % 360) / (scan.resolution || 1))
    return index < scan.angles.length ? index : null
}

/** Describes a beam. @param i its index */
export function beamText(scan, i) {
    const metres = scan.metres[i]
    return scan.angles[i] + '°: ' + (metres === null ? 'no return (' + scan.raw[i] + ')' : metres + ' m (' + scan.raw[i]
        + ' ' + scan.unit + ')')
}

/** Returns the beams of a scan as table rows. */
export function rowsOf(scan) {
    return scan.angles.map((angle, i) => ({angle, raw: scan.raw[i], metres: scan.metres[i]}))
}

/** Returns a scan as CSV text. */
export function csv(scan) {
    return ['angle_deg,raw_' + scan.unit + ',metres'].concat(rowsOf(scan).map(row => row.angle + ',' + row.raw + ','
        + (row.metres === null ? '' : row.metres))).join('\r\n') + '\r\n'
}

/** Draws the plot. @param scan null without one @param beam index of the marked beam; null without one */
export function draw(pen, geometry, colour, scan, beam) {
    drawGrid(pen, geometry, colour, scan && scan.unit === 'cm')
    if (scan) {
        drawScan(pen, geometry, scan)
    }
    if (scan && beam !== null) {
        drawBeam(pen, geometry, colour, scan.metres[beam], scan.angles[beam])
    }
    pen.fillStyle = colour
    pen.beginPath()
    pen.arc(geometry.x, geometry.y, 4, 0, 2 * Math.PI)
    pen.fill()
}

function drawLine(pen, geometry, to) {
    pen.beginPath()
    pen.moveTo(geometry.x, geometry.y)
    pen.lineTo(to.x, to.y)
    pen.stroke()
}

function drawGrid(pen, geometry, colour, inCentimetres) {
    const step = ringStep(geometry.reach)
    const scale = geometry.radius / geometry.reach
    const last = geometry.full ? 359 : 180
    pen.strokeStyle = colour
    pen.fillStyle = colour
    pen.font = '11px sans-serif'
    pen.lineWidth = 1
    pen.globalAlpha = 0.35
    for (let ring = step; ring <= geometry.reach + NEARLY; ring += step) {
        pen.beginPath()
        pen.arc(geometry.x, geometry.y, ring * scale, geometry.full ? 0 : Math.PI, 2 * Math.PI)
        pen.stroke()
    }
    for (let degrees = 0; degrees <= last; degrees += ANGLE_STEP) {
        drawLine(pen, geometry, point(geometry, geometry.reach, degrees))
    }
    pen.globalAlpha = 0.9
    pen.textAlign = 'center'
    const labelled = step * scale < LABEL ? 2 * step : step
    for (let ring = labelled; ring <= geometry.reach + NEARLY; ring += labelled) {
        pen.fillText(inCentimetres ? Math.round(ring * 100) + ' cm' : ring + ' m', geometry.x + ring * scale,
            geometry.y + 14)
    }
    for (let degrees = 0; degrees <= last; degrees += ANGLE_STEP) {
        const end = point(geometry, geometry.reach * (1 + 14 / geometry.radius), degrees)
        pen.textAlign = degrees < 80 || degrees > 280 ? 'left' : degrees > 100 && degrees < 260 ? 'right' : 'center'
        pen.fillText(degrees + '°', end.x, end.y + (degrees > 0 && degrees < 180 ? 0 : -3))
    }
    pen.globalAlpha = 1
}

/** Returns a distance within the plot; that of a beam without a return is the outermost ring. */
function within(geometry, metres) {
    return metres === null ? geometry.reach : Math.min(metres, geometry.reach)
}

function isIn(geometry, metres) {
    return metres !== null && metres <= geometry.reach
}

function drawScan(pen, geometry, scan) {
    const ends = scan.angles.map((angle, i) => point(geometry, within(geometry, scan.metres[i]), angle))
    pen.beginPath()
    pen.moveTo(geometry.x, geometry.y)
    ends.forEach(end => pen.lineTo(end.x, end.y))
    pen.closePath()
    pen.fillStyle = 'rgba(51, 122, 183, 0.18)'
    pen.fill()
    pen.fillStyle = '#d9534f'
    ends.filter((end, i) => isIn(geometry, scan.metres[i])).forEach(end => pen.fillRect(end.x - 1.5, end.y - 1.5, 3, 3))
}

function drawBeam(pen, geometry, colour, metres, degrees) {
    const at = point(geometry, within(geometry, metres), degrees)
    pen.strokeStyle = colour
    pen.lineWidth = 1.5
    drawLine(pen, geometry, at)
    if (isIn(geometry, metres)) {
        pen.beginPath()
        pen.arc(at.x, at.y, 5, 0, 2 * Math.PI)
        pen.stroke()
    }
}
