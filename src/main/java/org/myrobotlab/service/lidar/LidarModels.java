// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.SEAR.protocol.lidar.LidarModel;
import org.SEAR.protocol.lidar.LidarProtocol;
import org.SEAR.protocol.scip.HokuyoModel;

/** The scanner models of the LIDAR service, with their legal values and drivers. Any thread. */
public final class LidarModels {
    /** Models that use the protocol of another model. */
    private static final Map<String, LidarModel> SISTERS = Map.of("LMS211", LidarModel.LMS221, "LMS220",
        LidarModel.LMS221);
    private static final Map<String, LidarModel> MODELS = models();
    /** Rate that opens a USB port, where the rate has no effect. */
    private static final int ANY_BAUD = 115200;
    private static final double[][] LMS_MODES = {{180, 1}, {180, 0.5}, {100, 1}, {100, 0.5}, {100, 0.25}};
    private static final double[][] URG_MODES = {{240, 0.35}, {240, 0.7}, {240, 1.05}, {180, 0.35}, {180, 1.05}};
    private static final double[][] UTM_MODES = {{270, 0.25}, {270, 0.5}, {270, 1}, {180, 0.25}, {180, 1}};
    private static final double[][] RPLIDAR_MODES = {{360, 1}, {360, 0.5}, {180, 1}, {180, 0.5}};

    private LidarModels() {
    }

    private static Map<String, LidarModel> models() {
        Map<String, LidarModel> models = new LinkedHashMap<>();
        for (String name : Arrays.asList("LMS200", "LMS211", "LMS220", "LMS221", "LMS291", "URG-04LX", "UTM-30LX",
            "RPLIDAR-A1")) {
            models.put(name, SISTERS.containsKey(name) ? SISTERS.get(name) : LidarModel.of(name));
        }
        return models;
    }

    /** @throws IllegalArgumentException with the legal models */
    public static String checked(String model) {
        find(model);
        return model;
    }

    private static LidarModel find(String model) {
        LidarModel found = MODELS.get(model);
        if (found == null) {
            throw new IllegalArgumentException("LIDAR model is \"" + model + "\", legal: " + MODELS.keySet());
        }
        return found;
    }

    /** Returns whether both models use the same driver. */
    public static boolean talkAlike(String model, String other) {
        return model.equals(other) || find(model).getProtocol() == LidarProtocol.LMS
            && find(other).getProtocol() == LidarProtocol.LMS;
    }

    /** Returns whether the rate is legal for the model. */
    public static boolean hasBaud(String model, int baud) {
        return Arrays.stream(bauds(find(model))).anyMatch(known -> known == baud);
    }

    /** Returns the baud rate of the model at power-on. */
    public static int firstBaud(String model) {
        return bauds(find(model))[0];
    }

    /** @throws IllegalArgumentException with the legal rates */
    public static int checkedBaud(String model, int baud) {
        if (!hasBaud(model, baud)) {
            throw new IllegalArgumentException("LIDAR baud rate is " + baud + ", legal: "
                + Arrays.stream(bauds(find(model))).mapToObj(String::valueOf).collect(Collectors.joining(", ")));
        }
        return baud;
    }

    /** Returns the baud rates of a model; for a USB-only model the rate that opens its port. */
    static int[] bauds(LidarModel model) {
        int[] rates = Arrays.stream(model.rates()).filter(rate -> rate != HokuyoModel.USB).toArray();
        return rates.length > 0 ? rates : new int[] {ANY_BAUD};
    }

    /** Creates the driver of a model. */
    public static LidarDevice driver(String model, LidarListener listener) {
        LidarModel found = find(model);
        switch (found.getProtocol()) {
            case SCIP:
                return new HokuyoDevice(found, listener);
            case RPLIDAR:
                return new RplidarDevice(found, listener);
            default:
                return new LmsDevice(listener);
        }
    }

    /** Returns all models. */
    public static List<LidarChoice> choices() {
        return MODELS.entrySet().stream()
            .map(each -> new LidarChoice(each.getKey(), bauds(each.getValue()), modes(each.getValue()),
            each.getValue().getProtocol() == LidarProtocol.LMS)).collect(Collectors.toList());
    }

    private static double[][] modes(LidarModel model) {
        switch (model) {
            case URG_04LX:
                return URG_MODES;
            case UTM_30LX:
                return UTM_MODES;
            case RPLIDAR_A1:
                return RPLIDAR_MODES;
            default:
                return LMS_MODES;
        }
    }
}
