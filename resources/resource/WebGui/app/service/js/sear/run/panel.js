// SPDX-License-Identifier: Apache-2.0
// The SEAR panel: creates its parts, each of which knows only earlier ones, and subscribes them to the service.
import '../shared/style.js'
import {Badge} from '../records/badge.js'
import {Building} from '../build/building.js'
import {Cameras} from '../records/cameras.js'
import {Driving} from './driving.js'
import {Edits} from '../build/edits.js'
import {Ground} from '../world/ground.js'
import {Hand} from './hand.js'
import {Inspector} from '../build/inspector.js'
import {Layout} from '../shared/layout.js'
import {Messages} from '../shared/messages.js'
import {Motors} from './motors.js'
import {Palette} from '../build/palette.js'
import {Panel} from '../shared/panel.js'
import {Picture} from '../shared/picture.js'
import {Plot} from '../records/plot.js'
import {Pointed} from '../scene/gestures.js'
import {Pointer} from '../build/pointer.js'
import {Problems} from '../world/problems.js'
import {Project} from './project.js'
import {Records} from '../records/records.js'
import {Replay} from '../records/replay.js'
import {Run} from './run.js'
import {Script} from './script.js'
import {Share} from './share.js'
import {Shelf} from './shelf.js'
import {Tour} from './tour.js'
import {Video} from './video.js'
import {View} from '../scene/view.js'
import {Welcome} from './welcome.js'
import {World} from '../world/world.js'
import {count} from '../shared/words.js'

const TOPICS = ['publishSimulation', 'getWorld', 'publishStatus', 'publishProblems', 'publishUploaded', 'getPreview',
    'checkProject', 'getBundle',
    'getTerrain', 'getLooks', 'saveProject', 'saveProjectAs', 'loadProject', 'newProject', 'copyTemplate',
    'startSimulation', 'stopSimulation',
    'publishEdit', 'getProjectObject', 'getScript', 'getExampleScript', 'recordRun', 'endRecord', 'getRecords',
    'getRecordFrames',
    'getRecordMotion', 'getRecordValues', 'getCameraPicture', 'getRecordPicture', 'getProjectPicture',
    'publishKept']
const ASKED = ['getExamples', 'getExampleScripts', 'getGrammar', 'getEdits', 'getProjects']
const LOOK_MILLIS = 1000      // interval at which a page that shows the project asks for changes
const SETTLED_MILLIS = 12000  // time after which the status line drops a notice
const LISTEN_MILLIS = 100     // interval of checks for the view's elements

/** The parts of one panel. */
class SearPanel {
    constructor(panel, $interval) {
        const messages = new Messages()
        const picture = new Picture(panel.scope)
        const world = new World(panel, messages, picture)
        const problems = new Problems(panel, world, messages)
        const ground = new Ground(panel, picture)
        const view = new View(panel, messages, world, ground, picture)
        const pointed = new Pointed(panel, world, ground, view)
        const edits = new Edits(panel, messages, world, view, picture)
        const inspector = new Inspector(panel, world, edits)
        const pointer = new Pointer(world, view, picture)
        const palette = new Palette(panel, messages, world, view, edits, pointer)
        const building = new Building(panel, messages, world, view, edits, palette, pointer, picture)
        const layout = new Layout(panel, messages)
        const records = new Records(panel, messages)
        const replay = new Replay(panel, messages, world, picture)
        const plot = new Plot(panel, world, records, replay, layout)
        const cameras = new Cameras(panel, world, replay, picture, $interval)
        const shelf = new Shelf(panel)
        const project = new Project(panel, messages, world, problems, view, shelf)
        const script = new Script(panel, messages, project)
        const tour = new Tour(panel, world, view, palette, script, layout)
        const welcome = new Welcome(panel, world, view, palette, project, tour, shelf)
        const run = new Run(panel, messages, world, problems, view, edits, picture)
        const video = new Video(panel, messages, view, picture)
        const share = new Share(panel, messages, replay, ground)
        const driving = new Driving(panel, world, view, edits, run, picture)
        const motors = new Motors(panel, world)
        const hand = new Hand(panel, world, view, pointer)
        const badge = new Badge(panel, replay)

        this.panel = panel
        this.picture = picture
        this.parts = {messages, world, problems, ground, view, pointed, edits, inspector, palette, building, layout,
            records, replay, plot, motors, cameras, shelf, project, script, run, video, share, tour, welcome}
        this.listening = [hand, pointed, building, project, badge, driving]
        this.keyed = [driving, building, view, run]
        this.started = 0            // start of the service that was asked for its lists
        this.waiting = null         // timeout until the view's elements exist

        cameras.plottedBy(() => plot.open && !plot.source ? plot.lines : [])
        // a replay ends when the user returns to the present
        project.left.hear(() => {
            plot.showNow()
            edits.select(null)
            welcome.close()
        })
        run.begun.hear(() => plot.showNow())
        panel.scope.$watch(() => view.building, begun => begun && replay.end())
    }

