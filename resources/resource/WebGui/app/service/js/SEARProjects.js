// Opening, saving, uploading and downloading projects in the SEAR panel.
(function() {
    var words = window.SEARPanel.words
    var CHUNK = 256 * 1024      // characters; MyRobotLab takes messages up to 1 MiB
    var RECENT = 'sear.recentProjects'
    var NEW = 'project.sear'
    var MOST_RECENT = 8

    /** Adds it to a panel. @return what it does with messages */
    window.SEARPanel.projects = function(panel) {
        var $scope = panel.scope
        var msg = panel.msg
        $scope.form.path = NEW
        $scope.examples = []
        $scope.scripts = []         // names of the examples that drive
        $scope.question = null      // a file that is to be overwritten: path, and free, a name that is not taken
        $scope.transfer = null
        $scope.recent = readRecent()

        panel.asked = {}            // paths that this page wants saved and opened
        function readRecent() {
            try {
                return JSON.parse(window.localStorage.getItem(RECENT)) || []
            } catch (e) {
                return []
            }
        }
        function remember(path) {
            $scope.recent = [path].concat($scope.recent.filter(function(other) {
                return other !== path
            })).slice(0, MOST_RECENT)
            try {
                window.localStorage.setItem(RECENT, JSON.stringify($scope.recent))
            } catch (e) {
                panel.say('warn', 'this browser does not remember recent projects: ' + e.message)
            }
        }
        $scope.load = function(path) {
            $scope.problems = []
            $scope.form.path = path
            remember(path)
            panel.asked.load = path
            msg.send('loadProject', path)
        }
        /** What comes from an example is saved beside it, not over it. */
        function onLoaded() {
            panel.say('info', 'opened ' + (panel.asked.load || 'by another page'))
            if (panel.asked.load && $scope.examples.indexOf(panel.asked.load) >= 0) {
                $scope.form.path = words.fileName(panel.asked.load)
            }
            panel.asked.load = null
        }
        $scope.startAnew = function() {
            panel.asked.anew = true
            msg.send('newProject')
        }

        var written = {}            // paths that this page has saved to: those it overwrites without asking
        $scope.saveProject = function() {
            $scope.saveTo($scope.form.path, Boolean(written[$scope.form.path]))
        }
        $scope.saveTo = function(path, overwrite) {
            $scope.question = null
            panel.asked.save = path
            msg.send('saveProjectAs', path, overwrite)
        }
        $scope.cancel = function() {
            $scope.question = null
        }
        function onSaved(answer) {
            var mine = panel.asked.save === answer.asked
            if (answer.saved) {
                panel.say('info', mine ? 'saved ' + answer.path : 'saved by another page')
            }
            if (mine && answer.saved) {
                written[answer.path] = true
                $scope.form.path = answer.path
                remember(answer.path)
            } else if (mine) {
                $scope.question = answer
            }
            panel.asked.save = mine ? null : panel.asked.save
        }
        $scope.plain = function(script) {
            return script.replace(/\.py$/, '').replace(/_/g, ' ')
        }
        $scope.runScript = function() {
            panel.say('info', 'running ' + $scope.form.script)
            msg.send('runExampleScript', $scope.form.script)
        }
        $scope.copyTemplate = function() {
            msg.send('copyTemplate', $scope.form.template, $scope.form.folder)
        }

        $scope.upload = function(file) {
            if (!file) {
                return
            }
            var reader = new FileReader()
            reader.onload = function() {
                var text = reader.result.substring(reader.result.indexOf(',') + 1)
                var parts = Math.max(1, Math.ceil(text.length / CHUNK))
                $scope.problems = []
                for (var i = 0; i < parts; i++) {
                    msg.send('uploadProject', file.name, i, parts, text.substring(i * CHUNK, (i + 1) * CHUNK))
                }
                $scope.transfer = 'loading ' + file.name
                panel.asked.upload = file.name
                $scope.$applyAsync()
            }
            reader.onerror = function() {
                panel.say('error', file.name + ' can\'t be read: ' + reader.error.message)
                $scope.$applyAsync()
            }
            reader.readAsDataURL(file)
        }

        var parts = null            // of the bundle that this page downloads
        $scope.download = function() {
            parts = []
            $scope.transfer = 'saving'
            msg.send('getBundle', 0)
        }
        function onBundle(part) {
            if (!parts || part.index !== parts.length) {
                return              // another page downloads
            }
            parts.push(part.data)
            if (parts.length < part.count) {
                $scope.transfer = 'saving, part ' + parts.length + ' of ' + part.count
                msg.send('getBundle', parts.length)
                return
            }
            words.saveFile(words.fileName($scope.form.path).replace(/(\.sear)?$/, '.sear'), parts)
            parts = null
            $scope.transfer = null
        }

        /** Once its fields are there. */
        panel.listenToFiles = function() {
            var drop = document.getElementById('sear-drop-' + $scope.service.name)
            drop.addEventListener('dragover', function(event) {
                event.preventDefault()
            })
            drop.addEventListener('drop', function(event) {
                event.preventDefault()
                $scope.upload(event.dataTransfer.files[0])
            })
            document.getElementById('sear-file-' + $scope.service.name).addEventListener('change', function(event) {
                $scope.upload(event.target.files[0])
                event.target.value = ''     // so that the same file can be chosen again
            })
        }

        return {
            onBundle: onBundle,
            onExamples: function(paths) {
                $scope.examples = paths || []
            },
            onExampleScripts: function(names) {
                $scope.scripts = names || []
                $scope.form.script = $scope.form.script || $scope.scripts[0]
            },
            onUploaded: function(text) {
                $scope.transfer = null
                if (panel.asked.upload) {
                    $scope.form.path = panel.asked.upload
                }
                panel.asked.upload = null
                panel.say('info', text)
            },
            onSaveProject: function() {
                panel.say('info', 'saved by another page')
            },
            onSaveProjectAs: onSaved,
            onLoadProject: onLoaded,
            onNewProject: function(backup) {
                if (panel.asked.anew) {
                    $scope.form.path = NEW
                }
                panel.asked.anew = false
                panel.say('info', 'an empty project' + (backup ? '; the former one is kept in ' + backup : ''))
            },
            onCopyTemplate: function(path) {
                panel.say('info', 'copied to ' + path)
            }
        }
    }
})()
