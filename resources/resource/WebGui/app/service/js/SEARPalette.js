// The palette of the SEAR panel: everything that can be made, and where a click in the view puts it.
(function() {
    var GRID = 0.05             // metres between the places that things snap to

    /** Adds it to a panel. */
    window.SEARPanel.palette = function(panel) {
        var $scope = panel.scope
        $scope.building = false     // whether the palette is there
        $scope.armed = null         // what the next click makes: type or template, and fields that have to be filled in
        $scope.snap = true

        $scope.build = function() {
            $scope.building = !$scope.building
            $scope.armed = null
            panel.repaint()
        }
        /** Classes of one kind: shape, sensor, part. */
        $scope.typesOf = function(kind) {
            return $scope.grammar ? $scope.grammar.types.filter(function(type) {
                return type.kind === kind
            }) : []
        }

        $scope.arm = function(type, template) {
            var name = template || type.type
            if ($scope.armed && $scope.armed.name === name) {
                $scope.armed = null
                return
            }
            $scope.armed = {name: name, type: type, template: template, fields: type ? type.parameters.filter(isAsked).map(function(parameter) {
                return {p: parameter, text: ''}
            }) : []}
            panel.select(null)
        }
        /** What has no value to begin with: somebody has to say it. */
        function isAsked(parameter) {
            return parameter.required && parameter.initial === '' && parameter.name !== 'name'
        }
        $scope.disarm = function() {
            $scope.armed = null
        }
        $scope.isForRobots = function() {
            return Boolean($scope.armed && $scope.armed.type && !$scope.armed.type.environment)
        }
        $scope.armedText = function() {
            var armed = $scope.armed
            return !armed ? '' : $scope.isForRobots() ? 'Click on a robot to mount it there' : 'Click where it is to stand'
        }

        /** The number of a parameter with which a new object begins. */
        function initial(type, name) {
            var found = type.parameters.filter(function(parameter) {
                return parameter.name === name
            })[0]
            return found ? Number(found.initial || found['default']) || 0 : 0
        }
        /** How far the middle of a new object is above what it stands on. */
        function lift(type) {
            return initial(type, 'height') / 2 || initial(type, 'radius')
        }

        panel.snapped = function(value, free) {
            return $scope.snap && !free ? Math.round(value / GRID) * GRID : value
        }

        /**
         * Makes what is armed. @param at what was met: point [x, y, z] in the world, ground (whether that is a terrain), robot (its name, null for
         * none), local (the point in its frame), normal (of its surface, there) @param free whether it does not snap
         */
        panel.place = function(at, free) {
            var armed = $scope.armed
            var edit = {'do': armed.template ? 'robot' : 'add', set: {}}
            armed.fields.forEach(function(field) {
                edit.set[field.p.name] = field.text
            })
            if (armed.template) {
                edit.template = armed.template
            } else {
                edit.type = armed.type.type
            }
            if ($scope.isForRobots()) {
                var robot = at.robot || $scope.form.robot
                if (!robot) {
                    panel.say('error', 'a ' + armed.name + ' is a part of a robot: make one first')
                    return
                }
                edit.to = robot
                if (at.robot) {
                    edit.set = angular.extend(edit.set, panel.mounted(at, armed.type, free))
                } else {
                    put(edit.set, [0, 0.1, 0], free)
                }
            } else if (at.ground) {
                edit.set.x = panel.plain(panel.snapped(at.point[0], free))
                edit.set.z = panel.plain(panel.snapped(at.point[2], free))
                edit.set.onGround = 'true'
            } else {
                put(edit.set, [at.point[0], at.point[1] + (armed.type ? lift(armed.type) : 0), at.point[2]], free)
            }
            panel.edit(armed.template ? panel.withGround(edit) : edit, function(answer) {
                panel.selectAfter(answer)
                if (answer.done) {
                    $scope.armed = null
                } else if (armed.type) {
                    askFor(armed, answer.problems)
                }
            })
        }
        /** What was wrong gets a field, so that somebody can say it: the name of a motor's wheel. */
        function askFor(armed, problems) {
            armed.type.parameters.forEach(function(parameter) {
                var wrong = problems.some(function(problem) {
                    return problem.field.split(/[.#]/)[0] === parameter.name
                })
                var known = armed.fields.some(function(field) {
                    return field.p.name === parameter.name
                })
                if (wrong && !known) {
                    armed.fields.push({p: parameter, text: ''})
                }
            })
        }
        /** The height stays that of what was met, but for the last digits of a sum. */
        function put(set, point, free) {
            set.x = panel.plain(panel.snapped(point[0], free))
            set.y = panel.plain(point[1])
            set.z = panel.plain(panel.snapped(point[2], free))
        }
        /** For those who use no mouse: where the view looks at. */
        $scope.placeInTheMiddle = function() {
            panel.place(panel.middle(), false)
        }
        return {}
    }
})()
