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
    truck: ['Truck', 'A truck with a trailer: try to reverse.'],
    line: ['Line', 'A black line on the floor to follow.'],
    rover: ['Arduino rover', 'Motors and sensors on the pins of an Arduino.'],
    avoider: ['Arduino sketch', 'A rover that its own compiled Arduino sketch drives.'],
    turret: ['Turret', 'A distance sensor turned by a servo.'],
    ball: ['Ball', 'A rover with cameras, and a red ball to follow.'],
    dock: ['Docking station', 'A marker at a dock, and a robot with a camera.']
}
const BY_HEART = Object.keys(EXAMPLES)

/** The start tiles of one panel: an empty view shows them, and Open does. */
export class Welcome {
    constructor(panel, world, view, palette, project, tour, shelf) {
        this.panel = panel
        this.world = world
        this.view = view
        this.palette = palette
        this.project = project
        this.tour = tour
        this.shelf = shelf
        this.opened = false     // whether the user asked for the tiles
        this.shownGroups = []
        this.made = []          // lists that the tiles belong to
        shelf.isSeen = () => this.isShown()
    }

    isShown() {
        const asks = this.world.isEmpty() && !this.view.building && !this.world.instead
        return !this.panel.isSimulating() && (this.opened || asks)
    }

    /** Shows the tiles, or hides those that the user asked for. */
    toggle() {
        this.opened = !this.isShown()
        this.shelf.look()
    }

    close() {
        this.opened = false
    }

    key(event) {
        if (event.key === 'Escape') {
            this.close()
        }
    }

    title() {
        return this.world.isEmpty() ? 'A robot simulator. Where do you want to begin?' : 'Open a project'
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

    /** Returns the tile of a project on the shelf. */
    shelfTile(one) {
        const kept = one.kind === 'kept'
        return {name: one.path, title: one.title, text: this.shelf.words(one), drawn: true,
            plan: () => this.shelf.picture(one), open: () => this.project.open(one.path, kept ? one.words : '')}
    }

    /** Returns the groups of tiles: the tour and building, own projects, kept ones, examples. */
    groups() {
        const made = [this.project.examples, this.shelf.list, this.world.isEmpty()]
        if (made.some((part, i) => part !== this.made[i])) {
            this.made = made
            this.shownGroups = this.grouped(...made)
        }
        return this.shownGroups
    }

    grouped(paths, listed, isFirst) {
        const begin = [this.ownTile(TOUR, () => this.tour.start()), this.ownTile(MINE, () => this.build())]
        const examples = paths.slice().sort((a, b) => this.rank(a) - this.rank(b)).map(path => this.tileOf(path))
        if (!listed.length) {
            return [{name: '', tiles: begin.concat(examples)}]
        }
        const groups = [this.groupOf('My projects', 'own'),
            this.groupOf('Kept when another project replaced them', 'kept'),
            {name: 'Examples', tiles: examples}]
        groups[isFirst ? 'unshift' : 'push']({name: 'Begin', tiles: begin})
        return groups.filter(group => group.tiles.length)
    }

    groupOf(name, kind) {
        return {name, tiles: this.shelf.of(kind).map(one => this.shelfTile(one))}
    }

    /** Begins a robot of one's own, on empty ground. */
    build() {
        if (!this.world.isEmpty()) {
            this.project.startAnew()
        }
        this.close()
        this.view.showSpace()
        this.palette.build()
    }
}
