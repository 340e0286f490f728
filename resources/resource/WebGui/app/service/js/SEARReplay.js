// What was read at one moment of a record, in the form in which the world tells it while it runs.
(function() {
    var SAME = 1e-6             // metres

    /** @param numbers of the sensor's reading, null for none; @param sensor as the world that is shown has it */
    function readingOf(sensor, numbers) {
        if (!numbers || !numbers.length) {
            return {unrecorded: true}
        }
        if (sensor.ranges) {
            return {nearest: numbers[0]}
        }
        if (typeof sensor.value === 'boolean') {
            return {value: numbers[0] === 1}
        }
        var values = numbers.map(function(number) {
            return number === null ? NaN : number
        })
        var farthest = Math.max.apply(null, (sensor.cones || []).map(function(cone) {
            return cone.range
        }))
        return {value: values.length === 1 ? values[0] : values, hit: Math.abs(values[0] - farthest) < SAME ? null : undefined}
    }

    /**
     * The sensors with what they read then.
     * @param sensors of the world that is shown; @param record its frames; @param index of one of them
     */
    function sensorsAt(sensors, record, index) {
        var numbers = {}
        var at = 0
        record.sensors.forEach(function(name, i) {
            numbers[name] = record.readings[index].slice(at, at + record.sizes[i])
            at += record.sizes[i]
        })
        return sensors.map(function(sensor) {
            return angular.extend({name: sensor.name, type: sensor.type, robot: sensor.robot}, readingOf(sensor, numbers[sensor.name]))
        })
    }

    /** Has the robots of a world drive and shine as they did then. @param robots by name */
    function robotsAt(robots, record, index) {
        record.robots.forEach(function(name, i) {
            if (robots[name]) {
                robots[name].pose = record.robotPoses[index][i]
                robots[name].speed = record.speeds[index][i][0]
                robots[name].turnRate = record.speeds[index][i][1]
                robots[name].path = record.robotPoses.slice(0, index + 1).map(function(poses) {
                    return [poses[i][0], poses[i][2]]
                })
            }
        })
        record.lights.forEach(function(light, i) {
            var robot = robots[record.robots[light[0]]]
            if (robot && robot.lights) {
                robot.lights[light[1]] = record.brightness[index][i]
            }
        })
    }

    window.SEARPanel = window.SEARPanel || {}
    window.SEARPanel.replay = {sensorsAt: sensorsAt, robotsAt: robotsAt}
})()
