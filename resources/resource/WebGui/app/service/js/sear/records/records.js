// Writing what happens in a run into a file, and which of these files there are.
import {makeEvent} from '../shared/event.js'

var MEGABYTES = 512         // at which a record ends by itself
var PICTURES = 5            // of each camera a simulated second

/** Of one panel. */
export function makeRecords(panel, messages) {
    var msg = panel.msg
    var records = {
        path: 'run.searlog',    // of the next one
        pictures: false,        // whether it keeps those of cameras
        list: [],
        ended: makeEvent()      // one has ended
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
            messages.say('info', 'recording ' + (panel.isSimulating() ? '' : 'the next run ') + 'into ' + path)
        },
        onEndRecord: function(seconds) {
            messages.say('info', 'recorded ' + Number(seconds).toFixed(2) + ' s')
            records.ended.tell()
            msg.send('getRecords')
        }
    }
    return records
}
