// The tour of the SEAR panel: from an empty ground to a robot that sees and drives, each step as soon as its user has done it. By driver.js, which
// the build puts into lib. docs/first-robot.md is the same in words.
import {driver} from '../lib/driver.js'
import {frame} from '../shared/geometry.js'
import {local} from '../world/pointing.js'

var OPENS_MILLIS = 2000     // how long a step waits for the part of the page that it points at
var MOVED = 0.3             // metres that a robot has to drive
var NEAREST = 0.2           // metres before a robot where something is in its way, at least
var FARTHEST = 3            // and at most: as far as the eye sees
var MARK = 'sear-marked'    // the class of what is to be clicked
var ASIDE = 0.35            // metres to the left or right of its way

/**
 * The steps: what they point at, which thing of the palette is to be clicked there, what is said, whether it is done, and what is said instead once
 * that has been done wrongly. A step without done ends by its button.
 */
function stepsOf(panel, world, palette, script, layout) {
    function now() {
        return world.now() || {objects: [], robots: [], sensors: []}
    }
    function isArmed(name) {
        return Boolean(palette.armed && palette.armed.name === name)
    }
    /** Whether a robot is not where it has started. */
    function hasMoved() {
        return panel.isSimulating() && now().robots.some(function(robot) {
            var first = robot.path[0]
            return Math.hypot(robot.pose[0] - first[0], robot.pose[2] - first[1]) > MOVED
        })
    }
    var hasRobot = () => now().robots.length > 0
    var hasSensor = () => now().sensors.length > 0
    var boxes = () => now().objects.filter(object => object.type === 'Box')
    /** Whether a thing stands before a robot. */
    function isAhead(thing) {
        return now().robots.some(function(robot) {
            var at = local(frame(robot.pose), thing.pose)
            return Math.abs(at[0]) < ASIDE && at[2] > NEAREST && at[2] < FARTHEST
        })
    }
    return [
        {at: '.sear-palette', make: 'rover', title: 'Choose a robot',
            text: 'All that can be made is here. Click <b>Rover</b>: two driven wheels and a caster.',
            done: () => isArmed('rover') || hasRobot()},
        {at: '.sear-canvas', title: 'Put it on the ground',
            text: 'Click on the ground near the middle. It gets a floor to stand on.', done: hasRobot},
        {at: '.sear-palette', make: 'Distance', title: 'Give it an eye',
            text: 'Click <b>Distance sensor</b>, below <i>Sensors</i>.', done: () => isArmed('Distance') || hasSensor()},
        {at: '.sear-canvas', title: 'Mount it',
            text: 'Click on the rover, or on <b>Put it in the middle</b>. It looks ahead, and a little up, over the floor.', done: hasSensor},
        {at: '.sear-palette', make: 'Box', title: 'An obstacle',
            text: 'Click <b>Box</b>, the first of all.', done: () => isArmed('Box') || boxes().length > 0},
        {at: '.sear-canvas', title: 'In its way',
            text: 'Click on the ground about a metre ahead of the rover. It looks along the blue axis, to the east.',
            done: () => boxes().some(isAhead), wrong: () => boxes().length > 0,
            instead: 'That box is not in its way. Drag it to about a metre ahead of the rover, along the blue axis.'},
        {at: '.sear-making', title: 'Start',
            text: 'Click <b>Test drive</b>: the simulation starts, and the keys are the rover\'s.', done: panel.isSimulating},
        {at: '.sear-driving', title: 'Drive',
            text: 'Hold <b>W</b> or the arrow up, or click an arrow below the view. <i>Readings</i>, at the right, has what the eye sees.',
            done: hasMoved},
        {at: '.sear-drawers', title: 'See what it did',
            text: 'Click <b>Plots</b>: the rover\'s speed and what its eye sees, over time.', done: () => !layout.isFolded('plots')},
        {at: '.sear-bar', title: 'Stop',
            text: 'Click the red button. What you have built stays.', done: () => !panel.isSimulating()},
        {at: '.sear-drawers', title: 'It is a script, too',
            text: 'Click <b>Scripts</b>.', done: () => !layout.isFolded('scripts')},
        {at: '.sear-scripts', title: 'It is a script, too',
            text: 'Click <b>Show as Python</b>: these lines make the same robot. A script can drive it as well: '
            + 'docs/first-robot.md goes on there.', done: () => script.shown !== null},
        {at: '.sear-scripts', title: 'That is your first robot',
            text: '<b>Save</b>, below the project\'s name, makes one file of it.'}
    ]
}

