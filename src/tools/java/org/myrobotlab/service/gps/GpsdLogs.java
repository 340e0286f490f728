// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.gps;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.protocol.ubx.UbxFrame;

/**
 * Tool that compares positions with those of gpsd in its regression logs, which are not part of SEAR:
 * {@code ./gradlew gpsdLogs -PgpsdLogs=gpsd/test/daemon}. gpsd may leave out the first or last moment of a log while it
 * learns the receiver's cycle.
 */
public final class GpsdLogs {
    private static final Pattern VALUE = Pattern.compile("\"(time|lat|lon)\":\"?([^,\"}]*)");
    /** Sentences and messages of one moment differ by their last digits. Degrees. */
    private static final double CLOSE = 1e-6;
    /** Tolerance of places whose time gpsd does not know, degrees. */
    private static final double EXACT = 2e-9;
    /** Tolerance of times that receivers cut or round in one of their sentences, seconds. */
    private static final double ONE_MOMENT = 0.0101;
    /** Logs whose positions differ, with the reason. */
    private static final Map<String, String> DIFFERENT = new TreeMap<>();

    static {
        String cut = "gpsd leaves out a moment at which it has not found the end of the cycle";
        for (String log : List.of("ais-nmea", "bt451", "gp-320fw-2019-04-06-overflow", "rst39", "tn204", "ublox-lea-5h",
            "ublox-lea-m8f", "ublox-zed-f9t-rtcm3")) {
            DIFFERENT.put(log, cut);
        }
        DIFFERENT.put("bundg_zeus_9", "GLL and GGA of one second differ; gpsd reports both, SEAR takes GGA");
        DIFFERENT.put("ericsson-gru04", "proprietary $PERC,GPavp");
        DIFFERENT.put("ericsson-gru04-02-70sec", "proprietary $PERC,GPavp");
        DIFFERENT.put("garmin-10x", "GGA has a dead reckoning fix, RMC none; gpsd takes the last");
        DIFFERENT.put("garmin-geko201", "a demo: GGA has a simulated fix, RMC and GLL none; gpsd takes the last");
        DIFFERENT.put("garmin48", "GGA and GLL have different seconds; gpsd reports one of them");
        DIFFERENT.put("hemi", "gpsd ignores a GGA fix with less than three satellites");
        DIFFERENT.put("humminbird-M37", "each sentence has its own second; gpsd reports two of the first four");
        DIFFERENT.put("mtk-3301", "gpsd takes one GGA with quality 0");
        DIFFERENT.put("myguide-3100", "gpsd takes two GGA without quality while RMC and GSA have no fix");
        DIFFERENT.put("quectel-l76k-dual", "CASIC messages");
        DIFFERENT.put("tcp-torture", "marks for pauses inside the sentences of the log");
        DIFFERENT.put("tr737A+", "gpsd takes one GGA with quality 0");
        DIFFERENT.put("ublox-glo", "gpsd takes NAV-PVT without the flag gnssFixOK, for which u-blox' GGA "
            + "has quality 0");
        DIFFERENT.put("ublox-neo-m8l", "HNR-PVT");
        DIFFERENT.put("ublox-neo-m8u-hnr", "HNR-PVT");
    }

    private GpsdLogs() {
    }

    /** Time of day as seconds or null, latitude and longitude in degrees. */
    private static final class Place {
        final Double time;
        final double latitude;
        final double longitude;

        /** @param utc hhmmss.sss; null if unknown */
        Place(String utc, double latitude, double longitude) {
            time = utc == null ? null : Integer.parseInt(utc.substring(0, 2)) * 3600
                + Integer.parseInt(utc.substring(2, 4)) * 60 + Double.parseDouble(utc.substring(4));
            this.latitude = latitude;
            this.longitude = longitude;
        }

        boolean is(Place other) {
            boolean timed = time != null && other.time != null;
            double close = timed ? CLOSE : EXACT;
            return Math.abs(latitude - other.latitude) < close && Math.abs(longitude - other.longitude) < close
                && (!timed || Math.abs(time - other.time) < ONE_MOMENT);
        }

