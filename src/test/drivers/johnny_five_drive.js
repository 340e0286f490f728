// Drives a robot and reads its sensors through an Arduino with StandardFirmata, with johnny-five, a library for real
// ones.
//
// usage: NODE_PATH=... node johnny_five_drive.js TCP_PORT SECONDS
//
// Pins 9 and 10 are the motors' power, 7 and 8 their direction, A0 is a Sharp sensor, 4 a PING))). Prints the board's
// program and pins, the Sharp sensor's value, the echo in centimetres, and "drove" after a second of driving. Then
// turns in place and prints the number, minimum and maximum of A0's values each second, and "done" after SECONDS.
const net = require('net')
const {Firmata} = require('firmata-io')
const five = require('johnny-five')

const [port, seconds] = process.argv.slice(2).map(Number)
const socket = net.connect(port, '127.0.0.1')
socket.on('connect', () => socket.emit('open')) // like a serial port of node
const patience = 60000 // milliseconds: johnny-five's 10 s are too short for a busy computer
const io = new Firmata(socket, {reportVersionTimeout: patience})
const board = new five.Board({io, repl: false, debug: false, timeout: patience})

board.on('ready', () => {
  console.log(io.firmware.name + ', ' + io.pins.length + ' pins')
  const sharp = new five.Sensor({pin: 'A0', freq: 50})
  onceItHas(sharp, () => sharp.value, value => {
    console.log(value)
    const ping = new five.Proximity({controller: 'HCSR04', pin: 4})
    onceItHas(ping, () => ping.cm, centimetres => {
      console.log(centimetres)
      drive()
    })
  })
})

// A sensor reports every 50 ms, without a value until the board has answered.
function onceItHas(sensor, read, then) {
  sensor.on('data', function told() {
    if (read()) {
      sensor.removeListener('data', told)
      then(read())
    }
  })
}

function drive() {
  const [left, right] = [[9, 7], [10, 8]].map(pins => new five.Motor(pins))
  left.forward(128)
  right.forward(128)
  setTimeout(() => {
    console.log('drove')
    left.forward(128)
    right.reverse(128)
    const values = []
    let second = 0
    io.on('analog-read-0', value => values.push(value))
    const timer = setInterval(() => {
      console.log([++second, 's', values.length, Math.min(...values), Math.max(...values)].join(' '))
      values.length = 0
      if (second >= seconds) {
        clearInterval(timer)
        left.stop()
        right.stop()
        console.log('done')
        socket.end(() => process.exit(0))
      }
    }, 1000)
  }, 1000)
}
