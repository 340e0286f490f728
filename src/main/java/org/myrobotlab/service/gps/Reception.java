// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.gps;

import java.util.Locale;
import java.util.concurrent.atomic.AtomicLong;
import org.SEAR.protocol.nmea.SentenceReader;
import org.SEAR.protocol.ubx.UbxFrame;
import org.SEAR.protocol.ubx.UbxMessage;
import org.SEAR.protocol.ubx.UbxReader;

/** Reads a receiver's bytes from one connection: NMEA sentences and UBX messages. One thread feeds it; any reads. */
public final class Reception {
    private static final int RMC_UTC = 1;
    private static final int RMC_STATUS = 2;
    private static final int RMC_DATE = 9;
    private static final int ZDA_UTC = 1;
    private static final int ZDA_DAY = 2;
    private static final int ZDA_MONTH = 3;
    private static final int ZDA_YEAR = 4;
    /** First two-digit year of the 20th century in RMC: GPS began in 1980. */
    private static final int FIRST_YEAR = 80;
    private static final String DATE = "[0-9]{6}";
    private static final String TIME = "[0-9]{6}([.][0-9]*)?";

    private final Listener listener;
    private final SentenceReader reader = new SentenceReader(this::onSentence);
    private final UbxReader frames = new UbxReader(this::onFrame, reader::accept);
    private final FixMerger merger;
    private final AtomicLong count = new AtomicLong();
    private volatile String time;
    private volatile Fix lastFix;

    /** Gets what arrives, on the thread that feeds the bytes. */
    public interface Listener {
        /** Takes a valid sentence, from {@code $} to checksum. */
        void onSentence(String sentence);

        /** Takes a valid UBX message. */
        void onUbx(UbxFrame frame);

        /** Takes the fix of a moment. */
        void onFix(Fix fix);

        /** Takes the reason why a sentence or message with a fix is unusable. */
        void onInvalid(String reason);
    }

    public Reception(Listener listener) {
        this.listener = listener;
        merger = new FixMerger(this::onFix);
    }

    /** Takes bytes in pieces of any size. */
    public void feed(byte[] bytes) {
        frames.feed(bytes);
    }

    /** Returns the number of valid sentences and UBX messages. */
    public long getCount() {
        return count.get();
    }

    /** Returns the number of dropped, damaged sentences and UBX messages. */
    public long getDamaged() {
        return reader.getDamaged() + frames.getDamaged();
    }

    /** Returns the last fix, with or without position; null before the first. */
    public Fix getLastFix() {
        return lastFix;
    }

    /** Returns the UTC in the last RMC with a fix, ZDA or NAV-PVT: {@code 2026-11-28T19:01:09.200Z}; null before. */
    public String getTime() {
        return time;
    }

    private void onFix(Fix fix) {
        lastFix = fix;
        listener.onFix(fix);
    }

    private void onFrame(UbxFrame frame) {
        count.incrementAndGet();
        listener.onUbx(frame);
        if (frame.getMessage() == UbxMessage.NAV_PVT) {
            try {
                Fix fix = PvtFix.of(frame.getPayload());
                String reported = PvtFix.utc(frame.getPayload());
                time = reported == null ? time : reported;
                merger.accept(fix);
            } catch (IllegalArgumentException e) {
                listener.onInvalid("NAV-PVT: " + e.getMessage());
            }
        }
    }

    private void onSentence(String sentence) {
        count.incrementAndGet();
        listener.onSentence(sentence);
        try {
            onDate(FixSentences.type(sentence), FixSentences.fields(sentence));
            Fix fix = FixSentences.read(sentence);
            if (fix != null) {
                merger.accept(fix);
            }
        } catch (IllegalArgumentException e) {
            listener.onInvalid(FixSentences.type(sentence) + " sentence: " + sentence + " (" + e.getMessage() + ")");
        }
    }

    /** Takes the date of an RMC with a fix, because MT3301 invents one without, and that of ZDA. */
    private void onDate(String type, String... fields) {
        if ("RMC".equals(type) && fields.length > RMC_DATE && "A".equals(fields[RMC_STATUS]) && fields[RMC_DATE]
            .matches(DATE)) {
            String date = fields[RMC_DATE];
            String year = date.substring(4);
            setTime((Integer.parseInt(year) < FIRST_YEAR ? "20" : "19") + year, date.substring(2, 4),
                date.substring(0, 2), fields[RMC_UTC]);
        } else if ("ZDA".equals(type) && fields.length > ZDA_YEAR) {
            if (!fields[ZDA_UTC].isEmpty()) {
                merger.time(fields[ZDA_UTC]);
            }
            setTime(fields[ZDA_YEAR], fields[ZDA_MONTH], fields[ZDA_DAY], fields[ZDA_UTC]);
        }
    }

    private void setTime(String year, String month, String day, String utc) {
        if (utc.matches(TIME) && (year + month + day).matches("[0-9]{8}")) {
            time = String.format(Locale.ROOT, "%s-%s-%sT%s:%s:%sZ", year, month, day, utc.substring(0, 2),
                utc.substring(2, 4), utc.substring(4));
        }
    }
}
