// Panel of the Python service: an editor, run and stop, and what the script prints.
angular.module('mrlapp.service.PythonGui', []).controller('PythonGuiCtrl', ['$scope', '$timeout', function($scope, $timeout) {
    var msg = this.msg
    var MOST_LINES = 2000
    var KEYWORDS = '\\b(?:and|as|assert|break|class|continue|def|del|elif|else|except|exec|finally|for|from|global|if|import|in|is|lambda|not|or|pass'
        + '|print|raise|return|try|while|with|yield|None|True|False)\\b'
    var TOKENS = new RegExp('(#[^\\n]*)|("""[\\s\\S]*?(?:"""|$)|\'\'\'[\\s\\S]*?(?:\'\'\'|$)|"(?:\\\\.|[^"\\\\\\n])*"?|\'(?:\\\\.|[^\'\\\\\\n])*\'?)|('
        + KEYWORDS + ')|(\\b\\d[\\w.]*)', 'g')
    var CLASSES = ['py-c', 'py-s', 'py-k', 'py-n']

    $scope.form = {file: 'script.py', code: 'print "Hello from", python.name\n'}
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
            print(data, 'err')
            break
        case 'onScriptList':
            $scope.files = data
            break
        default:
            break
        }
        $scope.$applyAsync()
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
    $scope.save = function() {
        msg.send('saveScript', $scope.form.file, $scope.form.code)
        msg.send('getScriptList')
    }
    $scope.open = function() {
        msg.sendBlocking('openScript', $scope.form.file).then(function() {
            return msg.sendBlocking('publishState')
        }).then(function(state) {
            var script = state.openedScripts[$scope.form.file]
            if (script) {
                $scope.form.code = script.code
                $scope.colour()
            }
        })
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
    msg.subscribe('getScriptList')
    msg.subscribe(this)
    msg.send('getScriptList')
}])
