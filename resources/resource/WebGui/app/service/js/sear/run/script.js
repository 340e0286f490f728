// SPDX-License-Identifier: Apache-2.0
// "Show as Python" in the SEAR panel: the script that makes the project, to read, copy and save.
import * as words from '../shared/words.js'

/** The script view of one panel. */
export class Script {
    constructor(panel, messages, project) {
        this.panel = panel
        this.messages = messages
        this.project = project
        this.asked = false      // whether this page asked: each page receives the answers to all pages
        this.shown = null

        this.handlers = {
            onScript: text => {
                if (this.asked) {
                    this.shown = {text, lines: Math.min(24, text.split('\n').length)}
                }
                this.asked = false
            }
        }
    }

    show() {
        this.asked = true
        this.panel.msg.send('getScript')
    }

    close() {
        this.shown = null
    }

    copy() {
        const field = this.panel.element('python')
        field.focus()
        field.select()
        this.messages.say('info', document.execCommand('copy')
            ? 'the script is on the clipboard' : 'the script is selected: copy it with Ctrl+C')
    }

    save() {
        const name = words.fileName(this.project.path).replace(/(\.sear)?$/, '.py')
        words.saveText(name, this.shown.text)
    }
}
