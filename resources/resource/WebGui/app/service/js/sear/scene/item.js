// A thing in the view in space of the SEAR panel: a holder that goes from pose to pose without jumps, with what is seen in it.
import * as geometry from '../shared/geometry.js'

var JUMP = 1                // metres: what moves more at once was put there

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
Item.prototype.goTo = function(pose, now) {
    if (pose === this.pose) {
        return
    }
    var to = geometry.frame(pose)
    var far = !this.to || Math.abs(to[0] - this.to[0]) + Math.abs(to[1] - this.to[1]) + Math.abs(to[2] - this.to[2]) > JUMP
    this.from = far ? to : this.shown || this.to
    this.to = to
    this.pose = pose
    this.since = now
    this.holder.visible = true
}
/** @return whether it is still on its way */
Item.prototype.move = function(now, period) {
    if (!this.to) {
        return false
    }
    var share = this.from === this.to ? 1 : Math.min(1, (now - this.since) / period)
    if (share === 1 && this.shown === this.to) {
        return false
    }
    var pose = share === 1 ? this.to : between(this.from, this.to, share)
    this.shown = pose
    this.holder.position.set(pose[0], pose[1], pose[2])
    this.holder.quaternion.set(pose[3], pose[4], pose[5], pose[6])
    return share < 1
}
function between(a, b, share) {
    var dot = a[3] * b[3] + a[4] * b[4] + a[5] * b[5] + a[6] * b[6]
    var pose = a.map((value, i) => value * (1 - share) + (i > 2 && dot < 0 ? -b[i] : b[i]) * share)
    var length = Math.sqrt(pose[3] * pose[3] + pose[4] * pose[4] + pose[5] * pose[5] + pose[6] * pose[6])
    return pose.map((value, i) => i > 2 ? value / length : value)
}
