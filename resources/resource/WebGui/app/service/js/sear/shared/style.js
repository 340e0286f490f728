// SPDX-License-Identifier: Apache-2.0
// Style sheet of all panels, loaded before the first panel shows.
const link = document.createElement('link')
link.rel = 'stylesheet'
link.href = new URL('style.css', import.meta.url)
await new Promise((done, fail) => {
    link.onload = done
    link.onerror = function() {
        fail(new Error(link.href + ' is missing'))
    }
    document.head.appendChild(link)
})
