// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.imu;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.SerialDevice;
import org.SEAR.sensors.ImuReading;

/**
 * Firmware of SparkFun's Razor 9DOF inertial measurement unit. It sends a frame every 20 ms with angles or sensor
 * values, as text or binary. Commands begin with {@code #}. Source: command list and formats published with its
 * firmware 1.4.2 (Peter Bartz, TU Berlin).
 */
public final class Razor implements SerialDevice {
    private static final double INTERVAL = 0.02;
    private static final int TOKEN_SIZE = 2;
    private static final String COMMANDS = "fso";
    private static final String[] CALIBRATED = {"accel x,y,z (min/max) = ", "magn x,y,z (min/max) = ",
        "gyro x,y,z (current/average) = "};
    private static final int GYROSCOPE = 2;

    /** Contents of a frame. */
    private enum Mode { ANGLES, MOTION, CALIBRATED, RAW, BOTH, CALIBRATION }

    private final int baud;
    private final DeviceContext context;
    private final StringBuilder command = new StringBuilder();
    private final double[] least = new double[RazorFrames.AXES];
    private final double[] most = new double[RazorFrames.AXES];
    private Mode mode;
    private boolean binary;
    private boolean streaming;
    private boolean asked;
    private int calibrated;
    private long samples;
    private long frame;
    private ImuReading last;

    /** @param baud fixed baud rate, bits per second */
    public Razor(int baud, DeviceContext context) {
        this.baud = baud;
        this.context = context;
        reset();
    }

    /** Same as power-on: no setting survives power-off. */
    @Override
    public void reset() {
        powerOn(0);
    }

    @Override
    public void powerOff() {
        command.setLength(0);
    }

    @Override
    public void powerOn(double time) {
        command.setLength(0);
        mode = Mode.ANGLES;
        binary = false;
        streaming = true;
        asked = false;
        last = null;
        frame = (long) Math.floor(time / INTERVAL);
        calibrate(0);
    }

    @Override
    public int getBaud() {
        return baud;
    }

    @Override
    public void receive(int value, double time) {
        advance(time);
        if (command.length() > 0 || value == '#') {
            command.append((char) value);
            if (execute(command.substring(1), time)) {
                if (COMMANDS.indexOf(command.charAt(1)) >= 0) {
                    context.understood();
                }
                command.setLength(0);
            }
        }
    }

    /**
     * Runs the command after a {@code #} when it is complete.
     *
     * @return whether it has ended, known or not
     */
    private boolean execute(String text, double time) {
        if (text.isEmpty()) {
            return false;
        }
        switch (text.charAt(0)) {
            case 'f':
                asked = true;
                return true;
            case 's':
                if (text.length() > TOKEN_SIZE) {
                    context.send(("#SYNCH" + text.substring(1) + "\r\n").getBytes(StandardCharsets.ISO_8859_1), time);
                }
                return text.length() > TOKEN_SIZE;
            case 'o':
                return text.length() > 1 && setOutput(text.substring(1));
            default:
                return true;
        }
    }

    private boolean setOutput(String parameters) {
        switch (parameters.charAt(0)) {
            case '0':
            case '1':
                streaming = parameters.charAt(0) == '1';
                return true;
            case 't':
            case 'b':
                show(Mode.ANGLES, parameters.charAt(0) == 'b');
                return true;
            case 'x':
                show(Mode.MOTION, false);
                return true;
            case 'c':
                show(Mode.CALIBRATION, false);
                calibrate(0);
                return true;
            case 'n':
                calibrate((calibrated + 1) % CALIBRATED.length);
                return true;
            case 's':
                return parameters.length() > 2 && setSensors(parameters.charAt(1), parameters.charAt(2));
            case 'e':
                return parameters.length() > 1;
            default:
                return true;
        }
    }

    private boolean setSensors(char values, char format) {
        Mode wanted = values == 'r' ? Mode.RAW : values == 'c' ? Mode.CALIBRATED : values == 'b' ? Mode.BOTH : mode;
        show(wanted, format == 'b' || format != 't' && binary);
        return true;
    }

    private void show(Mode newMode, boolean inBinary) {
        mode = newMode;
        binary = inBinary;
    }

    private void calibrate(int sensor) {
        calibrated = sensor;
        samples = 0;
    }

    @Override
    public void receiveGarbage(double time) {
        advance(time);
        command.setLength(0);
    }

    @Override
    public void advance(double time) {
        while ((frame + 1) * INTERVAL <= time) {
            frame++;
            if (streaming || asked) {
                send(frame * INTERVAL);
            }
        }
    }

    /** Sends a frame; skips it while the last one is still on the line. */
    private void send(double time) {
        if (context.lineFreeAt() > time) {
            return;
        }
        asked = false;
        ImuReading reading = (ImuReading) context.read(context.sensor());
        if (!Double.isNaN(reading.getYaw())) {
            last = reading;
        }
        if (last != null) {
            context.send(frame(last), time);
        }
    }

    private byte[] frame(ImuReading reading) {
        switch (mode) {
            case ANGLES:
                return RazorFrames.angles(reading, binary);
            case MOTION:
                return RazorFrames.motion(reading);
            case CALIBRATION:
                return calibration(RazorFrames.raw(reading, calibrated)).getBytes(StandardCharsets.US_ASCII);
            case BOTH:
                ByteArrayOutputStream both = new ByteArrayOutputStream();
                both.writeBytes(RazorFrames.sensors(reading, true, binary));
                both.writeBytes(RazorFrames.sensors(reading, false, binary));
                return both.toByteArray();
            default:
                return RazorFrames.sensors(reading, mode == Mode.RAW, binary);
        }
    }

    /**
     * Minimum and maximum of each axis since the calibration began; for the gyroscope the current value and the mean.
     */
    private String calibration(double[] values) {
        StringBuilder text = new StringBuilder(CALIBRATED[calibrated]);
        samples++;
        for (int i = 0; i < values.length; i++) {
            boolean mean = calibrated == GYROSCOPE;
            least[i] = mean ? values[i] : samples == 1 ? values[i] : Math.min(least[i], values[i]);
            most[i] = samples == 1 ? values[i] : mean ? most[i] + (values[i] - most[i]) / samples
                : Math.max(most[i], values[i]);
            text.append(i == 0 ? "" : "  ").append(String.format(Locale.ROOT, "%.2f/%.2f", least[i], most[i]));
        }
        return text.append("\r\n").toString();
    }

    @Override
    public String title() {
        return "a Razor 9DOF";
    }

    @Override
    public String status() {
        return "Razor 9DOF: " + mode.name().toLowerCase(Locale.ROOT) + (binary ? ", binary" : ", text")
            + (streaming ? "" : ", on request") + ", " + baud + " baud";
    }
}
