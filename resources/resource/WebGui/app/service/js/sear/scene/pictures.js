// SPDX-License-Identifier: Apache-2.0
// Floor pictures for the SEAR panel's map, each requested when first needed.
import * as geometry from '../shared/geometry.js'

const KEY = 'picture '        // prefix of picture keys among the keys of looks
const NIGHT = 0.55            // opacity of pictures on a dark page, where labels are light
const PATIENCE_MILLIS = 10000 // timeout: requests the picture again

/** Pictures of floors. */
export class Pictures {
    /** @param ask requests pictures by their keys @param whenThere called when one has arrived */
    constructor(ask, whenThere) {
        this.ask = ask
        this.whenThere = whenThere
        this.images = {}        // by path; null if it can't be shown
        this.asked = {}         // by path: time of the request
    }

    /** Returns the image of a path; null until it is there. */
    of(path) {
        const now = Date.now()
        if (this.images[path] === undefined && !(now - this.asked[path] < PATIENCE_MILLIS)) {
            this.asked[path] = now
            this.ask([KEY + path])
        }
        return this.images[path] || null
    }

    /** Takes what the service has sent. */
    take(sent) {
        angular.forEach(sent, one => {
            const path = one.key.slice(KEY.length)
            if (one.key.indexOf(KEY) !== 0 || !this.asked[path]) {
                return
            }
            this.images[path] = null
            if (one.data) {
                const image = new window.Image()
                image.onload = () => {
                    this.images[path] = image
                    this.whenThere()
                }
                image.src = one.data
            }
        })
    }
}

/**
 * Draws an image on a floor as in the 3D view: its right at -z, its top at -x.
 * @param at see map.projection @param dark the theme
 */
export function lay(pen, at, floor, image, dark) {
    const half = [0, 2].map(axis => Math.max.apply(null, floor.corners.map(point => point[axis])))
    const pose = geometry.frame(floor.pose)
    function corner(x, z) {
        const point = geometry.onGround(pose, [x * half[0], 0, z * half[1]])
        return at(point[0], point[1])
    }
    const first = corner(-1, 1)
    const right = corner(-1, -1)
    const low = corner(1, 1)
    const wide = floor.tile ? image.width * 2 * half[1] / floor.tile : image.width
    const high = floor.tile ? image.height * 2 * half[0] / floor.tile : image.height
    pen.save()
    pen.transform((right.x - first.x) / wide, (right.y - first.y) / wide, (low.x - first.x) / high,
        (low.y - first.y) / high, first.x, first.y)
    pen.globalAlpha = dark ? NIGHT : 1
    pen.fillStyle = pen.createPattern(image, 'repeat')
    pen.fillRect(0, 0, wide, high)
    pen.restore()
}
