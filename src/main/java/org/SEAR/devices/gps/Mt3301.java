// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.gps;

import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import org.SEAR.devices.DeviceContext;
import org.SEAR.protocol.nmea.Nmea;
import org.SEAR.protocol.nmea.SentenceReader;
import org.SEAR.sensors.GpsFix;

/**
 * Firmware of a MediaTek GPS receiver (San Jose Navigation FV-M8 class): sentences out with each fix, PMTK commands in
 * with acknowledgements. Sources: recordings of FV-M11 and MT3329 receivers, MTK NMEA packet manual.
 */
public final class Mt3301 extends Receiver {
    /** Factory baud rate, bits per second. */
    public static final int DEFAULT_BAUD = 38400;
    private static final int CHANNELS = 32;
    private static final int TRACKED = 2;

    private final int powerOnBaud;
    private final int powerOnPeriod;
    private final SentenceReader reader = new SentenceReader(this::onSentence);
    private PmtkCommands commands;
    private OutputRates rates;
    private double heardAt;

    /**
     * @param model MT3301 or MT3329
     * @param baud baud rate at power-on, bits per second
     * @param rate fixes per second at power-on
     * @param timeToFix seconds without a fix after power-on
     */
    public Mt3301(GpsModel model, int baud, double rate, double timeToFix, DeviceContext context) {
        super(model, timeToFix, context);
        powerOnBaud = baud;
        powerOnPeriod = period(model, rate);
        reset();
    }

    /** Resets the time of the last byte; no setting survives power-off. */
    @Override
    void deliver() {
        heardAt = 0;
    }

    @Override
    void boot() {
        rates = new OutputRates();
        commands = new PmtkCommands(this);
        begin(powerOnBaud, powerOnPeriod);
    }

    @Override
    void take(int value, double time) {
        heardAt = time;
        reader.accept(value);
    }

    /** Runs a command; sentences without a valid checksum are ignored. */
    private void onSentence(String sentence) {
        String body = Nmea.body(sentence);
        if (body != null) {
            understood();
            commands.execute(body, heardAt);
        }
    }

    @Override
    void forgetInput() {
        reader.reset();
    }

    @Override
    byte[] output(GpsFix fix, long millis, long number) {
        Sentences sentences = new Sentences(getModel().getStyle(), fix, millis);
        StringBuilder text = new StringBuilder();
        add(text, OutputRates.GGA, number, one(sentences.gga()));
        add(text, OutputRates.GSA, number, sentences.gsa());
        add(text, OutputRates.GSV, number, sentences.gsv(true));
        add(text, OutputRates.RMC, number, one(sentences.rmc()));
        add(text, OutputRates.VTG, number, one(sentences.vtg()));
        add(text, OutputRates.GLL, number, one(sentences.gll()));
        add(text, OutputRates.ZDA, number, one(sentences.zda()));
        add(text, OutputRates.CHANNELS, number, one(channels()));
        return text.toString().getBytes(StandardCharsets.US_ASCII);
    }

    private static List<String> one(String body) {
        return Collections.singletonList(body);
    }

    private void add(StringBuilder text, int sentence, long number, List<String> bodies) {
        if (rates.isDue(sentence, number)) {
            bodies.forEach(body -> text.append(Nmea.sentence(body)));
        }
    }

    /** Satellite, signal and state of each of 32 channels: {@code PMTKCHN,21502,...}. */
    private static String channels() {
        StringBuilder body = new StringBuilder("PMTKCHN");
        Constellation sky = Constellation.GPS;
        for (int i = 0; i < CHANNELS; i++) {
            body.append(i < sky.size() ? String.format(Locale.ROOT, ",%02d%02d%d", sky.number(i), sky.signal(i),
                TRACKED) : ",00000");
        }
        return body.toString();
    }

    void answer(String body, double time) {
        send(Nmea.sentence(body), time);
    }

    /**
     * Sets the fix interval, milliseconds.
     *
     * @return whether the model supports it
     */
    boolean takePeriod(int millis, double time) {
        boolean can = millis >= getModel().getShortestPeriod() && millis <= PmtkCommands.MAX_PERIOD;
        if (can) {
            setPeriod(millis, time);
        }
        return can;
    }

    OutputRates getRates() {
        return rates;
    }

    @Override
    public String title() {
        return "an " + getModel();
    }

    @Override
    public String status() {
        return getModel() + ": a fix every " + getPeriod() + " ms, " + getBaud() + " baud";
    }
}
