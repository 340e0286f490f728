// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.lms;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.Bytes;

/** Telegrams of a real LMS200, recorded in 2017. */
public final class RealFrames {
    private RealFrames() {
    }

    /** Returns each telegram as it went over the line. */
    public static List<byte[]> frames() throws IOException {
        try (BufferedReader in = new BufferedReader(
            new InputStreamReader(RealFrames.class.getResourceAsStream("real-frames.txt"),
                StandardCharsets.US_ASCII))) {
            return in.lines().filter(line -> line.startsWith("02 ")).map(Bytes::bytes).collect(Collectors.toList());
        }
    }

    /** Returns the decoded telegrams of a command. */
    public static List<Telegram> telegrams(int command) throws IOException {
        List<Telegram> found = new ArrayList<>();
        TelegramReader reader = new TelegramReader(address -> address >= 0x80, telegram -> {
            if (telegram.getCommand() == command) {
                found.add(telegram);
            }
        });
        for (byte[] frame : frames()) {
            reader.accept(frame);
        }
        return found;
    }
}
