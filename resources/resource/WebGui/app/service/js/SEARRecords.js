// Plots and records in the SEAR panel: values over time, live and from records; a record shown again in the views.
(function() {
    var geometry = window.SEARPanel.geometry
    var plots = window.SEARPanel.plots
    var MOST_SAMPLES = 6000     // live ones; ten minutes
    var MOST_NAMES = 300        // values of a live world
    var MOST_LINES = 16

    /** All values of a world by their names. */
    function valuesOf(world) {
        var values = {}
        world.robots.forEach(function(robot) {
            var ahead = geometry.rotate(geometry.frame(robot.pose), [0, 0, 1])
            values[robot.name + '.x'] = robot.pose[0]
            values[robot.name + '.y'] = robot.pose[1]
            values[robot.name + '.z'] = robot.pose[2]
            values[robot.name + '.heading'] = Math.atan2(ahead[2], ahead[0]) * 180 / Math.PI
            values[robot.name + '.speed'] = robot.speed
            values[robot.name + '.turnRate'] = robot.turnRate
        })
        world.sensors.forEach(function(sensor) {
            sensor.names.forEach(function(name, i) {
                values[sensor.name + name] = sensor.numbers[i]
            })
        })
        return values
    }

    /** Adds it to a panel. @return what it does with messages */
    window.SEARPanel.records = function(panel) {
        var $scope = panel.scope
        var msg = panel.msg
        var plot = null             // made when it is first seen
        var live = {times: [], values: {}, last: -1}
        var fetched = {}            // values of records: by path and name, {times, values}
        var awaited = {}
        $scope.form.record = 'run.searlog'
        $scope.form.source = ''     // path of the record that is plotted; empty for the running simulation
        $scope.form.other = ''      // path of a second one
        $scope.form.add = ''
        $scope.form.replaySpeed = '1'
        $scope.plotting = false     // whether that part is open
        $scope.paused = null        // the live samples as they were when the plot was paused
        $scope.records = []
        $scope.lines = []           // names that are plotted
        $scope.names = []           // names that there are
        $scope.replay = null        // path, frames, index, playing

        // ---- writing -----------------------------------------------------------------------------------------------------------------------
        $scope.record = function() {
            if ($scope.service.recorded) {
                msg.send('endRecord')
            } else {
                msg.send('recordRun', $scope.form.record)
            }
        }

        // ---- which values ------------------------------------------------------------------------------------------------------------------
        $scope.$watch('isFolded("plots")', function(folded) {
            $scope.plotting = !folded
            if ($scope.plotting) {
                msg.send('getRecords')
                nameValues()
            }
        })
        function nameValues() {
            var world = $scope.form.source ? null : $scope.state
            if (world) {
                $scope.names = Object.keys(valuesOf(world)).slice(0, MOST_NAMES)
            }
        }
        $scope.chooseSource = function() {
            $scope.names = []
            $scope.replay = null
            if (plot) {
                plot.range = null
            }
            if ($scope.form.source) {
                awaited.frames = $scope.form.source
                msg.send('getRecordFrames', $scope.form.source)
            }
            nameValues()
            fetch()
            panel.repaint()
        }
        $scope.addLine = function() {
            var name = $scope.form.add
            if (name && $scope.lines.indexOf(name) < 0 && $scope.lines.length < MOST_LINES) {
                $scope.lines.push(name)
            }
            $scope.form.add = ''
            fetch()
        }
        $scope.removeLine = function(name) {
            $scope.lines = $scope.lines.filter(function(other) {
                return other !== name
            })
            draw()
        }
        /** Asks for what is plotted of records and not there yet. */
        function fetch() {
            [$scope.form.source, $scope.form.other].filter(Boolean).forEach(function(path) {
                $scope.lines.forEach(function(name) {
                    var key = path + '\n' + name
                    if (!fetched[key] && !awaited[key]) {
                        awaited[key] = true
                        msg.send('getRecordValues', path, [name])
                    }
                })
            })
            draw()
        }
        $scope.compare = fetch
        function forget() {
            fetched = {}
            awaited = {}
        }

        // ---- live --------------------------------------------------------------------------------------------------------------------------
        /** After each message of the running world. */
        function sample() {
            var state = $scope.state
            if (!state || state.time === live.last) {
                return
            }
            if (state.time < live.last || !live.times.length) {     // another run
                live = {times: [], values: {}, last: -1}
            }
            live.last = state.time
            var values = valuesOf(state)
            live.times.push(state.time)
            Object.keys(values).slice(0, MOST_NAMES).forEach(function(name) {
                var column = live.values[name] = live.values[name] || []
                column[live.times.length - 1] = values[name]
            })
            if (live.times.length > MOST_SAMPLES) {
                live.times.shift()
                angular.forEach(live.values, function(column) {
                    column.shift()
                })
            }
            if ($scope.plotting && !$scope.form.source) {
                if (!$scope.names.length) {
                    nameValues()
                }
                draw()
            }
        }
        $scope.pausePlot = function() {
            $scope.paused = $scope.paused ? null : angular.copy(live)
            draw()
        }

        // ---- drawing -----------------------------------------------------------------------------------------------------------------------
        function linesToDraw() {
            var shown = []
            $scope.lines.forEach(function(name, i) {
                var color = plots.colors[i % plots.colors.length]
                if (!$scope.form.source) {
                    var from = $scope.paused || live
                    shown.push({name: name, times: from.times, values: from.values[name] || [], color: color})
                }
                [$scope.form.source, $scope.form.other].forEach(function(path, k) {
                    var data = path && fetched[path + '\n' + name]
                    if (data && (k === 0 || path !== $scope.form.source)) {
                        shown.push({name: name, source: path, times: data.times, values: data.values, color: color, dashed: k === 1})
                    }
                })
            })
            return shown
        }
        $scope.lineColor = function(name) {
            return plots.colors[$scope.lines.indexOf(name) % plots.colors.length]
        }
        var pointed = null
        /** A line's values at the time that the mouse points at, or the slider. */
        $scope.lineText = function(name) {
            var time = pointed !== null ? pointed : $scope.replay ? $scope.replay.times[$scope.replay.index] : null
            return !plot ? '' : plot.lines.filter(function(line) {
                return line.name === name
            }).map(function(line) {
                var value = time === null ? line.values[line.values.length - 1] : plots.valueAt(line, time)
                return typeof value === 'number' && isFinite(value) ? String(Number(value.toPrecision(6))) : '-'
            }).join(' / ')
        }
        function draw() {
            var canvas = $scope.service && document.getElementById('sear-plot-' + $scope.service.name)
            if (!canvas || !canvas.clientWidth) {
                return
            }
            if (!plot || plot.canvas !== canvas) {
                plot = new window.SEARPanel.Plot(canvas, function(time) {
                    pointed = time
                    draw()
                    $scope.$applyAsync()
                })
            }
            plot.marked = pointed !== null ? pointed : $scope.replay ? $scope.replay.times[$scope.replay.index] : null
            plot.draw(linesToDraw())
        }
        $scope.zoomPlot = function(factor) {
            if (plot) {
                plot.zoom(factor)
                draw()
            }
        }
        $scope.wholePlot = function() {
            if (plot) {
                plot.range = null
                draw()
            }
        }
        $scope.savePlot = function() {
            window.SEARPanel.words.saveText('plot.csv', plots.csv(linesToDraw()))
        }
        $scope.$watch(function() {
            var canvas = $scope.plotting && $scope.service && document.getElementById('sear-plot-' + $scope.service.name)
            return canvas ? canvas.clientWidth + ' ' + canvas.clientHeight : ''
        }, draw)
        /** The plot, for tests. */
        $scope.plot = function() {
            return plot
        }

        // ---- a record in the views ---------------------------------------------------------------------------------------------------------
        var liveWorld = $scope.world
        var liveNote = $scope.note
        $scope.world = function() {
            return $scope.replay && $scope.replay.world || liveWorld()
        }
        function ending(replay) {
            return replay.whole ? '' : replay.written ? ', it is still being written' : ', where it was cut off'
        }
        $scope.note = function() {
            var replay = $scope.replay
            return replay && replay.world ? replay.path + ' at ' + replay.times[replay.index].toFixed(2) + ' s of '
                + replay.times[replay.times.length - 1].toFixed(2) + ' s' + ending(replay) : liveNote()
        }
        /** What sensors read, now or in the record: their places are not in it, so that the views show none there. */
        $scope.sensors = function() {
            var world = $scope.world()
            return $scope.replay && $scope.replay.read || world && world.sensors || []
        }
        function byName(list) {
            var found = {}
            list.forEach(function(one) {
                found[one.name] = one
            })
            return found
        }
        function showRecord(sent) {
            var world = liveWorld()
            if (!world || !sent.times.length) {
                panel.say('warn', sent.path + ' can\'t be shown in the view: there is no world; open the project that was recorded')
                return
            }
            sent.known = angular.copy(world.sensors)
            world = angular.extend({}, world, {sensors: [], robots: angular.copy(world.robots).map(function(robot) {
                robot.devices = []      // of which the record knows only bytes
                return robot
            }), objects: world.objects.map(function(object) {
                return angular.extend({}, object)
            })})
            sent.world = world
            sent.index = 0
            sent.playing = false
            $scope.replay = sent
            $scope.seek()
        }
        /** Shows the frame of the slider. */
        $scope.seek = function() {
            var replay = $scope.replay
            replay.index = Math.max(0, Math.min(replay.times.length - 1, Math.round(Number(replay.index))))
            var robots = byName(replay.world.robots)
            var objects = byName(replay.world.objects)
            window.SEARPanel.replay.robotsAt(robots, replay, replay.index)
            replay.read = window.SEARPanel.replay.sensorsAt(replay.known, replay, replay.index)
            replay.objects.forEach(function(name, i) {
                if (objects[name]) {
                    objects[name].pose = replay.objectPoses[replay.index][i]
                }
            })
            panel.repaint()
            draw()
        }
        $scope.playRecord = function() {
            var replay = $scope.replay
            replay.playing = !replay.playing
            if (replay.playing) {
                if (replay.index >= replay.times.length - 1) {
                    replay.index = 0
                }
                replay.began = Date.now()
                replay.from = replay.times[replay.index]
                replay.rate = Number($scope.form.replaySpeed)
                window.requestAnimationFrame(playOn)
            }
        }
        $scope.setReplaySpeed = function() {
            if ($scope.replay && $scope.replay.playing) {
                $scope.playRecord()
                $scope.playRecord()
            }
        }
        function playOn() {
            var replay = $scope.replay
            if (!replay || !replay.playing) {
                return
            }
            var time = replay.from + (Date.now() - replay.began) / 1000 * replay.rate
            var index = replay.index
            while (index < replay.times.length - 1 && replay.times[index + 1] <= time) {
                index++
            }
            replay.index = index
            replay.playing = index < replay.times.length - 1
            $scope.seek()
            $scope.$applyAsync()
            window.requestAnimationFrame(playOn)
        }
        $scope.endReplay = function() {
            $scope.replay = null
            panel.repaint()
            draw()
        }

        var theme = window.matchMedia('(prefers-color-scheme: dark)')
        theme.addEventListener('change', draw)
        window.addEventListener('resize', draw)
        $scope.$on('$destroy', function() {
            theme.removeEventListener('change', draw)
            window.removeEventListener('resize', draw)
            $scope.replay = null
        })
        panel.sample = sample
        return {
            onRecords: function(paths) {
                $scope.records = paths || []
            },
            onRecordRun: function(path) {
                panel.say('info', 'recording ' + (panel.isSimulating() ? '' : 'the next run ') + 'into ' + path)
            },
            onEndRecord: function(seconds) {
                panel.say('info', 'recorded ' + Number(seconds).toFixed(2) + ' s')
                forget()
                msg.send('getRecords')
            },
            onRecordFrames: function(sent) {
                if (sent && sent.path === awaited.frames && sent.path === $scope.form.source) {
                    awaited.frames = null
                    $scope.names = sent.names
                    showRecord(sent)
                }
            },
            onRecordValues: function(sent) {
                sent.names.forEach(function(name, i) {
                    fetched[sent.path + '\n' + name] = {times: sent.times, values: sent.values[i]}
                    delete awaited[sent.path + '\n' + name]
                })
                draw()
            }
        }
    }
})()
