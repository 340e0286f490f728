// SPDX-License-Identifier: Apache-2.0
import * as words from '../shared/words.js'

/** Makes the list of the project's problems: those of the last call, else those of the preview. */
export function makeProblems(panel, world, messages) {
    var checking = false
    var problems = {found: []}

    problems.check = function() {
        checking = true
        panel.msg.send('checkProject')
    }
    problems.forget = function() {
        problems.found = []
    }
    problems.all = function() {
        return problems.found.length || panel.isSimulating() || !world.preview ? problems.found : world.preview.problems
    }
    function onProblems(found) {
        problems.found = found || []
    }
    world.previewed.hear(problems.forget)
    problems.handlers = {
        onProblems: onProblems,
        /** Each page receives the answers to all pages. */
        onCheckProject: function(answer) {
            onProblems(answer.problems)
            if (checking && !answer.problems.length) {
                messages.say('info', 'the project has no problems'
                    + (answer.warnings.length ? ', but ' + words.count(answer.warnings.length, 'warning') : ''))
                answer.warnings.forEach(function(warning) {
                    messages.say('warn', warning)
                })
            }
            checking = false
        }
    }
    return problems
}
