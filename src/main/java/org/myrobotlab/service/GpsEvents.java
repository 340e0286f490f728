// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import org.SEAR.protocol.nmea.Pmtk;
import org.SEAR.protocol.ubx.UbxFrame;
import org.SEAR.protocol.ubx.UbxMessage;
import org.myrobotlab.service.gps.Fix;
import org.myrobotlab.service.gps.ReceiverModel;
import org.myrobotlab.service.gps.Reception;
import org.myrobotlab.service.gps.UbxText;
import org.myrobotlab.service.link.ServiceWarnings;

/** Publishes what a GPS service's receiver sends during one connection. One thread. */
final class GpsEvents implements Reception.Listener {
    /** Start of the reply to the firmware query. */
    private static final String FIRMWARE = "$" + Pmtk.RELEASE.body() + ",";

    private final GPS gps;
    private boolean asked;

    GpsEvents(GPS gps) {
        this.gps = gps;
    }

    @Override
    public void onUbx(UbxFrame frame) {
        gps.heard();
        if (frame.getMessage() == UbxMessage.MON_VER) {
            gps.onFirmware(UbxText.version(frame), null);
        } else if (frame.getMessage() == UbxMessage.ACK_NAK) {
            ServiceWarnings.publish(gps, "%s refused a command: %s", gps.getName(), UbxText.refused(frame));
        }
        askOnce();
    }

    @Override
    public void onSentence(String sentence) {
        gps.heard();
        if (sentence.startsWith(FIRMWARE)) {
            String release = sentence.substring(FIRMWARE.length()).split("[,*]", 2)[0];
            gps.onFirmware(release, ReceiverModel.ofRelease(release));
        } else {
            askOnce();
        }
        gps.invoke("publishSentence", sentence);
    }

    private void askOnce() {
        if (!asked && gps.isConnected()) {
            asked = true;
            gps.askFirmware();
        }
    }

    @Override
    public void onFix(Fix fix) {
        if (gps.changeFix(fix.hasFix())) {
            if (fix.hasFix()) {
                gps.info("%s has a fix", gps.getName());
            } else {
                ServiceWarnings.publish(gps, "%s has lost its fix", gps.getName());
            }
        }
        gps.invoke("publishGGAData", (Object) fix.tokens);
        gps.invoke("publishGGADData", (Object) fix.tokens);
        if (fix.hasFix()) {
            gps.invoke("publishGPS", (Object) new Double[] {fix.latitude, fix.longitude, fix.altitude});
        }
    }

    @Override
    public void onInvalid(String reason) {
        ServiceWarnings.publish(gps, "%s sent an invalid %s", gps.getName(), reason);
    }
}
