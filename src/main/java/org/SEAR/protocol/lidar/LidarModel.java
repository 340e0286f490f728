// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.lidar;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/**
 * LIDAR models that can be behind a port, as data. A further model of a known protocol is a further row. Sources:
 * SICK's technical description 8008970 of the LMS2xx, Hokuyo's SCIP 2.0 specification, Slamtec's data sheet of the
 * A1M8, recordings of LMS1xx and TiM.
 */
public enum LidarModel {
    /** SICK, indoor, millimetres: up to 8 m with factory settings, configurable up to 81.91 m. */
    LMS200("LMS200", "SICK", LidarProtocol.LMS, 8.191, 81.91, 0, 180, 1, 75, Rates.RS422, Fans.of(100, 1, 0.5, 0.25),
        Fans.of(180, 1, 0.5)),
    /** SICK, outdoor, centimetres. */
    LMS221("LMS221", "SICK", LidarProtocol.LMS, 80, 81.91, 0, 180, 1, 75, Rates.RS422, Fans.of(100, 1, 0.5, 0.25),
        Fans.of(180, 1, 0.5)),
    /** SICK, outdoor, centimetres. */
    LMS291("LMS291", "SICK", LidarProtocol.LMS, 80, 81.91, 0, 180, 1, 75, Rates.RS422, Fans.of(100, 1, 0.5, 0.25),
        Fans.of(180, 1, 0.5)),
    /** SICK, outdoor, network; 50 scans per second at half a degree, 25 at a quarter. */
    LMS111("LMS111", "SICK", LidarProtocol.COLA, 20, 20, 0.5, 270, 0.5, 50, Rates.ETHERNET, Fans.upTo(270, 0.5, 0.25)),
    /** SICK, network. */
    TIM561("TiM561", "SICK", LidarProtocol.COLA, 10, 10, 0.05, 270, 1 / 3.0, 15, Rates.ETHERNET,
        Fans.upTo(270, 1 / 3.0)),
    /** Hokuyo, indoor; steps of 1/1024 turn, 341 to either side of the front. */
    URG_04LX("URG-04LX", "Hokuyo", LidarProtocol.SCIP, 5.6, 5.6, 0.02, 682 * 360 / 1024.0, 360 / 1024.0, 10, Rates.URG,
        Fans.ofSteps(682 * 360 / 1024.0, 360 / 1024.0, 99)),
    /** Hokuyo, outdoor; steps of 1/1440 turn. */
    UTM_30LX("UTM-30LX", "Hokuyo", LidarProtocol.SCIP, 30, 60, 0.023, 270, 0.25, 40, Rates.USB,
        Fans.ofSteps(270, 0.25, 99)),
    /** Slamtec, indoor; motor speed and sample rate set its resolution. */
    RPLIDAR_A1("RPLIDAR-A1", "Slamtec", LidarProtocol.RPLIDAR, 12, 12, 0.15, 360, 1, 5.5, Rates.RPLIDAR,
        Fans.between(360, 0.18, 1.8)),
    /**
     * Generic scanner with any angles, for CoLa drivers. A step of 1/10000 degree and a distance in millimetres fit a
     * word each.
     */
    COLA("CoLa", "any", LidarProtocol.COLA, 30, 65.535, 0, 270, 0.25, 10, Rates.ETHERNET,
        Fans.between(360, 0.01, 6.5535));

    /** Baud rates, bits per second; the first one is that at power-on. */
    private static final class Rates {
        static final int[] RS422 = {9600, 19200, 38400, 500000};
        /** RS-232 or USB. */
        static final int[] URG = {19200, 38400, 57600, 115200, 250000, 500000, 750000, 12000000};
        static final int[] RPLIDAR = {115200};
        /** Full-speed USB, the only rate. */
        static final int[] USB = {12000000};
        /** Fast Ethernet, the only rate. */
        static final int[] ETHERNET = {100000000};
    }

    private static final String ALL = Arrays.stream(values()).map(LidarModel::getName)
        .collect(Collectors.joining(", "));

    private final String name;
    private final String maker;
    private final LidarProtocol protocol;
    private final double range;
    private final double farthest;
    private final double nearest;
    private final double spread;
    private final double resolution;
    private final double scanRate;
    private final int[] rates;
    private final List<Fans> fans;

