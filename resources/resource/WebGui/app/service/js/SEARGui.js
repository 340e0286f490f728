// Panel of the SEAR service. MyRobotLab loads this file for the first tab of such a service; it loads the others, each with one purpose.
(function() {
    // In this order: each uses some of those before it.
    var FILES = ['SEARTerrain', 'SEARGeometry', 'SEARWords', 'SEARMap', 'SEARLooks', 'SEARItem', 'SEARBeams', 'SEARGround', 'SEARScene', 'SEARWorld',
        'SEARProjects', 'SEARScript', 'SEAREdits', 'SEARInspector', 'SEARPalette', 'SEARPointing', 'SEARPlaces', 'SEARHandles', 'SEARBalance',
        'SEARBuilding', 'SEARRobots', 'SEARViews',
        'SEARPlot', 'SEARReplay', 'SEARRecords', 'SEARWorkspace', 'SEARPanel']
    var TOPICS = ['publishSimulation', 'getWorld', 'publishStatus', 'publishProblems', 'publishUploaded', 'getPreview', 'checkProject', 'getExamples',
        'getExampleScripts', 'getBundle', 'getTerrain', 'getLooks', 'saveProject', 'saveProjectAs', 'loadProject', 'newProject', 'copyTemplate',
        'startSimulation', 'stopSimulation', 'publishEdit', 'getEdits', 'getGrammar', 'getProjectObject', 'getScript', 'recordRun',
        'endRecord', 'getRecords', 'getRecordFrames', 'getRecordValues']
    var waiting = []            // panels that are to be built once all files are there

    window.SEARPanel = window.SEARPanel || {}

    function load(then) {
        if (window.SEARPanel.build) {
            then()
            return
        }
        waiting.push(then)
        if (waiting.length > 1) {
            return
        }
        FILES.forEach(function(file, i) {
            var script = document.createElement('script')
            script.src = 'service/js/' + file + '.js'
            script.async = false        // they run in the order in which they stand here
            script.onload = script.onerror = i < FILES.length - 1 ? null : function() {
                waiting.splice(0).forEach(function(one) {
                    one()
                })
            }
            document.head.appendChild(script)
        })
    }

    angular.module('mrlapp.service.SEARGui', []).controller('SEARGuiCtrl', ['$scope', '$timeout', '$interval', 'mrl', function($scope, $timeout, $interval, mrl) {
        var self = this
        var msg = this.msg
        var early = []              // messages that came before the panel was built
        var handle = function(inMsg) {
            early.push(inMsg)
        }

        $scope.form = {}
        this.onMsg = function(inMsg) {
            handle(inMsg)
        }
        this.updateState = function(service) {
            $scope.service = service
        }
        TOPICS.forEach(function(topic) {    // before anything is asked for, which the second panel of a page does at once
            msg.subscribe(topic)
        })
        msg.subscribe(this)
        load(function() {
            if (!window.SEARPanel.build) {
                $scope.last = {level: 'error', text: '', line: 'Files of this panel are missing: install SEAR again, then reload this page'}
                $scope.$applyAsync()
                return
            }
            handle = window.SEARPanel.build({scope: $scope, msg: msg, self: self, timeout: $timeout, interval: $interval})
            if ($scope.service) {
                self.updateState($scope.service)
            }
            early.forEach(handle)
            msg.send('getExamples')
            msg.send('getExampleScripts')
            msg.send('getGrammar')
            msg.send('getEdits')
            $scope.$applyAsync()
        })
    }])
})()
