import {Terrain} from './terrain.js'

var PATIENCE_MILLIS = 10000 // an answer that takes longer is asked for again

/** The terrain below a world, which comes apart from that. */
export function makeGround(panel, picture) {
    var terrain = null          // what the service has sent last, ready for use
    var awaited = {}            // which has been asked for, and when
    return {
        terrain: () => terrain,
        /** The ground of a world, which is asked for when it is first seen; null if there is none or it has not come yet. */
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
            /** Each page gets the answers to all pages. */
            onTerrain: function(sent) {
                if (sent && sent.stamp && sent.stamp === awaited.stamp && !(terrain && terrain.sent.stamp === sent.stamp)) {
                    terrain = new Terrain(sent, picture.repaint)
                    picture.repaint()
                }
            }
        }
    }
}
