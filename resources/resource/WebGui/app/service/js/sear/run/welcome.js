// What the SEAR panel shows in place of an empty view: pictures of what one can begin with.

var TILES = '../tiles/'
var TOUR = {name: 'tour', title: 'First robot', text: 'A tour of ten minutes: build a rover with an eye, and drive it.', picture: 'tour.jpg',
    first: true}
var MINE = {name: 'build', title: 'Build my own', text: 'An empty ground, and a palette of things, robots and sensors.', picture: 'build.jpg'}
// By the name of an example: its title, and what one sees there.
var EXAMPLES = {
    office: ['Office', 'A Roomba with a laser scanner among desks and chairs.'],
    maze: ['Maze', 'A robot that looks for the way out.'],
    sensors: ['Every sensor', 'One robot with all of them, in a yard.'],
    ramps: ['Ramps', 'Slopes, steps and kerbs: what can it climb?'],
    mountain: ['Mountain', 'Real terrain from elevation data.'],
    car: ['Car', 'A steered car on a road.'],
    line: ['Line', 'A black line on the floor, to be followed.'],
    rover: ['Arduino rover', 'Motors and sensors on the pins of an Arduino.'],
    turret: ['Turret', 'A distance sensor that a servo turns.'],
    ball: ['Ball', 'A rover with cameras, and a red ball to follow.'],
    dock: ['Docking station', 'A marker at a dock, and a robot with a camera.']
}
var BY_HEART = Object.keys(EXAMPLES)

/** Of one panel. */
export function makeWelcome(world, view, palette, project, tour) {
    var tiles = []
    var made = null             // the examples that these are of
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
    /** The tour, one to build without any example, and one for each example. */
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
