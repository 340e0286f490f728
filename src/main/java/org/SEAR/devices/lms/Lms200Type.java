package org.SEAR.devices.lms;

import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SearObject;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.DeviceType;
import org.SEAR.devices.SerialDevice;
import org.SEAR.protocol.lms.Baud;
import org.SEAR.protocol.lms.Identity;
import org.SEAR.protocol.lms.Variant;

/** Puts a SICK LMS200 behind the ports of a LIDAR with LMS(1). */
public final class Lms200Type implements DeviceType {
    private static final int LMS200 = 1;
    private static final int HUNDREDTHS = 100;

    @Override
    public Class<? extends SearObject> parameterType() {
        return LIDAR.class;
    }

    @Override
    public SerialDevice create(SearObject parameters, DeviceContext context) {
        LIDAR lidar = (LIDAR) parameters;
        if (lidar.getLms() != LMS200) {
            return null;
        }
        Variant variant = Variant.of((int) Math.round(lidar.getSpread()), (int) Math.round(lidar.getResolution() * HUNDREDTHS));
        if (variant == null) {
            context.warn("spread " + lidar.getSpread() + " with resolution " + lidar.getResolution()
                + " is none of an LMS200 (100 with 1, 0.5, 0.25; 180 with 1, 0.5): its device starts with 180 and 0.5");
            variant = Variant.V180_HALF;
        }
        int baud = lidar.getBaud();
        if (Baud.ofRate(baud) == null) {
            context.warn(baud + " baud is none of an LMS200 (9600, 19200, 38400, 500000): its device starts with 9600");
            baud = Baud.B9600.getRate();
        }
        return new Lms200(new PowerOnSettings(variant, baud, lidar.isLenient(), Identity.LMS200_30106), context);
    }
}
