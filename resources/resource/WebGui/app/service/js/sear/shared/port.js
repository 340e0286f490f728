/** The serial port of a device as its fields show it: what the service is set to; until the user connects, what the user has typed. */
export function makePort(panel, baud) {
    var touched = false
    var port = {path: '', baud: baud, names: []}

    port.touch = function() {
        touched = true
    }
    port.refresh = function() {
        panel.msg.send('getPortNames')
    }
    /** @param wanted the baud rate that was chosen here and is not settled yet, if there is one @return whether the fields show the service's */
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
