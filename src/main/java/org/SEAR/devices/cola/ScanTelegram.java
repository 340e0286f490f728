// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.cola;

import java.time.Instant;
import java.time.ZoneOffset;
import java.time.ZonedDateTime;
import org.SEAR.protocol.cola.ColaDialect;
import org.SEAR.protocol.cola.ColaPayload;

/**
 * A scan as LMDscandata sends it: state, counters, times, a channel of distances per echo, one of remissions, and
 * further data by the settings. Distances are in millimetres; 0 without a hit, or outside the model's range. Second
 * echoes and remission are not simulated: the second echo is always 0, the remission {@link #REMISSION} for every hit.
 * Immutable.
 */
final class ScanTelegram {
    /** Remission of a hit, in the scanner's unit. */
    private static final int REMISSION = 100;
    static final int SERIAL_NUMBER = 18340008;
    private static final int MM_PER_METRE = 1000;
    private static final int MICROSECONDS = 1000000;
    /** Nanoseconds in a microsecond. */
    private static final int NANOSECONDS = 1000;
    private static final int WORD = 0xFFFF;

    private final ColaModel model;
    private final ScannerSettings settings;
    private final int[] distances;
    private final long number;
    private final double time;

    /**
     * @param settings of the measurement
     * @param metres distances, right to left
     * @param number of the scan since power-on
     * @param time end of the scan, simulated seconds
     */
    ScanTelegram(ColaModel model, ScannerSettings settings, double[] metres, long number, double time) {
        this.model = model;
        this.settings = settings;
        this.number = number;
        this.time = time;
        distances = new int[metres.length];
        for (int i = 0; i < metres.length; i++) {
            long mm = metres[i] >= model.lidar.getNearest() && metres[i] < Double.POSITIVE_INFINITY
                ? Math.round(metres[i] * MM_PER_METRE) : 0;
            distances[i] = mm > model.lidar.getFarthest() * MM_PER_METRE ? 0 : (int) mm;
        }
    }

    /** Number of the scan since power-on. */
    long getNumber() {
        return number;
    }

    /**
     * Returns the framed telegram.
     *
     * @param verb sRA for an answer, sSN for a stream
     * @param telegramNumber since power-on
     * @param up time of the scan, seconds since power-on
     * @param sent time of the telegram, seconds since power-on
     * @param epochMillis UTC of simulated time 0
     */
    byte[] encode(ColaDialect dialect, String verb, long telegramNumber, double up, double sent, long epochMillis) {
        ColaPayload out = new ColaPayload(dialect).begin(verb, "LMDscandata");
        out.u2(1).u2(1).i4(SERIAL_NUMBER).u1(0).u1(0).u2((int) (telegramNumber & WORD)).u2((int) (number & WORD));
        out.i4((int) (long) (up * MICROSECONDS)).i4((int) (long) (sent * MICROSECONDS));
        out.u1(0).u1(0).u1(model.outputs).u1(0).u2(0).i4(settings.rate.frequency).i4(settings.rate.beams).u2(0);
        writeChannels(out);
        writeFlags(out, epochMillis);
        return out.toTelegram();
    }

    private void writeChannels(ColaPayload out) {
        int echoes = (settings.hasEcho(1) ? 1 : 0) + (settings.hasEcho(2) ? 1 : 0);
        int remissions = settings.hasRemission() ? echoes : 0;
        boolean wide = settings.isRemissionWide();
        out.u2(echoes + (wide ? remissions : 0));
        for (int echo = 1; echo <= 2; echo++) {
            if (settings.hasEcho(echo)) {
                writeDistances(out, echo);
            }
        }
        if (!wide) {
            out.u2(remissions);
        }
        for (int echo = 1; echo <= 2; echo++) {
            if (settings.hasEcho(echo) && remissions > 0) {
                writeRemissions(out, echo, wide);
            }
        }
        if (wide) {
            out.u2(0);
        }
    }

    private void writeDistances(ColaPayload out, int echo) {
        head(out, "DIST" + echo);
        for (int distance : distances) {
            out.u2(echo == 1 ? distance : 0);
        }
    }

    private void writeRemissions(ColaPayload out, int echo, boolean wide) {
        head(out, "RSSI" + echo);
        for (int distance : distances) {
            int value = echo == 1 && distance > 0 ? REMISSION : 0;
            if (wide) {
                out.u2(value);
            } else {
                out.u1(value);
            }
        }
    }

    private void head(ColaPayload out, String channel) {
        out.fixed(channel).real(1).real(0).i4(settings.start).u2(settings.rate.resolution).u2(distances.length);
    }

    /** Writes position, name, comment, time and event. Position, comment and events are always absent. */
    private void writeFlags(ColaPayload out, long epochMillis) {
        out.u2(0).u2(settings.hasName() ? 1 : 0);
        if (settings.hasName()) {
            out.text(settings.name);
        }
        out.u2(0).u2(settings.hasTime() ? 1 : 0);
        if (settings.hasTime()) {
            writeTime(out, epochMillis);
        }
        out.u2(0);
    }

    private void writeTime(ColaPayload out, long epochMillis) {
        long nanos = Math.round(time * MICROSECONDS) * NANOSECONDS;
        ZonedDateTime date = Instant.ofEpochMilli(epochMillis).plusNanos(nanos).atZone(ZoneOffset.UTC);
        out.u2(date.getYear()).u1(date.getMonthValue()).u1(date.getDayOfMonth()).u1(date.getHour()).u1(date.getMinute())
            .u1(date.getSecond());
        out.i4(date.getNano() / NANOSECONDS);
    }
}
