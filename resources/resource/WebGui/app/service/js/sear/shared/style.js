// The style sheet of all panels: it is in the page before the first of them shows.
var link = document.createElement('link')
link.rel = 'stylesheet'
link.href = new URL('style.css', import.meta.url)
await new Promise(function(done, fail) {
    link.onload = done
    link.onerror = function() {
        fail(new Error(link.href + ' is missing'))
    }
    document.head.appendChild(link)
})
