// SPDX-License-Identifier: Apache-2.0
// The SEAR panel's workspace: how it fills the window, and which parts are folded.
import {isLight} from './geometry.js'
import {recallJson, remember} from './page.js'

const FOLDS = 'sear.folds'    // local storage key of the user's folds
const WORDY = 1080            // minimum width for words beside the drawers' icons, pixels
const WIDE = 900              // minimum width for three columns
const MEDIUM = 720            // minimum width for two columns; below it, all parts are stacked and the page scrolls
const BELOW = ['project', 'plots', 'messages', 'scripts']    // parts above or below the view that are folded at first
const SLACK = 24              // hysteresis, wider than a scroll bar
const LEAST = 420             // minimum height of the columns, pixels
const MOST_BELOW = 200        // maximum height kept free for the page's content below the panel, pixels

/** Returns an element's top in the page, whatever the scroll position. */
function topOf(element) {
    let top = 0
    for (let e = element; e; e = e.offsetParent) {
        top += e.offsetTop
    }
    return top
}

/** Returns the scroll container of an element: MyRobotLab's frame around panels, or the page. */
function frameOf(element) {
    let e = element.parentElement
    while (e !== document.body && !/auto|scroll/.test(window.getComputedStyle(e).overflowY)) {
        e = e.parentElement
    }
    return e
}

/** Returns the height of a frame's content below an element, pixels. */
function below(element, frame) {
    let sum = 0
    for (let e = element; e !== frame; e = e.parentElement) {
        const bottom = e.getBoundingClientRect().bottom
        const style = window.getComputedStyle(e.parentElement)
        sum += parseFloat(style.paddingBottom) + parseFloat(style.borderBottomWidth) + parseFloat(style.marginBottom)
        for (let next = e.nextElementSibling; next; next = next.nextElementSibling) {
            const box = next.getBoundingClientRect()
            sum += box.top >= bottom - 1 ? box.height : 0
        }
    }
    return Math.min(MOST_BELOW, Math.ceil(sum))
}

/**
 * Returns the height available for an element, pixels: to the end of its frame or the window, without the content below
 * it.
 */
function roomFor(element) {
    const frame = frameOf(element)
    const end = frame === document.body
    ? window.innerHeight : Math.min(window.innerHeight, topOf(frame) + frame.clientHeight)
    return end - topOf(element) - below(element, frame)
}

/** The layout of one panel. */
export class Layout {
    constructor(panel, messages) {
        this.panel = panel
        this.messages = messages
        const folds = recallJson(FOLDS)
        this.chosen = angular.isObject(folds) ? folds : {} // by part: whether the user folded it
        this.room = null        // 'wide', 'medium' or 'narrow'
        this.crowded = false    // whether the drawers have no room for words
        this.dark = false       // the page's theme, which may differ from the browser's preference
        this.room = this.roomOf(window.innerWidth)
        panel.scope.$watch(() => this.measure())
    }

    /** Default folds: a narrow page also folds the part beside the view. */
    isFoldedAtFirst(part) {
        return this.room === 'narrow' ? part === 'world' || BELOW.indexOf(part) >= 0 : BELOW.indexOf(part) >= 0
    }

    isFolded(part) {
        return part in this.chosen ? Boolean(this.chosen[part]) : this.isFoldedAtFirst(part)
    }

    /** Folds or unfolds a part. */
    fold(part) {
        this.chosen[part] = !this.isFolded(part)
        remember(FOLDS, angular.toJson(this.chosen), this.messages, 'what is folded')
    }

    roomOf(width) {
        const room = this.room
        return width >= WIDE + (room === 'wide' ? 0 : SLACK) ? 'wide' : width >= MEDIUM
        + (room === 'narrow' ? SLACK : 0) ? 'medium' : 'narrow'
    }

    /** Measures room and height; keeps the old values while the tab is hidden. @return them */
    measure() {
        const whole = this.panel.element('workspace')
        if (!whole || !whole.clientWidth) {
            return ''
        }
        this.room = this.roomOf(whole.clientWidth)
        this.crowded = whole.clientWidth < WORDY
        const height = this.room === 'narrow' ? '' : Math.max(LEAST, roomFor(whole)) + 'px'
        if (whole.style.height !== height) {
            whole.style.height = height
        }
        this.dark = isLight(window.getComputedStyle(whole).color)
        return this.room + ' ' + this.crowded + ' ' + height + ' ' + this.dark
    }
}