    LidarModel(String name, String maker, LidarProtocol protocol, double range, double farthest, double nearest,
        double spread, double resolution, double scanRate, int[] rates, Fans... fans) {
        this.name = name;
        this.maker = maker;
        this.protocol = protocol;
        this.range = range;
        this.farthest = farthest;
        this.nearest = nearest;
        this.spread = spread;
        this.resolution = resolution;
        this.scanRate = scanRate;
        this.rates = rates;
        this.fans = List.of(fans);
    }

    /** Whether a model name is known, in any spelling: {@code urg04lx} is a URG-04LX. */
    public static boolean isKnown(String name) {
        return find(name) != null;
    }

    /**
     * Finds a model by name, in any spelling.
     *
     * @throws IllegalArgumentException that lists the valid models
     */
    public static LidarModel of(String name) {
        LidarModel model = find(name);
        if (model == null) {
            throw new IllegalArgumentException("LIDAR model is \"" + name + "\", legal: " + ALL);
        }
        return model;
    }

    private static LidarModel find(String name) {
        String plain = plain(name);
        return Arrays.stream(values()).filter(model -> plain(model.name).equals(plain)).findFirst().orElse(null);
    }

    private static String plain(String name) {
        return name.replaceAll("[^A-Za-z0-9]", "").toUpperCase(Locale.ROOT);
    }

    /** Names of all models, separated by commas. */
    public static String names() {
        return ALL;
    }

    /** Names of the models that support an angle and a resolution, separated by commas; empty if none does. */
    public static String namesWith(double spread, double resolution) {
        return Arrays.stream(values()).filter(model -> model.hasFan(spread, resolution)).map(LidarModel::getName)
            .collect(Collectors.joining(", "));
    }

    /** Name as its maker writes it: {@code URG-04LX}. */
    public String getName() {
        return name;
    }

    /** Name with its article: {@code an LMS200}. */
    public String withArticle() {
        return ("CTU".indexOf(name.charAt(0)) >= 0 ? "a " : "an ") + name;
    }

    public String getMaker() {
        return maker;
    }

    public LidarProtocol getProtocol() {
        return protocol;
    }

    /** Range with factory settings, metres. */
    public double getRange() {
        return range;
    }

    /** Longest distance that it can report in any configuration, metres. */
    public double getFarthest() {
        return farthest;
    }

    /** Shortest distance that it measures, metres. */
    public double getNearest() {
        return nearest;
    }

    /** Angle from the rightmost to the leftmost measurement with factory settings, degrees. */
    public double getSpread() {
        return spread;
    }

    /** Angle between two measurements with factory settings, degrees. */
    public double getResolution() {
        return resolution;
    }

    /** Scan rate with factory settings, scans per second. */
    public double getScanRate() {
        return scanRate;
    }

    /** Baud rate at power-on, bits per second; the bit rate of USB or network devices. */
    public int getBaud() {
        return rates[0];
    }

    /** Baud rates, bits per second, the power-on rate first. */
    public int[] rates() {
        return rates.clone();
    }

    /** Whether it supports a baud rate, bits per second. */
    public boolean hasBaud(int baud) {
        return Arrays.stream(rates).anyMatch(rate -> rate == baud);
    }

    /** Baud rates, separated by commas. */
    public String bauds() {
        return Arrays.stream(rates).mapToObj(String::valueOf).collect(Collectors.joining(", "));
    }

    /** Whether it supports an angle and a resolution, degrees. */
    public boolean hasFan(double wantedSpread, double wantedResolution) {
        return fans.stream().anyMatch(one -> one.has(wantedSpread, wantedResolution));
    }

    /** Supported angles and resolutions as text: {@code 100 with 1, 0.5 or 0.25; 180 with 1 or 0.5}. */
    public String fans() {
        return fans.stream().map(Fans::toString).collect(Collectors.joining("; "));
    }

    private Fans widest() {
        return fans.get(fans.size() - 1);
    }

    /** Initial angle if its object requests an unsupported one, degrees. */
    public double getWidestSpread() {
        return widest().spread;
    }

    /** Initial resolution if its object requests an unsupported one, degrees. */
    public double getFinestResolution() {
        return widest().finest;
    }

    /** That angle and resolution as text: {@code 180 and 0.5}. */
    public String widestFan() {
        return Fans.format(getWidestSpread()) + " and " + Fans.format(getFinestResolution());
    }
}
