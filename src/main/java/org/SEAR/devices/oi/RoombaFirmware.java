// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.oi;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.RobotHardware;
import org.SEAR.devices.SerialDevice;
import org.SEAR.protocol.Uart;

/**
 * Firmware of a Roomba 400, Create or Create 2: commands in, sensor packets out. A beat of 15 ms drives streams,
 * scripts, safety and battery. A command that the present mode does not accept is consumed with its arguments. Sources:
 * see {@link OiModel}.
 */
public final class RoombaFirmware implements SerialDevice, CommandReader.Listener {
    /** Period of sensor updates, seconds. */
    public static final double BEAT = 0.015;
    /** Baud rates of command 129, by its argument. */
    private static final int[] BAUDS = {300, 600, 1200, 2400, 4800, 9600, 14400, 19200, 28800, 38400, 57600, 115200};
    /** Time in passive mode without a command after which a Create 2 sleeps, seconds. */
    private static final double SLEEP_AFTER = 300;
    private static final int WALL_SIGNAL_MAX = 1023;
    private static final int WALL_SIGNAL_MAX_CREATE = 4095;
    private static final byte[] BOOT = "bl-start\r\nRoomba by iRobot!\r\n".getBytes(StandardCharsets.US_ASCII);

    private final OiModel model;
    private final int powerOnBaud;
    private final boolean headerSummed;
    private final DeviceContext context;
    private final RobotHardware hardware;
    private final ProximitySensors proximity;
    private final CommandReader reader;
    private SensorPackets packets;
    private CreateScript script;
    private Drive drive;
    private Battery battery;
    private Songs songs;
    private Stream stream;
    private Lights lights;
    private OiMode mode;
    private boolean asleep;
    private int baud;
    private int nextBaud;
    private double switchAt;
    private int buttons;
    private long beats;
    private double lastCommand;

    /**
     * @param baud baud rate at power-on, bits per second
     * @param headerSummed whether the checksum of a stream covers its header byte
     */
    public RoombaFirmware(OiModel model, int baud, boolean headerSummed, DeviceContext context) {
        this.model = model;
        this.powerOnBaud = baud;
        this.headerSummed = headerSummed;
        this.context = context;
        this.hardware = context.robot();
        this.proximity = new ProximitySensors(hardware, model == OiModel.CREATE2 ? WALL_SIGNAL_MAX
            : WALL_SIGNAL_MAX_CREATE);
        this.reader = new CommandReader(model, this);
        reset();
    }

    @Override
    public void reset() {
        battery = new Battery();
        beats = 0;
        lastCommand = 0;
        boot(powerOnBaud);
    }

    @Override
    public void powerOff() {
        enter(OiMode.OFF);
    }

    /** Boots as after command 7, which is equivalent to reinserting the battery. */
    @Override
    public void powerOn(double time) {
        beats = (long) Math.floor(time / BEAT);
        lastCommand = time;
        boot(powerOnBaud);
        greet(time);
    }

    private void greet(double time) {
        if (model == OiModel.CREATE2) {
            context.send(BOOT, time);
        }
    }

    private void boot(int speed) {
        proximity.reset();
        packets = new SensorPackets(this, model, hardware, proximity);
        packets.clearCounters();
        script = new CreateScript(this);
        drive = new Drive(hardware);
        songs = new Songs(model.getSongs());
        stream = new Stream(headerSummed);
        lights = new Lights();
        mode = OiMode.OFF;
        asleep = false;
        baud = speed;
        nextBaud = 0;
        buttons = 0;
        reader.clear();
    }

    @Override
    public int getBaud() {
        return baud;
    }

    @Override
    public void receive(int value, double time) {
        advance(time);
        if (!script.isBusy()) {
            reader.accept(value, time);
        }
    }

    @Override
    public void receiveGarbage(double time) {
        advance(time);
        reader.clear();
    }

    @Override
    public void advance(double time) {
        while ((beats + 1) * BEAT <= time) {
            beats++;
            switchBaud(beats * BEAT);
            beat(beats * BEAT);
        }
        switchBaud(time);
    }

    private void switchBaud(double time) {
        if (nextBaud != 0 && time >= switchAt) {
            baud = nextBaud;
            nextBaud = 0;
        }
    }

