// Panel of the Python service: an editor, run and stop, and the script's output.
{
    const MOST_LINES = 2000
    const KEEP_MILLIS = 300
    const TYPED = /([A-Za-z_]\w*)\.\w*$/ // a service call being typed
    const LINE = /File "<script>", line (\d+)/g
    const ABOUT_FILES = /\b(openScript|saveScript)\b/

    /** Returns the text to insert; its parameters become fields to type over, one after another. */
    const snippet = one => {
        const names = one.parameters ? one.parameters.split(', ') : []
        return one.name + '(' + names.map((name, i) => '${' + (i + 1) + ':' + name + '}').join(', ') + ')'
    }

    class PythonPanel {
        constructor(controller, $scope, $timeout, mrl, editors) {
            this.$scope = $scope
            this.$timeout = $timeout
            this.mrl = mrl
            this.msg = controller.msg
            this.draft = 'python.draft.' + this.msg.name  // key of the browser's storage
            this.editor = null      // the Ace editor, once loaded

            $scope.form = {file: 'script.py', code: 'print "Hello from", python.name\n'}
            $scope.question = null      // question before text or a file is lost: text, and go, which continues
            $scope.problem = ''
            this.kept = $scope.form.code // last text saved, opened or initial
            this.known = {}         // files that this page has opened or saved: overwritten without asking
            this.recall()
            $scope.files = []
            $scope.lines = []
            $scope.running = false

            controller.onMsg = inMsg => this.onMsg(inMsg.method, inMsg.data[0])

            this.lastError = ''
            this.offering = null    // name of such a service
            $scope.examples = []
            /** Shows another panel's script; asks before unsaved text is lost. */
            $scope.$on('python.show', (event, script) => {
                event.preventDefault()      // tells the other panel
                if (script.code === $scope.form.code) {
                    return
                }
                if (this.isUnsaved()) {
                    this.ask('The text below is not saved.', 'Show ' + script.file + ' anyway',
                        () => this.showScript(script))
                } else {
                    this.showScript(script)
                }
            })

            this.keeping = null

            this.calls = []         // calls of services' types: {type, name, parameters, doc}

            $timeout(() => {
                editors().then(ace => this.edit(ace))
            })

            ;['run', 'stop', 'saveScript', 'open', 'isUnsaved', 'cancel', 'openExample', 'clear'].forEach(name => {
                $scope[name] = this[name].bind(this)
            })
            ;['publishStdOut', 'publishStdError', 'publishStatus', 'getScriptList']
            .forEach(topic => this.msg.subscribe(topic))
            this.msg.subscribe(controller)
            this.msg.send('getScriptList')
            this.askForExamples()
            this.askForCalls()
            $scope.$on('mrl.services', () => {
                this.askForExamples()
                this.askForCalls()
            })
        }

        onMsg(method, data) {
            const $scope = this.$scope
            switch (method) {
            case 'onState':
                $scope.service = data
                $scope.running = data.executing
                break
            case 'onStdOut':
                this.print(data, '')
                break
            case 'onStdError':
                this.lastError = data
                this.print(data, 'err')
                this.markLine(data)
                break
            case 'onStatus':
                this.onStatus(data.key || data.detail, data.level)
                break
            case 'onScriptList':
                $scope.files = data
                break
            default:
                break
            }
            $scope.$applyAsync()
        }

        /** The console already shows a script's errors, and the page shows file errors beside the file's name. */
        onStatus(text, level) {
            if (this.lastError.indexOf(text) < 0 && !ABOUT_FILES.test(text)) {
                this.print(text + '\n', level === 'error' ? 'err' : '')
            }
        }

        print(text, kind) {
            this.$scope.lines.push({text, kind})
            this.$scope.lines.splice(0, this.$scope.lines.length - MOST_LINES)
            this.$timeout(() => {
                const element = document.getElementById('python-console-' + this.msg.name)
                element.scrollTop = element.scrollHeight
            })
        }

        run() {
            this.msg.send('exec', this.$scope.form.code, false)
        }

        stop() {
            this.msg.sendBlocking('stop')
        }

        // ---- files: asks before text or a file is lost
        // --------------------------------------------------------------------------------------------
        saveScript() {
            const file = this.$scope.form.file
            this.msg.sendBlocking('getScriptList').then(files => {
                // the list has only files of the script folder: for other files, the page can't know whether they exist
                const inFolder = /^[^/\\:]+\.py$/.test(file)
                if (this.known[file] || inFolder && files.indexOf(file) < 0) {
                    this.write(file)
                } else {
                    this.ask(file + (inFolder ? ' already exists, and this page has '
                        + 'not opened it.' : ' is overwritten if it exists.'), 'Save it',
                        () => this.write(file))
                }
            })
        }

        open() {
            const file = this.$scope.form.file
            if (this.isUnsaved()) {
                this.ask('The text below is not saved.', 'Open ' + file + ' anyway', () => this.read(file))
            } else {
                this.read(file)
            }
        }

        isUnsaved() {
            return this.$scope.form.code !== this.kept && Boolean(this.$scope.form.code.trim())
        }

        cancel() {
            this.$scope.question = null
        }

        ask(text, button, work) {
            this.$scope.question = {text, button, go: () => {
                this.$scope.question = null
                work()
            }}
        }

        write(file) {
            const code = this.$scope.form.code
            this.call('saveScript', [file, code]).then(script => {
                if (this.settle(file, script, ' was not saved: does its folder exist, and is it writable?')) {
                    this.kept = code
                    this.msg.send('getScriptList')
                    this.keep()
                }
            })
        }

        read(file) {
            this.call('openScript', [file]).then(script => {
                if (this.settle(file, script, ' can\'t be opened: no such file')) {
                    this.show(script.code)
                }
            })
        }

        // ---- examples of services that have some
        // -----------------------------------------------------------------------------------------------
        askForExamples() {
            const service = this.mrl.getServices()
                .filter(one => one.methods && one.methods.indexOf('getExampleScripts') >= 0)[0]
            this.offering = service ? service.name : null
            if (!this.offering) {
                this.$scope.examples = []
                return
            }
            this.mrl.sendBlocking(this.offering, 'getExampleScripts').then(names => {
                this.$scope.examples = names || []
            })
        }

        openExample() {
            const name = this.$scope.form.example
            if (!name) {
                return
            }
            this.$scope.form.example = null
            if (this.isUnsaved()) {
                this.ask('The text below is not saved.', 'Show ' + name + ' anyway', () => this.showExample(name))
            } else {
                this.showExample(name)
            }
        }

        showExample(name) {
            this.mrl.sendBlocking(this.offering, 'getExampleScript', name).then(code => {
                this.showScript({file: name, code})
            })
        }

        showScript(script) {
            this.$scope.form.file = script.file
            this.$scope.problem = ''
            this.show(script.code)
        }

        /** @return a promise of the script in the service's state; undefined after a failure */
        call(method, data) {
            return this.msg.sendBlocking(method, ...data).then(() => this.msg.sendBlocking('publishState'))
                .then(state => state.openedScripts[data[0]])
        }

        settle(file, script, problem) {
            this.$scope.problem = script ? '' : file + problem
            if (script) {
                this.known[file] = true
            }
            return Boolean(script)
        }

        /** Stores the text, so that it survives a reload of the page. */
        keep() {
            this.$timeout.cancel(this.keeping)
            this.keeping = this.$timeout(() => {
                try {
                    window.localStorage.setItem(this.draft,
                        JSON.stringify({file: this.$scope.form.file, code: this.$scope.form.code,
                        kept: this.kept, known: this.known}))
                } catch (e) {
                    this.$scope.problem = 'This browser can\'t store unsaved text: ' + e.message
                }
            }, KEEP_MILLIS)
        }

        recall() {
            try {
                const draft = JSON.parse(window.localStorage.getItem(this.draft))
                if (draft && draft.code) {
                    this.$scope.form.file = draft.file
                    this.$scope.form.code = draft.code
                    this.kept = draft.kept
                    this.known = draft.known
                }
            } catch (e) {
                return      // the browser stores nothing
            }
        }

        clear() {
            this.$scope.lines = []
        }

        // ---- the editor
        // -------------------------------------------------------------------------------------------------------------
        /** @param code that a file or an example contains: no text is lost with the page */
        show(code) {
            this.$scope.form.code = this.kept = code
            if (this.editor) {
                this.editor.session.setValue(code)
            }
            this.keep()
        }

        /** Marks the line of an error until the text changes. */
        markLine(traceback) {
            const lines = traceback.match(LINE)
            const row = lines ? Number(/\d+/.exec(lines.pop())[0]) - 1 : -1
            if (this.editor && row >= 0 && row < this.editor.session.getLength()) {
                this.editor.session.setAnnotations(
                    [{row, column: 0, type: 'error', text: traceback.trim().split('\n').pop()}])
                this.editor.scrollToLine(row, true)
            }
        }

        edit(ace) {
            const element = document.getElementById('python-code-' + this.msg.name)
            if (!element) {
                return
            }
            this.editor = ace.edit(element, {mode: 'ace/mode/python', fontSize: 13, tabSize: 4, useSoftTabs: true,
                showPrintMargin: false,
                useWorker: false, behavioursEnabled: false, enableKeyboardAccessibility: true,
                enableBasicAutocompletion: [{getCompletions: (asking, session, position, prefix, callback) =>
                    callback(null, this.completions())}]})
            this.editor.textInput.getElement().setAttribute('aria-label', 'Code; Ctrl+Enter runs it')
            this.editor.session.setValue(this.$scope.form.code)
            this.editor.session.on('change', () => {
                this.$scope.form.code = this.editor.getValue()
                this.editor.session.clearAnnotations()
                this.keep()
                this.$scope.$applyAsync()
            })
            this.editor.commands.addCommand(
            {name: 'run', bindKey: {win: 'Ctrl-Enter', mac: 'Ctrl-Enter|Command-Enter'}, exec: () => this.run()})
            this.editor.commands.on('afterExec', done => {
                if (done.command.name === 'insertstring' && done.args === '.' && TYPED.test(this.beforeCursor())) {
                    this.editor.execCommand('startAutocomplete')
                }
            })
            const dark = window.matchMedia('(prefers-color-scheme: dark)')
            const size = new window.ResizeObserver(() => {
                this.editor.resize()
            })
            const setTheme = () => {
                this.editor.setTheme(dark.matches ? 'ace/theme/github_dark' : 'ace/theme/github_light_default')
            }
            setTheme()
            dark.addEventListener('change', setTheme)
            size.observe(element)
            this.$scope.$on('$destroy', () => {
                dark.removeEventListener('change', setTheme)
                size.disconnect()
                this.editor.destroy()
            })
        }

        beforeCursor() {
            const at = this.editor.getCursorPosition()
            return this.editor.session.getLine(at.row).substring(0, at.column)
        }

        // ---- completion: calls listed by services, else all methods
        // ----------------------------------------------------------------------------
        askForCalls() {
            const service = this.mrl.getServices()
                .filter(one => one.methods && one.methods.indexOf('getScriptCalls') >= 0)[0]
            if (service && !this.calls.length) {
                this.mrl.sendBlocking(service.name, 'getScriptCalls').then(answer => {
                    this.calls = answer || []
                })
            }
        }

        /** Returns the type of a variable: that of a service, or of one that the text starts under another name. */
        typeOf(variable) {
            const service = this.mrl.getServices().filter(one => one.name.replace(/\W/g, '_') === variable)[0]
            const start = new RegExp('\\b' + variable
                + '\\s*=\\s*Runtime\\.(?:start|createAndStart)\\([^,]*,\\s*["\'](\\w+)')
            const started = start.exec(this.$scope.form.code)
            return started ? started[1] : service ? service.simpleName : null
        }

        methodsOf(type) {
            const service = this.mrl.getServices().filter(one => one.simpleName === type)[0]
            return service && service.methods || []
        }

        /** Returns the completions at the cursor, as Ace takes them. */
        completions() {
            const typed = TYPED.exec(this.beforeCursor())
            if (!typed) {
                return this.mrl.getServices().map(
                    service => ({value: service.name.replace(/\W/g, '_'), meta: service.simpleName}))
            }
            const type = this.typeOf(typed[1])
            const listed = this.calls.filter(one => one.type === type)
            return listed.length ? listed.map(
            one => ({caption: one.name + '(' + one.parameters + ')', snippet: snippet(one), value: one.name,
                meta: type, docText: one.doc})) : this.methodsOf(type)
                .map(name => ({caption: name, value: name + '(', meta: type}))
        }

    }

    angular.module('mrlapp.service.PythonGui', [])
        .controller('PythonGuiCtrl', ['$scope', '$timeout', 'mrl', 'editors', function(...services) {
        new PythonPanel(this, ...services)
    }]).factory('editors', ['$q', function($q) {
        let loaded = null

        function load(file) {
            const done = $q.defer()
            const script = document.createElement('script')
            script.src = 'ace/' + file
            script.onload = done.resolve
            script.onerror = done.reject
            document.head.appendChild(script)
            return done.promise
        }
        /** Returns a promise of Ace, which is loaded for the first of these panels. */
        return function() {
            loaded = loaded || load('ace.js').then(() => load('ext-language_tools.js')).then(() => {
                window.ace.config.set('basePath', 'ace')
                window.ace.require('ace/ext/language_tools')
                return window.ace
            })
            return loaded
        }
    }])
}
