// SPDX-License-Identifier: Apache-2.0
// Drag spring in the SEAR panel: with the Shift key, the mouse pulls a loose object of a running world. The service
// simulates the spring.
import * as geometry from '../shared/geometry.js'
import {find, local, onPlane, ray} from '../world/pointing.js'

var SEND_MILLIS = 50        // between two messages to the service
var AGAIN_MILLIS = 400      // the service releases the object after a second without messages

/** Makes the drag spring of one panel. */
export function makeHand(panel, world, view, pointer) {
    var held = null             // name, from: point taken, grip: the same in its own frame, way, normal of the mouse's plane
    var spring = null           // drawn line
    var hand = {}

    function nameOf(who) {
        return who && (who.robot || (who.object.loose ? who.object.name : null))
    }
    /** Returns the viewing direction. */
    function ahead() {
        var canvas = pointer.canvas()
        return pointer.scene() ? ray(pointer.scene(), canvas.clientWidth / 2, canvas.clientHeight / 2).along : null
    }
    function take(event) {
        var p = pointer.position(event)
        var under = event.button === 0 && event.shiftKey && panel.isSimulating() && world.running && !world.instead && !view.building
            && event.target === pointer.canvas() ? pointer.at(p[0], p[1]) : null
        var name = under && nameOf(under.who)
        var body = name && find(world.running, name)
        if (!body) {
            return
        }
        held = {name: name, from: under.point, grip: local(body.pose, under.point), way: [0, 0, 0], sent: 0, at: p, normal: ahead()}
        event.stopImmediatePropagation()
        event.preventDefault()
        pointer.canvas().focus()
        held.timer = window.setInterval(send, AGAIN_MILLIS)
        send()
        draw()
    }
    function send() {
        held.sent = Date.now()
        panel.msg.send('hold', held.name, held.way)
    }
    function move(event) {
        if (!held) {
            return
        }
        event.stopImmediatePropagation()
        if (!event.buttons) {
            letGo()
            return
        }
        held.at = pointer.position(event)
        var to = pointer.scene() ? onPlane(ray(pointer.scene(), held.at[0], held.at[1]), held.from, held.normal) : onMap()
        if (to) {
            held.way = to.map((value, i) => value - held.from[i])
        }
        if (Date.now() - held.sent >= SEND_MILLIS) {
            send()
        }
        draw()
    }
    function onMap() {
        var canvas = pointer.canvas()
        return [view.x - (held.at[1] - canvas.clientHeight / 2) / view.scale, held.from[1],
            view.z + (held.at[0] - canvas.clientWidth / 2) / view.scale]
    }
    function letGo() {
        if (held) {
            window.clearInterval(held.timer)
            panel.msg.send('letGo', held.name)
            held = null
            draw()
        }
    }

    // ---- drawing ---------------------------------------------------------------------------------------------------------------------------
    function makeSpring() {
        var space = 'http://www.w3.org/2000/svg'
        var svg = document.createElementNS(space, 'svg')
        spring = document.createElementNS(space, 'line')
        svg.setAttribute('class', 'sear-spring')
        svg.setAttribute('aria-hidden', 'true')
        svg.append(spring)
        pointer.canvas().parentElement.append(svg)
    }
    function draw() {
        if (!spring) {
            makeSpring()
        }
        var body = held && world.running && find(world.running, held.name)
        spring.parentElement.style.display = body ? '' : 'none'
        if (body) {
            var turned = geometry.rotate(body.pose, held.grip)
            var grip = [0, 1, 2].map(i => body.pose[i] + turned[i])
            var seen = pointer.scene() ? pointer.scene().toScreen(grip[0], grip[1], grip[2]) : view.toScreen(grip[0], grip[2])
            var ends = {x1: seen.x, y1: seen.y, x2: held.at[0], y2: held.at[1]}
            Object.keys(ends).forEach(name => spring.setAttribute(name, ends[name]))
        }
    }
    world.told.hear(function(running) {
        if (held && running) {
            draw()
        } else {
            letGo()
        }
    })

    /** Adds the listeners once the views exist, before all other mouse listeners. */
    hand.listen = function() {
        panel.element('view').parentElement.addEventListener('mousedown', take, true)
        var heard = {mousemove: move, mouseup: letGo, beforeunload: letGo, blur: function(event) {
            if (event.target === window) {      // not for an element in it
                letGo()
            }
        }}
        Object.keys(heard).forEach(name => window.addEventListener(name, heard[name], true))
        panel.scope.$on('$destroy', function() {
            letGo()
            Object.keys(heard).forEach(name => window.removeEventListener(name, heard[name], true))
        })
    }
    return hand
}
