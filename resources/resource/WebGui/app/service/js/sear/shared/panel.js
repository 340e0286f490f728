// SPDX-License-Identifier: Apache-2.0
// A panel of MyRobotLab's WebGui: its scope, its service, and the service's messages.

/** Common base of a panel's parts. */
export class Panel {
    /** @param controller MyRobotLab's @param prefix of the ids in its view @param $timeout Angular's */
    constructor(controller, $scope, prefix, $timeout) {
        this.controller = controller
        this.scope = $scope
        this.prefix = prefix
        this.timeout = $timeout
        this.msg = controller.msg
    }

    /** Returns an element of this panel's view; null if the page has none. */
    element(kind) {
        return this.scope.service ? document.getElementById(
            this.prefix + '-' + kind + '-' + this.scope.service.name) : null
    }

    isSimulating() {
        return Boolean(this.scope.service && this.scope.service.simulating)
    }

    /**
     * Makes an object's methods callable from the view.
     * @param methods their names
     */
    offer(object, methods) {
        methods.forEach(name => {
            this.scope[name] = object[name].bind(object)
        })
    }

    /**
     * Subscribes to the service.
     * @param topics subscribed topics @param asked methods called immediately, whose answers are messages
     * @param handlers by message name; each takes the data, and returns false if no digest is needed
     */
    hear(topics, asked, handlers) {
        this.controller.onMsg = inMsg => {
            const handler = Object.prototype.hasOwnProperty.call(handlers, inMsg.method) && handlers[inMsg.method]
            if (handler && handler(inMsg.data && inMsg.data[0]) !== false) {
                this.scope.$applyAsync()
            }
        }
        this.controller.updateState = handlers.onState
        topics.concat(asked).forEach(topic => this.msg.subscribe(topic))
        this.msg.subscribe(this.controller)
        asked.forEach(method => this.msg.send(method))
    }

    /**
     * Adds event listeners until the panel closes. @param listeners by event @param capture whether they run before
     * others
     */
    listen(target, listeners, capture) {
        Object.keys(listeners).forEach(event => target.addEventListener(event, listeners[event], capture))
        this.scope.$on('$destroy', () => {
            Object.keys(listeners).forEach(event => target.removeEventListener(event, listeners[event], capture))
        })
    }
}
