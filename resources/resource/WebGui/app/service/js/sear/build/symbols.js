// What stands for each kind of thing in the palette: a word, a little drawing (an SVG path in 24 x 24, drawn as a line), and the group that it is in.

export var GROUPS = ['Things', 'Robots', 'Drives', 'Sensors', 'Boards']
var BY_KIND = {shape: 'Things', sensor: 'Sensors', part: 'Drives'}
var ROBOT = 'M4 8h16v8H4zM7 16v3M17 16v3M12 8V4M10 4h4'
var OTHER = {Things: 'M4 4h16v16H4z', Sensors: 'M5 12a7 7 0 0 1 14 0M9 12a3 3 0 0 1 6 0M12 12v7', Drives: 'M12 4a8 8 0 1 0 .1 0M12 9a3 3 0 1 0 .1 0'}
var ROUND = 'M12 4a8 8 0 1 0 .1 0M12 7v4M8 12a4 4 0 0 0 8 0'
// By name: its word; its drawing; its group, if that does not follow from its kind.
var SYMBOLS = {
    Box: ['Box', 'M4 8l8-4 8 4v8l-8 4-8-4zM4 8l8 4 8-4M12 12v8'],
    Cylinder: ['Cylinder', 'M5 6c0-3 14-3 14 0v12c0 3-14 3-14 0zM5 6c0 3 14 3 14 0'],
    Cone: ['Cone', 'M12 3L5 18c0 3 14 3 14 0z'],
    Sphere: ['Sphere', 'M12 4a8 8 0 1 0 .1 0M4 12c0 3 16 3 16 0'],
    Terrain: ['Terrain', 'M2 19l6-10 4 6 3-4 7 8z'],
    Floor: ['Floor', 'M2 15l10-5 10 5-10 5z'],
    Model: ['3D model', 'M12 3l7 6-3 10H8L5 9zM12 3v16M5 9h14'],
    roomba400: ['Roomba 400', ROUND],
    create: ['Create', ROUND],
    create2: ['Create 2', ROUND],
    rover: ['Rover', 'M5 8h14v7H5zM8 18a2 2 0 1 0 .1 0M16 18a2 2 0 1 0 .1 0'],
    fourWheeled: ['Four wheels', 'M7 6h10v12H7zM4 6v4M20 6v4M4 14v4M20 14v4'],
    car: ['Car', 'M3 15v-4l3-1 3-4h6l3 4 3 1v4zM7 17a2 2 0 1 0 .1 0M17 17a2 2 0 1 0 .1 0'],
    Wheel: ['Wheel', 'M12 4a8 8 0 1 0 .1 0M12 10a2 2 0 1 0 .1 0M12 4v6M12 14v6M4 12h6M14 12h6'],
    Motor: ['Motor', 'M4 8h12v8H4zM16 11h5v2h-5M7 8V6M7 16v2'],
    Servo: ['Servo', 'M4 10h12v9H4zM8 10V7M8 7l11-3'],
    Dynamics: ['Mass and springs', 'M7 4h10M12 4v2l-4 2 8 3-8 3 8 3-4 2v1M7 20h10'],
    Distance: ['Distance sensor', 'M3 12h3M6 9v6M9 8c3 2 3 6 0 8M13 6c4 3 4 9 0 12M17 4c5 5 5 11 0 16'],
    LIDAR: ['Laser scanner', 'M12 19l-9-7M12 19L7 6M12 19V3M12 19l5-13M12 19l9-7M9 19h6'],
    GPS: ['GPS receiver', 'M12 21C5 13 6 10 6 9a6 6 0 0 1 12 0c0 1 1 4-6 12zM12 7a2 2 0 1 0 .1 0'],
    Compass: ['Compass', 'M12 3a9 9 0 1 0 .1 0M12 6l3 6-3 6-3-6zM9 12h6'],
    Accelerometer: ['Accelerometer', 'M4 20V5M2 7l2-3 2 3M4 20h16M18 18l3 2-3 2M4 20l9-9M10 11h3v3'],
    Gyroscope: ['Gyroscope', 'M12 4a8 8 0 1 0 .1 0M12 3v18M4 12c0-4 16-4 16 0s-16 4-16 0'],
    Odometer: ['Odometer', 'M3 17h18M5 17v-4M9 17v-2M13 17v-4M17 17v-2M5 9h12M15 6l3 3-3 3'],
    IMU: ['Motion unit (IMU)', 'M6 6h12v12H6zM9 9h6v6H9zM9 6V3M15 6V3M9 21v-3M15 21v-3'],
    LineSensor: ['Line sensor', 'M7 3h10v6H7zM10 9l-2 6M14 9l2 6M3 19h18'],
    ColorSensor: ['Colour sensor', 'M9 4a5 5 0 1 0 .1 0M15 4a5 5 0 1 0 .1 0M12 10a5 5 0 1 0 .1 0'],
    Camera: ['Camera', 'M3 8h4l2-3h6l2 3h4v11H3zM12 10a3.5 3.5 0 1 0 .1 0'],
    Bumper: ['Bumper', 'M5 18c0-14 14-14 14 0M8 18c0-8 8-8 8 0'],
    Arduino: ['Arduino', 'M3 6h18v12H3zM6 6V4M9 6V4M12 6V4M15 6V4M6 18v2M9 18v2M12 18v2M15 18v2M8 10h6v4H8z', 'Boards'],
    Led: ['Light (LED)', 'M8 12V9a4 4 0 0 1 8 0v3zM6 12h12M10 12v8M14 12v8', 'Boards']
}

/** Words of a name in camel case, for what has no symbol of its own: thermalGrid is "Thermal grid". */
function words(name) {
    var apart = name.replace(/([a-z0-9])([A-Z])/g, '$1 $2')
    return apart.charAt(0).toUpperCase() + apart.slice(1).replace(/ [A-Z](?=[a-z])/g, start => start.toLowerCase())
}

/** Of a type of the grammar. */
export function ofType(type) {
    var symbol = SYMBOLS[type.type] || [words(type.type)]
    var group = symbol[2] || BY_KIND[type.kind]
    return {make: type.type, type: type, word: symbol[0], path: symbol[1] || OTHER[group], group: group, doc: type.doc}
}
/** Of a whole robot. */
export function ofTemplate(name) {
    var symbol = SYMBOLS[name] || [words(name), ROBOT]
    return {make: name, template: name, word: symbol[0], path: symbol[1], group: 'Robots', doc: 'a whole robot that drives'}
}
