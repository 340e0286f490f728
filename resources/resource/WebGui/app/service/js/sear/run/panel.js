// SPDX-License-Identifier: Apache-2.0
// The SEAR panel: creates its parts, each of which knows only earlier ones, and subscribes them to the service.
import '../shared/style.js'
import {makeBadge} from '../records/badge.js'
import {makeBuilding} from '../build/building.js'
import {makeCameras} from '../records/cameras.js'
import {makeDriving} from './driving.js'
import {makeEdits} from '../build/edits.js'
import {makeGround} from '../world/ground.js'
import {makeHand} from './hand.js'
import {makeInspector} from '../build/inspector.js'
import {makeLayout} from '../shared/layout.js'
import {makeMessages} from '../shared/messages.js'
import {makePalette} from '../build/palette.js'
import {makePanel} from '../shared/panel.js'
import {makePicture} from '../shared/picture.js'
import {makePlot} from '../records/plot.js'
import {makePointed} from '../scene/gestures.js'
import {makePointer} from '../build/pointer.js'
import {makeProblems} from '../world/problems.js'
import {makeProject} from './project.js'
import {makeRecords} from '../records/records.js'
import {makeReplay} from '../records/replay.js'
import {makeRun} from './run.js'
import {makeScript} from './script.js'
import {makeShare} from './share.js'
import {makeTour} from './tour.js'
import {makeVideo} from './video.js'
import {makeView} from '../scene/view.js'
import {makeWelcome} from './welcome.js'
import {makeWorld} from '../world/world.js'
import {count} from '../shared/words.js'

var TOPICS = ['publishSimulation', 'getWorld', 'publishStatus', 'publishProblems', 'publishUploaded', 'getPreview', 'checkProject', 'getBundle',
    'getTerrain', 'getLooks', 'saveProject', 'saveProjectAs', 'loadProject', 'newProject', 'copyTemplate', 'startSimulation', 'stopSimulation',
    'publishEdit', 'getProjectObject', 'getScript', 'getExampleScript', 'recordRun', 'endRecord', 'getRecords', 'getRecordFrames',
    'getRecordMotion', 'getRecordValues', 'getCameraPicture', 'getRecordPicture']
var ASKED = ['getExamples', 'getExampleScripts', 'getGrammar', 'getEdits']
var LOOK_MILLIS = 1000      // interval at which a page that shows the project asks for changes
var SETTLED_MILLIS = 12000  // time after which the status line drops a notice
var LISTEN_MILLIS = 100     // interval of checks for the view's elements

/** Opens a panel. @param controller MyRobotLab's, whose scope gets the panel's parts */
export function open(controller, $scope, $timeout, $interval) {
    var panel = makePanel(controller, $scope, 'sear', $timeout)
    var messages = makeMessages()
    var picture = makePicture($scope)
    var world = makeWorld(panel, messages, picture)
    var problems = makeProblems(panel, world, messages)
    var ground = makeGround(panel, picture)
    var view = makeView(panel, messages, world, ground, picture)
    var pointed = makePointed(panel, world, ground, view)
    var edits = makeEdits(panel, messages, world, view, picture)
    var inspector = makeInspector(panel, world, edits)
    var pointer = makePointer(world, view, picture)
    var palette = makePalette(panel, messages, world, view, edits, pointer)
    var building = makeBuilding(panel, messages, world, view, edits, palette, pointer, picture)
    var layout = makeLayout(panel, messages)
    var records = makeRecords(panel, messages)
    var replay = makeReplay(panel, messages, world, picture)
    var badge = makeBadge(panel, replay)
    var plot = makePlot(panel, world, records, replay, layout)
    var cameras = makeCameras(panel, world, replay, picture, $interval)
    var project = makeProject(panel, messages, problems, view)
    var script = makeScript(panel, messages, project)
    var tour = makeTour(panel, world, view, palette, script, layout)
    var welcome = makeWelcome(world, view, palette, project, tour)
    var run = makeRun(panel, messages, world, problems, view, edits, picture)
    var driving = makeDriving(panel, world, view, edits, run, picture)
    var hand = makeHand(panel, world, view, pointer)
    var video = makeVideo(panel, messages, view, picture)
    var share = makeShare(panel, messages, replay, ground)

    cameras.plottedBy(() => plot.open && !plot.source ? plot.lines : [])
    // a replay ends when the user returns to the present
    project.left.hear(plot.showNow)
    run.begun.hear(plot.showNow)
    $scope.$watch(() => view.building, begun => begun && replay.end())

    function onState(service) {
        $scope.service = service
        run.follow()
        world.follow()
    }
    function onStatus(status) {
        if (status && status.level === 'error') {
            project.fail()
            run.settle()
        }
        var text = messages.newsOf(status)
        var all = problems.all()
        var listed = all.length > 1 && text.indexOf(all[0].file) === 0
        if (text) {
            messages.say(status.level, listed ? 'the project has ' + count(all.length, 'problem') + ', listed below' : text)
        }
    }
    function key(event) {
        return driving.key(event) || building.key(event) || view.key(event) || run.key(event)
    }

    // ---- the page --------------------------------------------------------------------------------------------------------------------------
    var first = null
    function listen() {
        if (panel.element('view')) {
            [hand, pointed, building, project, badge, driving].forEach(function(part) {
                part.listen()
            })
            picture.repaint()
        } else {
            first = $timeout(listen, LISTEN_MILLIS)
        }
    }
    $scope.$watch('messages.last', function(last) {
        if (last && last.level === 'info') {
            $timeout(function() {
                messages.settle(last)
            }, SETTLED_MILLIS)
        }
    })
    $scope.$watch(() => layout.isFolded('messages') ? 0 : messages.unread, unread => unread && messages.read())
    var looks = $interval(world.look, LOOK_MILLIS, 0, false)
    first = $timeout(listen)
    $scope.$on('$destroy', function() {
        $interval.cancel(looks)
        $timeout.cancel(first)
    })

    var parts = {messages, world, problems, ground, view, pointed, edits, inspector, palette, building, layout, records, replay, plot, cameras,
        project, script, run, video, share, tour, welcome}
    angular.extend($scope, parts, {key})
    function onLooks(sent) {
        view.handlers.onLooks(sent)
        share.take(sent)
    }
    panel.hear(TOPICS, ASKED, angular.extend.apply(angular, [{onState, onStatus}].concat(Object.values(parts).map(part => part.handlers), {onLooks})))
    if ($scope.service) {
        onState($scope.service)
    }
}
