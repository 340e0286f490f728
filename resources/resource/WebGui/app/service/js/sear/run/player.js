// SPDX-License-Identifier: Apache-2.0
// Plays the record of a shared run in its own page, without SEAR. share.js writes that page.
import * as geometry from '../shared/geometry.js'
import {makeMotion} from './motion.js'
import {Scene} from '../scene/scene.js'
import {Terrain} from '../world/terrain.js'
import {robotsAt} from '../records/frames.js'

function element(id) {
    return document.getElementById(id)
}

/** @param run world, record, motion or null, looks by key, terrain or null, title */
export function play(run) {
    var record = run.record
    var world = run.world
    var last = record.times.length - 1
    var index = 0
    var began = 0               // start of playing, by the browser's clock; 0 while paused
    var from = 0
    var waiting = false
    var grip = null
    var scene = new Scene(element('view'), function(keys) {
        window.setTimeout(function() {
            scene.looks.take(keys.map(key => run.looks[key]).filter(Boolean))
        })
    }, repaint)
    var motion = run.motion ? makeMotion(run.motion, world) : null
    var terrain = run.terrain ? new Terrain(run.terrain, repaint) : null

    function byName(list) {
        return list.reduce(function(all, one) {
            all[one.name] = one
            return all
        }, {})
    }
    var robots = byName(world.robots)
    var objects = byName(world.objects)

    function repaint() {
        if (!waiting) {
            waiting = true
            window.requestAnimationFrame(function() {
                waiting = false
                draw()
            })
        }
    }
    function draw() {
        if (began) {
            goOn()
        }
        scene.show(world, terrain, element('beams').checked)
        scene.draw(-1, element('follow').checked ? 0 : -1, window.matchMedia('(prefers-color-scheme: dark)').matches)
        if (began) {
            repaint()
        }
    }
    /** Shows a frame. */
    function seek(to) {
        index = Math.max(0, Math.min(last, Math.round(to)))
        robotsAt(robots, record, index)
        record.objects.forEach(function(name, i) {
            if (objects[name]) {
                objects[name].pose = record.objectPoses[index][i]
            }
        })
        world.time = record.times[index]
        if (motion) {
            motion.show(world.time)
        }
        element('slider').value = index
        element('time').textContent = record.times[index].toFixed(2) + ' s of ' + record.times[last].toFixed(2) + ' s'
        repaint()
    }
    function goOn() {
        var time = from + (Date.now() - began) / 1000 * Number(element('speed').value)
        var to = index
        while (to < last && record.times[to + 1] <= time) {
            to++
        }
        if (to !== index) {
            seek(to)
        }
        if (to === last) {
            stop()
        }
    }
    function stop() {
        began = 0
        element('play').textContent = 'Play'
    }
    function start() {
        if (index === last) {
            seek(0)
        }
        from = record.times[index]
        began = Date.now()
        element('play').textContent = 'Pause'
        repaint()
    }

    element('play').onclick = function() {
        if (began) {
            stop()
        } else {
            start()
        }
    }
    element('slider').max = last
    element('slider').oninput = function() {
        stop()
        seek(Number(element('slider').value))
    }
    element('speed').onchange = function() {
        if (began) {
            start()
        }
    }
    element('follow').onchange = repaint
    element('beams').onchange = repaint
    element('beams').parentElement.hidden = !world.sensors.length
    element('view').onpointerdown = function(event) {
        grip = {x: event.clientX, y: event.clientY}
        element('view').setPointerCapture(event.pointerId)
    }
    element('view').onpointermove = function(event) {
        if (grip && event.buttons) {
            scene[event.buttons !== 1 || event.shiftKey ? 'pan' : 'turn'](event.clientX - grip.x, event.clientY - grip.y)
            grip = {x: event.clientX, y: event.clientY}
            repaint()
        }
    }
    element('view').oncontextmenu = () => false
    element('view').addEventListener('wheel', function(event) {
        scene.zoom(event.deltaY < 0 ? 1.15 : 1 / 1.15)
        event.preventDefault()
        repaint()
    }, {passive: false})
    window.addEventListener('resize', repaint)

    seek(0)
    var area = geometry.area(geometry.shapesOf(world))
    if (area) {
        scene.fit({x: area.x, y: world.robots.length ? world.robots[0].pose[1] : 0, z: area.z, size: area.size},
            geometry.corners(world.objects))
    }
    start()
    return {scene: scene, index: () => index}
}
