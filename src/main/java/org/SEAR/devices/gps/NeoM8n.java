// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.gps;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.SEAR.devices.DeviceContext;
import org.SEAR.protocol.nmea.Nmea;
import org.SEAR.protocol.ubx.UbxFrame;
import org.SEAR.protocol.ubx.UbxMessage;
import org.SEAR.protocol.ubx.UbxReader;
import org.SEAR.sensors.GpsFix;

/**
 * Firmware of a u-blox NEO-M8N (protocol 18). Its settings select the NMEA sentences and UBX messages of each fix. It
 * runs UBX commands and ignores NMEA commands. Settings saved by CFG-CFG survive power-off. Sources: recordings of
 * NEO-M8N and M8T, the field tables of gpsd and pyubx2.
 */
public final class NeoM8n extends Receiver {
    /** Factory baud rate, bits per second. */
    public static final int DEFAULT_BAUD = 9600;
    private static final String NAME = "NEO-M8N";
    private static final String[] EXTENSIONS =
        {"ROM BASE 3.01 (107888)", "FWVER=SPG 3.01", "PROTVER=18.00", "MOD=NEO-M8N-0", "FIS=0xC22536 (100111)",
            "GPS;GLO;GAL;BDS", "SBAS;IMES;QZSS"};
    private static final int TEXT_SIZE = 30;
    private static final int HARDWARE_SIZE = 10;
    private static final int GPS_ONLY = 2;
    private static final int STOP = 8;
    private static final int GO = 9;
    private static final int ALL = -1;
    /** Order of a fix's sentences and messages. */
    private static final UbxMessage[] ORDER = {UbxMessage.NMEA_RMC, UbxMessage.NMEA_VTG, UbxMessage.NMEA_GGA,
        UbxMessage.NMEA_GSA,
        UbxMessage.NMEA_GSV, UbxMessage.NMEA_GLL, UbxMessage.NMEA_ZDA, UbxMessage.NAV_POSECEF, UbxMessage.NAV_POSLLH,
        UbxMessage.NAV_STATUS,
        UbxMessage.NAV_DOP, UbxMessage.NAV_SOL, UbxMessage.NAV_PVT, UbxMessage.NAV_VELECEF, UbxMessage.NAV_VELNED,
        UbxMessage.NAV_TIMEGPS, UbxMessage.NAV_CLOCK, UbxMessage.NAV_SAT, UbxMessage.NAV_EOE};

    private final UbxSettings delivered;
    private final UbxCommands commands = new UbxCommands(this);
    private final UbxReader reader = new UbxReader(this::onFrame, other -> { });
    private UbxSettings saved;
    private UbxSettings settings;
    private double heardAt;
    private boolean stopped;
    private boolean timeKnown;
    private UbxSolution last;
    private long firstFixAfter;

    /**
     * @param baud factory baud rate, bits per second
     * @param rate factory rate, fixes per second
     * @param timeToFix seconds without a fix after power-on
     */
    public NeoM8n(int baud, double rate, double timeToFix, DeviceContext context) {
        super(GpsModel.NEOM8N, timeToFix, context);
        delivered = new UbxSettings(baud, period(GpsModel.NEOM8N, rate));
        reset();
    }

    @Override
    void deliver() {
        saved = copy(delivered);
    }

    private static UbxSettings copy(UbxSettings from) {
        UbxSettings copy = new UbxSettings(0, 0);
        copy.copy(from, ALL);
        return copy;
    }

    @Override
    void boot() {
        settings = copy(saved);
        stopped = false;
        forgetSky();
        begin(settings.baud(), settings.period());
    }

    private void forgetSky() {
        timeKnown = false;
        firstFixAfter = 0;
        last = null;
    }

    @Override
    void take(int value, double time) {
        heardAt = time;
        reader.accept(value);
    }

    private void onFrame(UbxFrame frame) {
        understood();
        if (settings.takes(UbxSettings.UBX)) {
            commands.execute(frame, heardAt);
        }
    }

    @Override
    void forgetInput() {
        reader.reset();
    }

