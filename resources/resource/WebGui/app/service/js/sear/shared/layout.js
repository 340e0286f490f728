// The workspace of the SEAR panel: how it fills the window, and which of its parts are folded.
import {isLight} from './geometry.js'
import {recallJson, remember} from './page.js'

var FOLDS = 'sear.folds'    // where the browser remembers what its user has folded and opened
var WORDY = 1080            // pixels from which on the drawers have words beside their icons
var WIDE = 900              // and from which on there are three columns
var MEDIUM = 720            // and two; below, all stands below each other, and the page scrolls
var BELOW = ['project', 'plots', 'messages', 'scripts']    // what stands above or below the view, and what nobody needs at first
var SLACK = 24              // more than a scroll bar that comes or goes
var LEAST = 420             // pixels of height that the columns need
var MOST_BELOW = 200        // pixels that are kept free for what the page has below the panel

/** Where an element begins in the page, wherever that is scrolled to. */
function topOf(element) {
    var top = 0
    for (var e = element; e; e = e.offsetParent) {
        top += e.offsetTop
    }
    return top
}

/** What an element scrolls in: MyRobotLab's own frame around panels, or the page. */
function frameOf(element) {
    var e = element.parentElement
    while (e !== document.body && !/auto|scroll/.test(window.getComputedStyle(e).overflowY)) {
        e = e.parentElement
    }
    return e
}

/** Pixels of what a frame has below an element. */
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

/** Pixels from where an element begins to where its frame, or the window, ends, without what stands below it. */
function roomFor(element) {
    var frame = frameOf(element)
    var end = frame === document.body ? window.innerHeight : Math.min(window.innerHeight, topOf(frame) + frame.clientHeight)
    return end - topOf(element) - below(element, frame)
}

/** Of one panel. */
export function makeLayout(panel, messages) {
    var folds = recallJson(FOLDS)
    var chosen = angular.isObject(folds) ? folds : {}   // by the name of a part: whether its user has folded it
    var layout = {
        room: null,             // 'wide', 'medium' or 'narrow'
        crowded: false,         // whether there is no room for the drawers' words
        dark: false             // the page: it may be light where its user prefers dark ones
    }
    layout.room = roomOf(window.innerWidth)

    /** As long as nobody has chosen: the view has what a narrow page has, and on others what stands beside it. */
    function isFoldedAtFirst(part) {
        return layout.room === 'narrow' ? part === 'world' || BELOW.indexOf(part) >= 0 : BELOW.indexOf(part) >= 0
    }
    layout.isFolded = function(part) {
        return part in chosen ? Boolean(chosen[part]) : isFoldedAtFirst(part)
    }
    /** Folds a part, or opens it. */
    layout.fold = function(part) {
        chosen[part] = !layout.isFolded(part)
        remember(FOLDS, angular.toJson(chosen), messages, 'what is folded')
    }

    function roomOf(width) {
        var room = layout.room
        return width >= WIDE + (room === 'wide' ? 0 : SLACK) ? 'wide' : width >= MEDIUM + (room === 'narrow' ? SLACK : 0) ? 'medium' : 'narrow'
    }
    /** Takes the room and the height that there are now; those of before while the tab is not shown. @return them */
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
