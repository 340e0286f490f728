// SPDX-License-Identifier: Apache-2.0
// The terrain in the SEAR panel: shaded picture, contour lines, elevation and place of a point. The Java class
// TerrainJson documents the data format.
const CONTOUR_PIXELS = 6      // distance of the elevation samples for contours, pixels
const MOST_LINES = 14         // maximum contour lines between the lowest and the highest visible point
const INDEX = 5               // every n-th line is thick and labelled
const LABEL_PIXELS = 280      // distance between two labels
const MOST_LABELS = 40
const PLACES = 33
const TRIANGLES = [[0, 1, 2], [0, 2, 3]]     // of a square
const CONTOURS = {light: 'rgba(96, 58, 20, 0.45)', dark: 'rgba(255, 226, 190, 0.35)'}
const LABELS = {light: '#5b3a1a', dark: '#f0dcc0'}
const NIGHT = 'rgba(10, 14, 20, 0.5)'

/** Returns the smallest of 1, 2, 5, 10, 20, 50, .. and their tenths that is not below a value. */
export function nice(value) {
    const ten = Math.pow(10, Math.floor(Math.log(value) / Math.LN10 + 1e-9))
    const one = value / ten
    return ten * (one <= 1 + 1e-9 ? 1 : one <= 2 + 1e-9 ? 2 : one <= 5 + 1e-9 ? 5 : 10)
}

/** Decodes the service's data. @param whenSeen called when the picture can be drawn */
export class Terrain {
    constructor(sent, whenSeen) {
        const bytes = atob(sent.heights)
        this.sent = sent
        this.heights = new Float64Array(sent.rows * sent.columns)
        for (let i = 0; i < this.heights.length; i++) {
            const value = bytes.charCodeAt(2 * i) + 256 * bytes.charCodeAt(2 * i + 1)
            this.heights[i] = sent.lowest + value * (sent.highest - sent.lowest) / 65535
        }
        this.picture = new window.Image()
        this.picture.onload = whenSeen
        this.picture.src = sent.picture
        this.lines = null
    }

    /**
     * Calls back with the grid cell of a point: index of its south-west post, fractions north and east. Returns null
     * outside the grid.
     */
    among(x, z, rows, columns, use) {
        const row = (x - this.sent.south) / (this.sent.north - this.sent.south) * (rows - 1)
        const column = (z - this.sent.west) / (this.sent.east - this.sent.west) * (columns - 1)
        if (!(row >= 0 && column >= 0 && row <= rows - 1 && column <= columns - 1)) {
            return null
        }
        const r = Math.min(rows - 2, Math.floor(row))
        const c = Math.min(columns - 2, Math.floor(column))
        return use(r * columns + c, row - r, column - c)
    }

    /** Returns the elevation in metres of the world; null outside the area. */
    height(x, z) {
        const heights = this.heights
        const columns = this.sent.columns
        return this.among(x, z, this.sent.rows, columns, (at, north, east) =>
            mixed(heights[at], heights[at + 1], heights[at + columns], heights[at + columns + 1], north, east))
    }

    /** Returns latitude and longitude in degrees; null outside the area, or for ground without a place on Earth. */
    place(x, z) {
        const places = this.sent.places
        return places && this.among(x, z, PLACES, PLACES, (at, north, east) => {
            const place = [0, 1].map(i => mixed(places[at][i], places[at + 1][i], places[at + PLACES][i],
                places[at + PLACES + 1][i], north, east))
            place[1] -= 360 * Math.floor((place[1] + 180) / 360)
            return place
        })
    }

    /** Describes a point as text; empty outside the area. */
    words(x, z) {
        const height = this.height(x, z)
        if (height === null) {
            return ''
        }
        const place = this.place(x, z)
        return 'here ' + height.toFixed(1) + ' m'
        + (place ? ', ' + (height + this.sent.altitude).toFixed(1) + ' m above the geoid at '
            + place[0].toFixed(6) + '°, ' + place[1].toFixed(6) + '°' : '')
    }

    /**
     * Returns the contour lines of the visible part: interval in metres, and lines as [level, x1, z1, x2, z2]. The
     * sampling grid is fixed in the world while the view moves.
     */
    contours(area, scale) {
        const key = [area.south, area.north, area.west, area.east, scale].join(' ')
        if (!this.lines || this.lines.key !== key) {
            this.lines = this.traced(area, Math.pow(2, Math.ceil(Math.log(CONTOUR_PIXELS / scale) / Math.LN2)))
            this.lines.key = key
        }
        return this.lines
    }

