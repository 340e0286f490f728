// SPDX-License-Identifier: Apache-2.0
// Readings at one moment of a record, in the form of the running world.
/**
 * Returns the sensors with their readings at a frame.
 * @param sensors of the shown world @param record its frames @param index of the frame
 */
export function sensorsAt(sensors, record, index) {
    return sensors.map(sensor => {
        const place = record.sensors.indexOf(sensor.name)
        return {name: sensor.name, type: sensor.type, robot: sensor.robot, eye: sensor.eye,
            words: place >= 0 && record.words[index][place] || 'not in the record'}
    })
}

/** Sets the robots' poses, speeds, paths and lights as at a frame. @param robots by name */
export function robotsAt(robots, record, index) {
    record.robots.forEach((name, i) => {
        if (robots[name]) {
            robots[name].pose = record.robotPoses[index][i]
            robots[name].speed = record.speeds[index][i][0]
            robots[name].turnRate = record.speeds[index][i][1]
            robots[name].path = record.robotPoses.slice(0, index + 1).map(poses => [poses[i][0], poses[i][2]])
        }
    })
    record.lights.forEach((light, i) => {
        const robot = robots[record.robots[light[0]]]
        if (robot && robot.lights) {
            robot.lights[light[1]] = record.brightness[index][i]
        }
    })
}
