// SPDX-License-Identifier: Apache-2.0
// The palette's entry of each kind of object: a word, a picture drawn by the view, and a group.

import {THINGS} from './things.js'

export const GROUPS = ['Things', 'Robots', 'Drives', 'Joints', 'Sensors', 'Boards']
const BY_KIND = {shape: 'Things', world: 'Things', sensor: 'Sensors', part: 'Drives', joint: 'Joints'}
const BOARDS = ['Arduino', 'Led']
// The pictures are tiles of one file, in this order, COLUMNS per row; ./gradlew tabScreenshots -Ppictures=palette takes
// them.
const PICTURES = new URL('../tiles/palette.png', import.meta.url)
export const COLUMNS = 8
const WORDS = {
    Box: 'Box', Cylinder: 'Cylinder', Cone: 'Cone', Sphere: 'Sphere', Terrain: 'Terrain', Floor: 'Floor',
        Model: '3D model',
    roomba400: 'Roomba 400', create: 'Create', create2: 'Create 2', rover: 'Rover', fourWheeled: 'Four wheels',
    car: 'Car', Wheel: 'Wheel',
    Motor: 'Motor', Servo: 'Servo', Dynamics: 'Mass and springs', Distance: 'Distance sensor', LIDAR: 'Laser scanner',
    GPS: 'GPS receiver',
    Compass: 'Compass', Accelerometer: 'Accelerometer', Gyroscope: 'Gyroscope', Odometer: 'Odometer',
    IMU: 'Motion unit (IMU)',
    LineSensor: 'Line sensor', ColorSensor: 'Colour sensor', Bumper: 'Bumper', Arduino: 'Arduino', Led: 'Light (LED)',
    chassis: 'Chassis',
    Camera: 'Camera', Marker: 'Marker', Chessboard: 'Chessboard', Picture: 'Picture',
    Hinge: 'Hinge', Slider: 'Slider', BallJoint: 'Ball joint', FixedJoint: 'Fixed joint', Rope: 'Rope or spring',
    ForceTorque: 'Force and torque',
    ball: 'Ball', table: 'Table', ramp: 'Ramp', coneAlley: 'Cone alley', goal: 'Goal', Gravity: 'Gravity',
    Maze: 'Maze', FloorPlan: 'Floor plan', Wall: 'Wall', ContactForce: 'Contact force'
}
// Other search words.
const ALSO = {
    Box: 'wall cube block crate obstacle', Cylinder: 'pole pillar can tube', Cone: 'pylon', Sphere: 'ball',
        Terrain: 'ground hill mountain landscape',
    Floor: 'ground plane line', Model: 'mesh stl obj', roomba400: 'vacuum cleaner irobot', create: 'irobot',
    create2: 'irobot roomba',
    rover: 'two wheels', car: 'vehicle steered', Wheel: 'caster tyre tire', Motor: 'encoder engine drive',
    Servo: 'joint arm steering',
    Dynamics: 'weight suspension', Distance: 'sonar ultrasonic ultrasound infrared range eye',
    LIDAR: 'lidar rangefinder', GPS: 'position satellite',
    Compass: 'magnetometer heading', Accelerometer: 'tilt', Gyroscope: 'gyro rotation', Odometer: 'encoder way',
    IMU: 'gyro orientation',
    LineSensor: 'infrared reflectance', ColorSensor: 'color', Bumper: 'touch contact switch',
    Arduino: 'board microcontroller', Led: 'lamp',
    chassis: 'own empty body base', Camera: 'eye picture depth infrared thermal webcam kinect',
    Marker: 'aruco apriltag tag fiducial code', Chessboard: 'calibration checkerboard pattern',
    Picture: 'image poster sign photo',
    Hinge: 'joint revolute door axle', Slider: 'joint prismatic lift rail', BallJoint: 'joint hitch trailer spherical',
    FixedJoint: 'joint weld glue', Rope: 'joint cable chain winch rod elastic',
    FloorPlan: 'map ros walls picture maze office yaml pgm', Maze: 'walls labyrinth micromouse eyesim',
    Wall: 'line fence room house',
    ForceTorque: 'joint wrench load cell scale strain', ContactForce: 'touch pressure bumper scale newton',
    ball: 'football toy', table: 'desk furniture', ramp: 'slope hill climb', coneAlley: 'slalom pylon lane',
    goal: 'football gate', Gravity: 'moon mars weightless weight acceleration world'
}
const ALSO_ROBOTS = 'robot'
export const PICTURED = Object.keys(WORDS)
// Pictures for kinds without their own, for example sensors of a plug-in.
const OTHER = {Things: 'Box', Robots: 'rover', Drives: 'Motor', Sensors: 'Distance', Boards: 'Arduino', Joints: 'Hinge'}

/** Returns the CSS style that shows the picture of a kind. */
function styleOf(name) {
    const i = PICTURED.indexOf(name)
    const rows = Math.ceil(PICTURED.length / COLUMNS)
    return {'background-image': 'url("' + PICTURES + '")', 'background-size': COLUMNS * 100 + '% ' + rows * 100 + '%',
        'background-position': i % COLUMNS / (COLUMNS - 1) * 100 + '% ' + Math.floor(i / COLUMNS) / (rows - 1)
            * 100 + '%'}
}
/** Splits a camel-case name into words, for kinds not listed here: thermalGrid becomes "Thermal grid". */
function words(name) {
    const apart = name.replace(/([a-z0-9])([A-Z])/g, '$1 $2')
    return apart.charAt(0).toUpperCase() + apart.slice(1).replace(/ [A-Z](?=[a-z])/g, start => start.toLowerCase())
}
function kind(name, group, more) {
    return Object.assign({make: name, group, word: WORDS[name] || words(name),
        style: styleOf(WORDS[name] ? name : OTHER[group]),
        sought: [WORDS[name] || words(name), name, ALSO[name] || '', group === 'Robots' ? ALSO_ROBOTS : ''].join(' ')
            .toLowerCase()}, more)
}

/** Returns the entry of a type of the grammar. */
export function ofType(type) {
    return kind(type.type, BOARDS.indexOf(type.type) < 0 ? BY_KIND[type.kind] : 'Boards', {type, doc: type.doc})
}
/** Returns the entry of a whole robot. */
export function ofTemplate(name) {
    return kind(name, 'Robots', {template: name, doc: name === 'chassis' ? 'an empty body for your own robot: add '
        + 'wheels and motors'
        : 'a complete robot that drives'})
}
/** Returns the entry of a thing of several objects. */
export function ofThing(name) {
    return kind(name, 'Things', {template: name, doc: THINGS[name].doc})
}
