// Panel of the Python service: an editor, run and stop, and what the script prints.
angular.module('mrlapp.service.PythonGui', []).controller('PythonGuiCtrl', ['$scope', '$timeout', 'mrl', function($scope, $timeout, mrl) {
    var msg = this.msg
    var MOST_LINES = 2000
    var KEYWORDS = '\\b(?:and|as|assert|break|class|continue|def|del|elif|else|except|exec|finally|for|from|global|if|import|in|is|lambda|not|or|pass'
        + '|print|raise|return|try|while|with|yield|None|True|False)\\b'
    var TOKENS = new RegExp('(#[^\\n]*)|("""[\\s\\S]*?(?:"""|$)|\'\'\'[\\s\\S]*?(?:\'\'\'|$)|"(?:\\\\.|[^"\\\\\\n])*"?|\'(?:\\\\.|[^\'\\\\\\n])*\'?)|('
        + KEYWORDS + ')|(\\b\\d[\\w.]*)', 'g')
    var CLASSES = ['py-c', 'py-s', 'py-k', 'py-n']

    var DRAFT = 'python.draft.' + msg.name
    var KEEP_MILLIS = 300

    $scope.form = {file: 'script.py', code: 'print "Hello from", python.name\n'}
    $scope.question = null      // what Open or Save would lose: text, and go, what to do all the same
    $scope.problem = ''
    var kept = $scope.form.code // the text as it is in a file, or as it was before anybody typed
    var known = {}              // files that this page has opened or saved: those it overwrites without asking
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

    // The console has a script's errors already, and beside the file's name stands what was wrong with that.
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
    // ---- files: no text and no file is lost unasked ----------------------------------------------------------------------------------------
    $scope.saveScript = function() {
        var file = $scope.form.file
        msg.sendBlocking('getScriptList').then(function(files) {
            // only scripts in the folder of scripts are listed: of any other file nobody knows whether it is there
            var inFolder = /^[^/\\:]+\.py$/.test(file)
            if (known[file] || inFolder && files.indexOf(file) < 0) {
                write(file)
            } else {
                ask(file + (inFolder ? ' is there already, and this page has not opened it.' : ' is overwritten if it is there already.'), 'Save it',
                    write, file)
            }
        })
    }
    $scope.open = function() {
        var file = $scope.form.file
        if ($scope.isUnsaved()) {
            ask('The text below is not saved.', 'Open ' + file + ' all the same', read, file)
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
            if (settle(file, script, ' was not saved: is there such a folder, and may it be written to?')) {
                kept = code
                msg.send('getScriptList')
                keep()
            }
        })
    }
    function read(file) {
        call('openScript', [file]).then(function(script) {
            if (settle(file, script, ' can\'t be opened: there is no such file')) {
                $scope.form.code = kept = script.code
                $scope.colour()
            }
        })
    }
    // ---- examples: of services that have some ------------------------------------------------------------------------------------------------
    var offering = null         // the name of such a service
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
            ask('The text below is not saved.', 'Show ' + name + ' all the same', showExample, name)
        } else {
            showExample(name)
        }
    }
    function showExample(name) {
        mrl.sendBlocking(offering, 'getExampleScript', name).then(function(code) {
            $scope.form.file = name
            $scope.form.code = kept = code
            $scope.problem = ''
            $scope.colour()
        })
    }

    /** @return a promise of the script as the service has it then; undefined if it could not be done */
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

    // The text outlives a reload of the page.
    var keeping = null
    function keep() {
        $timeout.cancel(keeping)
        keeping = $timeout(function() {
            try {
                window.localStorage.setItem(DRAFT, JSON.stringify({file: $scope.form.file, code: $scope.form.code, kept: kept, known: known}))
            } catch (e) {
                $scope.problem = 'This browser does not keep unsaved text: ' + e.message
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

    // ---- the editor: a see-through text field over the same text in colours ----------------------------------------------------------------
    function escaped(text) {
        return text.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;')
    }

    function coloured(code) {
        var html = ''
        var at = 0
        code.replace(TOKENS, function(token) {
            var groups = Array.prototype.slice.call(arguments, 1, 1 + CLASSES.length)
            var index = arguments[1 + CLASSES.length]
            var kind = CLASSES[groups.findIndex(function(group) {
                return group !== undefined
            })]
            html += escaped(code.substring(at, index)) + '<span class="' + kind + '">' + escaped(token) + '</span>'
            at = index + token.length
        })
        return html + escaped(code.substring(at)) + '\n'
    }

    $scope.colour = function() {
        keep()
        var picture = document.getElementById('python-colours-' + msg.name)
        if (picture) {
            picture.innerHTML = coloured($scope.form.code || '')
            scroll()
        }
    }

    function scroll() {
        var text = document.getElementById('python-code-' + msg.name)
        var picture = document.getElementById('python-colours-' + msg.name)
        picture.scrollTop = text.scrollTop
        picture.scrollLeft = text.scrollLeft
    }

    $scope.key = function(event) {
        var text = event.target
        if (event.key === 'Enter' && event.ctrlKey) {
            event.preventDefault()
            $scope.run()
        } else if (event.key === 'Tab' && !event.shiftKey && !event.ctrlKey) {
            event.preventDefault()
            var at = text.selectionStart
            text.setRangeText('    ', at, text.selectionEnd, 'end')
            $scope.form.code = text.value
            $scope.colour()
        }
    }

    $timeout(function() {
        document.getElementById('python-code-' + msg.name).addEventListener('scroll', scroll)
        $scope.colour()
    })

    msg.subscribe('publishStdOut')
    msg.subscribe('publishStdError')
    msg.subscribe('publishStatus')
    msg.subscribe('getScriptList')
    msg.subscribe(this)
    msg.send('getScriptList')
    askForExamples()
    $scope.$on('mrl.services', askForExamples)
}])
