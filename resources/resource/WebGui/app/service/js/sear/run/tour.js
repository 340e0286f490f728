// SPDX-License-Identifier: Apache-2.0
// The tour of the SEAR panel: from empty ground to a driving robot with a sensor. A step ends as soon as the user has
// done it. Uses driver.js, which the build copies to lib. docs/first-robot.md has the same content.
import {driver} from '../lib/driver.js'
import {frame} from '../shared/geometry.js'
import {local} from '../world/pointing.js'

const OPENS_MILLIS = 2000     // maximum wait for a step's element
const MOVED = 0.3             // metres that the robot has to drive
const NEAREST = 0.2           // minimum distance of an obstacle ahead of the robot, metres
const FARTHEST = 3            // and maximum: the sensor's range
const MARK = 'sear-marked'    // class of the element to click
const ASIDE = 0.35            // maximum lateral offset of an obstacle, metres

/**
 * Returns the steps: element to point at, palette entry to click, text, completion test, and the text after a mistake.
 * A step without a test ends by its button.
 */
function stepsOf(panel, world, palette, script, layout) {
    function now() {
        return world.now() || {objects: [], robots: [], sensors: []}
    }
    function isArmed(name) {
        return Boolean(palette.armed && palette.armed.name === name)
    }
    /** Whether a robot has left its start. */
    function hasMoved() {
        return panel.isSimulating() && now().robots.some(robot => {
            const first = robot.path[0]
            return Math.hypot(robot.pose[0] - first[0], robot.pose[2] - first[1]) > MOVED
        })
    }
    const hasRobot = () => now().robots.length > 0
    const hasSensor = () => now().sensors.length > 0
    const boxes = () => now().objects.filter(object => object.type === 'Box')
    /** Whether an object is ahead of a robot. */
    function isAhead(thing) {
        return now().robots.some(robot => {
            const at = local(frame(robot.pose), thing.pose)
            return Math.abs(at[0]) < ASIDE && at[2] > NEAREST && at[2] < FARTHEST
        })
    }
    return [
        {at: '.sear-palette', make: 'rover', title: 'Choose a robot',
            text: 'The palette contains all objects. Click <b>Rover</b>: two driven wheels and a caster.',
            done: () => isArmed('rover') || hasRobot()},
        {at: '.sear-canvas', title: 'Put it on the ground',
            text: 'Click on the ground near the middle. SEAR adds a floor.', done: hasRobot},
        {at: '.sear-palette', make: 'Distance', title: 'Give it an eye',
            text: 'Click <b>Distance sensor</b>, in the group <i>Sensors</i>.', done: () => isArmed('Distance')
                || hasSensor()},
        {at: '.sear-canvas', title: 'Mount it',
            text: 'Click on the rover, or on <b>Put it in the middle</b>. The sensor looks ahead and slightly up, '
                + 'over the floor.', done: hasSensor},
        {at: '.sear-palette', make: 'Box', title: 'An obstacle',
            text: 'Click <b>Box</b>, the first entry.', done: () => isArmed('Box') || boxes().length > 0},
        {at: '.sear-canvas', title: 'In its way',
            text: 'Click on the ground about a metre ahead of the rover. The rover faces along the blue axis, '
            + 'to the east.',
            done: () => boxes().some(isAhead), wrong: () => boxes().length > 0,
            instead: 'That box is not in the rover\'s way. Drag it to about a metre ahead of the rover, along '
                + 'the blue axis.'},
        {at: '.sear-making', title: 'Start',
            text: 'Click <b>Test drive</b>: the simulation starts, and the keys drive the rover.',
                done: () => panel.isSimulating()},
        {at: '.sear-driving', title: 'Drive',
            text: 'Hold <b>W</b> or the arrow up, or click an arrow below the view. <i>Readings</i>, on the right, '
            + 'shows the sensor\'s values.',
            done: hasMoved},
        {at: '.sear-drawers', title: 'See what it did',
            text: 'Click <b>Plots</b>: the rover\'s speed and the sensor\'s reading over time.',
                done: () => !layout.isFolded('plots')},
        {at: '.sear-bar', title: 'Stop',
            text: 'Click the red button. Your robot and objects remain.', done: () => !panel.isSimulating()},
        {at: '.sear-drawers', title: 'It is a script, too',
            text: 'Click <b>Scripts</b>.', done: () => !layout.isFolded('scripts')},
        {at: '.sear-scripts', title: 'It is a script, too',
            text: 'Click <b>Show as Python</b>: this script makes the same robot. A script can also drive it: see '
            + 'docs/first-robot.md.', done: () => script.shown !== null},
        {at: '.sear-scripts', title: 'That is your first robot',
            text: '<b>Save</b>, below the project\'s name, stores it in one file.'}
    ]
}

