// SPDX-License-Identifier: Apache-2.0
import * as words from '../shared/words.js'

/** The list of the project's problems: those of the last call, else those of the preview. */
export class Problems {
    constructor(panel, world, messages) {
        this.panel = panel
        this.world = world
        this.checking = false
        this.found = []
        world.previewed.hear(() => this.forget())
        this.handlers = {
            onProblems: found => this.onProblems(found),
            /** Each page receives the answers to all pages. */
            onCheckProject: answer => {
                this.onProblems(answer.problems)
                if (this.checking && !answer.problems.length) {
                    messages.say('info', 'the project has no problems'
                        + (answer.warnings.length ? ', but ' + words.count(answer.warnings.length, 'warning') : ''))
                    answer.warnings.forEach(warning => {
                        messages.say('warn', warning)
                    })
                }
                this.checking = false
            }
        }
    }

    check() {
        this.checking = true
        this.panel.msg.send('checkProject')
    }

    forget() {
        this.found = []
    }

    all() {
        return this.found.length || this.panel.isSimulating() || !this.world.preview
            ? this.found : this.world.preview.problems
    }

    onProblems(found) {
        this.found = found || []
    }
}
