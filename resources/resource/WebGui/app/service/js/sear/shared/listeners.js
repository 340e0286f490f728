// SPDX-License-Identifier: Apache-2.0
/** Listeners to one event of a part. */
export class Listeners {
    constructor() {
        this.listeners = []
    }

    /** Adds a listener, a function. */
    hear(listener) {
        this.listeners.push(listener)
    }

    /** Calls all listeners. @param what their argument */
    tell(what) {
        this.listeners.forEach(listener => listener(what))
    }
}
