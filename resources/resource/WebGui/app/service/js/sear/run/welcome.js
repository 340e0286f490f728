// SPDX-License-Identifier: Apache-2.0
// Start tiles that the SEAR panel shows in an empty view.

const TILES = '../tiles/'
const TOUR = {name: 'tour', title: 'First robot', text: 'A ten-minute tour: build a rover with a sensor, and drive it.',
    picture: 'tour.jpg',
    first: true}
const MINE = {name: 'build', title: 'Build my own', text: 'Empty ground, and a palette of objects, robots and sensors.',
    picture: 'build.jpg'}
// Title and description of each example, by name.
const EXAMPLES = {
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
const BY_HEART = Object.keys(EXAMPLES)

/** The start tiles of one panel. */
export class Welcome {
    constructor(world, view, palette, project, tour) {
        this.world = world
        this.view = view
        this.palette = palette
        this.project = project
        this.tour = tour
        this.shownTiles = []
        this.made = null        // examples that the tiles belong to
    }

    isShown() {
        return this.world.isEmpty() && !this.view.building && !this.world.instead
    }

    nameOf(path) {
        return path.replace(/^.*\//, '').replace(/\.sear$/, '')
    }

    rank(path) {
        const at = BY_HEART.indexOf(this.nameOf(path))
        return at < 0 ? BY_HEART.length : at
    }

    picture(file) {
        return new URL(TILES + file, import.meta.url).href
    }

    tileOf(path) {
        const name = this.nameOf(path)
        const known = EXAMPLES[name] || [name, '']
        return {name, title: known[0], text: known[1], picture: known[1] ? this.picture(name + '.jpg') : '',
            open: () => this.project.open(path)}
    }

    ownTile(tile, open) {
        return Object.assign({}, tile, {picture: this.picture(tile.picture), open})
    }

    /** Returns the tiles: the tour, one for building, and one for each example. */
    tiles() {
        if (this.made !== this.project.examples) {
            this.made = this.project.examples
            this.shownTiles = [this.ownTile(TOUR, () => this.tour.start()),
                this.ownTile(MINE, () => this.palette.build())]
                .concat(this.made.slice().sort((a, b) => this.rank(a) - this.rank(b)).map(path => this.tileOf(path)))
        }
        return this.shownTiles
    }
}
