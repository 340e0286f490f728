// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.scip;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * Finds replies in a sensor's output: lines up to an empty one. Reports and skips a reply with a wrong checksum or
 * without status. One thread at a time.
 */
public final class ReplyReader {
    private static final int LONGEST_LINE = 80;
    /** Maximum number of lines; a scan of 1440 steps with intensities has fewer. */
    private static final int MAX_LINES = 200;

    private final Consumer<Reply> replies;
    private final Runnable broken;
    private final StringBuilder line = new StringBuilder();
    private final List<String> lines = new ArrayList<>();
    private boolean bad;

    /**
     * @param replies receives the valid replies
     * @param broken runs for each invalid reply
     */
    public ReplyReader(Consumer<Reply> replies, Runnable broken) {
        this.replies = replies;
        this.broken = broken;
    }

    /** Takes bytes from the sensor. */
    public void accept(byte[] bytes) {
        for (byte each : bytes) {
            accept((char) (each & 0xFF));
        }
    }

    private void accept(char character) {
        if (character != '\n') {
            bad |= line.length() >= LONGEST_LINE;
            if (!bad) {
                line.append(character);
            }
        } else if (line.length() == 0) {
            finish();
        } else {
            bad |= lines.size() >= MAX_LINES;
            if (!bad) {
                lines.add(line.toString());
            }
            line.setLength(0);
        }
    }

    /** Discards an incomplete reply. */
    public void clear() {
        line.setLength(0);
        lines.clear();
        bad = false;
    }

    private void finish() {
        Reply reply = bad || lines.isEmpty() ? null : parse();
        boolean anything = bad || !lines.isEmpty();
        clear();
        if (reply != null) {
            replies.accept(reply);
        } else if (anything) {
            broken.run();
        }
    }

    private Reply parse() {
        List<String> texts = new ArrayList<>();
        for (String each : lines.subList(1, lines.size())) {
            String text = Checksum.strip(each);
            if (text == null) {
                return null;
            }
            texts.add(text);
        }
        if (texts.isEmpty() || texts.get(0).length() != 2) {
            return null;
        }
        return new Reply(lines.get(0), texts.get(0), texts.subList(1, texts.size()));
    }
}
