// SPDX-License-Identifier: Apache-2.0
// Service calls of a robot that the user drives with keys, buttons or a gamepad, depending on its steering.
const RADIUS = 0.3            // metres: narrowest arc of a differential drive while it drives on

function angle(steered, left) {
    return left === 0 ? steered.straight : steered.straight
        + Math.abs(left) * ((left > 0 ? steered.left : steered.right) - steered.straight)
}
/** Whether nothing can steer the robot. */
export function isFixed(robot) {
    return !robot.steered && !robot.turns
}

/**
 * Returns each call as its method and arguments.
 * @param way forward and left, -1 to 1 @param most m/s at 1
 */
export function drive(robot, way, most) {
    const speed = way[0] * most
    const straight = ['driveStraight', robot.name, speed]
    if (robot.steered) {
        const degrees = angle(robot.steered, way[1])
        return [robot.steered.servo ? ['setServo', robot.steered.servo, degrees] : ['setSteering', robot.name,
            degrees], straight]
    }
    if (way[1] === 0 || isFixed(robot)) {
        return [straight]
    }
    return [speed === 0 ? ['drive', robot.name, way[1] * most, 0] : ['drive', robot.name, speed, RADIUS / way[1]]]
}