    private void beat(double time) {
        double wheels = drive.isMoving() ? (hardware.getLeftLoad() + hardware.getRightLoad())
            * Battery.STALLED_WHEEL : 0;
        battery.drain(asleep ? Battery.ASLEEP : Battery.IDLE + wheels, BEAT);
        String danger = mode == OiMode.SAFE ? danger() : null;
        if (danger != null) {
            enter(OiMode.PASSIVE);
            drive.brake();
            context.warn(danger, danger + ": the robot left safe mode and stopped; send safe or full mode again when "
                + "its wheels are on the ground");
        }
        if (model == OiModel.CREATE2 && mode == OiMode.PASSIVE && time - lastCommand > SLEEP_AFTER) {
            asleep = true;
        }
        script.tick(time);
        if (stream.isRunning() && mode != OiMode.OFF && !asleep && context.lineFreeAt() <= time) {
            context.send(stream.frame(packets, time), time);
        }
    }

    /** Cause that ends safe mode, as text; null if there is none. */
    private String danger() {
        if (hardware.isLeftWheelDropped() || hardware.isRightWheelDropped() || model.hasCasterSwitch()
            && hardware.isCasterDropped()) {
            return "a wheel has dropped";
        }
        return (drive.isForward() || drive.isBackwardAndTight()) && proximity.isAnyCliff() ? "a cliff" : null;
    }

    /** Changes the mode; leaving safe and full mode stops the motors. */
    private void enter(OiMode next) {
        if (!next.isActive()) {
            drive.stop();
            lights.setMotors(0);
        }
        mode = next;
    }

    @Override
    public void onUnknown(int code) {
        if (mode != OiMode.OFF) {
            context.warn("opcode", "opcode " + code + " does not exist on a " + model.getName() + ": ignored");
        }
    }

    @Override
    public void onCommand(Opcode opcode, int[] a, int count, double time) {
        if (asleep && opcode != Opcode.START && opcode != Opcode.RESET) {
            return;
        }
        if (!opcode.isAllowed(model, mode)) {
            if (mode != OiMode.OFF || opcode == Opcode.DRIVE || opcode == Opcode.DRIVE_DIRECT) {
                context.warn("mode " + opcode, "command " + opcode.getCode() + " (" + opcode
                    + ") has no effect in mode " + mode + "; "
                    + "send 128 (START) and 131 (SAFE) or 132 (FULL) first, in MyRobotLab roomba.startup()");
            }
            return;
        }
        context.understood();
        lastCommand = time;
        if (opcode.getCode() <= Opcode.DEMO.getCode()) {
            changeMode(opcode, a, time);
        } else if (!act(opcode, a, time) && !report(opcode, a, count, time)) {
            String first = count > 0 ? " with first argument " + a[0] : "";
            context.warn("command " + opcode, "command " + opcode.getCode() + " (" + opcode + ")" + first
                + " is not possible on a " + model.getName() + ": ignored");
        }
    }

    private void changeMode(Opcode opcode, int[] a, double time) {
        switch (opcode) {
            case RESET:
                enter(OiMode.OFF);
                boot(powerOnBaud);
                context.clearOutput();
                greet(time);
                break;
            case START:
                asleep = false;
                enter(OiMode.PASSIVE);
                break;
            case BAUD:
                changeBaud(a[0], time);
                break;
            case CONTROL:
            case SAFE:
                enter(OiMode.SAFE);
                break;
            case FULL:
                enter(OiMode.FULL);
                break;
            case POWER:
                enter(OiMode.PASSIVE);
                asleep = true;
                break;
            default:
                enter(OiMode.PASSIVE);
                context.warn("program", opcode + ": the simulated robot has no cleaning programs or demos; it stands "
                    + "still in passive mode");
                break;
        }
    }

    private void changeBaud(int code, double time) {
        if (code >= BAUDS.length) {
            context.warn("baud", "baud code " + code + ", legal: 0 (300 baud) to 11 (115200 baud); ignored");
            return;
        }
        if (model.isLadder()) {
            enter(OiMode.PASSIVE);
        }
        nextBaud = BAUDS[code];
        switchAt = Math.max(time, context.lineFreeAt());
        switchBaud(time);
    }

    /**
     * Runs commands of motors, lights and songs.
     *
     * @return whether the command is one of these and possible
     */
    private boolean act(Opcode opcode, int[] a, double time) {
        switch (opcode) {
            case DRIVE:
                drive.arc(word(a, 0), word(a, 2));
                return true;
            case DRIVE_DIRECT:
                drive.direct(word(a, 0), word(a, 2));
                return true;
            case DRIVE_PWM:
                drive.pwm(word(a, 0), word(a, 2));
                return true;
            case SONG:
                return songs.define(a);
            case PLAY:
                return play(a[0], time);
            case DOCK:
                changeMode(opcode, a, time);
                return true;
            case STOP:
                stream.start(new int[0]);
                enter(OiMode.OFF);
                return true;
            case BUTTONS:
                buttons = a[0];
                return true;
            case SCHEDULE:
            case SET_TIME:
            case SEND_IR:
                return true;
            default:
                return lights.set(opcode, a);
        }
    }

