// SPDX-License-Identifier: Apache-2.0
// The SEAR panel's workspace: how it fills the window, and which parts are folded.
import {isLight} from './geometry.js'
import {recallJson, remember} from './page.js'

var FOLDS = 'sear.folds'    // local storage key of the user's folds
var WORDY = 1080            // minimum width for words beside the drawers' icons, pixels
var WIDE = 900              // minimum width for three columns
var MEDIUM = 720            // minimum width for two columns; below it, all parts are stacked and the page scrolls
var BELOW = ['project', 'plots', 'messages', 'scripts']    // parts above or below the view that are folded at first
var SLACK = 24              // hysteresis, wider than a scroll bar
var LEAST = 420             // minimum height of the columns, pixels
var MOST_BELOW = 200        // maximum height kept free for the page's content below the panel, pixels

/** Returns an element's top in the page, whatever the scroll position. */
function topOf(element) {
    var top = 0
    for (var e = element; e; e = e.offsetParent) {
        top += e.offsetTop
    }
    return top
}

/** Returns the scroll container of an element: MyRobotLab's frame around panels, or the page. */
function frameOf(element) {
    var e = element.parentElement
    while (e !== document.body && !/auto|scroll/.test(window.getComputedStyle(e).overflowY)) {
        e = e.parentElement
    }
    return e
}

/** Returns the height of a frame's content below an element, pixels. */
function below(element, frame) {
    var sum = 0
    for (var e = element; e !== frame; e = e.parentElement) {
        var bottom = e.getBoundingClientRect().bottom
        var style = window.getComputedStyle(e.parentElement)
        sum += parseFloat(style.paddingBottom) + parseFloat(style.borderBottomWidth) + parseFloat(style.marginBottom)
        for (var next = e.nextElementSibling; next; next = next.nextElementSibling) {
            var box = next.getBoundingClientRect()
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
    var frame = frameOf(element)
    var end = frame === document.body ? window.innerHeight : Math.min(window.innerHeight, topOf(frame) + frame.clientHeight)
    return end - topOf(element) - below(element, frame)
}

/** Makes the layout of one panel. */
export function makeLayout(panel, messages) {
    var folds = recallJson(FOLDS)
    var chosen = angular.isObject(folds) ? folds : {}   // by part: whether the user folded it
    var layout = {
        room: null,             // 'wide', 'medium' or 'narrow'
        crowded: false,         // whether the drawers have no room for words
        dark: false             // the page's theme, which may differ from the browser's preference
    }
    layout.room = roomOf(window.innerWidth)

    /** Default folds: a narrow page also folds the part beside the view. */
    function isFoldedAtFirst(part) {
        return layout.room === 'narrow' ? part === 'world' || BELOW.indexOf(part) >= 0 : BELOW.indexOf(part) >= 0
    }
    layout.isFolded = function(part) {
        return part in chosen ? Boolean(chosen[part]) : isFoldedAtFirst(part)
    }
    /** Folds or unfolds a part. */
    layout.fold = function(part) {
        chosen[part] = !layout.isFolded(part)
        remember(FOLDS, angular.toJson(chosen), messages, 'what is folded')
    }

    function roomOf(width) {
        var room = layout.room
        return width >= WIDE + (room === 'wide' ? 0 : SLACK) ? 'wide' : width >= MEDIUM + (room === 'narrow' ? SLACK : 0) ? 'medium' : 'narrow'
    }
    /** Measures room and height; keeps the old values while the tab is hidden. @return them */
    function measure() {
        var whole = panel.element('workspace')
        if (!whole || !whole.clientWidth) {
            return ''
        }
        layout.room = roomOf(whole.clientWidth)
        layout.crowded = whole.clientWidth < WORDY
        var height = layout.room === 'narrow' ? '' : Math.max(LEAST, roomFor(whole)) + 'px'
        if (whole.style.height !== height) {
            whole.style.height = height
        }
        layout.dark = isLight(window.getComputedStyle(whole).color)
        return layout.room + ' ' + layout.crowded + ' ' + height + ' ' + layout.dark
    }
    panel.scope.$watch(measure)
    return layout
}
