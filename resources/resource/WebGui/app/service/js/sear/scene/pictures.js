// SPDX-License-Identifier: Apache-2.0
// Floor pictures for the SEAR panel's map, each requested when first needed.
import * as geometry from '../shared/geometry.js'

var KEY = 'picture '        // prefix of picture keys among the keys of looks
var NIGHT = 0.55            // opacity of pictures on a dark page, where labels are light
var PATIENCE_MILLIS = 10000 // timeout: requests the picture again

/** @param ask requests pictures by their keys @param whenThere called when one has arrived */
export function makePictures(ask, whenThere) {
    var images = {}             // by path; null if it can't be shown
    var asked = {}              // by path: time of the request

    return {
        /** Returns the image of a path; null until it is there. */
        of: function(path) {
            var now = Date.now()
            if (images[path] === undefined && !(now - asked[path] < PATIENCE_MILLIS)) {
                asked[path] = now
                ask([KEY + path])
            }
            return images[path] || null
        },
        /** Takes what the service has sent. */
        take: function(sent) {
            angular.forEach(sent, function(one) {
                var path = one.key.slice(KEY.length)
                if (one.key.indexOf(KEY) !== 0 || !asked[path]) {
                    return
                }
                images[path] = null
                if (one.data) {
                    var image = new window.Image()
                    image.onload = function() {
                        images[path] = image
                        whenThere()
                    }
                    image.src = one.data
                }
            })
        }
    }
}

/**
 * Draws an image on a floor as in the 3D view: its right at -z, its top at -x.
 * @param at see map.projection @param dark the theme
 */
export function lay(pen, at, floor, image, dark) {
    var half = [0, 2].map(axis => Math.max.apply(null, floor.corners.map(point => point[axis])))
    var pose = geometry.frame(floor.pose)
    function corner(x, z) {
        var point = geometry.onGround(pose, [x * half[0], 0, z * half[1]])
        return at(point[0], point[1])
    }
    var first = corner(-1, 1)
    var right = corner(-1, -1)
    var low = corner(1, 1)
    var wide = floor.tile ? image.width * 2 * half[1] / floor.tile : image.width
    var high = floor.tile ? image.height * 2 * half[0] / floor.tile : image.height
    pen.save()
    pen.transform((right.x - first.x) / wide, (right.y - first.y) / wide, (low.x - first.x) / high, (low.y - first.y) / high, first.x, first.y)
    pen.globalAlpha = dark ? NIGHT : 1
    pen.fillStyle = pen.createPattern(image, 'repeat')
    pen.fillRect(0, 0, wide, high)
    pen.restore()
}
