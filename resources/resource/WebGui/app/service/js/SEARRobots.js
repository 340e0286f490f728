// What building robots needs beyond other things in the SEAR panel: how a robot stands, the test drive, and sensors that are put on a body.
(function() {
    var pointing = window.SEARPanel.pointing
    var FLOOR = '20'            // metres: side of the floor that a robot gets where there is no ground
    var UPRIGHT = 0.7           // a surface whose normal is less steep than this is a side
    var TURN = 15               // degrees

    /** Adds it to a panel. */
    window.SEARPanel.robots = function(panel) {
        var $scope = panel.scope
        var driving = false         // whether a test drive is to begin as soon as the simulation runs
        var carried = null          // the button of the palette from which something is being dragged

        // ---- how it stands -----------------------------------------------------------------------------------------------------------------
        /** Of the robot that is selected, or whose part is: centre, critical, words; null for none. */
        $scope.balance = function() {
            var robot = window.SEARPanel.balance.robotOf(pointing.find($scope.world(), $scope.selected))
            return robot && robot.balance
        }
        $scope.centreText = function() {
            return $scope.balance().centre.map(function(metres) {
                return metres.toFixed(3)
            }).join(', ')
        }

        // ---- the test drive ----------------------------------------------------------------------------------------------------------------
        /** Starts, or ends, a simulation in which the keys drive the robot that is selected, else the one that is driven anyway. */
        $scope.testDrive = function() {
            var world = $scope.world()
            if (panel.isSimulating()) {
                $scope.stop()
            } else if (!world || !world.robots.length) {
                panel.say('error', 'there is no robot to drive: choose one in the palette and click on the ground')
            } else {
                var found = pointing.find(world, $scope.selected)
                var robot = found && (found.robot || found.object)
                $scope.form.robot = robot && robot.parts ? robot.name : $scope.form.robot || world.robots[0].name
                driving = true
                $scope.start()
            }
        }
        $scope.$watch(panel.isSimulating, function(simulating) {
            if (simulating && driving) {
                panel.canvas().focus()
                panel.say('info', 'drive ' + $scope.form.robot + ': U forward, J back, H left, K right, ; halt, Enter back to the start')
            }
            driving = driving && !simulating && Boolean($scope.pending)
        })

        // ---- making ------------------------------------------------------------------------------------------------------------------------
        /** The edit that makes a robot, and ground for it where there is none. */
        panel.withGround = function(edit) {
            var world = $scope.world()
            var ground = world && world.objects.some(function(object) {
                return object.type === 'Floor' || object.ground || object.terrain
            })
            return ground ? edit : {'do': 'all', edits: [{'do': 'add', type: 'Floor', set: {length: FLOOR, width: FLOOR}}, edit]}
        }
        /**
         * Where a part of a robot is put: at a point of its body, snapped along the surface only; what has beams looks away from a side.
         * @param at what was met, see pointing @param type its class
         */
        panel.mounted = function(at, type, free) {
            var set = {}
            ;['x', 'y', 'z'].forEach(function(axis, i) {
                var along = axis !== 'y' && !(at.normal && Math.abs(at.normal[i]) > UPRIGHT / 2)
                set[axis] = panel.plain(along ? panel.snapped(at.local[i], free) : at.local[i])
            })
            if (at.normal && Math.abs(at.normal[1]) < UPRIGHT && hasBeams(type)) {
                var degrees = Math.atan2(at.normal[0], at.normal[2]) * 180 / Math.PI
                set.ry = panel.plain(free ? degrees : Math.round(degrees / TURN) * TURN)
            }
            return set
        }
        function hasBeams(type) {
            return Boolean(type) && type.parameters.some(function(parameter) {
                return parameter.name === 'seesOwnRobot'
            })
        }

        // ---- from the palette into the view ------------------------------------------------------------------------------------------------
        function grab(event) {
            carried = event.target.closest && event.button === 0 ? event.target.closest('.sear-palette [data-make]') : null
        }
        /** The views don't turn meanwhile. */
        function carry(event) {
            if (carried) {
                event.stopPropagation()
            }
        }
        function drop(event) {
            var name = carried && carried.getAttribute('data-make')
            carried = null
            if (!name || event.target !== panel.canvas()) {
                return
            }
            if (!$scope.armed || $scope.armed.name !== name) {
                var type = panel.typeOf(name)
                $scope.arm(type, type ? undefined : name)
            }
            var under = panel.under(event)
            if (under) {
                panel.place(under, event.altKey)
            }
            $scope.$applyAsync()
        }
        window.addEventListener('mousedown', grab, true)
        window.addEventListener('mousemove', carry, true)
        window.addEventListener('mouseup', drop, true)
        $scope.$on('$destroy', function() {
            window.removeEventListener('mousedown', grab, true)
            window.removeEventListener('mousemove', carry, true)
            window.removeEventListener('mouseup', drop, true)
        })
        return {}
    }
})()
