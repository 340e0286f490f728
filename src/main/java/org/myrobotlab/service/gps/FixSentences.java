// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.gps;

import java.util.Arrays;

/**
 * Reads the sentences with a position, of any talker (GP, GN, GL, GA, GB, BD, ...):
 *
 * <pre>
 * $GPGGA,hhmmss.ss,ddmm.mmmm,N,dddmm.mmmm,E,quality,satellites,hdop,altitude,M,separation,M,age,station*cs
 * $GNGNS,hhmmss.ss,ddmm.mmmm,N,dddmm.mmmm,E,modes,satellites,hdop,altitude,separation,age,station,status*cs
 * $GPRMC,hhmmss.ss,A,ddmm.mmmm,N,dddmm.mmmm,E,knots,course,ddmmyy,variation,E,mode,status*cs
 * $GPGLL,ddmm.mmmm,N,dddmm.mmmm,E,hhmmss.ss,A,mode*cs
 * </pre>
 *
 * <p>Trailing fields may be missing: GGA and GNS need 13 fields with their type, RMC 8, GLL 7.
 */
final class FixSentences {
    /** Rank of GGA, which has more than GNS; GNS has more than RMC and GLL. */
    static final int GGA_RANK = 2;
    private static final int TYPE = 3;
    private static final int GNS_RANK = 1;
    private static final int GNS_MODES = 6;
    private static final int GNS_SEPARATION = 10;
    private static final int GNS_STATUS = 13;
    private static final int RMC_STATUS = 2;
    private static final int RMC_LATITUDE = 3;
    private static final int RMC_MODE = 12;
    private static final int GLL_UTC = 5;
    private static final int GLL_STATUS = 6;
    private static final int GLL_MODE = 7;
    /** Mode indicators in the order of GGA's qualities from 1. */
    private static final String MODES = "ADPRFEMS";
    private static final int COORDINATES = 4;
    /** Most fields of the sentences above; missing ones are read as empty. */
    private static final int MOST = 15;

    /** Kinds of sentences, with the fewest fields including the type. */
    private enum Kind {
        GGA(13), GNS(13), RMC(8), GLL(7);

        private final int fewest;

        Kind(int fewest) {
            this.fewest = fewest;
        }
    }

    private FixSentences() {
    }

    /** Returns the three letters behind the talker, for example GGA; empty for proprietary sentences. */
    static String type(String sentence) {
        int end = sentence.indexOf(',');
        return end == TYPE + TYPE && sentence.charAt(1) != 'P' ? sentence.substring(TYPE, end) : "";
    }

    /** Returns the fields without the checksum. */
    static String[] fields(String sentence) {
        return sentence.split("[*]", 2)[0].split(",", -1);
    }

    /**
     * Returns the fix of a GGA sentence that another message was converted to.
     *
     * @param source name of the message
     */
    static Fix converted(String source, String sentence) {
        return new Fix(source, fields(sentence), sentence.split(",", -1), GGA_RANK);
    }

    /**
     * Returns the fix of a sentence; null for other sentences.
     *
     * @param sentence from {@code $} to checksum
     * @throws IllegalArgumentException if fields are missing or illegal
     */
    static Fix read(String sentence) {
        Kind kind = kind(type(sentence));
        if (kind == null) {
            return null;
        }
        String[] found = fields(sentence);
        if (found.length < kind.fewest) {
            throw new IllegalArgumentException(kind + " has " + found.length + " fields, legal: " + kind.fewest
                + " or more");
        }
        String[] fields = Arrays.copyOf(found, Math.max(MOST, found.length));
        Arrays.fill(fields, found.length, fields.length, "");
        switch (kind) {
            case GGA:
                return new Fix(fields[0], fields, sentence.split(",", -1), GGA_RANK);
            case GNS:
                return gns(fields);
            case RMC:
                return minimum(fields, 1, RMC_LATITUDE, "A".equals(fields[RMC_STATUS]), found.length > RMC_MODE
                    ? fields[RMC_MODE] : "A");
            default:
                return minimum(fields, GLL_UTC, 1, "A".equals(fields[GLL_STATUS]), found.length > GLL_MODE
                    ? fields[GLL_MODE] : "A");
        }
    }

    private static Kind kind(String type) {
        for (Kind kind : Kind.values()) {
            if (kind.name().equals(type)) {
                return kind;
            }
        }
        return null;
    }

    private static Fix gns(String... fields) {
        String[] tokens = Fix.empty(fields[0]);
        System.arraycopy(fields, 1, tokens, 1, Fix.ALTITUDE);
        tokens[Fix.SEPARATION] = fields[GNS_SEPARATION];
        boolean safe = !fields[GNS_STATUS].startsWith("U") && !fields[GNS_STATUS].startsWith("V");
        tokens[Fix.QUALITY] = safe ? quality(fields[GNS_MODES]) : "0";
        return new Fix(fields[0], tokens.clone(), tokens, GNS_RANK);
    }

    /** Returns the fix of a sentence without altitude. */
    private static Fix minimum(String[] fields, int utc, int latitude, boolean valid, String mode) {
        String[] tokens = Fix.empty(fields[0]);
        tokens[Fix.UTC] = fields[utc];
        System.arraycopy(fields, latitude, tokens, Fix.LATITUDE, COORDINATES);
        tokens[Fix.QUALITY] = valid ? quality(mode.isEmpty() ? "A" : mode) : "0";
        return new Fix(fields[0], tokens.clone(), tokens, 0);
    }

    /** Returns GGA's quality for the first mode indicator that is a fix. */
    private static String quality(String modes) {
        for (char mode : modes.toCharArray()) {
            int at = MODES.indexOf(mode);
            if (at >= 0) {
                return String.valueOf(at + 1);
            }
        }
        return "0";
    }
}