    traced(area, step) {
        const south = Math.max(Math.floor(area.south / step), Math.ceil(this.sent.south / step))
        const north = Math.min(Math.ceil(area.north / step), Math.floor(this.sent.north / step))
        const west = Math.max(Math.floor(area.west / step), Math.ceil(this.sent.west / step))
        const east = Math.min(Math.ceil(area.east / step), Math.floor(this.sent.east / step))
        const columns = east - west + 1
        const heights = []
        let lowest = Infinity
        let highest = -Infinity
        for (let row = south; row <= north; row++) {
            for (let column = west; column <= east; column++) {
                const height = this.height(row * step, column * step) + (this.sent.altitude || 0)
                lowest = Math.min(lowest, height)
                highest = Math.max(highest, height)
                heights.push(height)
            }
        }
        const found = {interval: highest > lowest ? nice((highest - lowest) / MOST_LINES) : 0, lines: []}
        for (let r = south; found.interval && r < north; r++) {
            for (let c = west; c < east; c++) {
                const at = (r - south) * columns + c - west
                cross(found, r * step, c * step, step,
                    [heights[at], heights[at + 1], heights[at + columns + 1], heights[at + columns]])
            }
        }
        return found
    }

    /**
     * Draws the terrain.
     * @param at maps metres on the ground to pixels @param area edges of the visible part: south, north, west, east 
     * @param dark the theme
     */
    draw(pen, at, area, scale, dark) {
        const corner = at(this.sent.north, this.sent.west)
        const other = at(this.sent.south, this.sent.east)
        if (this.picture.complete && this.picture.naturalWidth) {
            pen.drawImage(this.picture, corner.x, corner.y, other.x - corner.x, other.y - corner.y)
        }
        if (dark) {
            pen.fillStyle = NIGHT
            pen.fillRect(corner.x, corner.y, other.x - corner.x, other.y - corner.y)
        }
        const found = this.contours(area, scale)
        const theme = dark ? 'dark' : 'light'
        pen.strokeStyle = CONTOURS[theme]
        ;[false, true].forEach(index => {
            pen.beginPath()
            found.lines.forEach(line => {
                if ((line[0] % INDEX === 0) === index) {
                    const from = at(line[1], line[2])
                    const to = at(line[3], line[4])
                    pen.moveTo(from.x, from.y)
                    pen.lineTo(to.x, to.y)
                }
            })
            pen.lineWidth = index ? 1.6 : 0.8
            pen.stroke()
        })
        pen.lineWidth = 1
        label(pen, at, found, LABELS[theme])
    }
}

function mixed(southWest, southEast, northWest, northEast, north, east) {
    return (southWest * (1 - east) + southEast * east) * (1 - north)
        + (northWest * (1 - east) + northEast * east) * north
}

/**
 * Adds the lines in a square with corners south-west, south-east, north-east, north-west: one in each of two triangles.
 */
function cross(found, x, z, step, corners) {
    const low = Math.min.apply(null, corners)
    const high = Math.max.apply(null, corners)
    const places = [[x, z], [x, z + step], [x + step, z + step], [x + step, z]]
    for (let n = Math.ceil(low / found.interval); n * found.interval < high; n++) {
        const level = n * found.interval
        TRIANGLES.forEach(triangle => {
            const ends = []
            triangle.forEach((a, i) => {
                const b = triangle[(i + 1) % 3]
                if (corners[a] <= level !== corners[b] <= level) {
                    const share = (level - corners[a]) / (corners[b] - corners[a])
                    ends.push(places[a][0] + share * (places[b][0] - places[a][0]), places[a][1]
                        + share * (places[b][1] - places[a][1]))
                }
            })
            if (ends.length === 4) {
                found.lines.push([n].concat(ends))
            }
        })
    }
}

/** Labels some thick lines with their elevation, spaced apart. */
function label(pen, at, found, ink) {
    const put = []
    pen.fillStyle = ink
    pen.font = '11px sans-serif'
    found.lines.forEach(line => {
        if (line[0] % INDEX || put.length >= MOST_LABELS) {
            return
        }
        const place = at((line[1] + line[3]) / 2, (line[2] + line[4]) / 2)
        if (put.every(other => Math.abs(other.x - place.x) + Math.abs(other.y - place.y) > LABEL_PIXELS)) {
            put.push(place)
            pen.fillText(String(Number((line[0] * found.interval).toFixed(3))), place.x + 2, place.y + 4)
        }
    })
}