    @Override
    byte[] output(GpsFix found, long millis, long number) {
        GpsFix fix = stopped ? null : found;
        solve(fix, millis);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        Sentences sentences = new Sentences(SentenceStyle.UBLOX, fix, timeKnown ? (Long) millis : null);
        for (UbxMessage message : ORDER) {
            if (settings.isDue(message, number)) {
                byte[] part = message.getGroup() == UbxMessage.NAV ? ubx(message)
                    : nmea(sentences, message, fix != null);
                bytes.write(part, 0, part.length);
            }
        }
        return bytes.toByteArray();
    }

    private void solve(GpsFix fix, long millis) {
        if (fix != null && firstFixAfter == 0) {
            firstFixAfter = Math.max(1, sinceStart(millis));
        }
        timeKnown |= fix != null;
        last = new UbxSolution(fix, millis, timeKnown, firstFixAfter, sinceStart(millis));
    }

    private byte[] ubx(UbxMessage message) {
        return settings.sends(UbxSettings.UBX) ? new UbxFrame(message, last.payload(message)).toBytes() : new byte[0];
    }

    private byte[] nmea(Sentences sentences, UbxMessage message, boolean fix) {
        StringBuilder text = new StringBuilder();
        if (settings.sends(UbxSettings.NMEA)) {
            bodies(sentences, message, fix).forEach(body -> text.append(Nmea.sentence(body)));
        }
        return text.toString().getBytes(StandardCharsets.US_ASCII);
    }

    private static List<String> bodies(Sentences sentences, UbxMessage message, boolean fix) {
        switch (message) {
            case NMEA_GGA:
                return Collections.singletonList(sentences.gga());
            case NMEA_GLL:
                return Collections.singletonList(sentences.gll());
            case NMEA_GSA:
                return sentences.gsa();
            case NMEA_GSV:
                return sentences.gsv(fix);
            case NMEA_RMC:
                return Collections.singletonList(sentences.rmc());
            case NMEA_VTG:
                return Collections.singletonList(sentences.vtg());
            default:
                return Collections.singletonList(sentences.zda());
        }
    }

    void answer(UbxFrame frame, double time) {
        if (settings.sends(UbxSettings.UBX)) {
            send(frame.toBytes(), time);
        }
    }

    /** Answers a poll from the last fix. */
    void answerPoll(UbxMessage message, double time) {
        if (message == UbxMessage.MON_VER) {
            answer(new UbxFrame(message, version()), time);
        } else if (message.getGroup() == UbxMessage.NAV) {
            if (last == null) {
                solve(null, utc(time));
            }
            answer(new UbxFrame(message, last.payload(message)), time);
        }
    }

    private static byte[] version() {
        ByteBuffer text = UbxFrame.room(TEXT_SIZE + HARDWARE_SIZE + TEXT_SIZE * EXTENSIONS.length);
        text.put(Arrays.copyOf(GpsModel.NEOM8N.getRelease().getBytes(StandardCharsets.US_ASCII), TEXT_SIZE));
        text.put(Arrays.copyOf("00080000".getBytes(StandardCharsets.US_ASCII), HARDWARE_SIZE));
        for (String extension : EXTENSIONS) {
            text.put(Arrays.copyOf(extension.getBytes(StandardCharsets.US_ASCII), TEXT_SIZE));
        }
        return text.array();
    }

    /** Changes to the baud rate of the settings, if it differs. */
    void followBaud(double time) {
        if (settings.baud() != getBaud()) {
            changeBaud(settings.baud(), time);
        }
    }

    /**
     * Runs CFG-RST.
     *
     * @param cold whether any satellite data is cleared
     * @param mode 2 GNSS only, 8 stop, 9 start, others the whole receiver
     */
    void restart(boolean cold, int mode, double time) {
        if (mode == STOP || mode == GO) {
            stopped = mode == STOP;
        } else if (mode == GPS_ONLY) {
            forgetSky();
            refresh(cold, time);
        } else {
            boot();
            restart(cold, time);
            setPeriod(getPeriod(), time);
        }
    }

    UbxSettings getSettings() {
        return settings;
    }

    UbxSettings getSaved() {
        return saved;
    }

    UbxSettings getDelivered() {
        return delivered;
    }

    @Override
    public String title() {
        return "a " + NAME;
    }

    @Override
    public String status() {
        return NAME + ": a fix every " + getPeriod() + " ms, " + getBaud() + " baud" + (stopped ? ", stopped" : "");
    }
}
