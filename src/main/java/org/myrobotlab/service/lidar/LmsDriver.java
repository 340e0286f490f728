// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import java.util.Arrays;
import java.util.function.Consumer;
import org.SEAR.protocol.lms.Baud;
import org.SEAR.protocol.lms.LmsCommand;
import org.SEAR.protocol.lms.Telegram;
import org.SEAR.protocol.lms.TelegramReader;
import org.myrobotlab.service.lidar.requests.DeviceLine;
import org.myrobotlab.service.lidar.requests.DriverEvents;
import org.myrobotlab.service.lidar.requests.Requests;

/**
 * Driver of a SICK LMS2xx: sends requests, takes acknowledgements and replies, see {@link Requests}, and takes streamed
 * scans. Any thread.
 */
final class LmsDriver extends LidarDriver<LmsRequest> implements TelegramReader.Listener {
    /**
     * Pause within a telegram, seconds, after which the reader drops it: the device aborts a scan to answer a request.
     */
    private static final double BROKEN_OFF = 0.3;

    private final DeviceLine line;
    private final Consumer<Telegram> scans;
    private final TelegramReader reader = new TelegramReader(address -> (address & Telegram.FROM_DEVICE) != 0, this);
    private double heardAt;

    /** @param scans takes the B0h telegrams of streaming */
    LmsDriver(DeviceLine line, DriverEvents events, Consumer<Telegram> scans) {
        super(line, events, Arrays.stream(Baud.values()).mapToInt(Baud::getRate).toArray());
        this.line = line;
        this.scans = scans;
    }

    @Override
    void forget() {
        reader.clear();
    }

    @Override
    synchronized void receive(byte[] bytes) {
        heardAt = line.now();
        reader.accept(bytes);
    }

    @Override
    synchronized void tick() {
        if (reader.isPending() && line.now() > heardAt + BROKEN_OFF) {
            reader.interrupt();
        }
        super.tick();
    }

    @Override
    public void onStray(int value) {
        boolean acknowledged = value == Telegram.ACK;
        if (requests.current() != null && (acknowledged || value == Telegram.NAK)) {
            requests.hear();
            if (!acknowledged) {
                requests.refused("NAK");
            }
        }
    }

    @Override
    public void onTelegram(Telegram telegram) {
        int command = telegram.getCommand();
        requests.hear();
        LmsRequest current = requests.current();
        if (current != null && command == current.command.getReply()) {
            accept(requests.answered().then, telegram);
            requests.next();
        } else if (current != null && command == LmsCommand.NOT_PERMITTED) {
            requests.answered();
            events.error("the LIDAR does not permit " + current.name + " in its present operating mode");
            requests.next();
        } else if (command == LmsCommand.SCAN.getReply()) {
            accept(scans, telegram);
        } else if (command == LmsCommand.POWER_ON) {
            events.info("the LIDAR has started: " + LmsReplies.text(telegram));
        }
    }

    private void accept(Consumer<Telegram> taker, Telegram telegram) {
        try {
            taker.accept(telegram);
        } catch (IndexOutOfBoundsException | IllegalArgumentException e) {
            events.error("the LIDAR sent an invalid telegram " + Integer.toHexString(telegram.getCommand()) + "h, "
                + telegram.size() + " bytes: " + e.getMessage());
        }
    }
}
