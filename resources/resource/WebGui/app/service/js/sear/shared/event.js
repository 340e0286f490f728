// SPDX-License-Identifier: Apache-2.0
/** Makes an event: hear(listener) adds a listener, tell(what) calls all of them. */
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
