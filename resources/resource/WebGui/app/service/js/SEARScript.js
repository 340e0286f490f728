// "Show as Python" in the SEAR panel: the script that makes the project, to read, to copy and to save.
(function() {
    /** Adds it to a panel. @return what it does with messages */
    window.SEARPanel.script = function(panel) {
        var $scope = panel.scope
        var asked = false           // whether this page wants it: each page gets the answers to all pages
        $scope.python = null        // the script that is shown

        $scope.showScript = function() {
            asked = true
            panel.msg.send('getScript')
        }
        $scope.closeScript = function() {
            $scope.python = null
        }
        $scope.copyScript = function() {
            var field = document.getElementById('sear-python-' + $scope.service.name)
            field.focus()
            field.select()
            panel.say('info', document.execCommand('copy') ? 'the script is on the clipboard' : 'the script is selected: copy it with Ctrl+C')
        }
        $scope.saveScript = function() {
            var name = window.SEARPanel.words.fileName($scope.form.path).replace(/(\.sear)?$/, '.py')
            window.SEARPanel.words.saveText(name, $scope.python.text)
        }

        return {
            onScript: function(text) {
                if (asked) {
                    $scope.python = {text: text, lines: Math.min(24, text.split('\n').length)}
                }
                asked = false
            }
        }
    }
})()
