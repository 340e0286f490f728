// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;

/**
 * Data of real cameras. Pixels are square, so the vertical field of view follows from the horizontal one. Errors come
 * from data sheets and published measurements.
 */
enum CameraModel {
    /**
     * Raspberry Pi camera v2, whole sensor, binned: IMX219, 62.2 degrees, up to 30 Hz in this mode, full well 4300 e-
     * (Raspberry Pi documentation, camera).
     */
    PI_V2("RaspberryPi-v2", Camera.COLOR, 640, 480, 62.2, 30, 0.02, 10000, new Errors().well(4300)),
    /**
     * Logitech C270: 640 x 480 at 30 Hz. Logitech's specification gives "diagonal field of view (dFoV): 55°" without
     * the format. For 4 : 3 this is a horizontal field of view of 45.2 degrees. Older specifications gave 60.
     */
    C270("C270", Camera.COLOR, 640, 480, 45.2, 30, 0.02, 10000, new Errors()),
    /**
     * Kinect for Xbox 360, depth: 640 x 480 at 30 Hz, 57 degrees, 0.8 to 4 m (Kinect for Windows sensor
     * specifications). The error grows with the square of the distance, 1.425 mm at 1 m (Khoshelham and Elberink,
     * "Accuracy and resolution of Kinect depth data", 2012).
     */
    KINECT("Kinect", Camera.DEPTH, 640, 480, 57, 30, 0.8, 4, new Errors().depth(0.001425)),
    /**
     * RealSense D435, depth: 848 x 480 at 30 Hz, 87 degrees, 0.3 to 10 m (D400 series data sheet). Its error is
     * distance² * subpixel / 447 pixels (focal length) / 50 mm (baseline) (Intel, "Tuning depth cameras for best
     * performance"). For the subpixel an author of that paper says "best to use about 0.08", an empirical number that
     * may be as low as 0.032 (librealsense on GitHub, issue 3904): 3.6 mm at 1 m.
     */
    D435("D435", Camera.DEPTH, 848, 480, 87, 30, 0.3, 10, new Errors().depth(0.0036)),
    /**
     * Melexis MLX90640-BAB: 32 x 24 at 8 Hz, 55 degrees; 0.1 K at 1 Hz, which is 0.28 K at 8 Hz (data sheet, revision
     * 11).
     */
    MLX90640("MLX90640", Camera.INFRARED, 32, 24, 55, 8, 0.01, 1000, new Errors().netd(0.28)),
    /** Pixy2: 316 x 208 pixels of colour at 60 Hz, 60 degrees, with blob detection (docs.pixycam.com, v2). */
    PIXY2("Pixy2", Camera.COLOR, 316, 208, 60, 60, 0.02, 10000, new Errors());

    final String label;
    final String kind;
    final int width;
    final int height;
    final double fieldOfView;
    final double rate;
    final double near;
    final double far;
    final Errors errors;

    /** Measurement errors of a model. */
    static final class Errors {
        double fullWell;
        double depthNoise;
        double netd;

        Errors well(double electrons) {
            fullWell = electrons;
            return this;
        }

        Errors depth(double metres) {
            depthNoise = metres;
            return this;
        }

        Errors netd(double kelvin) {
            netd = kelvin;
            return this;
        }
    }

    CameraModel(String label, String kind, int width, int height, double fieldOfView, double rate, double near,
        double far, Errors errors) {
        this.label = label;
        this.kind = kind;
        this.width = width;
        this.height = height;
        this.fieldOfView = fieldOfView;
        this.rate = rate;
        this.near = near;
        this.far = far;
        this.errors = errors;
    }

    /**
     * Returns the model of a name; case and punctuation are ignored: {@code raspberry pi v2} is a RaspberryPi-v2.
     *
     * @param owner for the error message
     * @throws IllegalArgumentException with the names of the models
     */
    static CameraModel of(String name, String owner) {
        for (CameraModel model : values()) {
            if (name != null && plain(model.label).equals(plain(name))) {
                return model;
            }
        }
        throw new IllegalArgumentException(owner + ": model is \"" + name + "\", legal: "
            + Arrays.stream(values()).map(model -> model.label).collect(Collectors.joining(", ")));
    }

    private static String plain(String name) {
        return name.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]", "");
    }
}
