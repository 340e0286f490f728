// SPDX-License-Identifier: Apache-2.0
// Recording runs into files, and the list of these files.
import {makeEvent} from '../shared/event.js'

var MEGABYTES = 512         // size limit of a record
var PICTURES = 5            // pictures per camera and simulated second

/** Makes the recording controls of one panel. */
export function makeRecords(panel, messages) {
    var msg = panel.msg
    var records = {
        path: 'run.searlog',    // path of the next record
        pictures: false,        // whether it contains camera pictures
        list: [],
        ended: makeEvent()      // a record has ended
    }
    records.toggle = function() {
        if (panel.scope.service.recorded) {
            msg.send('endRecord')
        } else {
            if (records.pictures) {
                msg.send('recordRun', records.path, MEGABYTES, PICTURES)
            } else {
                msg.send('recordRun', records.path)
            }
        }
    }
    records.handlers = {
        onRecords: function(paths) {
            records.list = paths || []
        },
        onRecordRun: function(path) {
            messages.say('info', 'recording ' + (panel.isSimulating() ? '' : 'the next run ') + 'to ' + path)
        },
        onEndRecord: function(seconds) {
            messages.say('info', 'recorded ' + Number(seconds).toFixed(2) + ' s')
            records.ended.tell()
            msg.send('getRecords')
        }
    }
    return records
}
