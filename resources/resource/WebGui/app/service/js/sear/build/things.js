// SPDX-License-Identifier: Apache-2.0
// Things to play with that consist of one or several objects: their parts around the place where they stand.

const WOOD = '#c49a6c'
const ORANGE = '#ff7f0e'
const BLUE = '#1f4e8c'

function box(part, size, at, more) {
    return {type: 'Box', part, set: Object.assign({length: size[0], height: size[1], width: size[2], x: at[0], y: at[1],
        z: at[2], mass: 0}, more)}
}

function table() {
    const legs = [[-1, -1], [-1, 1], [1, -1], [1, 1]].map(([x, z], i) =>
        box('leg' + (i + 1), [0.04, 0.46, 0.04], [0.27 * x, 0.23, 0.42 * z], {color: WOOD}))
    return [box('top', [0.6, 0.03, 0.9], [0, 0.475, 0], {color: WOOD})].concat(legs)
}

/** A slope of 15 degrees up to the east, onto a platform. */
function ramp() {
    return [box('slope', [0.5, 0.02, 1], [0, 0.12, -0.23], {rx: -15, color: WOOD}),
        box('top', [0.5, 0.26, 0.5], [0, 0.13, 0.5], {color: WOOD})]
}

function coneAlley() {
    return [0, 1, 2, 3].flatMap(row => [-1, 1].map(side => ({type: 'Cone',
        part: (side < 0 ? 'right' : 'left') + (row + 1),
        set: {radius: 0.1, height: 0.3, mass: 0.3, color: ORANGE, x: 0.35 * side, y: 0.15, z: 0.5 * row}})))
}

function goal() {
    const posts = [-1, 1].map(side =>
        box(side < 0 ? 'right' : 'left', [0.05, 0.4, 0.05], [0.4 * side, 0.2, 0], {color: BLUE}))
    return posts.concat(box('bar', [0.85, 0.05, 0.05], [0, 0.425, 0], {color: BLUE}))
}

function ball() {
    return [{type: 'Sphere', part: '', set: {radius: 0.1, mass: 0.2, color: '#d62728', x: 0, y: 0.1, z: 0}}]
}

/** The things, with a description. */
export const THINGS = {
    ball: {parts: ball, doc: 'a red ball that rolls'},
    table: {parts: table, doc: 'a fixed table that a small robot can drive under'},
    ramp: {parts: ramp, doc: 'a slope of 15 degrees up to a platform'},
    coneAlley: {parts: coneAlley, doc: 'two rows of four cones to drive between'},
    goal: {parts: goal, doc: 'two posts with a bar'}
}

/** Whether a name is that of a thing. */
export function isThing(name) {
    return Object.prototype.hasOwnProperty.call(THINGS, name)
}

/** Returns the first free name: ball1, ball2 and so on; of a thing with parts, its parts' names begin with it. */
function free(thing, taken) {
    for (let i = 1;; i++) {
        const name = thing + i
        if (!taken.some(one => one === name || one.indexOf(name + ' ') === 0)) {
            return name
        }
    }
}

/**
 * Returns the edit that makes a thing, one step of undo.
 * @param at x, y, z of the ground below it, metres @param taken names in the world
 */
export function thingEdit(thing, at, taken, plain) {
    const name = free(thing, taken)
    const edits = THINGS[thing].parts().map(({type, part, set}) => ({'do': 'add', type,
        name: part ? name + ' ' + part : name,
        set: Object.assign({}, set, {x: plain(at[0] + set.x), y: plain(at[1] + set.y), z: plain(at[2] + set.z)})}))
    return {'do': 'all', words: 'add ' + name, edits}
}
