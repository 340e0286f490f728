// SPDX-License-Identifier: Apache-2.0
import {Terrain} from './terrain.js'

const PATIENCE_MILLIS = 10000 // timeout: requests the terrain again

/** The terrain of a world, which the service sends separately. */
export class Ground {
    constructor(panel, picture) {
        this.panel = panel
        this.picture = picture
        this.terrain = null     // latest terrain from the service, ready for use
        this.awaited = {}       // stamp of the requested terrain, and when it was requested
        this.handlers = {onTerrain: sent => this.take(sent)}
    }

    /** Returns the terrain of a world, requested when first needed; null without one, or until it arrives. */
    of(world) {
        const stamps = world ? world.objects.map(object => object.ground).filter(Boolean) : []
        if (!stamps.length) {
            return null
        }
        if (this.isThere(stamps[0])) {
            return this.terrain
        }
        if (this.awaited.stamp !== stamps[0] || Date.now() - this.awaited.since > PATIENCE_MILLIS) {
            this.awaited = {stamp: stamps[0], since: Date.now()}
            this.panel.msg.send('getTerrain')
        }
        return null
    }

    isThere(stamp) {
        return Boolean(this.terrain) && this.terrain.sent.stamp === stamp
    }

    /** Takes a terrain. Each page receives the answers to all pages. */
    take(sent) {
        if (sent && sent.stamp && sent.stamp === this.awaited.stamp && !this.isThere(sent.stamp)) {
            this.terrain = new Terrain(sent, this.picture.repaint)
            this.picture.repaint()
        }
    }
}
