// SPDX-License-Identifier: Apache-2.0
// Badge above the SEAR panel's view while it shows a record, with a button back to the present.

/** Makes the badge of one panel. */
export function makeBadge(panel, replay) {
    var element = null
    var words = null
    var badge = {}

    function make(parent) {
        var back = document.createElement('button')
        words = document.createElement('span')
        element = document.createElement('div')
        words.setAttribute('role', 'status')
        back.type = 'button'
        back.className = 'btn btn-primary btn-xs sear-back-to-now'
        back.textContent = 'Back to now'
        back.addEventListener('click', function() {
            replay.end()
            panel.scope.$applyAsync()
        })
        element.className = 'sear-badge'
        element.append(words, back)
        parent.append(element)
    }
    function show() {
        if (element) {
            element.hidden = !replay.shown
            var text = replay.shown ? 'Replay of ' + replay.shown.path : ''
            if (words.textContent !== text) {
                words.textContent = text
            }
        }
    }
    /** Creates the badge once the views exist. */
    badge.listen = function() {
        make(panel.element('view').parentElement)
        show()
    }
    replay.moved.hear(show)
    return badge
}
