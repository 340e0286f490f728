// SPDX-License-Identifier: Apache-2.0
// Badge above the SEAR panel's view while it shows a record, with a button back to the present.

/** The badge of one panel. */
export class Badge {
    constructor(panel, replay) {
        this.panel = panel
        this.replay = replay
        this.element = null
        this.words = null
        replay.moved.hear(() => this.show())
    }

    make(parent) {
        const back = document.createElement('button')
        this.words = document.createElement('span')
        this.element = document.createElement('div')
        this.words.setAttribute('role', 'status')
        back.type = 'button'
        back.className = 'btn btn-primary btn-xs sear-back-to-now'
        back.textContent = 'Back to now'
        back.addEventListener('click', () => {
            this.replay.end()
            this.panel.scope.$applyAsync()
        })
        this.element.className = 'sear-badge'
        this.element.append(this.words, back)
        parent.append(this.element)
    }

    show() {
        if (this.element) {
            this.element.hidden = !this.replay.shown
            const text = this.replay.shown ? 'Replay of ' + this.replay.shown.path : ''
            if (this.words.textContent !== text) {
                this.words.textContent = text
            }
        }
    }

    /** Creates the badge once the views exist. */
    listen() {
        this.make(this.panel.element('view').parentElement)
        this.show()
    }
}
