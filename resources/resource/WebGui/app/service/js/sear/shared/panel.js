// SPDX-License-Identifier: Apache-2.0
// A panel of MyRobotLab's WebGui: its scope, its service, and the service's messages.

/**
 * Makes the common base of a panel's parts.
 * @param controller MyRobotLab's @param prefix of the ids in its view @param $timeout Angular's
 */
export function makePanel(controller, $scope, prefix, $timeout) {
    return {
        scope: $scope,
        msg: controller.msg,
        timeout: $timeout,
        /** Returns an element of this panel's view; null if the page has none. */
        element: kind => $scope.service ? document.getElementById(prefix + '-' + kind + '-' + $scope.service.name) : null,
        isSimulating: () => Boolean($scope.service && $scope.service.simulating),
        /**
         * Subscribes to the service.
         * @param topics subscribed topics @param asked methods called immediately, whose answers are messages
         * @param handlers by message name; each takes the data, and returns false if no digest is needed
         */
        hear: function(topics, asked, handlers) {
            controller.onMsg = function(inMsg) {
                var handler = Object.prototype.hasOwnProperty.call(handlers, inMsg.method) && handlers[inMsg.method]
                if (handler && handler(inMsg.data && inMsg.data[0]) !== false) {
                    $scope.$applyAsync()
                }
            }
            controller.updateState = handlers.onState
            topics.concat(asked).forEach(function(topic) {
                controller.msg.subscribe(topic)
            })
            controller.msg.subscribe(controller)
            asked.forEach(function(method) {
                controller.msg.send(method)
            })
        }
    }
}
