// SPDX-License-Identifier: Apache-2.0
/** Makes the serial port fields of a device: the service's settings; before the user connects, the user's input. */
export function makePort(panel, baud) {
    var touched = false
    var port = {path: '', baud: baud, names: []}

    port.touch = function() {
        touched = true
    }
    port.refresh = function() {
        panel.msg.send('getPortNames')
    }
    /**
     * Follows the service's settings.
     * @param wanted baud rate chosen here and not confirmed yet, if any @return whether the fields show the service's
     * settings
     */
    port.follow = function(service, wanted) {
        touched = touched && !service.connected
        var follows = Boolean(service.config) && !touched
        if (follows) {
            port.path = service.config.port || port.path
            port.baud = wanted || service.config.baud || port.baud
        }
        return follows
    }
    port.setBaud = function() {
        if (panel.scope.service.connected) {
            panel.msg.send('setBaud', Number(port.baud))
        } else {
            touched = true
        }
    }
    port.handlers = {
        onPortNames: function(names) {
            port.names = names
        }
    }
    return port
}