/** The tour of one panel. */
export class Tour {
    constructor(panel, world, view, palette, script, layout) {
        this.panel = panel
        this.view = view
        this.palette = palette
        this.layout = layout
        this.step = null
        this.steps = stepsOf(panel, world, palette, script, layout)
        this.guide = null
        /** Checks the step at each digest: a finished step opens the next one. */
        panel.scope.$watch(() => {
            const step = this.guide && this.steps[this.step]
            return step && step.done && step.done() ? this.step : null
        }, done => {
            if (done !== null) {
                panel.timeout(() => {
                    if (this.guide && this.step === done) {
                        this.guide.moveNext()
                        panel.scope.$applyAsync()
                    }
                })
            }
        })
        /** After a mistake, the step shows how to correct it. */
        panel.scope.$watch(() => {
            const step = this.guide && this.steps[this.step]
            return step && step.wrong && step.wrong() && !step.done() ? this.step : null
        }, wrong => {
            if (wrong !== null) {
                this.guide.getConfig().steps[wrong].popover.description = this.steps[wrong].instead
                this.guide.moveTo(wrong)
            }
        })
        panel.scope.$on('$destroy', () => {
            if (this.guide) {
                this.guide.destroy()
            }
        })
    }

    show() {
        return driver({
            // continues immediately after a finished step, and clicks during a transition count
            animate: false,
            allowKeyboardControl: false,        // the arrow keys drive
            overlayOpacity: 0.35,
            stagePadding: 4,
            overlayClickBehavior: () => { },
            showProgress: true,
            progressText: '{{current}} of {{total}}',
            showButtons: ['next', 'close'],
            nextBtnText: 'Skip',
            doneBtnText: 'Done',
            popoverClass: 'sear-tour' + (this.layout.dark ? ' sear-tour-dark' : ''),
            waitForElement: OPENS_MILLIS,
            steps: this.steps.map(step => ({
                element: () => this.panel.element('workspace').querySelector(step.at),
                popover: {title: step.title, description: step.text}
            })),
            onHighlightStarted: () => {
                this.step = this.guide.getActiveIndex()
            },
            onHighlighted: () => this.point(),
            onDestroyed: () => {
                this.step = null
                this.unmark(this.panel.element('workspace'))
                this.guide = null
                this.panel.scope.$applyAsync()
            }
        })
    }

    /** Scrolls to the palette entry to click, and marks it. */
    point() {
        const step = this.steps[this.step]
        const whole = this.panel.element('workspace')
        this.unmark(whole)
        if (step && step.make) {
            this.palette.sought = ''
            this.panel.timeout(() => {      // when the unfiltered palette exists
                const button = whole.querySelector('[data-make="' + step.make + '"]')
                if (button && this.steps[this.step] === step) {
                    button.classList.add(MARK)
                    button.scrollIntoView({block: 'center'})
                }
            })
        }
    }

    unmark(whole) {
        whole.querySelectorAll('.' + MARK).forEach(button => button.classList.remove(MARK))
    }

    start() {
        loadStyle().then(() => {
            this.view.build(true)
            this.guide = this.show()
            this.guide.drive()
            this.panel.scope.$applyAsync()
        })
    }
}

let style = null
/** Loads the styles of driver.js, once per page. */
function loadStyle() {
    style = style || new Promise(done => {
        const link = document.createElement('link')
        link.rel = 'stylesheet'
        link.href = new URL('../lib/driver.css', import.meta.url)
        link.onload = link.onerror = done       // works without styles, too
        document.head.appendChild(link)
    })
    return style
}
