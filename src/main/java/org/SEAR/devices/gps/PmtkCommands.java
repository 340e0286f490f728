// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.gps;

import java.util.Arrays;
import org.SEAR.protocol.nmea.Pmtk;

/** Commands of MediaTek receivers, for example {@code $PMTK220,200*2C}, answered by {@code $PMTK001,220,3*30}. */
final class PmtkCommands {
    /** Longest fix interval, milliseconds. */
    static final int MAX_PERIOD = 10000;
    private static final int INVALID = 0;
    private static final int UNSUPPORTED = 1;
    private static final int FAILED = 2;
    private static final int DONE = 3;
    /** First number of queries; a query gets an answer, but no acknowledgement. */
    private static final int FIRST_QUERY = 400;

    private final Mt3301 device;
    private int dgps;
    private int sbas;

    PmtkCommands(Mt3301 device) {
        this.device = device;
    }

    /** @param body a sentence without its frame, checksum verified */
    void execute(String body, double time) {
        String[] parts = body.split(",", -1);
        if (parts[0].equals("PQBAUD") && parts.length == 3) {
            int baud = number(parts[2]);
            if (Pmtk.BAUDS.contains(baud)) {
                device.changeBaud(baud, time);
            }
        } else if (Pmtk.numberOf(parts[0]) >= 0) {
            run(Pmtk.numberOf(parts[0]), Arrays.stream(parts).skip(1).mapToInt(PmtkCommands::number).toArray(), time);
        }
    }

    private static int number(String text) {
        return text.matches("-?\\d{1,8}") ? Integer.parseInt(text) : Integer.MIN_VALUE;
    }

    private void run(int number, int[] a, double time) {
        Pmtk command = Pmtk.of(number);
        int flag = command == null ? UNSUPPORTED : answer(command, time) ? DONE : set(command, a, time);
        if (number < FIRST_QUERY || command == Pmtk.QUERY_FIRMWARE || flag != DONE) {
            device.answer(Pmtk.ACKNOWLEDGE.body(number, flag), time);
        }
        if (command == Pmtk.SET_BAUD && flag == DONE) {
            device.changeBaud(a[0] == 0 ? Mt3301.DEFAULT_BAUD : a[0], time);
        }
    }

    /**
     * Answers a query.
     *
     * @return whether the command is one
     */
    private boolean answer(Pmtk command, double time) {
        switch (command) {
            case QUERY_FIX_INTERVAL:
                device.answer(Pmtk.FIX_INTERVAL.body(device.getPeriod(), 0, 0, 0, 0), time);
                return true;
            case QUERY_DGPS:
                device.answer(Pmtk.DGPS.body(dgps), time);
                return true;
            case QUERY_SBAS:
                device.answer(Pmtk.SBAS.body(sbas), time);
                return true;
            case QUERY_OUTPUT:
                device.answer(Pmtk.OUTPUT.body() + device.getRates().describe(), time);
                return true;
            case QUERY_FIRMWARE:
                return true;
            case QUERY_RELEASE:
                device.answer(Pmtk.RELEASE.body(device.getModel().getRelease(), "0000", "20090609", ""), time);
                return true;
            default:
                return false;
        }
    }

    private int set(Pmtk command, int[] a, double time) {
        switch (command) {
            case TEST:
            case SET_POWER_SAVING:
                return DONE;
            case HOT_START:
            case WARM_START:
                device.restart(false, time);
                return DONE;
            case COLD_START:
            case FULL_COLD_START:
                device.restart(true, time);
                return DONE;
            case SET_PERIOD:
                return a.length != 1 || a[0] < 0 ? INVALID : device.takePeriod(a[0], time) ? DONE : FAILED;
            case SET_FIX_INTERVAL:
                return a.length < 1 || a[0] < 0 ? INVALID : device.takePeriod(a[0], time) ? DONE : FAILED;
            case SET_BAUD:
                return a.length == 1 && (a[0] == 0 || Pmtk.BAUDS.contains(a[0])) ? DONE : INVALID;
            case SET_DGPS:
                dgps = first(a, dgps, 2);
                return first(a, -1, 2) < 0 ? INVALID : DONE;
            case SET_SBAS:
                sbas = first(a, sbas, 1);
                return first(a, -1, 1) < 0 ? INVALID : DONE;
            case SET_OUTPUT:
                return setOutput(a);
            default:
                return UNSUPPORTED;
        }
    }

    private int setOutput(int[] a) {
        if (a.length == 1 && a[0] == -1) {
            device.getRates().setDefault();
            return DONE;
        }
        return device.getRates().set(a) ? DONE : INVALID;
    }

    /** The only argument if it is legal, else {@code fallback}. */
    private static int first(int[] a, int fallback, int max) {
        return a.length == 1 && a[0] >= 0 && a[0] <= max ? a[0] : fallback;
    }
}
