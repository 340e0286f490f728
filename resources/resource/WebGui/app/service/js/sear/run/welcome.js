// SPDX-License-Identifier: Apache-2.0
// Start tiles that the SEAR panel shows in an empty view.

var TILES = '../tiles/'
var TOUR = {name: 'tour', title: 'First robot', text: 'A ten-minute tour: build a rover with a sensor, and drive it.', picture: 'tour.jpg',
    first: true}
var MINE = {name: 'build', title: 'Build my own', text: 'Empty ground, and a palette of objects, robots and sensors.', picture: 'build.jpg'}
// Title and description of each example, by name.
var EXAMPLES = {
    office: ['Office', 'A Roomba with a laser scanner among desks and chairs.'],
    maze: ['Maze', 'A robot that searches for the exit.'],
    sensors: ['Every sensor', 'One robot with all sensors, in a yard.'],
    ramps: ['Ramps', 'Slopes, steps and kerbs: what can it climb?'],
    mountain: ['Mountain', 'Real terrain from elevation data.'],
    car: ['Car', 'A steered car on a road.'],
    line: ['Line', 'A black line on the floor to follow.'],
    rover: ['Arduino rover', 'Motors and sensors on the pins of an Arduino.'],
    turret: ['Turret', 'A distance sensor turned by a servo.'],
    ball: ['Ball', 'A rover with cameras, and a red ball to follow.'],
    dock: ['Docking station', 'A marker at a dock, and a robot with a camera.']
}
var BY_HEART = Object.keys(EXAMPLES)

/** Makes the start tiles of one panel. */
export function makeWelcome(world, view, palette, project, tour) {
    var tiles = []
    var made = null             // examples that the tiles belong to
    var welcome = {}

    welcome.isShown = function() {
        return world.isEmpty() && !view.building && !world.instead
    }
    function nameOf(path) {
        return path.replace(/^.*\//, '').replace(/\.sear$/, '')
    }
    function rank(path) {
        var at = BY_HEART.indexOf(nameOf(path))
        return at < 0 ? BY_HEART.length : at
    }
    function picture(file) {
        return new URL(TILES + file, import.meta.url).href
    }
    function tileOf(path) {
        var name = nameOf(path)
        var known = EXAMPLES[name] || [name, '']
        return {name: name, title: known[0], text: known[1], picture: known[1] ? picture(name + '.jpg') : '', open: () => project.open(path)}
    }
    function ownTile(tile, open) {
        return angular.extend({}, tile, {picture: picture(tile.picture), open: open})
    }
    /** Returns the tiles: the tour, one for building, and one for each example. */
    welcome.tiles = function() {
        if (made !== project.examples) {
            made = project.examples
            tiles = [ownTile(TOUR, tour.start), ownTile(MINE, palette.build)]
                .concat(made.slice().sort((a, b) => rank(a) - rank(b)).map(tileOf))
        }
        return tiles
    }
    return welcome
}
