// A thing in the view in space of the SEAR panel: a holder that goes from pose to pose without jumps, with what is seen in it.
import * as geometry from '../shared/geometry.js'

/** What stands somewhere: a holder in the scene that is moved, with what is seen in it. */
export function Item(parent, source) {
    this.source = source
    this.parent = parent
    this.holder = new window.THREE.Object3D()
    this.holder.visible = false
    parent.add(this.holder)
    this.extra = null           // what stands beside it in the scene and goes with it
    this.marker = null          // likewise, what stands for a sensor while one builds
    this.pose = null
    this.from = null
    this.to = null
    this.dressed = false
}
/** @param seconds simulated, that it takes to get there */
Item.prototype.goTo = function(pose, now, seconds) {
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
/** @return whether it is still on its way */
Item.prototype.move = function(now, period) {
    if (!this.to || this.shown === this.to) {
        return false
    }
    var pose = this.from ? geometry.between(this.from, this.to, (now - this.since) / period, this.seconds) : this.to
    this.shown = pose
    this.holder.position.set(pose[0], pose[1], pose[2])
    this.holder.quaternion.set(pose[3], pose[4], pose[5], pose[6])
    return pose !== this.to
}
