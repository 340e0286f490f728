// Panel of the Python service: an editor, run and stop, and the script's output.
angular.module('mrlapp.service.PythonGui', []).controller('PythonGuiCtrl', ['$scope', '$timeout', 'mrl', 'editors', function($scope, $timeout, mrl, editors) {
    var msg = this.msg
    var MOST_LINES = 2000
    var DRAFT = 'python.draft.' + msg.name
    var KEEP_MILLIS = 300
    var TYPED = /([A-Za-z_]\w*)\.\w*$/      // a service call being typed
    var LINE = /File "<script>", line (\d+)/g
    var editor = null           // the Ace editor, once loaded

    $scope.form = {file: 'script.py', code: 'print "Hello from", python.name\n'}
    $scope.question = null      // question before text or a file is lost: text, and go, which continues
    $scope.problem = ''
    var kept = $scope.form.code // last text saved, opened or initial
    var known = {}              // files that this page has opened or saved: overwritten without asking
    recall()
    $scope.files = []
    $scope.lines = []
    $scope.running = false

    this.onMsg = function(inMsg) {
        var data = inMsg.data[0]
        switch (inMsg.method) {
        case 'onState':
            $scope.service = data
            $scope.running = data.executing
            break
        case 'onStdOut':
            print(data, '')
            break
        case 'onStdError':
            lastError = data
            print(data, 'err')
            markLine(data)
            break
        case 'onStatus':
            onStatus(data.key || data.detail, data.level)
            break
        case 'onScriptList':
            $scope.files = data
            break
        default:
            break
        }
        $scope.$applyAsync()
    }

    // The console already shows a script's errors, and the page shows file errors beside the file's name.
    var lastError = ''
    var ABOUT_FILES = /\b(openScript|saveScript)\b/
    function onStatus(text, level) {
        if (lastError.indexOf(text) < 0 && !ABOUT_FILES.test(text)) {
            print(text + '\n', level === 'error' ? 'err' : '')
        }
    }

    function print(text, kind) {
        $scope.lines.push({text: text, kind: kind})
        $scope.lines.splice(0, $scope.lines.length - MOST_LINES)
        $timeout(function() {
            var element = document.getElementById('python-console-' + msg.name)
            element.scrollTop = element.scrollHeight
        })
    }

    $scope.run = function() {
        msg.send('exec', $scope.form.code, false)
    }
    $scope.stop = function() {
        msg.sendBlocking('stop')
    }
    // ---- files: asks before text or a file is lost --------------------------------------------------------------------------------------------
    $scope.saveScript = function() {
        var file = $scope.form.file
        msg.sendBlocking('getScriptList').then(function(files) {
            // the list has only files of the script folder: for other files, the page can't know whether they exist
            var inFolder = /^[^/\\:]+\.py$/.test(file)
            if (known[file] || inFolder && files.indexOf(file) < 0) {
                write(file)
            } else {
                ask(file + (inFolder ? ' already exists, and this page has not opened it.' : ' is overwritten if it exists.'), 'Save it',
                    write, file)
            }
        })
    }
    $scope.open = function() {
        var file = $scope.form.file
        if ($scope.isUnsaved()) {
            ask('The text below is not saved.', 'Open ' + file + ' anyway', read, file)
        } else {
            read(file)
        }
    }
    $scope.isUnsaved = function() {
        return $scope.form.code !== kept && Boolean($scope.form.code.trim())
    }
    $scope.cancel = function() {
        $scope.question = null
    }
    function ask(text, button, work, file) {
        $scope.question = {text: text, button: button, go: function() {
            $scope.question = null
            work(file)
        }}
    }

    function write(file) {
        var code = $scope.form.code
        call('saveScript', [file, code]).then(function(script) {
            if (settle(file, script, ' was not saved: does its folder exist, and is it writable?')) {
                kept = code
                msg.send('getScriptList')
                keep()
            }
        })
    }
    function read(file) {
        call('openScript', [file]).then(function(script) {
            if (settle(file, script, ' can\'t be opened: no such file')) {
                show(script.code)
            }
        })
    }
    // ---- examples of services that have some -------------------------------------------------------------------------------------------------
    var offering = null         // name of such a service
    $scope.examples = []
    function askForExamples() {
        var service = mrl.getServices().filter(function(one) {
            return one.methods && one.methods.indexOf('getExampleScripts') >= 0
        })[0]
        offering = service ? service.name : null
        if (!offering) {
            $scope.examples = []
            return
        }
        mrl.sendBlocking(offering, 'getExampleScripts').then(function(names) {
            $scope.examples = names || []
        })
    }
    $scope.openExample = function() {
        var name = $scope.form.example
        if (!name) {
            return
        }
        $scope.form.example = null
        if ($scope.isUnsaved()) {
            ask('The text below is not saved.', 'Show ' + name + ' anyway', showExample, name)
        } else {
            showExample(name)
        }
    }
    function showExample(name) {
        mrl.sendBlocking(offering, 'getExampleScript', name).then(function(code) {
            showScript({file: name, code: code})
        })
    }
    function showScript(script) {
        $scope.form.file = script.file
        $scope.problem = ''
        show(script.code)
    }
    /** Shows another panel's script; asks before unsaved text is lost. */
    $scope.$on('python.show', function(event, script) {
        event.preventDefault()      // tells the other panel
        if (script.code === $scope.form.code) {
            return
        }
        if ($scope.isUnsaved()) {
            ask('The text below is not saved.', 'Show ' + script.file + ' anyway', showScript, script)
        } else {
            showScript(script)
        }
    })

    /** @return a promise of the script in the service's state; undefined after a failure */
    function call(method, data) {
        return msg.sendBlocking.apply(null, [method].concat(data)).then(function() {
            return msg.sendBlocking('publishState')
        }).then(function(state) {
            return state.openedScripts[data[0]]
        })
    }
    function settle(file, script, problem) {
        $scope.problem = script ? '' : file + problem
        if (script) {
            known[file] = true
        }
        return Boolean(script)
    }

    // Stores the text, so that it survives a reload of the page.
    var keeping = null
    function keep() {
        $timeout.cancel(keeping)
        keeping = $timeout(function() {
            try {
                window.localStorage.setItem(DRAFT, JSON.stringify({file: $scope.form.file, code: $scope.form.code, kept: kept, known: known}))
            } catch (e) {
                $scope.problem = 'This browser can\'t store unsaved text: ' + e.message
            }
        }, KEEP_MILLIS)
    }
    function recall() {
        try {
            var draft = JSON.parse(window.localStorage.getItem(DRAFT))
        } catch (e) {
            return
        }
        if (draft && draft.code) {
            $scope.form.file = draft.file
            $scope.form.code = draft.code
            kept = draft.kept
            known = draft.known
        }
    }
    $scope.clear = function() {
        $scope.lines = []
    }

    // ---- the editor ------------------------------------------------------------------------------------------------------------------------
    /** @param code that a file or an example contains: no text is lost with the page */
    function show(code) {
        $scope.form.code = kept = code
        if (editor) {
            editor.session.setValue(code)
        }
        keep()
    }
    /** Marks the line of an error until the text changes. */
    function markLine(traceback) {
        var lines = traceback.match(LINE)
        var row = lines ? Number(/\d+/.exec(lines.pop())[0]) - 1 : -1
        if (editor && row >= 0 && row < editor.session.getLength()) {
            editor.session.setAnnotations([{row: row, column: 0, type: 'error', text: traceback.trim().split('\n').pop()}])
            editor.scrollToLine(row, true)
        }
    }

    function edit(ace) {
        var element = document.getElementById('python-code-' + msg.name)
        if (!element) {
            return
        }
        editor = ace.edit(element, {mode: 'ace/mode/python', fontSize: 13, tabSize: 4, useSoftTabs: true, showPrintMargin: false, useWorker: false,
            behavioursEnabled: false, enableKeyboardAccessibility: true, enableBasicAutocompletion: [{getCompletions: complete}]})
        editor.textInput.getElement().setAttribute('aria-label', 'Code; Ctrl+Enter runs it')
        editor.session.setValue($scope.form.code)
        editor.session.on('change', function() {
            $scope.form.code = editor.getValue()
            editor.session.clearAnnotations()
            keep()
            $scope.$applyAsync()
        })
        editor.commands.addCommand({name: 'run', bindKey: {win: 'Ctrl-Enter', mac: 'Ctrl-Enter|Command-Enter'}, exec: $scope.run})
        editor.commands.on('afterExec', function(done) {
            if (done.command.name === 'insertstring' && done.args === '.' && TYPED.test(beforeCursor())) {
                editor.execCommand('startAutocomplete')
            }
        })
        var dark = window.matchMedia('(prefers-color-scheme: dark)')
        var size = new window.ResizeObserver(function() {
            editor.resize()
        })
        function setTheme() {
            editor.setTheme(dark.matches ? 'ace/theme/github_dark' : 'ace/theme/github_light_default')
        }
        setTheme()
        dark.addEventListener('change', setTheme)
        size.observe(element)
        $scope.$on('$destroy', function() {
            dark.removeEventListener('change', setTheme)
            size.disconnect()
            editor.destroy()
        })
    }
    function beforeCursor() {
        var at = editor.getCursorPosition()
        return editor.session.getLine(at.row).substring(0, at.column)
    }

    // ---- completion: calls listed by services, else all methods -----------------------------------------------------------------------------
    var calls = []              // calls of services' types: {type, name, parameters, doc}
    function askForCalls() {
        var service = mrl.getServices().filter(function(one) {
            return one.methods && one.methods.indexOf('getScriptCalls') >= 0
        })[0]
        if (service && !calls.length) {
            mrl.sendBlocking(service.name, 'getScriptCalls').then(function(answer) {
                calls = answer || []
            })
        }
    }
    /** Returns the type of a variable: that of a service, or of one that the text starts under another name. */
    function typeOf(variable) {
        var service = mrl.getServices().filter(function(one) {
            return one.name.replace(/\W/g, '_') === variable
        })[0]
        var started = new RegExp('\\b' + variable + '\\s*=\\s*Runtime\\.(?:start|createAndStart)\\([^,]*,\\s*["\'](\\w+)').exec($scope.form.code)
        return started ? started[1] : service ? service.simpleName : null
    }
    function methodsOf(type) {
        var service = mrl.getServices().filter(function(one) {
            return one.simpleName === type
        })[0]
        return service && service.methods || []
    }
    function complete(asking, session, position, prefix, callback) {
        var typed = TYPED.exec(beforeCursor())
        var type = typed && typeOf(typed[1])
        var listed = calls.filter(function(one) {
            return one.type === type
        })
        if (!typed) {
            callback(null, mrl.getServices().map(function(service) {
                return {value: service.name.replace(/\W/g, '_'), meta: service.simpleName}
            }))
        } else if (listed.length) {
            callback(null, listed.map(function(one) {
                return {caption: one.name + '(' + one.parameters + ')', snippet: snippet(one), value: one.name, meta: type, docText: one.doc}
            }))
        } else {
            callback(null, methodsOf(type).map(function(name) {
                return {caption: name, value: name + '(', meta: type}
            }))
        }
    }
    /** Returns the text to insert; its parameters become fields to type over, one after another. */
    function snippet(one) {
        return one.name + '(' + (one.parameters ? one.parameters.split(', ').map(function(name, i) {
            return '${' + (i + 1) + ':' + name + '}'
        }).join(', ') : '') + ')'
    }

    $timeout(function() {
        editors().then(edit)
    })

    msg.subscribe('publishStdOut')
    msg.subscribe('publishStdError')
    msg.subscribe('publishStatus')
    msg.subscribe('getScriptList')
    msg.subscribe(this)
    msg.send('getScriptList')
    askForExamples()
    askForCalls()
    $scope.$on('mrl.services', function() {
        askForExamples()
        askForCalls()
    })
}]).factory('editors', ['$q', function($q) {
    var loaded = null

    function load(file) {
        var done = $q.defer()
        var script = document.createElement('script')
        script.src = 'ace/' + file
        script.onload = done.resolve
        script.onerror = done.reject
        document.head.appendChild(script)
        return done.promise
    }
    /** Returns a promise of Ace, which is loaded for the first of these panels. */
    return function() {
        loaded = loaded || load('ace.js').then(function() {
            return load('ext-language_tools.js')
        }).then(function() {
            window.ace.config.set('basePath', 'ace')
            window.ace.require('ace/ext/language_tools')
            return window.ace
        })
        return loaded
    }
}])
