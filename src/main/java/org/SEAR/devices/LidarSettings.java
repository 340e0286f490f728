package org.SEAR.devices;

import org.SEAR.POJOs.LIDAR;
import org.SEAR.protocol.lidar.LidarModel;
import org.SEAR.protocol.lidar.LidarProtocol;

/**
 * What a LIDAR's device starts with: the fan and the speed of its object where its model has them, else the model's own, which is told to the user.
 * Immutable.
 */
public final class LidarSettings {
    /** What the device is. */
    public final LidarModel model;
    /** Degrees from the rightmost to the leftmost beam. */
    public final double spread;
    /** Degrees between two beams. */
    public final double resolution;
    /** Bits a second. */
    public final int baud;

    private LidarSettings(LidarModel model, double spread, double resolution, int baud) {
        this.model = model;
        this.spread = spread;
        this.resolution = resolution;
        this.baud = baud;
    }

    /**
     * The settings of an object whose device speaks a protocol.
     *
     * @param context hears what is other than the object says
     * @return null if the object has no device, or one of another protocol
     */
    public static LidarSettings of(LIDAR lidar, LidarProtocol protocol, DeviceContext context) {
        LidarModel model = LidarModel.of(lidar.getModel());
        if (lidar.getLms() == 0 || model.getProtocol() != protocol) {
            return null;
        }
        boolean fan = model.hasFan(lidar.getSpread(), lidar.getResolution());
        if (!fan) {
            context.warn("spread " + lidar.getSpread() + " with resolution " + lidar.getResolution() + " is none of "
                + model.withArticle() + " (" + model.fans() + "): its device starts with " + model.widestFan());
        }
        int baud = lidar.getBaud();
        if (!model.hasBaud(baud)) {
            context.warn(baud + " baud is none of " + model.withArticle() + " (" + model.bauds() + "): its device starts with " + model.getBaud());
            baud = model.getBaud();
        }
        return new LidarSettings(model, fan ? lidar.getSpread() : model.getWidestSpread(), fan ? lidar.getResolution() : model.getFinestResolution(),
            baud);
    }
}
