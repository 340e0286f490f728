package org.SEAR.devices.gps;

import java.nio.charset.StandardCharsets;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.SerialDevice;
import org.SEAR.protocol.nmea.Nmea;
import org.SEAR.protocol.nmea.SentenceReader;
import org.SEAR.sensors.GpsFix;

/**
 * The firmware of a MediaTek GPS receiver (San Jose Navigation FV-M8 class): sentences out with each fix, PMTK commands in with acknowledgements.
 * Sources: recordings of FV-M11 and MT3329 receivers, MTK NMEA packet manual.
 */
public final class Mt3301 implements SerialDevice {
    /** Bits a second of a receiver as delivered. */
    public static final int DEFAULT_BAUD = 38400;
    private static final double MILLIS = 1000;
    private static final String RESTARTED = "$POLYN,TIME,RESTART_OCCURRED\r\n$POLYN,EPH,0,00000000\r\n$POLYN,ALM,0,00000000\r\n";

    private final GpsModel model;
    private final int powerOnBaud;
    private final int powerOnPeriod;
    private final long timeToFix;
    private final DeviceContext context;
    private final SentenceReader reader = new SentenceReader(this::onSentence);
    private PmtkCommands commands;
    private OutputRates rates;
    private int period;
    private long nextFix;
    private long fixNumber;
    private long firstFix;
    private boolean greeted;
    private int baud;
    private int nextBaud;
    private double switchAt;
    private double heardAt;

    /**
     * @param baud bits a second at power-on
     * @param rate fixes a second at power-on
     * @param timeToFix seconds without a fix after power-on
     */
    public Mt3301(GpsModel model, int baud, double rate, double timeToFix, DeviceContext context) {
        int millis = (int) Math.round(MILLIS / rate);
        if (!isPeriod(model, millis)) {
            throw new IllegalArgumentException("GPS rate " + rate + " Hz: an " + model + " has 0.1 to " + MILLIS / model.getShortestPeriod());
        }
        this.model = model;
        this.powerOnBaud = baud;
        this.powerOnPeriod = millis;
        this.timeToFix = Math.round(timeToFix * MILLIS);
        this.context = context;
        reset();
    }

    @Override
    public void reset() {
        rates = new OutputRates();
        commands = new PmtkCommands(this);
        period = powerOnPeriod;
        baud = powerOnBaud;
        nextBaud = 0;
        nextFix = period;
        fixNumber = 0;
        firstFix = timeToFix;
        greeted = false;
        reader.reset();
    }

    @Override
    public void powerOff() {
        nextBaud = 0;
    }

    @Override
    public void powerOn(double time) {
        reset();
        greeted = true;
        restart(true, time);
        nextFix = nextFixAfter(time);
    }

    @Override
    public int getBaud() {
        return baud;
    }

    @Override
    public void receive(int value, double time) {
        advance(time);
        heardAt = time;
        reader.accept(value);
    }

    /** Commands without checksum are not obeyed. */
    private void onSentence(String sentence) {
        String body = Nmea.body(sentence);
        if (body != null) {
            commands.execute(body, heardAt);
        }
    }

    @Override
    public void receiveGarbage(double time) {
        advance(time);
        reader.reset();
    }

    @Override
    public void advance(double time) {
        if (!greeted) {
            greeted = true;
            context.send((Nmea.sentence(model.getGreeting()) + RESTARTED).getBytes(StandardCharsets.US_ASCII), 0);
        }
        while (nextFix / MILLIS <= time) {
            switchBaud(nextFix / MILLIS);
            fix(nextFix);
            nextFix += period;
        }
        switchBaud(time);
    }

    private void switchBaud(double time) {
        if (nextBaud != 0 && time >= switchAt) {
            baud = nextBaud;
            nextBaud = 0;
            reader.reset();
        }
    }

    /** Sends the sentences of a fix; while those of the last one are still on the line there is no new fix. */
    private void fix(long millis) {
        double time = millis / MILLIS;
        if (context.lineFreeAt() > time) {
            return;
        }
        GpsFix fix = null;
        if (millis >= firstFix) {
            Object reading = context.read(context.sensor());
            fix = reading instanceof GpsFix && ((GpsFix) reading).isValid() ? (GpsFix) reading : null;
        }
        String text = text(new Sentences(model, fix, context.epochMillis() + millis), fix != null);
        fixNumber++;
        if (!text.isEmpty()) {
            context.send(text.getBytes(StandardCharsets.US_ASCII), time);
        }
    }

    private String text(Sentences sentences, boolean hasFix) {
        StringBuilder text = new StringBuilder();
        add(text, OutputRates.GGA, sentences.gga());
        add(text, OutputRates.GSA, Satellites.gsa(hasFix));
        for (int i = 1; i <= Satellites.gsvSentences(); i++) {
            add(text, OutputRates.GSV, Satellites.gsv(i));
        }
        add(text, OutputRates.RMC, sentences.rmc());
        add(text, OutputRates.VTG, sentences.vtg());
        add(text, OutputRates.GLL, sentences.gll());
        add(text, OutputRates.ZDA, sentences.zda());
        add(text, OutputRates.CHANNELS, Satellites.channels());
        return text.toString();
    }

    private void add(StringBuilder text, int sentence, String body) {
        if (rates.isDue(sentence, fixNumber)) {
            text.append(Nmea.sentence(body));
        }
    }

    void answer(String body, double time) {
        context.send(Nmea.sentence(body).getBytes(StandardCharsets.US_ASCII), time);
    }

    /** Goes on at another speed once what was sent has left. */
    void changeBaud(int newBaud, double time) {
        nextBaud = newBaud;
        switchAt = Math.max(time, context.lineFreeAt());
        switchBaud(time);
    }

    /**
     * Milliseconds from fix to fix.
     *
     * @return whether the model can do that
     */
    boolean setPeriod(int millis, double time) {
        if (!isPeriod(model, millis)) {
            return false;
        }
        period = millis;
        nextFix = nextFixAfter(time);
        return true;
    }

    private long nextFixAfter(double time) {
        return (long) Math.floor(time * MILLIS / period) * period + period;
    }

    private static boolean isPeriod(GpsModel model, int millis) {
        return millis >= model.getShortestPeriod() && millis <= PmtkCommands.MAX_PERIOD;
    }

    /** Starts anew; a cold one takes its time to the first fix. */
    void restart(boolean cold, double time) {
        firstFix = cold ? Math.round(time * MILLIS) + timeToFix : 0;
        context.send((Nmea.sentence(model.getGreeting()) + RESTARTED).getBytes(StandardCharsets.US_ASCII), time);
    }

    OutputRates getRates() {
        return rates;
    }

    int getPeriod() {
        return period;
    }

    GpsModel getModel() {
        return model;
    }

    @Override
    public String status() {
        return model + ": a fix every " + period + " ms, " + baud + " baud";
    }
}
