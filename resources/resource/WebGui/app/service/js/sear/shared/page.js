// SPDX-License-Identifier: Apache-2.0
// The browser's page for all panels: local storage, frames, theme.

/** Returns a stored text; null if there is none, or if the browser stores nothing. */
export function recall(key) {
    try {
        return window.localStorage.getItem(key)
    } catch (e) {
        return null
    }
}
/** Returns a stored JSON value, likewise. */
export function recallJson(key) {
    try {
        return JSON.parse(recall(key))
    } catch (e) {
        return null
    }
}
/** Stores a text. @param what name of the text, for the warning if the browser can't store it */
export function remember(key, text, messages, what) {
    try {
        window.localStorage.setItem(key, text)
    } catch (e) {
        messages.say('warn', 'this browser does not store ' + what + ': ' + e.message)
    }
}

/** Returns a function that runs another one in the next animation frame, once however often it is called. */
export function oncePerPicture(done) {
    let waiting = false
    return () => {
        if (!waiting) {
            waiting = true
            window.requestAnimationFrame(() => {
                waiting = false
                done()
            })
        }
    }
}

/** Redraws a panel when its window or the theme changes, until the panel closes. */
export function whenPageChanges($scope, draw) {
    const theme = window.matchMedia('(prefers-color-scheme: dark)')
    theme.addEventListener('change', draw)
    window.addEventListener('resize', draw)
    $scope.$on('$destroy', () => {
        theme.removeEventListener('change', draw)
        window.removeEventListener('resize', draw)
    })
}

/** Clears a canvas and returns its context, in page pixels. */
export function penOf(canvas) {
    const ratio = window.devicePixelRatio || 1
    canvas.width = canvas.clientWidth * ratio
    canvas.height = canvas.clientHeight * ratio
    const pen = canvas.getContext('2d')
    pen.scale(ratio, ratio)
    return pen
}
