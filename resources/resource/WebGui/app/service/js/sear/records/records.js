// SPDX-License-Identifier: Apache-2.0
// Recording runs into files, and the list of these files.
import {Listeners} from '../shared/listeners.js'

const MEGABYTES = 512         // size limit of a record
const PICTURES = 5            // pictures per camera and simulated second

/** The recording controls of one panel. */
export class Records {
    constructor(panel, messages) {
        this.panel = panel
        this.msg = panel.msg
        this.path = 'run.searlog' // path of the next record
        this.pictures = false   // whether it contains camera pictures
        this.list = []
        this.ended = new Listeners() // a record has ended
        this.handlers = {
            onRecords: paths => {
                this.list = paths || []
            },
            onRecordRun: path => {
                messages.say('info', 'recording ' + (panel.isSimulating() ? '' : 'the next run ') + 'to ' + path)
            },
            onEndRecord: seconds => {
                messages.say('info', 'recorded ' + Number(seconds).toFixed(2) + ' s')
                this.ended.tell()
                this.msg.send('getRecords')
            }
        }
    }

    toggle() {
        if (this.panel.scope.service.recorded) {
            this.msg.send('endRecord')
        } else {
            if (this.pictures) {
                this.msg.send('recordRun', this.path, MEGABYTES, PICTURES)
            } else {
                this.msg.send('recordRun', this.path)
            }
        }
    }
}
