// SPDX-License-Identifier: Apache-2.0
// "Show as Python" in the SEAR panel: the script that makes the project, to read, copy and save.
import * as words from '../shared/words.js'

/** Makes the script view of one panel. */
export function makeScript(panel, messages, project) {
    var asked = false           // whether this page asked: each page receives the answers to all pages
    var script = {shown: null}  // text, and rows of the text field

    script.show = function() {
        asked = true
        panel.msg.send('getScript')
    }
    script.close = function() {
        script.shown = null
    }
    script.copy = function() {
        var field = panel.element('python')
        field.focus()
        field.select()
        messages.say('info', document.execCommand('copy') ? 'the script is on the clipboard' : 'the script is selected: copy it with Ctrl+C')
    }
    script.save = function() {
        var name = words.fileName(project.path).replace(/(\.sear)?$/, '.py')
        words.saveText(name, script.shown.text)
    }

    script.handlers = {
        onScript: function(text) {
            if (asked) {
                script.shown = {text: text, lines: Math.min(24, text.split('\n').length)}
            }
            asked = false
        }
    }
    return script
}
