// What the SEAR panel knows of the world: the running one, which the service tells again and again, else the project as it would start.
(function() {
    var words = window.SEARPanel.words
    var PATH_STEP = 0.02        // metres; as the service has it
    var LONGEST_PATH = 500      // points
    var PATIENCE_MILLIS = 10000 // an answer that takes longer is asked for again
    var WAIT_MILLIS = 1500      // so long time stands still in lock-step before the page says so

    /** Adds it to a panel. @return what it does with messages */
    window.SEARPanel.world = function(panel) {
        var $scope = panel.scope
        var msg = panel.msg

        var speed = 1               // as the simulation has it
        var missing = 0             // when the whole was asked for, 0 if nothing is awaited
        /** The whole world, for a page that opens later: what was warned of until then, too. */
        function onWorld(state) {
            angular.forEach(state && state.warnings, function(text) {
                if (!$scope.messages.some(function(message) { return message.text === text })) {
                    panel.say('warn', text)
                }
            })
            onSimulation(state)
        }

        /** Takes the whole of a world, or what has changed in the one that is shown. */
        function onSimulation(state) {
            if (!state || !state.running || !panel.isSimulating()) {
                $scope.state = null
            } else if (!state.changes) {
                missing = 0
                if (!$scope.state) {
                    panel.show(state)
                }
                $scope.state = state
            } else if ($scope.state && state.number <= $scope.state.number) {
                return              // it came after the whole that has it already
            } else if ($scope.state && state.number === $scope.state.number + 1) {
                change($scope.state, state)
            } else {
                askForWorld()
            }
            if ($scope.state && $scope.state.wantedSpeed !== speed) {
                speed = $scope.state.wantedSpeed
                $scope.form.speed = String(speed)
            }
            watchTime($scope.state)
            panel.repaint()
        }

        var moved = 0               // when simulated time was seen to pass, by this page's clock
        var seenTime = null
        /** In lock-step time stands still unless a script lets it pass. */
        function watchTime(state) {
            var waited = $scope.waiting
            if (!state || state.time !== seenTime) {
                seenTime = state && state.time
                moved = Date.now()
            }
            $scope.waiting = Boolean(state && state.lockStep && !state.paused && Date.now() - moved > WAIT_MILLIS)
            if ($scope.waiting !== waited) {
                $scope.$applyAsync()
            }
        }
        /** Nobody waits for the script any more: time runs by itself. */
        $scope.letTimeRun = function() {
            msg.send('setSpeed', 1)
            msg.send('setLockStep', false)
        }

        function askForWorld() {
            if (Date.now() - missing > PATIENCE_MILLIS) {
                missing = Date.now()
                msg.send('getWorld')
            }
        }

        function change(state, message) {
            angular.forEach(message.changes, function(changed, list) {
                angular.forEach(changed, function(values, index) {
                    angular.extend(state[list][index], values)
                    if (list === 'robots' && values.pose) {
                        extendPath(state.robots[index])
                    }
                })
            })
            angular.extend(state, message)
            delete state.changes
        }

        /** As the service does it for pages that open later. */
        function extendPath(robot) {
            var path = robot.path
            var last = path[path.length - 1]
            if (Math.sqrt(Math.pow(last[0] - robot.pose[0], 2) + Math.pow(last[1] - robot.pose[2], 2)) > PATH_STEP) {
                path.push([robot.pose[0], robot.pose[2]])
            }
            if (path.length > LONGEST_PATH) {
                robot.path = path.filter(function(one, i) {
                    return i === 0 || i === path.length - 1 || (path.length - 2 - i) % 2
                })
            }
        }

        $scope.statusText = function() {
            return $scope.pending || (!panel.isSimulating() ? 'no simulation runs' : $scope.service.paused ? 'paused' :
                $scope.waiting ? 'time waits for a script' : 'running')
        }
        /** Goes on where the status ends; apart from it, since that is read out when it changes. */
        $scope.timeText = function() {
            var state = $scope.pending ? null : $scope.state
            return state ? ' at ' + state.time.toFixed(2) + ' s' + (state.speed ? ', ' + state.speed.toFixed(1) + ' × real time' : '') : ''
        }
        // ---- the project as it would start, while nothing runs ------------------------------
        var lookedAt = 0            // when it was asked for, 0 if nothing is awaited
        panel.look = function() {
            var now = Date.now()
            if (panel.width() && !document.hidden && !panel.isSimulating() && now - lookedAt > PATIENCE_MILLIS) {
                lookedAt = now
                msg.send('getPreview', $scope.preview ? $scope.preview.stamp : '')
            }
        }
        function onPreview(preview) {
            lookedAt = 0
            // each page gets the answers to all pages: only what has a world or says why not is one, else the page that asked has the newest
            if (preview && preview.problems && !panel.isSimulating() && !angular.equals(preview, $scope.preview)) {
                $scope.preview = preview
                $scope.problems = []
                panel.askForSelected()
                if (preview.world) {
                    panel.show(preview.world)
                }
                panel.repaint()
            }
        }

        /** The running world, else the project as it would start; null if it has none. */
        $scope.world = function() {
            return $scope.state || $scope.preview && $scope.preview.world
        }
        $scope.note = function() {
            var preview = $scope.preview
            if (panel.isSimulating() || !preview) {
                return ''
            }
            if (preview.reason) {
                return 'Not running, and nothing to show: ' + preview.reason
            }
            if (!preview.world) {
                return 'Not running, and nothing to show: the project has ' + words.count(preview.problems.length, 'problem') + ', listed below'
            }
            if (!preview.world.objects.length && !preview.world.robots.length) {
                return 'Not running, and the project is empty: open one or an example above, drop a .sear file there, press Build, or create objects in a script'
            }
            return 'Not running: this is how the project starts, with the button Start or ' + $scope.service.name + '.startSimulation()'
        }

        return {onSimulation: onSimulation, onWorld: onWorld, onPreview: onPreview}
    }
})()
