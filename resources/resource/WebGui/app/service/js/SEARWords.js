// What the SEAR panel says of readings, and the files that it gives to the browser.
(function() {
    var UNITS = {Distance: ['m', 3], Compass: ['°', 1], Accelerometer: ['m/s²', 3], Gyroscope: ['rad/s', 3], Odometer: ['m', 3], IMU: ['°', 1],
        LineSensor: ['%', 1], ColorSensor: ['', 0]}
    var NO_BREAK = '\u00a0'
    var PLAIN = ['', 6]         // of a sensor that somebody has added

    /** A sensor's reading for people, with its unit and as many digits as it has sense in. */
    function readingText(sensor) {
        if (sensor.unrecorded) {
            return 'not in the record'
        }
        if (sensor.nearest !== undefined) {
            return sensor.nearest === null ? 'nothing in range' : 'nearest ' + sensor.nearest.toFixed(3) + NO_BREAK + 'm'
        }
        if (sensor.ranges) {
            var near = sensor.ranges.filter(function(metres) {
                return metres !== null
            })
            return sensor.ranges.length + ' beams, ' + (near.length ? 'nearest ' + Math.min.apply(null, near).toFixed(3) + ' m' : 'nothing in range')
        }
        if (sensor.hit === null) {
            return 'nothing within ' + Math.round(sensor.value * 1e3) / 1e3 + ' m'
        }
        if (typeof sensor.value === 'boolean') {
            return sensor.value ? 'pressed' : 'not pressed'
        }
        var values = angular.isArray(sensor.value) ? sensor.value : String(sensor.value).split(',')
        if (sensor.type === 'GPS') {
            return fixed(values[0], 7) + '°, ' + fixed(values[1], 7) + '°, ' + fixed(values[2], 2) + NO_BREAK + 'm'
        }
        var unit = Object.prototype.hasOwnProperty.call(UNITS, sensor.type) ? UNITS[sensor.type] : PLAIN
        return values.map(function(value) {
            return isNaN(value) ? value : unit === PLAIN ? String(Number(Number(value).toPrecision(PLAIN[1]))) : fixed(value, unit[1])
        }).join(', ') + (unit[0] && unit[0] !== '°' ? NO_BREAK : '') + unit[0]
    }

    /** So many digits behind the point, without the sign of a zero. */
    function fixed(value, digits) {
        var text = Number(value).toFixed(digits)
        return Number(text) === 0 ? text.replace('-', '') : text
    }

    function count(number, thing) {
        return number + ' ' + thing + (number === 1 ? '' : 's')
    }

    // ---- files -----------------------------------------------------------------------------------------------------------------------------
    function bytes(base64) {
        return Uint8Array.from(window.atob(base64), function(one) {
            return one.charCodeAt(0)
        })
    }

    /** The last part of a path. */
    function fileName(path) {
        return path.split(/[\\/]/).pop()
    }

    /** Has the browser save a file. @param parts of it, in base64 */
    function saveFile(name, parts) {
        saveBlob(name, new Blob(parts.map(bytes), {type: 'application/zip'}))
    }
    function saveText(name, text) {
        saveBlob(name, new Blob([text], {type: 'text/plain'}))
    }
    function saveBlob(name, blob) {
        var link = document.createElement('a')
        link.href = window.URL.createObjectURL(blob)
        link.download = name
        document.body.appendChild(link)
        link.click()
        document.body.removeChild(link)
        setTimeout(function() {
            window.URL.revokeObjectURL(link.href)
        }, 60000)
    }

    window.SEARPanel.words = {reading: readingText, count: count, fileName: fileName, saveFile: saveFile, saveText: saveText}
})()
