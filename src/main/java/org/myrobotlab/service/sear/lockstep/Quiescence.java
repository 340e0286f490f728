// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.lockstep;

import java.util.concurrent.atomic.AtomicLong;
import org.myrobotlab.serial.SerialDeviceFactory;
import org.myrobotlab.serial.VirtualSerialPort;
import org.myrobotlab.service.sear.Host;

/** Waits until the listeners of all virtual ports have processed their bytes and the callbacks of scripts have run. */
public final class Quiescence {
    private final Host host;
    private final Fence messages;
    private VirtualSerialPort complainedOf;
    private boolean reported;
    private final SleepingThreads sleepers;
    private final AtomicLong disturbances = new AtomicLong();
    private volatile long settledBytes;
    private volatile long settledCalls;

    public Quiescence(Host host, SleepingThreads sleepers) {
        this.host = host;
        this.sleepers = sleepers;
        messages = new Fence(host, sleepers);
    }

    /**
     * Waits until ports and callbacks are idle. Checks the callbacks only after new bytes, after a thread has slept, or
     * after {@link #disturb}.
     */
    public void settle() throws InterruptedException {
        await();
        while (isDisturbed()) {
            long calls = calls();
            long bytes = accepted();
            await(); // so that all messages that these bytes cause are queued
            messages.await();
            settledCalls = calls;
            settledBytes = bytes;
        }
    }

    /** Returns whether a callback may run that the last {@link #settle} did not wait for. */
    public boolean isDisturbed() {
        return calls() != settledCalls || accepted() != settledBytes;
    }

    /** Learns the threads of callbacks before there are any. */
    public void greet() {
        messages.greet();
    }

    /** Makes the next {@link #settle} check the callbacks. */
    public void disturb() {
        disturbances.incrementAndGet();
    }

    private long calls() {
        return disturbances.get() + sleepers.getWoken();
    }

    private static long accepted() {
        long sum = 0;
        for (VirtualSerialPort port : SerialDeviceFactory.getVirtualPorts()) {
            sum += port.getAccepted();
        }
        return sum;
    }

    /** Waits for all ports. Gives up a port after {@link Timeouts#END}, because its listener hangs. */
    private void await() throws InterruptedException {
        boolean moved = true;
        while (moved) {
            moved = false;
            for (VirtualSerialPort port : SerialDeviceFactory.getVirtualPorts()) {
                if (port.getPending() > 0 && port != complainedOf) {
                    if (isHanded(port)) {
                        moved = true;
                    } else {
                        complainedOf = port;
                        host.warn(unfinished(port, Timeouts.END) + ": lock-step continues without it");
                    }
                }
            }
        }
    }

    private boolean isHanded(VirtualSerialPort port) throws InterruptedException {
        if (port.awaitHanded(Timeouts.millis(Timeouts.WORD))) {
            return true;
        }
        if (!reported) {
            reported = true;
            host.warn(unfinished(port, Timeouts.WORD) + Timeouts.waits());
        }
        return port.awaitHanded(Timeouts.millis(Timeouts.END - Timeouts.WORD));
    }

    private static String unfinished(VirtualSerialPort port, long seconds) {
        return "a listener of port " + port.getName() + " has not processed " + port.getPending() + " bytes within "
            + seconds + " s";
    }
}
