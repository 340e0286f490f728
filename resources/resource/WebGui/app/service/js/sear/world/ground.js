// SPDX-License-Identifier: Apache-2.0
import {Terrain} from './terrain.js'

var PATIENCE_MILLIS = 10000 // timeout: requests the terrain again

/** Makes the terrain of a world, which the service sends separately. */
export function makeGround(panel, picture) {
    var terrain = null          // latest terrain from the service, ready for use
    var awaited = {}            // stamp of the requested terrain, and when it was requested
    return {
        terrain: () => terrain,
        /** Returns the terrain of a world, requested when first needed; null without one, or until it arrives. */
        of: function(world) {
            var stamps = world ? world.objects.map(object => object.ground).filter(Boolean) : []
            if (!stamps.length) {
                return null
            }
            if (terrain && terrain.sent.stamp === stamps[0]) {
                return terrain
            }
            if (awaited.stamp !== stamps[0] || Date.now() - awaited.since > PATIENCE_MILLIS) {
                awaited = {stamp: stamps[0], since: Date.now()}
                panel.msg.send('getTerrain')
            }
            return null
        },
        handlers: {
            /** Each page receives the answers to all pages. */
            onTerrain: function(sent) {
                if (sent && sent.stamp && sent.stamp === awaited.stamp && !(terrain && terrain.sent.stamp === sent.stamp)) {
                    terrain = new Terrain(sent, picture.repaint)
                    picture.repaint()
                }
            }
        }
    }
}
