// SPDX-License-Identifier: Apache-2.0
// Object in the SEAR panel's 3D view: a holder with content that moves smoothly from pose to pose.
import * as geometry from '../shared/geometry.js'

/** Makes an object's holder in the scene. */
export class Item {
    constructor(parent, source) {
        this.source = source
        this.parent = parent
        this.holder = new window.THREE.Object3D()
        this.holder.visible = false
        parent.add(this.holder)
        this.extra = null           // another object in the scene, removed together with it
        this.marker = null          // likewise, the ball that marks a sensor while building
        this.pose = null
        this.from = null
        this.to = null
        this.dressed = false
    }

    /** Starts a movement to a pose. @param seconds simulated duration of the movement */
    goTo(pose, now, seconds) {
        if (pose === this.pose) {
            return
        }
        this.from = this.shown || this.to
        this.to = geometry.frame(pose)
        this.seconds = seconds
        this.pose = pose
        this.since = now
        this.holder.visible = true
    }

    /** Moves the holder. @return whether it is still moving */
    move(now, period) {
        if (!this.to || this.shown === this.to) {
            return false
        }
        const pose = this.from ? geometry.between(this.from, this.to, (now - this.since) / period,
            this.seconds) : this.to
        this.shown = pose
        this.holder.position.set(pose[0], pose[1], pose[2])
        this.holder.quaternion.set(pose[3], pose[4], pose[5], pose[6])
        return pose !== this.to
    }
}