/** Of one panel. */
export function makeTour(panel, world, view, palette, script, layout) {
    var tour = {step: null}     // the number of the step, null while there is no tour
    var steps = stepsOf(panel, world, palette, script, layout)
    var guide = null

    function show() {
        return driver({
            animate: false,                     // a step that is done is followed at once, and what is clicked meanwhile counts
            allowKeyboardControl: false,        // the arrow keys drive
            overlayOpacity: 0.35,
            stagePadding: 4,
            overlayClickBehavior: function() { },
            showProgress: true,
            progressText: '{{current}} of {{total}}',
            showButtons: ['next', 'close'],
            nextBtnText: 'Skip',
            doneBtnText: 'Done',
            popoverClass: 'sear-tour' + (layout.dark ? ' sear-tour-dark' : ''),
            waitForElement: OPENS_MILLIS,
            steps: steps.map(step => ({
                element: () => panel.element('workspace').querySelector(step.at),
                popover: {title: step.title, description: step.text}
            })),
            onHighlightStarted: function() {
                tour.step = guide.getActiveIndex()
            },
            onHighlighted: point,
            onDestroyed: function() {
                tour.step = null
                unmark(panel.element('workspace'))
                guide = null
                panel.scope.$applyAsync()
            }
        })
    }
    /** What is to be clicked in the palette is brought into sight there, and marked. */
    function point() {
        var step = steps[tour.step]
        var whole = panel.element('workspace')
        unmark(whole)
        if (step && step.make) {
            palette.sought = ''
            panel.timeout(function() {      // when all is there that was not looked for
                var button = whole.querySelector('[data-make="' + step.make + '"]')
                if (button && steps[tour.step] === step) {
                    button.classList.add(MARK)
                    button.scrollIntoView({block: 'center'})
                }
            })
        }
    }
    function unmark(whole) {
        whole.querySelectorAll('.' + MARK).forEach(button => button.classList.remove(MARK))
    }
    tour.start = function() {
        loadStyle().then(function() {
            view.build(true)
            guide = show()
            guide.drive()
            panel.scope.$applyAsync()
        })
    }
    /** Comes with what the page is told: a step that is done makes room for the next. */
    panel.scope.$watch(function() {
        var step = guide && steps[tour.step]
        return step && step.done && step.done() ? tour.step : null
    }, function(done) {
        if (done !== null) {
            panel.timeout(function() {
                if (guide && tour.step === done) {
                    guide.moveNext()
                    panel.scope.$applyAsync()
                }
            })
        }
    })
    /** A step that was done wrongly says how to mend that. */
    panel.scope.$watch(function() {
        var step = guide && steps[tour.step]
        return step && step.wrong && step.wrong() && !step.done() ? tour.step : null
    }, function(wrong) {
        if (wrong !== null) {
            guide.getConfig().steps[wrong].popover.description = steps[wrong].instead
            guide.moveTo(wrong)
        }
    })
    panel.scope.$on('$destroy', function() {
        if (guide) {
            guide.destroy()
        }
    })
    return tour
}

var style = null
/** The styles of driver.js, once for each page. */
function loadStyle() {
    style = style || new Promise(function(done) {
        var link = document.createElement('link')
        link.rel = 'stylesheet'
        link.href = new URL('../lib/driver.css', import.meta.url)
        link.onload = link.onerror = done       // it works without, too
        document.head.appendChild(link)
    })
    return style
}
