// The browser's page, as all panels use it: its memory, its pictures, its theme.

/** What the page has remembered; null if nothing, or if the browser remembers nothing. */
export function recall(key) {
    try {
        return window.localStorage.getItem(key)
    } catch (e) {
        return null
    }
}
/** The same of what was remembered as JSON. */
export function recallJson(key) {
    try {
        return JSON.parse(recall(key))
    } catch (e) {
        return null
    }
}
/** @param what it is, for the warning if the browser remembers nothing */
export function remember(key, text, messages, what) {
    try {
        window.localStorage.setItem(key, text)
    } catch (e) {
        messages.say('warn', 'this browser does not remember ' + what + ': ' + e.message)
    }
}

/** A function that has something done with the browser's next picture, however often it is called until then. */
export function oncePerPicture(done) {
    var waiting = false
    return function() {
        if (!waiting) {
            waiting = true
            window.requestAnimationFrame(function() {
                waiting = false
                done()
            })
        }
    }
}

/** Has a panel drawn again when its window or the theme changes, until the panel goes. */
export function whenPageChanges($scope, draw) {
    var theme = window.matchMedia('(prefers-color-scheme: dark)')
    theme.addEventListener('change', draw)
    window.addEventListener('resize', draw)
    $scope.$on('$destroy', function() {
        theme.removeEventListener('change', draw)
        window.removeEventListener('resize', draw)
    })
}

/** Empties a canvas and gives its pen, whose units are the page's pixels. */
export function penOf(canvas) {
    var ratio = window.devicePixelRatio || 1
    canvas.width = canvas.clientWidth * ratio
    canvas.height = canvas.clientHeight * ratio
    var pen = canvas.getContext('2d')
    pen.scale(ratio, ratio)
    return pen
}