    /** Handles a key: the first part that knows it. */
    key(event) {
        return this.keyed.some(part => part.key(event))
    }

    onState(service) {
        this.panel.scope.service = service
        this.parts.run.follow()
        this.parts.world.follow()
        this.parts.project.follow()
        this.ask(service.started)
    }

    /** Asks for lists once per start of the service, also after a lost connection. @param started its number */
    ask(started) {
        if (started && started !== this.started) {
            this.started = started
            ASKED.forEach(method => this.panel.msg.send(method))
        }
    }

    onStatus(status) {
        const {messages, problems, project, run} = this.parts
        if (status && status.level === 'error') {
            project.fail()
            run.settle()
        }
        const text = messages.newsOf(status)
        const all = problems.all()
        const listed = all.length > 1 && text.indexOf(all[0].file) === 0
        if (text) {
            messages.say(status.level, listed ? 'the project has ' + count(all.length, 'problem')
                + ', listed below' : text)
        }
    }

    onLooks(sent) {
        this.parts.view.handlers.onLooks(sent)
        this.parts.share.take(sent)
    }

    /** Adds the listeners once the view's elements exist. */
    listen() {
        if (this.panel.element('view')) {
            this.listening.forEach(part => part.listen())
            this.picture.repaint()
        } else {
            this.waiting = this.panel.timeout(() => this.listen(), LISTEN_MILLIS)
        }
    }

    /** Removes notices from the status line after a while, and counts messages as read while they are visible. */
    watchMessages() {
        const {messages, layout} = this.parts
        this.panel.scope.$watch('messages.last', last => {
            if (last && last.level === 'info') {
                this.panel.timeout(() => messages.settle(last), SETTLED_MILLIS)
            }
        })
        this.panel.scope.$watch(() => layout.isFolded('messages') ? 0 : messages.unread, unread => unread
            && messages.read())
    }

    /** Subscribes all parts to the service. */
    hear() {
        this.panel.hear(TOPICS.concat(ASKED), [], Object.assign({
            onState: service => this.onState(service),
            onStatus: status => this.onStatus(status)
        }, ...Object.values(this.parts).map(part => part.handlers), {onLooks: sent => this.onLooks(sent)}))
    }
}

/** Opens a panel. @param controller MyRobotLab's, whose scope gets the panel's parts */
export function open(controller, $scope, $timeout, $interval) {
    const sear = new SearPanel(new Panel(controller, $scope, 'sear', $timeout), $interval)
    sear.watchMessages()
    const looks = $interval(() => sear.parts.world.look(), LOOK_MILLIS, 0, false)
    sear.waiting = $timeout(() => sear.listen())
    $scope.$on('$destroy', () => {
        $interval.cancel(looks)
        $timeout.cancel(sear.waiting)
    })
    Object.assign($scope, sear.parts, {key: event => sear.key(event)})
    sear.hear()
    if ($scope.service) {
        sear.onState($scope.service)
    }
}
