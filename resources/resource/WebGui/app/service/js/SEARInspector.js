// The inspector of the SEAR panel: every parameter of the selected object with its unit, what is legal, and what it means, as the grammar says it.
(function() {
    var PARTS = ['component', 'wheel']              // of a robot: other edits see to them

    /** Adds it to a panel. */
    window.SEARPanel.inspector = function(panel) {
        var $scope = panel.scope
        $scope.rows = []            // of the parameters
        $scope.parts = []           // of a selected robot: what edits call them, and their names
        $scope.inspected = {}       // the name as it stands in its field, and the robot that it is on
        $scope.refused = ''         // what was wrong and belongs to no field
        var shown = null            // whose rows these are

        /** Text of a value, entries of a list of them. */
        function same(a, b) {
            return angular.equals(a === undefined ? '' : a, b === undefined ? '' : b)
        }
        function rowOf(parameter) {
            return {p: parameter, id: 'sear-p-' + parameter.name, text: '', was: '', entries: null, error: ''}
        }
        /** Fields of one entry of a list: of a group its parameters, else the value itself. */
        function entryOf(row, value) {
            var fields = row.p.parameters || [row.p]
            return fields.map(function(parameter) {
                var text = row.p.parameters ? (value || {})[parameter.name] : value
                return {p: parameter, text: text === undefined || text === null ? parameter.initial || parameter['default'] : text}
            })
        }
        function fill(row, value) {
            if (same(row.was, value) && row.filled) {
                return              // what the user is just typing stays
            }
            row.filled = true
            row.was = value === undefined ? '' : value
            if (!row.refused) {
                row.error = ''
            }
            row.refused = false     // what another page has set in the meantime comes with the reason why this page could not set it
            if (row.p.list) {
                row.entries = (value || []).map(function(one) {
                    return entryOf(row, one)
                })
            } else {
                row.text = row.was
            }
        }

        panel.onSelect(function() {
            var object = $scope.object
            var type = object && panel.typeOf(object.type)
            if (!type) {
                $scope.rows = []
                $scope.parts = []
                shown = null
                return
            }
            if (shown !== object.object + ' ' + object.type) {
                shown = object.object + ' ' + object.type
                $scope.refused = ''
                $scope.rows = type.parameters.filter(function(parameter) {
                    return parameter.name !== 'name' && (type.kind !== 'robot' || PARTS.indexOf(parameter.name) < 0)
                }).map(rowOf)
            }
            $scope.rows.forEach(function(row) {
                fill(row, object.values[row.p.name])
            })
            $scope.inspected = {name: object.name, robot: object.robot || ''}
            $scope.mountable = type.robot && (type.environment || Boolean(object.robot))
            $scope.stays = Boolean(object.robot) && !type.environment
            $scope.parts = partsOf(object)
        })
        function partsOf(robot) {
            if (robot.type !== 'SEARrobot') {
                return []
            }
            var names = (robot.values.component || []).concat((robot.values.wheel || []).map(function(wheel) {
                return wheel.name
            }))
            return names.map(function(name) {
                return {object: panel.address(robot.name, name), name: name.slice(name.indexOf('/') + 1)}
            })
        }

        $scope.robotNames = function() {
            var world = $scope.world()
            return world ? world.robots.map(function(robot) {
                return robot.name
            }) : []
        }

        // ---- changes -----------------------------------------------------------------------------------------------------------------------
        function valueOf(row) {
            return !row.entries ? row.text : row.entries.map(function(entry) {
                if (!row.p.parameters) {
                    return entry[0].text
                }
                var value = {}
                entry.forEach(function(field) {
                    value[field.p.name] = field.text
                })
                return value
            })
        }
        /** Sends what stands in a row. */
        $scope.setRow = function(row) {
            var value = valueOf(row)
            if (same(value, row.was)) {
                row.error = ''
                return
            }
            var edit = {'do': 'set', object: $scope.selected, set: {}, was: {}}
            edit.set[row.p.name] = value
            edit.was[row.p.name] = row.was
            panel.edit(edit, function(answer) {
                showAt(row, answer)
            })
        }
        function showAt(row, answer) {
            row.error = ''
            $scope.refused = ''
            if (answer.done) {
                return
            }
            var other = []
            angular.forEach(answer.problems, function(problem) {
                var text = 'legal: ' + problem.legal
                if (problem.field.split(/[.#]/)[0] === row.p.name) {
                    row.error += (row.error ? '; ' : '') + (problem.field === row.p.name ? '' : problem.field + ' ') + text
                } else {
                    other.push((problem.field ? problem.field + ' is "' + problem.value + '", ' : problem.value + ', ') + text)
                }
            })
            if (!answer.problems.length || other.length && !row.error) {
                row.error = other.shift() || answer.reason
            }
            row.refused = Boolean(row.error)
            $scope.refused = other.join('; ')
            panel.askForSelected()
        }
        $scope.addEntry = function(row) {
            row.entries.push(entryOf(row, null))
            if (row.p.parameters) {
                $scope.setRow(row)
            }
        }
        $scope.removeEntry = function(row, entry) {
            row.entries.splice(row.entries.indexOf(entry), 1)
            $scope.setRow(row)
        }
        /** What it means, what is legal and what it is without a value. */
        $scope.docOf = function(parameter) {
            return parameter.doc + '. Legal: ' + parameter.legal + (parameter['default'] ? '. Default: ' + parameter['default'] : '') + '.'
        }
        return {}
    }
})()
