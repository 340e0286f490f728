// Drives a robot and reads its sensors through an Arduino with StandardFirmata, with johnny-five, which is made for real ones.
//
// usage: NODE_PATH=... node johnny_five_drive.js TCP_PORT SECONDS
//
// Pins 9 and 10 are the motors' power, 7 and 8 their direction, A0 is a Sharp sensor, 4 a PING))). Prints the board's program and pins, the Sharp
// sensor's value and the centimetres of the echo, after a second of driving "drove"; then it turns the robot in place, tells each second how many
// values of A0 came and the least and greatest of them, and after SECONDS of this "done".
const net = require('net')
const {Firmata} = require('firmata-io')
const five = require('johnny-five')

const [port, seconds] = process.argv.slice(2).map(Number)
const socket = net.connect(port, '127.0.0.1')
socket.on('connect', () => socket.emit('open')) // as a serial port of node says it
const patience = 60000 // milliseconds: johnny-five gives up after 10 s, which a busy computer may need
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

// A sensor tells every 50 ms what it has, which is nothing before the board has answered.
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