    private boolean play(int song, double time) {
        if (songs.has(song) && !songs.play(song, time)) {
            context.warn("song", "song " + song + " is not defined: command 141 (PLAY) is ignored");
        }
        return songs.has(song);
    }

    /**
     * Runs commands of sensors, streams and scripts.
     *
     * @return whether the command is one of these and possible
     */
    private boolean report(Opcode opcode, int[] a, int count, double time) {
        switch (opcode) {
            case SENSORS:
                return query(Arrays.copyOf(a, 1), time);
            case QUERY_LIST:
                return query(Arrays.copyOfRange(a, 1, count), time);
            case STREAM:
                return startStream(Arrays.copyOfRange(a, 1, count));
            case PAUSE_STREAM:
                if (a[0] == 0) {
                    stream.pause();
                } else {
                    stream.resume();
                }
                return true;
            case SCRIPT:
                return script.define(a);
            case PLAY_SCRIPT:
                script.play();
                return true;
            case SHOW_SCRIPT:
                context.send(script.show(), time);
                return true;
            case WAIT_TIME:
            case WAIT_DISTANCE:
            case WAIT_ANGLE:
            case WAIT_EVENT:
                return script.await(opcode, a, time);
            default:
                return false;
        }
    }

    private boolean query(int[] ids, double time) {
        if (!Arrays.stream(ids).allMatch(packets::has)) {
            return false;
        }
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        for (int id : ids) {
            packets.write(id, out, time);
        }
        if (out.size() > 0) {
            context.send(out.toByteArray(), time);
        }
        return true;
    }

    private boolean startStream(int[] ids) {
        if (!Arrays.stream(ids).allMatch(packets::has)) {
            return false;
        }
        stream.start(ids);
        if (stream.frameSize() > Uart.bytes(BEAT, baud)) {
            context.warn("stream", "a stream of more than " + (int) Uart.bytes(BEAT, baud)
                + " bytes every 15 ms exceeds " + baud + " baud; the robot skips frames");
        }
        return true;
    }

    private static int word(int[] a, int at) {
        return (short) (a[at] << 8 | a[at + 1]);
    }

    /** Receives a byte of the script. */
    void feed(int value, double time) {
        reader.accept(value, time);
    }

    /** Discards a command that the script leaves incomplete. */
    void endOfScript() {
        reader.clear();
    }

    /**
     * Whether an event of command 158 is present. The simulated robot has no docks, pressed buttons or digital inputs.
     */
    boolean isEvent(int event) {
        int contacts = packets.bumpsAndDrops();
        switch (event) {
            case 1:
                return contacts >> 2 != 0;
            case 2:
                return (contacts & 16) != 0;
            case 3:
                return (contacts & 8) != 0;
            case 4:
                return (contacts & 4) != 0;
            case 5:
                return (contacts & 3) != 0;
            case 6:
                return (contacts & 2) != 0;
            case 7:
                return (contacts & 1) != 0;
            case 8:
                return hardware.isInVirtualWall();
            case 9:
                return proximity.isWall();
            case 10:
                return proximity.isAnyCliff();
            case 11:
            case 12:
            case 13:
            case 14:
                return proximity.isCliff(event - 11);
            case 22:
                return mode == OiMode.PASSIVE;
            default:
                return false;
        }
    }

    /** Mode as in packet 35. */
    public OiMode getMode() {
        return mode;
    }

    /** Lights and motors, for display. */
    public Lights getLights() {
        return lights;
    }

    SensorPackets getPackets() {
        return packets;
    }

    Drive getDrive() {
        return drive;
    }

    Battery getBattery() {
        return battery;
    }

    Songs getSongs() {
        return songs;
    }

    int getStreamLength() {
        return stream.getLength();
    }

    int getButtons() {
        return buttons;
    }

    @Override
    public boolean takesDriveCommands() {
        return mode.isActive();
    }

    @Override
    public String title() {
        return "a " + model.getName();
    }

    @Override
    public String status() {
        String song = songs.isPlaying(beats * BEAT) ? ", song " + songs.getNumber() : "";
        return "OI mode: " + mode.name().toLowerCase(java.util.Locale.ROOT) + (asleep ? " (asleep)" : "") + ", "
            + lights.describe() + song + ", battery " + battery.getCharge() + " mAh";
    }
}
