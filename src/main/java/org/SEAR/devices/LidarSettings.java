// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

import org.SEAR.POJOs.LIDAR;
import org.SEAR.protocol.lidar.LidarModel;
import org.SEAR.protocol.lidar.LidarProtocol;

/**
 * Start settings of a LIDAR's device: angle range and baud rate of its object. Where the model does not have them, the
 * model's own apply and the user gets a warning. Immutable.
 */
public final class LidarSettings {
    public final LidarModel model;
    /** Angle from the rightmost to the leftmost measurement, degrees. */
    public final double spread;
    /** Angle between two measurements, degrees. */
    public final double resolution;
    /** Baud rate, bits per second. */
    public final int baud;

    private LidarSettings(LidarModel model, double spread, double resolution, int baud) {
        this.model = model;
        this.spread = spread;
        this.resolution = resolution;
        this.baud = baud;
    }

    /**
     * Settings of an object whose device uses a protocol.
     *
     * @param context receives a warning for each setting that differs from the object's
     * @return null if the object has no device, or one with another protocol
     */
    public static LidarSettings of(LIDAR lidar, LidarProtocol protocol, DeviceContext context) {
        LidarModel model = LidarModel.of(lidar.getModel());
        if (lidar.getLms() == 0 || model.getProtocol() != protocol) {
            return null;
        }
        boolean fan = model.hasFan(lidar.getSpread(), lidar.getResolution());
        if (!fan) {
            context.warn("spread " + lidar.getSpread() + " with resolution " + lidar.getResolution()
                + " is not available on "
                + model.withArticle() + ", legal: " + model.fans() + "; its device starts with " + model.widestFan());
        }
        int baud = lidar.getBaud();
        if (!model.hasBaud(baud)) {
            context.warn(baud + " baud is not available on " + model.withArticle() + ", legal: " + model.bauds()
                + "; its device starts with " + model.getBaud());
            baud = model.getBaud();
        }
        return new LidarSettings(model, fan ? lidar.getSpread() : model.getWidestSpread(), fan ? lidar.getResolution()
            : model.getFinestResolution(), baud);
    }
}
