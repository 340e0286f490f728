// Scans as the Java class Ranges tells them: 16 bits a beam.
var NOTHING = 65535         // a beam that met nothing
var TENTHS = 10000          // of millimetres in a metre

/** @return metres of each beam, null where nothing was met */
export function rangesOf(text) {
    var bytes = window.atob(text)
    var unit = numberAt(bytes, 0) / TENTHS
    var ranges = new Array(bytes.length / 2 - 1)
    for (var i = 0; i < ranges.length; i++) {
        var number = numberAt(bytes, i + 1)
        ranges[i] = number === NOTHING ? null : number * unit
    }
    return ranges
}
function numberAt(bytes, at) {
    return bytes.charCodeAt(2 * at) + 256 * bytes.charCodeAt(2 * at + 1)
}

/** Has the sensors of a list or of changes their ranges as numbers. */
export function unpackRanges(sensors) {
    angular.forEach(sensors, function(sensor) {
        if (typeof sensor.ranges === 'string') {
            sensor.ranges = rangesOf(sensor.ranges)
        }
    })
}
