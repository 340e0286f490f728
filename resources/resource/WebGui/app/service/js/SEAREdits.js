// What the SEAR panel has the service do to the project, and which object is selected.
(function() {
    /** Adds it to a panel. @return what it does with messages */
    window.SEARPanel.edits = function(panel) {
        var $scope = panel.scope
        var msg = panel.msg
        var page = Math.random().toString(36).slice(2)      // tells answers to this page from those to others
        var sent = 0
        var waiting = {}            // by number of an edit: what is done with its answer
        var listeners = []          // called when what is selected has changed
        $scope.grammar = null       // types and templates of what can be made; null until it is known
        $scope.undoable = null      // what undo would take back, in words
        $scope.redoable = null
        $scope.selected = null      // what edits call it: box1, rover, rover/ping
        $scope.object = null        // as its file has it; null until it is known

        panel.plain = window.SEARPanel.places.plain

        /** Has the service do an edit. @param then takes its answer; else this page says what was wrong */
        panel.edit = function(edit, then) {
            edit.page = page + ' ' + ++sent
            waiting[edit.page] = then || sayRefusal
            $scope.view.chosen = true       // who builds looks where he wants to
            msg.send('tryEdit', edit)
        }
        function sayRefusal(answer) {
            if (!answer.done) {
                panel.say('error', panel.refusal(answer))
            }
        }
        /** Why an edit was not done, in one text. */
        panel.refusal = function(answer) {
            return answer.reason || answer.problems.map(function(problem) {
                return problem.file + ': ' + (problem.field ? problem.field + ' is "' + problem.value + '"' : problem.value) + ', legal: ' + problem.legal
            }).join('\n')
        }

        function onEdit(answer) {
            if (!answer) {
                return
            }
            var then = waiting[answer.page]
            delete waiting[answer.page]
            if (answer.done) {
                onEdits(answer)
                panel.look()
                ask()
                if (answer.note && then) {
                    panel.say('warn', answer.note)
                }
            }
            if (then) {
                then(answer)
            }
        }
        function onEdits(state) {
            if (state) {
                $scope.undoable = state.undo
                $scope.redoable = state.redo
            }
        }
        function takeBack(kind, said) {
            panel.edit({'do': kind}, function(answer) {
                panel.say(answer.done ? 'info' : 'error', answer.done ? said + ': ' + answer.words : panel.refusal(answer))
            })
        }
        $scope.undo = function() {
            takeBack('undo', 'undone')
        }
        $scope.redo = function() {
            takeBack('redo', 'done again')
        }

        // ---- what is selected --------------------------------------------------------------------------------------------------------------
        /** @param address what edits call it; null for nothing */
        panel.select = function(address) {
            if ($scope.selected !== address) {
                $scope.selected = address
                $scope.object = null
                listeners.forEach(function(listener) {
                    listener()
                })
            }
            ask()
            panel.repaint()
        }
        $scope.select = panel.select
        /** @param listener is called when another object is selected, or its values have changed */
        panel.onSelect = function(listener) {
            listeners.push(listener)
        }
        function ask() {
            if ($scope.selected) {
                msg.send('getProjectObject', $scope.selected)
            }
        }
        panel.askForSelected = ask
        /** Each page gets the answers to all pages. */
        function onProjectObject(object) {
            if (!object || object.object !== $scope.selected) {
                return
            }
            if (object.gone) {
                panel.select(null)
                return
            }
            $scope.object = object
            listeners.forEach(function(listener) {
                listener()
            })
            panel.repaint()
        }
        /** What edits call a part or sensor of a robot, which the world may tell with its robot's name before it. */
        panel.address = function(robot, name) {
            return robot + '/' + name.slice(name.indexOf('/') + 1)
        }
        $scope.address = panel.address

        /** The description of a class; null if there is none. */
        panel.typeOf = function(name) {
            return $scope.grammar && $scope.grammar.types.filter(function(type) {
                return type.type === name
            })[0] || null
        }

        // ---- edits of what is selected -----------------------------------------------------------------------------------------------------
        function selectAfter(answer) {
            sayRefusal(answer)
            if (answer.done && answer.object) {
                panel.select(answer.object)
            }
        }
        panel.selectAfter = selectAfter
        $scope.remove = function() {
            if ($scope.selected) {
                panel.edit({'do': 'delete', object: $scope.selected}, function(answer) {
                    sayRefusal(answer)
                    if (answer.done) {
                        if (!answer.note) {     // else that says what went with it
                            panel.say('info', answer.words + ': Undo brings it back')
                        }
                        panel.select(null)
                    }
                })
            }
        }
        /** The copy stands a little beside. */
        $scope.duplicate = function() {
            var object = $scope.object
            if (object) {
                panel.edit({'do': 'duplicate', object: object.object, set: {z: panel.plain(Number(object.values.z) + 0.5)}}, selectAfter)
            }
        }
        $scope.rename = function(name) {
            panel.edit({'do': 'rename', object: $scope.selected, name: name}, selectAfter)
        }
        $scope.mount = function(robot) {
            if (robot) {
                panel.edit({'do': 'mount', object: $scope.selected, to: robot, set: {x: '0', y: '0.1', z: '0'}}, selectAfter)
            } else {
                panel.edit({'do': 'unmount', object: $scope.selected, set: {x: '0', y: '0.5', z: '0'}}, selectAfter)
            }
        }

        return {
            onEdit: onEdit,
            onEdits: onEdits,
            onGrammar: function(grammar) {
                $scope.grammar = grammar || $scope.grammar
                listeners.forEach(function(listener) {
                    listener()
                })
            },
            onProjectObject: onProjectObject
        }
    }
})()
