package org.SEAR.devices.gps;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** The commands of MediaTek receivers, for example {@code $PMTK220,200*2C}, each answered by {@code $PMTK001,220,3*30}. */
final class PmtkCommands {
    /** Longest time from fix to fix, milliseconds. */
    static final int MAX_PERIOD = 10000;
    private static final int INVALID = 0;
    private static final int UNSUPPORTED = 1;
    private static final int FAILED = 2;
    private static final int DONE = 3;
    private static final List<Integer> BAUDS = Arrays.asList(4800, 9600, 14400, 19200, 38400, 57600, 115200);

    private final Mt3301 device;
    private int dgps;
    private int sbas;

    PmtkCommands(Mt3301 device) {
        this.device = device;
    }

    /** @param body a sentence without its frame, checked */
    void execute(String body, double time) {
        String[] parts = body.split(",", -1);
        if (parts[0].equals("PQBAUD") && parts.length == 3) {
            int baud = number(parts[2]);
            if (BAUDS.contains(baud)) {
                device.changeBaud(baud, time);
            }
        } else if (parts[0].matches("PMTK\\d{3}")) {
            run(Integer.parseInt(parts[0].substring(4)), Arrays.stream(parts).skip(1).mapToInt(PmtkCommands::number).toArray(), time);
        }
    }

    private static int number(String text) {
        return text.matches("-?\\d{1,8}") ? Integer.parseInt(text) : Integer.MIN_VALUE;
    }

    private void run(int command, int[] a, double time) {
        int answer = query(command, time) ? DONE : set(command, a, time);
        if (command < 400 || command == 604 || answer != DONE) {
            acknowledge(command, answer, time);
        }
        if (command == 251 && answer == DONE) {
            device.changeBaud(a[0] == 0 ? Mt3301.DEFAULT_BAUD : a[0], time);
        }
    }

    private void acknowledge(int command, int flag, double time) {
        device.answer(String.format(Locale.ROOT, "PMTK001,%d,%d", command, flag), time);
    }

    /** Questions. @return whether it was one */
    private boolean query(int command, double time) {
        switch (command) {
            case 400:
                device.answer("PMTK500," + device.getPeriod() + ",0,0,0,0", time);
                return true;
            case 401:
                device.answer("PMTK501," + dgps, time);
                return true;
            case 413:
                device.answer("PMTK513," + sbas, time);
                return true;
            case 414:
                device.answer("PMTK514" + device.getRates().describe(), time);
                return true;
            case 604:
                return true;
            case 605:
                device.answer("PMTK705," + device.getModel().getRelease() + ",0000,20090609,", time);
                return true;
            default:
                return false;
        }
    }

    private int set(int command, int[] a, double time) {
        switch (command) {
            case 0:
            case 320:
                return DONE;
            case 101:
            case 102:
                device.restart(false, time);
                return DONE;
            case 103:
            case 104:
                device.restart(true, time);
                return DONE;
            case 220:
                return a.length != 1 || a[0] < 0 ? INVALID : device.setPeriod(a[0], time) ? DONE : FAILED;
            case 300:
                return a.length < 1 || a[0] < 0 ? INVALID : device.setPeriod(a[0], time) ? DONE : FAILED;
            case 251:
                return a.length == 1 && (a[0] == 0 || BAUDS.contains(a[0])) ? DONE : INVALID;
            case 301:
                dgps = first(a, dgps, 2);
                return first(a, -1, 2) < 0 ? INVALID : DONE;
            case 313:
                sbas = first(a, sbas, 1);
                return first(a, -1, 1) < 0 ? INVALID : DONE;
            case 314:
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

    /** The first argument if it is there and legal, else {@code fallback}. */
    private static int first(int[] a, int fallback, int max) {
        return a.length == 1 && a[0] >= 0 && a[0] <= max ? a[0] : fallback;
    }
}
