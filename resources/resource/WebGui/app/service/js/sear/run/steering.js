// What the SEAR panel tells a robot that somebody drives by keys, buttons or a gamepad: calls of the service, by how the robot is steered.
var RADIUS = 0.3            // metres of the narrowest arc of a robot that turns by its two sides, while it drives on

function angle(steered, left) {
    return left === 0 ? steered.straight : steered.straight + Math.abs(left) * ((left > 0 ? steered.left : steered.right) - steered.straight)
}
/** Whether nothing turns it. */
export function isFixed(robot) {
    return !robot.steered && !robot.turns
}

/**
 * The method and what it is given, of each call.
 * @param way how far forward and to the left, -1 to 1; @param most m/s at 1
 */
export function drive(robot, way, most) {
    var speed = way[0] * most
    var straight = ['driveStraight', robot.name, speed]
    if (robot.steered) {
        var degrees = angle(robot.steered, way[1])
        return [robot.steered.servo ? ['setServo', robot.steered.servo, degrees] : ['setSteering', robot.name, degrees], straight]
    }
    if (way[1] === 0 || isFixed(robot)) {
        return [straight]
    }
    return [speed === 0 ? ['drive', robot.name, way[1] * most, 0] : ['drive', robot.name, speed, RADIUS / way[1]]]
}
