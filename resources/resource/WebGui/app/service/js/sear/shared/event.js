/** What happens again and again: hear(listener) has a function called each time, tell(what) calls all. */
export function makeEvent() {
    var listeners = []
    return {
        hear: function(listener) {
            listeners.push(listener)
        },
        tell: function(what) {
            listeners.forEach(function(listener) {
                listener(what)
            })
        }
    }
}
