// The SEAR panel as a whole: its form, what the service tells it, problems, messages, and the run of the simulation.
(function() {
    var words = window.SEARPanel.words
    var SPEED = 0.2             // m/s of the drive buttons, MyRobotLab's Roomba default
    // The method, and what it is given after the robot's name.
    var DRIVES = {forward: ['driveStraight', SPEED], backward: ['driveStraight', -SPEED], left: ['drive', SPEED, 0], right: ['drive', -SPEED, 0],
        stop: ['driveStraight', 0]}
    var KEYS = {h: 'left', k: 'right', u: 'forward', j: 'backward', ';': 'stop', enter: 'reset'}
    var MOST_MESSAGES = 100
    var REPEATED = 'could not invoke '      // so MyRobotLab begins to say once more that a call has failed

    /**
     * Builds a panel. @param panel its scope, msg, self (the controller), and Angular's timeout and interval
     * @return a function that takes the messages from the service
     */
    window.SEARPanel.build = function(panel) {
        var $scope = panel.scope
        var msg = panel.msg

        $scope.form = {path: '', speed: '1', example: '', script: '', template: 'userCode.py', folder: 'SEARproject', beams: true, follow: false,
            robot: null, eye: ''}   // the robot that is driven and followed; the sensor through whose eye one looks
        $scope.state = null         // of the running world
        $scope.preview = null       // the project as it would start: stamp, world, problems, reason
        $scope.problems = []        // what a call found wrong
        $scope.messages = []        // newest first
        $scope.last = null          // the newest one as a line
        $scope.pending = null       // what the service has been told to do and has not done yet: starting or stopping

        panel.isSimulating = function() {
            return Boolean($scope.service && $scope.service.simulating)
        }

        // ---- messages from the service -----------------------------------------------------------------------------------------------------
        var told = false            // whether the service has said why a call failed, and MyRobotLab has not repeated that yet
        function onStatus(status) {
            var text = status && (status.key || status.detail)
            if (!text) {
                return
            }
            if (status.level === 'error') {
                $scope.transfer = null
                $scope.pending = null
                panel.asked = {}
                var repeats = text.indexOf(REPEATED) === 0
                var wasTold = told
                told = !repeats
                if (repeats && wasTold) {
                    return
                }
            }
            var problems = $scope.allProblems()
            var listed = problems.length > 1 && text.indexOf(problems[0].file) === 0
            panel.say(status.level, listed ? 'the project has ' + words.count(problems.length, 'problem') + ', listed below' : text)
        }

        var said = 0
        panel.say = function(level, text) {
            var newest = $scope.messages[0]
            if (newest && newest.text === text && newest.level === level) {
                newest.times++
                newest.time = new Date()
            } else {
                $scope.messages.unshift({id: said++, level: level, text: text, time: new Date(), times: 1})
                $scope.messages.splice(MOST_MESSAGES)
            }
            $scope.last = {level: level, text: text, line: text.split('\n')[0]}
        }
        $scope.clear = function() {
            $scope.messages = []
            $scope.last = null
        }

        // ---- problems ----------------------------------------------------------------------------------------------------------------------
        var checking = false
        $scope.check = function() {
            checking = true
            msg.send('checkProject')
        }
        function onProblems(problems) {
            $scope.problems = problems || []
        }
        /** Each page gets the answers to all pages. */
        function onCheckProject(found) {
            onProblems(found.problems)
            if (checking && !found.problems.length) {
                panel.say('info', 'the project has no problems' + (found.warnings.length ? ', but ' + words.count(found.warnings.length, 'warning') : ''))
                found.warnings.forEach(function(warning) {
                    panel.say('warn', warning)
                })
            }
            checking = false
        }
        /** What a call found wrong, else what is wrong with the project as it is. */
        $scope.allProblems = function() {
            return $scope.problems.length || panel.isSimulating() || !$scope.preview ? $scope.problems : $scope.preview.problems
        }

        // ---- the run -----------------------------------------------------------------------------------------------------------------------
        /** The service has done what it was told, whatever has happened since. */
        function settle() {
            $scope.pending = null
        }
        $scope.start = function() {
            $scope.problems = []
            $scope.pending = 'starting'
            msg.send('startSimulation')
        }
        $scope.stop = function() {
            $scope.pending = 'stopping'
            msg.send('stopSimulation')
        }
        $scope.setSpeed = function() {
            msg.send('setSpeed', Number($scope.form.speed))
        }
        $scope.drive = function(way) {
            if (way === 'reset') {
                msg.send('reset')
            } else {
                msg.send.apply(msg, DRIVES[way].slice(0, 1).concat($scope.form.robot || [], DRIVES[way].slice(1)))
            }
        }
        $scope.key = function(event) {
            var way = KEYS[(event.key || '').toLowerCase()]
            if (way && panel.isSimulating() && !event.ctrlKey && !event.altKey && !event.metaKey) {
                $scope.drive(way)
                event.preventDefault()
            }
        }

        panel.self.updateState = function(service) {
            $scope.service = service
            if ($scope.pending === (service.simulating ? 'starting' : 'stopping')) {    // another state was on its way before
                $scope.pending = null
            }
            if (!service.simulating) {
                $scope.state = null
                panel.look()
            }
            panel.repaint()
        }
        window.SEARPanel.workspace(panel)
        var world = window.SEARPanel.world(panel)
        var handlers = angular.extend({
            onState: function(service) {
                panel.self.updateState(service)
            },
            onStartSimulation: settle,
            onStopSimulation: settle,
            onProblems: onProblems,
            onCheckProject: onCheckProject,
            onStatus: onStatus
        }, world, window.SEARPanel.projects(panel), window.SEARPanel.script(panel), window.SEARPanel.edits(panel),
        window.SEARPanel.inspector(panel), window.SEARPanel.palette(panel), window.SEARPanel.building(panel),
        window.SEARPanel.robots(panel), window.SEARPanel.views(panel), window.SEARPanel.records(panel))

        return function(inMsg) {
            var handler = Object.prototype.hasOwnProperty.call(handlers, inMsg.method) && handlers[inMsg.method]
            if (handler) {
                handler(inMsg.data && inMsg.data[0])
                panel.sample()
                if (handler !== world.onSimulation && handler !== world.onWorld) {     // which may come faster than the screen is drawn
                    $scope.$applyAsync()
                }
            }
        }
    }
})()
