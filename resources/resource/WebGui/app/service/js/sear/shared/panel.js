// A panel of MyRobotLab's WebGui: its scope, its service, and the messages that come from there.

/**
 * Makes what all parts of a panel need.
 * @param controller that MyRobotLab has made @param prefix of the ids in its view @param $timeout Angular's
 */
export function makePanel(controller, $scope, prefix, $timeout) {
    return {
        scope: $scope,
        msg: controller.msg,
        timeout: $timeout,
        /** An element of this panel's view; null while the page has none. */
        element: kind => $scope.service ? document.getElementById(prefix + '-' + kind + '-' + $scope.service.name) : null,
        isSimulating: () => Boolean($scope.service && $scope.service.simulating),
        /**
         * Has a panel hear its service.
         * @param topics that it wants to hear of @param asked methods whose answers come as messages and which are asked at once
         * @param handlers by the name of a message; each takes what came, and says by false that nothing else has to be shown anew
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