        @Override
        public String toString() {
            return String.format(Locale.ROOT, "%s s: %.9f %.9f", time, latitude, longitude);
        }
    }

    private static void add(List<Place> places, Place place) {
        Place last = places.isEmpty() ? null : places.get(places.size() - 1);
        if (last == null || !last.is(place) || (last.time == null) != (place.time == null)) {
            places.add(place);
        }
    }

    private static List<Place> ofGpsd(Path check) throws IOException {
        List<Place> places = new ArrayList<>();
        for (String line : new String(Files.readAllBytes(check), StandardCharsets.ISO_8859_1).split("\n")) {
            if (!line.startsWith("{\"class\":\"TPV\"") || !line.contains("\"lat\":")) {
                continue;
            }
            String time = null;
            double[] place = new double[2];
            Matcher value = VALUE.matcher(line);
            while (value.find()) {
                if (value.group(1).equals("time")) {
                    time = value.group(2).substring(value.group(2).indexOf('T') + 1).replaceAll("[:Z]", "");
                } else {
                    place[value.group(1).equals("lat") ? 0 : 1] = Double.parseDouble(value.group(2));
                }
            }
            add(places, new Place(time, place[0], place[1]));
        }
        return places;
    }

    private static List<Place> ofSear(Path log) throws IOException {
        List<Place> places = new ArrayList<>();
        new Reception(new Reception.Listener() {
            @Override
            public void onSentence(String sentence) {
            }

            @Override
            public void onUbx(UbxFrame frame) {
            }

            @Override
            public void onInvalid(String reason) {
            }

            @Override
            public void onFix(Fix fix) {
                if (fix.hasFix()) {
                    add(places, new Place(fix.utc, fix.latitude, fix.longitude));
                }
            }
        }).feed(Files.readAllBytes(log));
        return places;
    }

    private static List<Place> without(List<Place> places, List<Place> others) {
        return places.stream().filter(place -> others.stream().noneMatch(place::is)).collect(Collectors.toList());
    }

    /** @param folder the folder of logs with their {@code .chk} files; throws at a difference that is not listed */
    public static void main(String[] folder) throws IOException {
        List<Path> logs;
        try (Stream<Path> files = Files.list(Path.of(folder[0]))) {
            logs = files.filter(file -> file.toString().endsWith(".log") && Files.exists(Path.of(file + ".chk")))
                .sorted().collect(Collectors.toList());
        }
        List<String> different = new ArrayList<>();
        int equal = 0;
        int other = 0;
        for (Path log : logs) {
            String name = log.getFileName().toString().replace(".log", "");
            List<Place> gpsd = ofGpsd(Path.of(log + ".chk"));
            List<Place> sear = ofSear(log);
            List<Place> missing = without(gpsd, sear);
            List<Place> extra = without(sear, gpsd);
            if (sear.isEmpty() && !gpsd.isEmpty()) {
                other++;
            } else if (isEnd(missing, gpsd, false) && isEnd(extra, sear, true)) {
                equal += sear.isEmpty() ? 0 : 1;
            } else {
                System.out.printf(Locale.ROOT, "%s: gpsd %d, of these missing %d %s; SEAR %d, of these not in "
                    + "gpsd's %d %s; %s%n", name, gpsd.size(),
                    missing.size(), first(missing), sear.size(), extra.size(), first(extra), DIFFERENT.get(name));
                different.add(name);
            }
        }
        System.out.printf("%d logs: %d equal, %d different, %d only in other protocols, the rest without positions%n",
            logs.size(), equal, different.size(), other);
        different.removeAll(DIFFERENT.keySet());
        if (equal == 0 || !different.isEmpty()) {
            throw new IllegalStateException("unexpected differences: " + different);
        }
    }

    /** Returns whether only the last place of a log is left over, or the first. */
    private static boolean isEnd(List<Place> left, List<Place> all, boolean orFirst) {
        return left.stream().allMatch(place -> orFirst && place == all.get(0) || place == all.get(all.size() - 1));
    }

    private static List<Place> first(List<Place> places) {
        return places.subList(0, Math.min(1, places.size()));
    }
}
