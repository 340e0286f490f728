// SPDX-License-Identifier: Apache-2.0
/** The serial port fields of a device: the service's settings; before the user connects, the user's input. */
export class Port {
    constructor(panel, baud) {
        this.panel = panel
        this.touched = false
        this.path = ''
        this.baud = baud
        this.names = []
        this.handlers = {
            onPortNames: names => {
                this.names = names
            }
        }
    }

    touch() {
        this.touched = true
    }

    refresh() {
        this.panel.msg.send('getPortNames')
    }

    /**
     * Follows the service's settings.
     * @param wanted baud rate chosen here and not confirmed yet, if any @return whether the fields show the service's
     * settings
     */
    follow(service, wanted) {
        this.touched = this.touched && !service.connected
        const follows = Boolean(service.config) && !this.touched
        if (follows) {
            this.path = service.config.port || this.path
            this.baud = wanted || service.config.baud || this.baud
        }
        return follows
    }

    setBaud() {
        if (this.panel.scope.service.connected) {
            this.panel.msg.send('setBaud', Number(this.baud))
        } else {
            this.touched = true
        }
    }
}
